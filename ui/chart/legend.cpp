// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/legend.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <QStyleOptionFocusRect>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int sample = 22;
constexpr int sampleGap = 5;
constexpr int between = 10;
constexpr int swatchHeight = 10;
constexpr int haloWidth = 4;
constexpr double hiddenOpacity = 0.45; ///< opacity of hidden entries

int textWidth(const QString& text, const QFontMetrics& metrics) {
    return metrics.horizontalAdvance(text) + 2;
}

/// The size of a text broken between words into lines of at most `width`.
QSize wrappedSize(const QString& text, const QFontMetrics& metrics, int width) {
    constexpr int unlimited = 100'000;
    return metrics.boundingRect(QRect(0, 0, width, unlimited), Qt::TextWordWrap, text).size();
}

} // namespace

std::vector<QRect> legendRects(const LegendEntries& entries, const QFontMetrics& metrics,
                               int width) {
    std::vector<QRect> rects;
    const int line = metrics.height() + 2;
    int x = 0, y = 0, below = line;
    for (const LegendEntry& e : entries) {
        const int full = sample + sampleGap + textWidth(e.text, metrics);
        const int w = std::min(full, width);
        if (x > 0 && x + w > width) {
            x = 0;
            y += below;
            below = line;
        }
        if (full > width) { // alone in its row
            below = std::max(line,
                             wrappedSize(e.text, metrics, width - sample - sampleGap).height() + 2);
        }
        rects.emplace_back(x, y, w, below);
        x += w + between;
    }
    return rects;
}

int legendHeight(const std::vector<QRect>& rects) {
    return rects.empty() ? 0 : rects.back().bottom() + 1;
}

namespace {

void drawSwatch(QPainter& painter, const LegendEntry& entry, const QRectF& swatch) {
    if (entry.swatch == Swatch::area) {
        painter.fillRect(swatch, entry.colour);
        paintHatch(painter, swatch.toRect(), entry.hatch, entry.hatchLine);
        return;
    }
    const QPointF at = swatch.center();
    const double reach = swatch.height() / 2;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(entry.colour, 2));
    painter.setBrush(Qt::NoBrush);
    if (entry.swatch == Swatch::square) {
        painter.drawRect(QRectF(at.x() - reach, at.y() - reach, 2 * reach, 2 * reach));
    } else if (entry.swatch == Swatch::arrow) {
        painter.drawLine(at + QPointF(0, reach), at + QPointF(0, -reach));
        painter.drawPolyline(
            QPolygonF({at + QPointF(-reach, 0), at + QPointF(0, -reach), at + QPointF(reach, 0)}));
    } else {
        painter.drawPolygon(QPolygonF({at + QPointF(0, -reach), at + QPointF(reach, 0),
                                       at + QPointF(0, reach), at + QPointF(-reach, 0)}));
    }
}

} // namespace

