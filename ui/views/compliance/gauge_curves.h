// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/gauge_placement.h"
#include "core/study/outcome.h"
#include "ui/views/compliance/length_curves.h"

#include <memory>
#include <optional>

namespace sparkout {

using GaugePlacementPtr = std::shared_ptr<const GaugePlacement>;

/// The diameters of all zones or sections over the place of the gauge, the one farthest from the
/// middle of the field, the best place and the present one.
class GaugeCurves : public LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(GaugeCurves)
public:
    static constexpr int spreadKey = 200, farthestKey = 201, bestKey = 202, presentKey = 203,
                         sectionKey = 300; ///< of the legend; sections count on

    GaugeCurves(ViewPlot& plot, QCPAxisRect& rect);

    /// @param outcome the run whose gauge stands at `present_mm`
    void show(GaugePlacementPtr placement, OutcomePtr outcome, double present_mm);

    [[nodiscard]] const GaugePlacement* placement() const { return m_placement.get(); }
    [[nodiscard]] const GaugePosition* best() const;
    /// Of all diameters the greatest distance from the middle of the field [µm].
    [[nodiscard]] double farthest_um(const GaugePosition& position) const;
    [[nodiscard]] double farthestNow_um() const; ///< in the run shown
    [[nodiscard]] QCPGraph* farthestGraph() const { return m_farthest; }
    [[nodiscard]] QCPGraph* bestGraph() const { return m_best; }
    [[nodiscard]] QCPGraph* presentGraph() const { return m_present; }

    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] QString valuesAt(double x_mm) const override;
    [[nodiscard]] QString placeLabel() const override;
    void restyle() override;

private:
    /// A position of the gauge drawn at a place: in traverse each stands for its zone.
    struct Drawn {
        double x_mm;
        const GaugePosition* position;
    };
    [[nodiscard]] std::vector<Drawn> drawn() const;
    [[nodiscard]] std::vector<std::size_t> drawnSections() const;
    [[nodiscard]] QString nameOf(std::size_t section) const;
    [[nodiscard]] QColor colourOf(std::size_t section) const;
    void drawSections(const std::vector<Drawn>& places, const QVector<double>& x);

    GaugePlacementPtr m_placement;
    OutcomePtr m_outcome;
    QCPGraph* m_lowest;
    QCPGraph* m_highest;
    QCPGraph* m_farthest;
    QCPGraph* m_present;
    QCPGraph* m_best;
    std::vector<QCPGraph*> m_sections;
};

} // namespace sparkout
