// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/painted_layer.h"

#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"

#include <algorithm>

namespace sparkout {

namespace {

QString layerOf(QCustomPlot& plot) {
    if (!plot.layer(HairLine::layerName())) {
        plot.addLayer(HairLine::layerName());
        plot.layer(HairLine::layerName())->setMode(QCPLayer::lmBuffered);
    }
    return HairLine::layerName();
}

} // namespace

HairLine::HairLine(QCustomPlot& plot, Role role)
    : PaintedLayer(plot, layerOf(plot), Edges::sharp), m_role(role) {}

void HairLine::setAt(std::optional<double> x) {
    if (x != m_x) {
        m_x = x;
        layer()->replot();
    }
}

void HairLine::draw(QCPPainter* painter) {
    if (!m_x) {
        return;
    }
    const bool moment = m_role == Role::moment;
    const QColor colour =
        style::thinned(mParentPlot->palette().color(moment ? QPalette::Highlight : QPalette::Text),
                       moment ? 255 : 160);
    painter->setPen(QPen(colour, moment ? 2 : 0));
    for (const QCPAxisRect* rect : mParentPlot->axisRects()) {
        const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
        if (axis && axis->range().contains(*m_x)) {
            const double x = axis->coordToPixel(*m_x);
            painter->drawLine(QLineF(x, rect->top(), x, rect->bottom()));
        }
    }
}

namespace {
constexpr double nameGap = 4;
constexpr double namePad = 2;   ///< padding of a name's box, on both sides
constexpr double leastBand = 2; ///< narrower bands are not named [px]
} // namespace

/// A visible band and the place of its name.
struct BandLayer::Name {
    double from, to;  ///< the band's pixels
    double width;     ///< width of the box
    double left = 0;  ///< left edge of the box, once placed
    const Band* band; ///< the named band
    const QString* text;

    [[nodiscard]] bool touchesBand() const { return left < to && left + width > from; }
};

Band zoneBand(Zone zone, int section, double from, double to, int middleAlpha) {
    constexpr int endAlpha = 28;
    const bool middle = zone == Zone::nz;
    const style::Drawn drawn = middle ? style::Drawn::middleZone : style::Drawn::endZone;
    const int alpha = middle ? middleAlpha : endAlpha;
    const auto colour = [drawn, alpha](const QPalette& palette) {
        return style::filling(style::colour(drawn, palette), alpha, palette);
    };
    return {from, to, colour, Names::zone(zone, section), {}, Names::zoneFull(zone, section)};
}

BandLayer::BandLayer(QCPAxisRect* rect, bool showNames)
    : PaintedLayer(*rect, QStringLiteral("bands"), Edges::sharp), m_showNames(showNames) {
    moveToLayer(layer(), true); // behind what was there before
}

const Band* BandLayer::bandAt(double x) const {
    const auto it =
        std::ranges::find_if(m_bands, [x](const Band& b) { return b.from <= x && x < b.to; });
    return it == m_bands.end() ? nullptr : &*it;
}

QColor BandLayer::colourOf(const Band& band) const {
    return band.colour(mParentPlot->palette());
}

int BandLayer::nameMargin(const QFont& font) {
    return QFontMetrics(font).height() + 4;
}

QRect BandLayer::clipRect() const {
    return mParentPlot->viewport();
}

void BandLayer::draw(QCPPainter* painter) {
    const QCPAxis* axis = m_rect->axis(QCPAxis::atBottom);
    const QRectF area = m_rect->rect();
    painter->setPen(Qt::NoPen);
    for (std::size_t i = 0; i < m_bands.size();) {
        // Merges neighbours of one colour: each rectangle costs Qt a change of threads.
        const Band& first = m_bands[i];
        const QColor colour = colourOf(first);
        double end = first.to;
        for (++i; i < m_bands.size() && m_bands[i].from == end && colourOf(m_bands[i]) == colour;
             ++i) {
            end = m_bands[i].to;
        }
        const double from = std::max(axis->coordToPixel(first.from), area.left());
        const double to = std::min(axis->coordToPixel(end), area.right() + 1);
        if (to > from) {
            painter->setBrush(colour);
            painter->drawRect(QRectF(from, area.top(), to - from, area.height()));
        }
    }
    m_drawnNames.clear();
    if (m_showNames) {
        drawNames(painter, area);
    }
}

std::vector<BandLayer::Name> BandLayer::namesIn(const QRectF& area, bool brief) const {
    const QCPAxis* axis = m_rect->axis(QCPAxis::atBottom);
    const QFontMetricsF metrics(mParentPlot->font());
    std::vector<Name> names;
    for (const Band& band : m_bands) {
        const QString& text = brief && !band.brief.isEmpty() ? band.brief : band.name;
        const double from = std::max(axis->coordToPixel(band.from), area.left());
        const double to = std::min(axis->coordToPixel(band.to), area.right() + 1);
        const double width = metrics.horizontalAdvance(text) + 2 * namePad;
        if (to >= from + leastBand && !text.isEmpty() && width <= area.width()) {
            names.push_back({from, to, width, 0, &band, &text});
        }
    }
    return names;
}

namespace {

/// Puts the boxes side by side, each as near as possible to the middle of its band. Returns the
/// index of the first that does not touch its band; empty if all do.
template <typename Names>
std::optional<std::size_t> place(Names& names, const QRectF& area) {
    double free = area.left();
    for (auto& name : names) {
        name.left = std::max(free, (name.from + name.to - name.width) / 2);
        free = name.left + name.width + nameGap;
    }
    double end = area.right() + 1;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        name->left = std::min(name->left, end - name->width);
        end = name->left - nameGap;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!names[i].touchesBand() || names[i].left < area.left()) {
            return i;
        }
    }
    return {};
}

} // namespace

void BandLayer::drawNames(QCPPainter* painter, const QRectF& area) {
    std::vector<Name> names = namesIn(area, false);
    if (place(names, area)) {
        names = namesIn(area, true);
        while (place(names, area)) {
            names.erase(
                std::ranges::min_element(names, {}, [](const Name& n) { return n.to - n.from; }));
        }
    }
    const QFontMetricsF metrics(mParentPlot->font());
    painter->setFont(mParentPlot->font());
    for (const Name& name : names) {
        const QRectF box(name.left, area.top() - 2 - metrics.height(), name.width,
                         metrics.height());
        painter->setPen(Qt::NoPen);
        painter->setBrush(colourOf(*name.band));
        painter->drawRect(box);
        painter->setPen(mParentPlot->palette().color(QPalette::Text));
        painter->drawText(QPointF(box.left() + namePad, box.bottom() - metrics.descent()),
                          *name.text);
        m_drawnNames.push_back({*name.text, box});
    }
}

} // namespace sparkout
