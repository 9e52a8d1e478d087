// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/view.h"

#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;

namespace sparkout {

class LayersPlot;
class LayersSurface;
class LegendStrip;
class PlotPages;
class PlotTools;
class SidePlot;
class Settings;

/// The view "Layers": the stock as it comes off, double stroke by double stroke or revolution by
/// revolution, up to the cycle's moment; in a section along the axis, as a surface that can be
/// turned, or with the wheel that takes it off. A click on a layer brings the cycle there.
class LayersView : public View {
    Q_OBJECT
public:
    explicit LayersView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] LayersPlot* plot() const { return m_plot; }
    [[nodiscard]] LayersSurface* surface() const { return m_surface; }
    [[nodiscard]] SidePlot* side() const { return m_side; }
    [[nodiscard]] PlotTools* tools() const; ///< of what is shown
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    void retranslate() override;

protected:
    [[nodiscard]] QString hint() const override;
    void recolour() override;
    void showOutcome() override;
    void followCycle() override;

private:
    void build();
    void buildTools(QWidget* bar);
    void connectParts();
    void chooseContent();
    void setSeries(); ///< of the chosen radius
    void showDone();
    void fillRadii();
    void showState();
    void replotShown();
    [[nodiscard]] QString notice() const;
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QStringList heading() const;

    LayersPlot* m_plot;
    LayersSurface* m_surface;
    SidePlot* m_side;
    LegendStrip* m_legend;
    PlotPages* m_pages = nullptr;
    QComboBox* m_radius;
    QLabel* m_summary;
    QLabel* m_notice;
    QLabel* m_values;
    OutcomePtr m_good;           ///< what is shown
    std::optional<int> m_wanted; ///< k of the radius the user chose
};

} // namespace sparkout