void drawLegendEntry(QPainter& painter, const LegendEntry& entry, const QRect& rect,
                     const QColor& textColour) {
    painter.save();
    painter.setOpacity(entry.shown ? 1 : hiddenOpacity);
    const int middle = rect.top() + (QFontMetrics(painter.font()).height() + 1) / 2;
    if (entry.pen == Qt::NoPen) {
        const QRect swatch(rect.left() + 4, middle - swatchHeight / 2 + 1, sample - 8,
                           swatchHeight);
        drawSwatch(painter, entry, swatch);
    } else {
        QPen pen(entry.colour, entry.weight, entry.pen, Qt::FlatCap);
        if (!entry.dash.isEmpty()) {
            pen.setDashPattern(entry.dash);
        }
        if (entry.halo.isValid()) {
            painter.setPen(QPen(entry.halo, haloWidth, Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(rect.left(), middle, rect.left() + sample, middle);
        }
        painter.setPen(pen);
        painter.drawLine(rect.left(), middle, rect.left() + sample, middle);
    }
    painter.setPen(textColour);
    QFont font = painter.font();
    font.setStrikeOut(!entry.shown);
    painter.setFont(font);
    const QRect text = rect.adjusted(sample + sampleGap, 0, 0, 0);
    const QFontMetrics metrics(font);
    const int align = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip;
    const bool wraps = textWidth(entry.text, metrics) > text.width()
                       && wrappedSize(entry.text, metrics, text.width()).width() <= text.width();
    painter.drawText(text, wraps ? align | Qt::TextWordWrap : align,
                     wraps ? entry.text
                           : metrics.elidedText(entry.text, Qt::ElideRight, text.width()));
    painter.restore();
}

void CurveChoice::toggle(int key) {
    if (m_hidden.erase(key) == 0) {
        m_hidden.insert(key);
    }
}

void CurveChoice::only(int key, const LegendEntries& entries) {
    std::set<int> others;
    for (const LegendEntry& e : entries) {
        if (e.key >= 0 && e.key != key) {
            others.insert(e.key);
        }
    }
    m_hidden = m_hidden == others ? std::set<int>() : others;
}

LegendStrip::LegendStrip(QWidget* parent) : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
    retranslate();
}

void LegendStrip::retranslate() {
    setToolTip(tr("Click: hide or show the curve. Ctrl+click: show only this one. Keyboard: "
                  "arrows, Space, Ctrl+Space."));
    tell();
}

void LegendStrip::setEntries(LegendEntries entries) {
    m_entries = std::move(entries);
    if (m_current >= static_cast<int>(m_entries.size())) {
        m_current = -1;
    }
    tell();
    setFixedHeight(heightForWidth(std::max(width(), 100)));
    update();
}

/// The entries in words, for a screen reader.
void LegendStrip::tell() {
    QStringList texts;
    for (const LegendEntry& e : m_entries) {
        texts << (!e.shown                    ? tr("%1 (hidden)").arg(e.text)
                  : e.swatch == Swatch::arrow ? tr("%1 (above the plot)").arg(e.text)
                                              : e.text);
    }
    if (m_current >= 0) {
        texts.prepend(tr("chosen: %1").arg(texts[m_current]));
    }
    setAccessibleDescription(texts.join(QStringLiteral("; ")));
}

QRect LegendStrip::entryRect(int index) const {
    return legendRects(m_entries, fontMetrics(), width()).at(static_cast<std::size_t>(index));
}

int LegendStrip::entryAt(const QPoint& at) const {
    const std::vector<QRect> rects = legendRects(m_entries, fontMetrics(), width());
    const auto hit =
        std::ranges::find_if(rects, [&](const QRect& rect) { return rect.contains(at); });
    const auto index = static_cast<std::size_t>(hit - rects.begin());
    return hit != rects.end() && m_entries[index].key >= 0 ? static_cast<int>(index) : -1;
}

void LegendStrip::activate(int index, bool only) {
    if (index < 0) {
        return;
    }
    const int key = m_entries[static_cast<std::size_t>(index)].key;
    only ? emit onlyAsked(key) : emit toggled(key);
}

int LegendStrip::heightForWidth(int width) const {
    return legendHeight(legendRects(m_entries, fontMetrics(), width));
}

QSize LegendStrip::sizeHint() const {
    return {300, heightForWidth(std::max(width(), 300))};
}

QSize LegendStrip::minimumSizeHint() const {
    return {100, 0};
}

void LegendStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setFixedHeight(heightForWidth(width()));
}

void LegendStrip::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        setFixedHeight(heightForWidth(width()));
    } else if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void LegendStrip::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        activate(entryAt(event->pos()), event->modifiers().testFlag(Qt::ControlModifier));
    }
}

void LegendStrip::mouseMoveEvent(QMouseEvent* event) {
    entryAt(event->pos()) >= 0 ? setCursor(Qt::PointingHandCursor) : unsetCursor();
}

/// Moves to the next clickable entry in the direction of the step.
void LegendStrip::choose(int step) {
    const int count = static_cast<int>(m_entries.size());
    int at = m_current < 0 && step < 0 ? count : m_current;
    for (at += step; at >= 0 && at < count; at += step) {
        if (m_entries[static_cast<std::size_t>(at)].key >= 0) {
            m_current = at;
            tell();
            update();
            return;
        }
    }
}

void LegendStrip::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up: choose(-1); return;
    case Qt::Key_Right:
    case Qt::Key_Down: choose(1); return;
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        activate(m_current, event->modifiers().testFlag(Qt::ControlModifier));
        return;
    default: QWidget::keyPressEvent(event);
    }
}

void LegendStrip::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    if (m_current < 0) {
        choose(1);
    }
}

void LegendStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const std::vector<QRect> rects = legendRects(m_entries, fontMetrics(), width());
    for (std::size_t i = 0; i < rects.size(); ++i) {
        drawLegendEntry(painter, m_entries[i], rects[i], palette().color(QPalette::WindowText));
    }
    if (hasFocus() && m_current >= 0) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        focus.rect = rects[static_cast<std::size_t>(m_current)];
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

} // namespace sparkout
