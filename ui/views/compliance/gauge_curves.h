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
/// middle of the tolerance, the best place and the current one.
class GaugeCurves : public LengthCurves {
    Q_DECLARE_TR_FUNCTIONS(GaugeCurves)
public:
    static constexpr int spreadKey = 200, farthestKey = 201, bestKey = 202, presentKey = 203,
                         sectionKey = 300; ///< keys of the legend; sections follow

    GaugeCurves(ViewPlot& plot, QCPAxisRect& rect);

    /// @param outcome the run with the gauge at `present_mm`
    void show(GaugePlacementPtr placement, OutcomePtr outcome, double present_mm);

    [[nodiscard]] const GaugePlacement* placement() const { return m_placement.get(); }
    [[nodiscard]] const GaugePosition* best() const;
    /// The greatest distance of a diameter from the middle of the tolerance [µm].
    [[nodiscard]] double farthest_um(const GaugePosition& position) const;
    [[nodiscard]] double farthestNow_um() const; ///< for the shown run
    [[nodiscard]] QCPGraph* farthestGraph() const { return m_farthest; }
    [[nodiscard]] QCPGraph* bestGraph() const { return m_best; }
    [[nodiscard]] QCPGraph* presentGraph() const { return m_present; }

    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] QString valuesAt(double x_mm) const override;
    [[nodiscard]] QString placeLabel() const override;
    void restyle() override;

private:
    /// A position of the gauge and where it is drawn: in traverse it represents a zone.
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
