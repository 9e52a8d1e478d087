// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/csv_table.h"
#include "ui/views/layers_look.h"

#include <qcustomplot.h>

#include <optional>

namespace sparkout {

class BandLayer;
class LayerStack;

/// The stock in a section along the part's axis, layer on layer, from the blank to the final
/// radius, with the tolerance field; what the cycle has not cut yet is still metal.
class LayersPlot : public QCustomPlot {
    Q_OBJECT
public:
    /// Keys of the legend beside the numbers of the stages.
    enum Key { fieldKey = 1000, targetKey, blankKey, finalKey };

    explicit LayersPlot(QWidget* parent = nullptr);

    void setSeries(LayerSeries series); ///< no replot
    void setDone(LayersDone done);      ///< up to where the cycle stands; no replot
    void setDimmed(bool dim);
    void fit();
    void toggleCurve(int key);
    void showOnly(int key);
    void retranslate();
    void restyle();

    [[nodiscard]] const LayerSeries& series() const { return m_series; }
    [[nodiscard]] bool isDimmed() const { return m_dim; }
    [[nodiscard]] QCPAxisRect* cell() const { return m_rect; }
    [[nodiscard]] QCPGraph* graph(Key key) const; ///< of the field the upper limit
    [[nodiscard]] const CurveChoice& choice() const { return m_choice; }
    [[nodiscard]] const LayersDone& done() const { return m_done; }
    /// Radius of a column after so many of the layers done.
    [[nodiscard]] double radiusAfter_mm(std::size_t column, std::size_t count) const;
    /// Where a layer is painted; empty when it is hidden or not cut yet.
    [[nodiscard]] QRectF layerRect(std::size_t column, std::size_t span) const;
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] CsvTable table() const;

signals:
    void contentChanged();             ///< of the legend
    void pointed(const QString& text); ///< empty: at nothing
    void strokeClicked(int stroke);    ///< the last of the layer

protected:
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Hit {
        std::size_t column, span;
    };
    void build();
    void fill();
    void fillBands();
    void show();
    [[nodiscard]] std::optional<Hit> layerAt(const QPointF& at) const;
    void onMouse(QMouseEvent* event);

    LayerSeries m_series;
    CurveChoice m_choice;
    QCPAxisRect* m_rect = nullptr;
    BandLayer* m_bands = nullptr;
    LayerStack* m_stack = nullptr;
    QCPGraph *m_lower = nullptr, *m_upper = nullptr;
    QCPGraph *m_target = nullptr, *m_blank = nullptr, *m_final = nullptr;
    LayersDone m_done;
    bool m_dim = false;
};

} // namespace sparkout
