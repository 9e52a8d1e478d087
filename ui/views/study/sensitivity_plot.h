// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/bar_plot.h"
#include "ui/session/studies.h"

#include <string>
#include <vector>

namespace sparkout {

/// How the weight of a factor is expressed.
enum class SensitivityKind { ranks, sobol };

/// The influence of the factors on one characteristic of a batch: a row for each factor, a bar for
/// each zone or section. Shows signed coefficients of the standardised rank regression, or Sobol
/// indices, the first-order one beside the total one.
class SensitivityPlot : public BarPlot {
    Q_OBJECT
public:
    explicit SensitivityPlot(QWidget* parent = nullptr);

    void setBatch(BatchOutcomePtr outcome, const std::string& name); ///< no replot
    void setIndices(SobolIndicesPtr indices); ///< indices of the same batch, or null
    void setKind(SensitivityKind kind);
    [[nodiscard]] SensitivityKind kind() const { return m_kind; }
    [[nodiscard]] bool empty() const { return m_bars.empty(); } ///< there is nothing to draw
    [[nodiscard]] CsvTable table() const override;
    /// The coefficients of every characteristic that has them.
    [[nodiscard]] static CsvTable ranksTable(const BatchOutcome& outcome);
    [[nodiscard]] static CsvTable sobolTable(const BatchOutcome& outcome,
                                             const SobolIndices& indices);
    /// The drawn weight by the drawn order of places: the coefficient, or the total index.
    [[nodiscard]] double weight(std::size_t place, std::size_t factor) const;

protected:
    void setTexts() override;
    [[nodiscard]] QString described(const BarPart& part) const override;

private:
    /// The values of one place.
    struct Bars {
        std::size_t characteristic;       ///< index in the summary
        std::vector<double> inner, outer; ///< by factor; for ranks both are the coefficient
        double determination = 0;         ///< R² for ranks
    };
    void fill();
    [[nodiscard]] BarChart makeChart() const;
    [[nodiscard]] std::size_t seriesOfPlace() const; ///< number of series for each place
    [[nodiscard]] QString placeName(const Bars& bars) const;

    BatchOutcomePtr m_outcome;
    SobolIndicesPtr m_indices;
    std::string m_name;
    SensitivityKind m_kind = SensitivityKind::ranks;
    std::vector<Bars> m_bars;
};

} // namespace sparkout
