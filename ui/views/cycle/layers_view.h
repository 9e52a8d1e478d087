// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/stock_layers.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/legend.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/plot_view.h"

#include <QCoreApplication>
#include <QPalette>
#include <QString>

#include <optional>

class QComboBox;
class QLabel;

namespace sparkout {

/// Colours and words that the stacked layers and their surface share.
class LayersLook {
    Q_DECLARE_TR_FUNCTIONS(LayersLook)
public:
    [[nodiscard]] static QColor stage(int stage, const QPalette& palette); ///< counted from 1
    /// The colour of a layer, lighter for every other one, so that neighbours differ.
    [[nodiscard]] static QColor layer(const LayerSeries& series, std::size_t span,
                                      const QPalette& palette);
    /// The zones or sections along the length, by rising length.
    [[nodiscard]] static std::vector<Band> zoneBands(const LayerSeries& series);
    [[nodiscard]] static QColor uncut(const QPalette& palette); ///< stock still to be removed
    /// A swatch for each stage; the key is its number.
    [[nodiscard]] static LegendEntries stages(const LayerSeries& series, const CurveChoice& choice,
                                              const QPalette& palette);
    /// "Double strokes 3…5, stage 1".
    [[nodiscard]] static QString spanName(const LayerSeries& series, std::size_t span);
    /// The layer of a zone or section in words and numbers.
    [[nodiscard]] static QString values(const LayerSeries& series, const LayersDone& done,
                                        std::size_t column, std::size_t span);
};

/// A plot with one cell: the part's length over its axis of rotation, with its zones or sections as
/// bands; radii from the target in micrometres, far above the axis, which is drawn in a strip below
/// the cell after a break line.
class PartPlot : public ChartPlot {
    Q_OBJECT
public:
    void restyle() override;

    [[nodiscard]] QRect painted() const; ///< the cell and the strip below it
    [[nodiscard]] int stripHeight() const;
    void drawPartAxis(QCPPainter& painter) const;

protected:
    explicit PartPlot(QWidget* parent) : ChartPlot(parent) {}

    [[nodiscard]] virtual const LayerSeries& zones() const = 0; ///< series with the bands
    [[nodiscard]] LineChart partChart() const;                  ///< axes and bands, without series
    void setTexts() override;
};

/// The stock in a section along the part's axis, layer on layer, from the blank to the final
/// radius, with the tolerance; stock not cut yet is shown as metal.
class LayersPlot : public PartPlot {
    Q_OBJECT
public:
    /// Keys of the legend, in addition to the numbers of the stages.
    enum Key { fieldKey = 1000, targetKey, blankKey, finalKey };

    explicit LayersPlot(QWidget* parent = nullptr);

    void setSeries(LayerSeries series); ///< no replot
    void setDone(LayersDone done);      ///< up to the moment of the cycle; no replot

    [[nodiscard]] const LayerSeries& series() const { return m_series; }
    [[nodiscard]] const LayersDone& done() const { return m_done; }
    /// Radius of a column after this number of layers.
    [[nodiscard]] double radiusAfter_mm(std::size_t column, std::size_t count) const;
    /// The rectangle of a layer; empty if it is hidden or not cut yet.
    [[nodiscard]] QRectF layerRect(std::size_t column, std::size_t span) const;
    [[nodiscard]] LegendEntries legendEntries() const override;

signals:
    void strokeClicked(int stroke); ///< last stroke of the layer

private:
    struct Hit {
        std::size_t column, span;
    };
    [[nodiscard]] const LayerSeries& zones() const override { return m_series; }
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    [[nodiscard]] LineChart made() const;
    [[nodiscard]] ChartTable doneTable() const;
    [[nodiscard]] double above_um(double radius_mm) const; ///< height above the target
    [[nodiscard]] std::optional<Hit> layerAt(const QPointF& at) const;

    LayerSeries m_series;
    LayersDone m_done;
};

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
