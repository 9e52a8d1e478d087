// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/bar_drawing.h"
#include "ui/chart/view_plot.h"

#include <cstddef>
#include <optional>

namespace sparkout {

/// A plot with a chart of bars, boxes or slices: bars are read and activated by mouse and keyboard;
/// otherwise it is like every plot of a view, but without a movable range.
class BarPlot : public ViewPlot {
    Q_OBJECT
public:
    explicit BarPlot(QWidget* parent = nullptr);
    ~BarPlot() override;

    void setChart(BarChart chart); ///< no replot
    [[nodiscard]] const BarChart& chart() const { return m_drawing.chart(); }
    /// The last painted bars, in the order of the categories.
    [[nodiscard]] const BarDrawing& drawing() const { return m_drawing; }
    [[nodiscard]] bool shows(std::size_t series) const;
    /// Whether activating a bar leads somewhere, which its read-out shows.
    void setLeads(bool leads) { m_leads = leads; }

    void fit() override {} ///< all of it is always visible
    void restyle() override;
    PlotTools& addTools(PlotSubject subject, Settings* settings) override;
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] CsvTable table() const override;

signals:
    void entered(std::size_t series, std::size_t category); ///< a bar, by a click or Enter

protected:
    void showChoice() override;
    [[nodiscard]] LegendEntries besides(int key) const override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    [[nodiscard]] virtual QString described(const BarPart& part) const; ///< as text
    void onMouse(QMouseEvent* event) override;
    void pointAway() override;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    class Layer;

    [[nodiscard]] QString describedAt(int part) const; ///< may be empty
    void choose(int part);                             ///< by keyboard
    void enter(int part);

    BarDrawing m_drawing;
    int m_chosen = -1; ///< part chosen by keyboard
    int m_pressed = -1;
    bool m_leads = false;
    bool m_stale = false; ///< not repainted while hidden
};

} // namespace sparkout
