// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/grinding_scene.h"
#include "core/study/outcome.h"
#include "ui/views/cycle/layers_view.h"

namespace sparkout {

/// Wheel and part from the side at a moment of the cycle, with exaggerated heights: the surface
/// under the wheel, its deflection, the tolerance and the gauge.
class SidePlot : public PartPlot {
    Q_OBJECT
public:
    enum Key { wheelKey, surfaceKey, unloadedKey, fieldKey };

    explicit SidePlot(QWidget* parent = nullptr);

    void setRun(OutcomePtr outcome);    ///< no replot
    void setScene(GrindingScene scene); ///< no replot

    [[nodiscard]] const GrindingScene& scene() const { return m_scene; }
    [[nodiscard]] const LayerSeries& limits() const; ///< target and tolerance of the run
    [[nodiscard]] QColor colourOf(Key key) const;
    [[nodiscard]] double above_um(double radius_mm) const; ///< height above the target, as drawn
    /// Drawn radius of a surface, including its deflection.
    [[nodiscard]] double seen_mm(const SceneSurface& surface) const;
    [[nodiscard]] QRectF wheelRect() const;
    [[nodiscard]] QString values() const;          ///< the balance under the wheel in one sentence
    [[nodiscard]] CsvTable table() const override; ///< one row for each zone or section

private:
    [[nodiscard]] const LayerSeries& zones() const override { return limits(); }
    [[nodiscard]] LineChart made() const; ///< axes and legend of the scene

    OutcomePtr m_outcome;
    GrindingScene m_scene;
};

} // namespace sparkout
