// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/legend_strip.h"

#include <QEvent>
#include <QFontMetrics>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int sample = 22;
constexpr int gap = 5;
constexpr int between = 14;
} // namespace

LegendStrip::LegendStrip(QWidget* parent) : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void LegendStrip::setEntries(std::vector<LegendEntry> entries) {
    m_entries = std::move(entries);
    QStringList texts;
    for (const LegendEntry& e : m_entries) {
        texts << e.text;
    }
    setAccessibleDescription(texts.join(QStringLiteral("; ")));
    setFixedHeight(heightForWidth(std::max(width(), 100)));
    update();
}

std::vector<QRect> LegendStrip::layOut(int width) const {
    std::vector<QRect> rects;
    const QFontMetrics metrics(font());
    const int height = metrics.height() + 2;
    int x = 0, y = 0;
    for (const LegendEntry& e : m_entries) {
        const int w = std::min(sample + gap + metrics.horizontalAdvance(e.text), width);
        if (x > 0 && x + w > width) {
            x = 0;
            y += height;
        }
        rects.emplace_back(x, y, w, height);
        x += w + between;
    }
    return rects;
}

int LegendStrip::heightForWidth(int width) const {
    const std::vector<QRect> rects = layOut(width);
    return rects.empty() ? 0 : rects.back().bottom() + 1;
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
    }
}

QRect LegendStrip::entryRect(int index) const {
    return layOut(width()).at(static_cast<std::size_t>(index));
}

void LegendStrip::mousePressEvent(QMouseEvent* event) {
    const std::vector<QRect> rects = layOut(width());
    for (std::size_t i = 0; i < rects.size() && event->button() == Qt::LeftButton; ++i) {
        if (m_entries[i].key >= 0 && rects[i].contains(event->pos())) {
            const bool only = event->modifiers().testFlag(Qt::ControlModifier);
            only ? emit onlyAsked(m_entries[i].key) : emit toggled(m_entries[i].key);
            return;
        }
    }
}

void LegendStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QFont struck = font();
    struck.setStrikeOut(true);
    const std::vector<QRect> rects = layOut(width());
    for (std::size_t i = 0; i < rects.size(); ++i) {
        const LegendEntry& e = m_entries[i];
        const QRect& r = rects[i];
        painter.setOpacity(e.shown ? 1 : 0.5);
        painter.setFont(e.shown ? font() : struck);
        if (e.pen == Qt::NoPen) {
            painter.fillRect(QRect(r.left() + 4, r.center().y() - 4, sample - 8, 10), e.colour);
        } else {
            painter.setPen(QPen(e.colour, 2, e.pen));
            painter.drawLine(r.left(), r.center().y(), r.left() + sample, r.center().y());
        }
        painter.setPen(palette().color(QPalette::WindowText));
        const QRect text = r.adjusted(sample + gap, 0, 0, 0);
        const bool fits = r.width() < width();
        painter.drawText(
            text, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
            fits ? e.text : painter.fontMetrics().elidedText(e.text, Qt::ElideRight, text.width()));
    }
}

} // namespace sparkout
