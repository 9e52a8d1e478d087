// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/bars/bar_plot.h"
#include "ui/session/studies.h"

#include <string>
#include <vector>

namespace sparkout {

/// How the weight of a factor is expressed.
enum class SensitivityKind { ranks, sobol };

/// Which factor matters most for one characteristic of a batch: a row a factor, a bar a zone or
/// section. Coefficients of the standardised rank regression with their signs, or Sobol indices,
/// the first-order one beside the total one.
class SensitivityPlot : public BarPlot {
    Q_OBJECT
public:
    explicit SensitivityPlot(QWidget* parent = nullptr);

    void setBatch(BatchOutcomePtr outcome, const std::string& name); ///< no replot
    void setIndices(SobolIndicesPtr indices);                        ///< of the same batch, or null
    void setKind(SensitivityKind kind);
    [[nodiscard]] SensitivityKind kind() const { return m_kind; }
    [[nodiscard]] bool empty() const { return m_bars.empty(); } ///< nothing could be computed
    [[nodiscard]] CsvTable table() const override;
    /// Of every characteristic that has them.
    [[nodiscard]] static CsvTable ranksTable(const BatchOutcome& outcome);
    [[nodiscard]] static CsvTable sobolTable(const BatchOutcome& outcome,
                                             const SobolIndices& indices);
    /// The weight that is drawn, of a place in the drawn order: the coefficient, or the total.
    [[nodiscard]] double weight(std::size_t place, std::size_t factor) const;

protected:
    void setTexts() override;
    [[nodiscard]] QString described(const BarPart& part) const override;

private:
    /// What is known of one place.
    struct Bars {
        std::size_t characteristic;       ///< of the summary
        std::vector<double> inner, outer; ///< by factor; of ranks both are the coefficient
        double determination = 0;         ///< R² of the ranks
    };
    void fill();
    [[nodiscard]] BarChart makeChart() const;
    [[nodiscard]] std::size_t seriesOfPlace() const; ///< how many each place has
    [[nodiscard]] QString placeName(const Bars& bars) const;

    BatchOutcomePtr m_outcome;
    SobolIndicesPtr m_indices;
    std::string m_name;
    SensitivityKind m_kind = SensitivityKind::ranks;
    std::vector<Bars> m_bars;
};

} // namespace sparkout
