// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/legend_strip.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <QStyleOptionFocusRect>

#include <algorithm>

namespace sparkout {

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
        texts << (e.shown ? e.text : tr("%1 (hidden)").arg(e.text));
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
