// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_view.h"

#include <optional>

class QComboBox;
class QLabel;

namespace sparkout {

class LayersPlot;
class LayersSurface;
class SidePlot;

/// The view "Layers": the removal of the stock, double stroke by double stroke or revolution by
/// revolution, up to the cycle's moment; in a section along the axis, as a surface that can be
/// turned, or with the wheel. A click on a layer moves the cycle there.
class LayersView : public PlotView {
    Q_OBJECT
public:
    explicit LayersView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] LayersPlot* plot() const { return m_plot; }
    [[nodiscard]] LayersSurface* surface() const { return m_surface; }
    [[nodiscard]] SidePlot* side() const { return m_side; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool showsMoment() const override { return true; }

protected:
    [[nodiscard]] QString hint() const override;
    void nameParts() override;
    void takeOutcome(const OutcomePtr& before) override;
    [[nodiscard]] bool drawn() const override;
    void showState() override;
    void followCycle() override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;

private:
    void connectTools();
    void chooseContent();
    void setSeries(); ///< for the chosen radius
    void showDone();
    void fillRadii();
    [[nodiscard]] QString summary() const;

    LayersPlot* m_plot;
    LayersSurface* m_surface;
    SidePlot* m_side;
    QComboBox* m_radius;
    QLabel* m_summary;
    std::optional<int> m_wanted; ///< k of the radius chosen by the user
};

} // namespace sparkout
