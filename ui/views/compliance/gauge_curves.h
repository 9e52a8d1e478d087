// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/gauge_placement.h"
#include "core/study/outcome.h"
#include "ui/plot/line_chart.h"

#include <QCoreApplication>

#include <functional>
#include <memory>
#include <vector>

namespace sparkout {

using GaugePlacementPtr = std::shared_ptr<const GaugePlacement>;

/// The diameters of all zones or sections over the place of the gauge, the one farthest from the
/// middle of the tolerance, the best place and the current one.
class GaugeCurves {
    Q_DECLARE_TR_FUNCTIONS(GaugeCurves)
public:
    static constexpr int spreadKey = 200, farthestKey = 201, bestKey = 202, presentKey = 203,
                         limitsKey = 204, sectionKey = 300; ///< keys of the legend; sections follow

    GaugeCurves() = default;
    /// @param outcome the run with the gauge at `present_mm`
    GaugeCurves(GaugePlacementPtr placement, OutcomePtr outcome, double present_mm);

    [[nodiscard]] const GaugePlacement* placement() const { return m_placement.get(); }
    [[nodiscard]] const GaugePosition* best() const;
    /// The greatest distance of a diameter from the middle of the tolerance [µm].
    [[nodiscard]] double farthest_um(const GaugePosition& position) const;
    [[nodiscard]] double farthestNow_um() const; ///< in the shown run
    [[nodiscard]] LineChart chart() const;

private:
    /// A position of the gauge at a place: in traverse each represents its zone.
    struct Place {
        double x_mm;
        const GaugePosition* position;
    };
    using Value = std::function<double(const GaugePosition&)>;

    [[nodiscard]] std::vector<Place> drawn() const;
    /// Values at the places of completed cycles, with gaps at the others.
    [[nodiscard]] std::vector<XY> lineOf(const Value& value) const;
    [[nodiscard]] std::vector<ChartSeries> sections() const;
    [[nodiscard]] double fromMiddle_um(double deviation_mm) const;
    [[nodiscard]] QString nameOf(std::size_t section) const;
    [[nodiscard]] ChartTable table() const;
    [[nodiscard]] QString valuesAt(double x_mm) const;

    GaugePlacementPtr m_placement;
    OutcomePtr m_outcome;
    double m_present_mm = 0;
};

} // namespace sparkout
