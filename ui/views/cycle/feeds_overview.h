// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QWidget>

namespace sparkout {

class FeedsPlot;

/// The whole cycle in a thin strip: stages, the actual feed of every column, and a window that
/// marks the visible range. The window can be moved and its edges dragged; a click elsewhere brings
/// it there, the wheel zooms, a double click shows everything. Keys: arrows move, with Shift they
/// move the end, with Ctrl the beginning; Home shows everything.
class FeedsOverview : public QWidget {
    Q_OBJECT
public:
    explicit FeedsOverview(const FeedsPlot& plot, QWidget* parent = nullptr);

    void showRun();                 ///< the curves changed: run, axis, palette or language
    void followPlot() { update(); } ///< the visible range has changed
    void retranslate();
    [[nodiscard]] QRectF window() const; ///< in widget coordinates
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

signals:
    void timesAsked(double from_s, double to_s); ///< also while dragging
    void dragged();                              ///< a drag, a click or a key press ended
    void fitAsked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Part { outside, begin, end, middle };
    [[nodiscard]] Part partAt(double x) const;
    [[nodiscard]] double pixelOf(double time_s) const;
    [[nodiscard]] double wholeRange() const; ///< range of the axis
    /// Requests a range of the axis, limited to the cycle.
    void ask(double from, double to);
    void drawCurves();

    const FeedsPlot& m_plot;
    QPixmap m_curves;
    Part m_dragged = Part::outside;
    double m_grip = 0;           ///< axis position at the beginning of the drag
    double m_from = 0, m_to = 0; ///< window at the beginning of the drag
};

} // namespace sparkout
