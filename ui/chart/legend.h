// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"

#include <QColor>
#include <QFontMetrics>
#include <QRect>
#include <QString>
#include <QVector>
#include <QWidget>

#include <set>
#include <vector>

class QPainter;

namespace sparkout {

/// Filled, the mark of a point, or the arrow of a curve that lies above the plot.
enum class Swatch { area, square, rhombus, arrow };

struct LegendEntry {
    QColor colour;
    Qt::PenStyle pen = Qt::SolidLine; ///< NoPen: a swatch
    QString text;
    int key = -1;                 ///< key that a click hides or shows; negative: none
    bool shown = true;            ///< false: hidden by the user, drawn faintly
    QVector<qreal> dash = {};     ///< dashes of the line, in pen widths; empty: those of `pen`
    QColor halo = {};             ///< outline of the line; none by default
    Swatch swatch = Swatch::area; ///< used without a line
    Hatch hatch = Hatch::none;    ///< pattern over a swatch
    QColor hatchLine = {};        ///< colour of the pattern's lines
    double weight = 2;            ///< width of the line
};
using LegendEntries = std::vector<LegendEntry>;

/// Rectangles of the entries in rows of at most `width`, from (0, 0); a longer text is wrapped.
[[nodiscard]] std::vector<QRect> legendRects(const LegendEntries& entries,
                                             const QFontMetrics& metrics, int width);

/// Total height of the rows.
[[nodiscard]] int legendHeight(const std::vector<QRect>& rects);

void drawLegendEntry(QPainter& painter, const LegendEntry& entry, const QRect& rect,
                     const QColor& textColour);

/// The curves hidden by the user, by the keys of the legend.
class CurveChoice {
public:
    [[nodiscard]] bool shows(int key) const { return !m_hidden.contains(key); }
    void toggle(int key);
    /// Shows only this entry; if it is the only one already, all.
    void only(int key, const LegendEntries& entries);

private:
    std::set<int> m_hidden;
};

/// A legend beside the plot that wraps its entries over several lines. A click hides or shows a
/// curve, Ctrl+click shows only this one; by keyboard: arrows choose, Space, Ctrl+Space.
class LegendStrip : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setEntries(LegendEntries entries);
    [[nodiscard]] const LegendEntries& entries() const { return m_entries; }
    [[nodiscard]] QRect entryRect(int index) const; ///< in widget coordinates
    void retranslate();

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void toggled(int key);   ///< hide or show this curve
    void onlyAsked(int key); ///< show only this one

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] int entryAt(const QPoint& at) const; ///< −1: none that can be clicked
    void activate(int index, bool only);
    void choose(int step);
    void tell();

    LegendEntries m_entries;
    int m_current = -1; ///< chosen by keyboard
};

} // namespace sparkout
