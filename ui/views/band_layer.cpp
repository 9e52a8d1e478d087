// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/band_layer.h"

#include <algorithm>
#include <functional>

namespace sparkout {

namespace {
constexpr int nameLines = 2;
constexpr double nameGap = 3;
constexpr double leastBand = 2; ///< narrower bands are not named [px]
} // namespace

BandLayer::BandLayer(QCPAxisRect* rect, bool showNames)
    : QCPLayerable(rect->parentPlot(), QStringLiteral("bands"))
    , m_rect(rect)
    , m_showNames(showNames) {}

const Band* BandLayer::bandAt(double x) const {
    const auto it =
        std::ranges::find_if(m_bands, [x](const Band& b) { return b.from <= x && x < b.to; });
    return it == m_bands.end() ? nullptr : &*it;
}

int BandLayer::nameMargin(const QFont& font) {
    return nameLines * QFontMetrics(font).height() + 4;
}

void BandLayer::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(false);
}

QRect BandLayer::clipRect() const {
    return mParentPlot->viewport();
}

void BandLayer::draw(QCPPainter* painter) {
    const QCPAxis* axis = m_rect->axis(QCPAxis::atBottom);
    const QRectF area = m_rect->rect();
    painter->setPen(Qt::NoPen);
    for (const Band& band : m_bands) {
        const double from = std::max(axis->coordToPixel(band.from), area.left());
        const double to = std::min(axis->coordToPixel(band.to), area.right() + 1);
        if (to > from) {
            painter->setBrush(band.colour);
            painter->drawRect(QRectF(from, area.top(), to - from, area.height()));
        }
    }
    m_drawnNames.clear();
    if (m_showNames) {
        drawNames(painter, area);
    }
}

void BandLayer::drawNames(QCPPainter* painter, const QRectF& area) {
    const QCPAxis* axis = m_rect->axis(QCPAxis::atBottom);
    const QFontMetricsF metrics(mParentPlot->font());
    painter->setFont(mParentPlot->font());
    painter->setPen(mParentPlot->palette().color(QPalette::Text));
    struct Name {
        double from, to, width;
        const QString* text;
    };
    std::vector<Name> names;
    for (const Band& band : m_bands) {
        const double from = std::max(axis->coordToPixel(band.from), area.left());
        const double to = std::min(axis->coordToPixel(band.to), area.right() + 1);
        const double width = metrics.horizontalAdvance(band.name);
        if (to >= from + leastBand && !band.name.isEmpty() && width < area.width()) {
            names.push_back({from, to, width, &band.name});
        }
    }
    // Wide bands are named first: where room is short, they matter most.
    std::ranges::stable_sort(names, std::greater{}, [](const Name& n) { return n.to - n.from; });
    std::vector<QRectF> taken;
    for (const Name& name : names) {
        const double left = std::clamp((name.from + name.to - name.width) / 2, area.left(),
                                       area.right() - name.width);
        for (int line = 0; line < nameLines; ++line) {
            const double bottom = area.top() - 2 - line * metrics.height();
            const QRectF box(left, bottom - metrics.height(), name.width, metrics.height());
            const QRectF wide = box.adjusted(-nameGap, 1, nameGap, -1);
            if (std::ranges::none_of(taken, [&](const QRectF& t) { return t.intersects(wide); })) {
                taken.push_back(box);
                painter->drawText(QPointF(left, bottom - metrics.descent()), *name.text);
                m_drawnNames << *name.text;
                break;
            }
        }
    }
}

} // namespace sparkout
