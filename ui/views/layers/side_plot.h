// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/grinding_scene.h"
#include "core/study/outcome.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/view_plot.h"
#include "ui/tables/csv_table.h"

namespace sparkout {

class BandLayer;
class SideScene;

/// Wheel and part from the side at a moment of the cycle, heights exaggerated: the surface that the
/// wheel meets, how far it gives way, the tolerance field and the gauge.
class SidePlot : public ViewPlot {
    Q_OBJECT
public:
    /// Keys of the legend.
    enum Key { wheelKey, surfaceKey, unloadedKey, fieldKey };

    explicit SidePlot(QWidget* parent = nullptr);

    void setRun(OutcomePtr outcome);    ///< no replot
    void setScene(GrindingScene scene); ///< no replot
    void fit();
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle() override;

    [[nodiscard]] const GrindingScene& scene() const { return m_scene; }
    [[nodiscard]] const LayerSeries& limits() const; ///< of the run: target and field
    [[nodiscard]] bool shows(Key key) const { return m_choice.shows(key); }
    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] QColor colourOf(Key key) const;
    [[nodiscard]] double above_um(double radius_mm) const; ///< the target: as it is drawn
    /// Radius at which a surface is seen, given way.
    [[nodiscard]] double seen_mm(const SceneSurface& surface) const;
    /// Where the wheel is painted.
    [[nodiscard]] QRectF wheelRect() const;
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] QString values() const; ///< the balance under the wheel in one sentence
    [[nodiscard]] CsvTable table() const; ///< one row a zone or section

private:
    void setTexts() override;
    void fillBands();

    OutcomePtr m_outcome;
    GrindingScene m_scene;
    CurveChoice m_choice;
    QCPAxisRect* m_rect = nullptr;
    BandLayer* m_bands = nullptr;
    SideScene* m_painted = nullptr;
};

} // namespace sparkout
