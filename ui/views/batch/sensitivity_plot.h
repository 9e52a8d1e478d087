// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view_plot.h"
#include "ui/session/batch_runner.h"

#include <string>
#include <vector>

namespace sparkout {

/// How the weight of a factor is stated.
enum class SensitivityKind { ranks, sobol };

/// Which factor matters most for one characteristic of a batch: a row a factor, a bar a zone or
/// section. Coefficients of the standardised rank regression with their signs, or Sobol indices,
/// the first-order one within the total one.
class SensitivityPlot : public ViewPlot {
    Q_OBJECT
public:
    explicit SensitivityPlot(QWidget* parent = nullptr);

    void setBatch(BatchOutcomePtr outcome, const std::string& name); ///< no replot
    void setIndices(SobolIndicesPtr indices);                        ///< of the same batch, or null
    void setKind(SensitivityKind kind);
    void fit() override;
    void restyle() override;

    [[nodiscard]] SensitivityKind kind() const { return m_kind; }
    [[nodiscard]] bool empty() const { return m_bars.empty(); } ///< nothing could be said
    [[nodiscard]] LegendEntries legendEntries() const override; ///< keys: places, in order
    [[nodiscard]] CsvTable table() const override;
    /// Of every characteristic that has them.
    [[nodiscard]] static CsvTable ranksTable(const BatchOutcome& outcome);
    [[nodiscard]] static CsvTable sobolTable(const BatchOutcome& outcome,
                                             const SobolIndices& indices);
    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    /// The weight that is drawn, of a place in the drawn order: the coefficient, or the total.
    [[nodiscard]] double weight(std::size_t place, std::size_t factor) const;

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    /// What is drawn of one place.
    struct Bars {
        std::size_t characteristic;       ///< of the summary
        std::vector<double> inner, outer; ///< by factor; of ranks both are the coefficient
        double determination = 0;         ///< R² of the ranks
        QCPBars* innerBars = nullptr;
        QCPBars* outerBars = nullptr;
    };
    void fill();
    void draw(Bars& bars, std::size_t place);
    void nameFactors();
    [[nodiscard]] double barWidth() const;
    [[nodiscard]] double barAt(std::size_t place, std::size_t factor) const; ///< on the axis
    [[nodiscard]] QString placeName(const Bars& bars) const;

    BatchOutcomePtr m_outcome;
    SobolIndicesPtr m_indices;
    std::string m_name;
    SensitivityKind m_kind = SensitivityKind::ranks;
    QCPAxisRect* m_rect = nullptr;
    std::vector<Bars> m_bars;
};

} // namespace sparkout
