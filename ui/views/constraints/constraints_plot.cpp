// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/constraints/constraints_plot.h"

#include "core/units.h"
#include "ui/plot/free_place.h"
#include "ui/plot/painted_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

using units::umPerMm;

constexpr int callOutPadding = 4;           ///< around its text
constexpr int namePadding = 2, nameGap = 4; ///< beside the name of a limit, and below it
constexpr double markRoom = 8.5;            ///< half the size of the mark with a margin [px]
constexpr double leaderFrom = 13;           ///< distance of a call-out with a leader [px]

QString inTwoLines(QString text) {
    return text.replace(QStringLiteral(": "), QStringLiteral(":\n"));
}

} // namespace

/// The names of the limits that bind, and a call-out for the mark, placed where they cover the
/// least.
class ConstraintsPlot::Labels : public PaintedLayer {
public:
    explicit Labels(const ConstraintsPlot& plot)
        : PaintedLayer(plot.cell(), QStringLiteral("axes"), Edges::smooth), m_plot(plot) {}

    QRectF callOut; ///< in the last replot

protected:
    void draw(QCPPainter* painter) override {
        callOut = {};
        FreePlace places(QRectF(m_rect->rect()).adjusted(1, 1, -1, -1));
        for (const ChartSeries& of : m_plot.chart().series) {
            if (of.isLine() && m_plot.shows(of.key)) {
                QPolygonF points;
                for (const XY& point : of.points) {
                    points << m_plot.pixelOf(point);
                }
                places.addCurve(points);
            }
        }
        painter->setFont(m_plot.font());
        const LimitChart& limits = m_plot.limits();
        const QPointF at = limits.marked()
                               ? m_plot.pixelOf(m_plot.chart().series.back().points.front())
                               : QPointF();
        if (limits.marked()) {
            places.addSpot(QRectF(at, at).adjusted(-markRoom, -markRoom, markRoom, markRoom));
        }
        for (const BoundCurve& piece : limits.envelope()) {
            if (m_plot.shows(LimitChart::envelopeKey)) {
                drawName(*painter, piece, places);
            }
        }
        if (limits.marked() && !limits.markText().isEmpty()) {
            drawCallOut(*painter, limits.markText(), at, places);
        }
    }

private:
    void drawText(QCPPainter& painter, const QRectF& box, const QMargins& padding,
                  const QString& text) const {
        painter.fillRect(box, style::thinned(m_plot.palette().color(QPalette::Base), 200));
        painter.setPen(m_plot.ink());
        painter.drawText(box.marginsRemoved(padding), Qt::AlignHCenter | Qt::AlignTop, text);
    }

    /// Places a name on the visible part of a piece that is wider than it: of some positions along
    /// it, above and below, the one that covers the least, the middle first.
    void drawName(QCPPainter& painter, const BoundCurve& piece, FreePlace& places) const {
        const QCPAxis &stocks = m_plot.across(), &feeds = m_plot.up();
        const QFontMetrics metrics(m_plot.font());
        const QString name = LimitChart::boundName(piece);
        const double from = std::max(piece.points.front().stock_mm * umPerMm, stocks.range().lower),
                     to = std::min(piece.points.back().stock_mm * umPerMm, stocks.range().upper);
        const double width = std::abs(stocks.coordToPixel(from) - stocks.coordToPixel(to));
        const QSizeF size(metrics.horizontalAdvance(name) + 2 * namePadding,
                          metrics.height() + nameGap);
        QRectF chosen;
        int least = std::numeric_limits<int>::max();
        for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {
            const double stock = from + share * (to - from);
            double depth = piece.points.front().depth_mm;
            for (const LimitPoint& point : piece.points) {
                depth = point.stock_mm * umPerMm <= stock ? point.depth_mm : depth;
            }
            const QPointF at = m_plot.pixelOf({stock, depth * umPerMm});
            if (from >= to || size.width() >= width || depth * umPerMm >= feeds.range().upper
                || std::min(share, 1 - share) * width < size.width() / 2) {
                continue;
            }
            for (const double top : {at.y() - size.height(), at.y()}) {
                const QRectF place({at.x() - size.width() / 2, top}, size);
                const int covered = places.coveredIn(place);
                if (covered < least && place.top() >= m_rect->top()
                    && place.bottom() <= m_rect->bottom()) {
                    least = covered;
                    chosen = place;
                }
            }
        }
        if (!chosen.isNull()) {
            drawText(painter, chosen, {namePadding, 0, namePadding, nameGap}, name);
            places.addSpot(chosen);
        }
    }

    /// Draws the text beside the mark, in two lines if one is too long.
    void drawCallOut(QCPPainter& painter, const QString& line, const QPointF& at,
                     const FreePlace& places) {
        const auto placeOf = [&](const QString& text) {
            const QSizeF size = QFontMetricsF(m_plot.font()).boundingRect(QRectF(), 0, text).size();
            return places.nearest(size + QSizeF(2 * callOutPadding, 2 * callOutPadding), at);
        };
        const QString lines = inTwoLines(line);
        const FreePlace::Found flat = placeOf(line), high = placeOf(lines);
        const bool isFlat =
            flat.place.width() <= m_rect->width()
            && std::pair(flat.covered, flat.away) <= std::pair(high.covered, high.away);
        const FreePlace::Found& found = isFlat ? flat : high;
        callOut = found.place;
        drawText(painter, callOut, {callOutPadding, callOutPadding, callOutPadding, callOutPadding},
                 isFlat ? line : lines);
        if (found.away > leaderFrom) {
            painter.setPen(QPen(m_plot.ink(), 1));
            painter.drawLine(QLineF(at, {std::clamp(at.x(), callOut.left(), callOut.right()),
                                         std::clamp(at.y(), callOut.top(), callOut.bottom())}));
        }
    }

    const ConstraintsPlot& m_plot;
};

ConstraintsPlot::ConstraintsPlot(QWidget* parent)
    : ChartPlot(parent)
    , m_labels(new Labels(*this))
    , m_moment(new HairLine(*this, HairLine::Role::moment)) {
    cell().setMinimumMargins(QMargins(0, 6, 14, 0));
    setChart([this] { return m_limits.chart(m_isLogarithmic); });
    connect(&up(), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
            &ConstraintsPlot::contentChanged); // the legend marks curves above the plot
}

void ConstraintsPlot::setRun(OutcomePtr outcome, int group) {
    const bool same = !m_limits.isEmpty() && m_limits.group() == group && !m_fitNext;
    m_fitNext = false;
    m_limits = LimitChart(std::move(outcome), group, m_limits.requirement());
    remake();
    if (same) {
        refit();
    } else {
        fit();
    }
}

void ConstraintsPlot::setLogarithmic(bool on) {
    m_isLogarithmic = on;
    remake();
    fit();
}

void ConstraintsPlot::setMarked(const std::optional<ConstraintResult>& requirement) {
    m_limits.setMarked(requirement);
    remake();
}

void ConstraintsPlot::setMoment(std::optional<double> stock_mm) {
    m_moment->setAt(stock_mm ? std::optional(*stock_mm * umPerMm) : std::nullopt);
}

std::optional<double> ConstraintsPlot::moment_um() const {
    return m_moment->at();
}

QRectF ConstraintsPlot::callOut() const {
    return m_labels->callOut;
}

void ConstraintsPlot::fit() {
    ChartPlot::fit();
    m_fittedStock = across().range();
    m_fittedFeeds = up().range();
}

/// Refits each axis that the user has not zoomed, so that a run looks the same after an edit and
/// after its undo; also the stock axis if nothing of the cycle would remain visible.
void ConstraintsPlot::refit() {
    const QCPRange stock = across().range(), feeds = up().range();
    const QCPRange fittedStock = m_fittedStock, fittedFeeds = m_fittedFeeds;
    const ChartSpan cycle = chart().readSpan;
    fit();
    if (stock != fittedStock && cycle.high >= stock.lower && cycle.low <= stock.upper) {
        across().setRange(stock);
        m_fittedStock = fittedStock;
    }
    if (feeds != fittedFeeds) {
        up().setRange(feeds);
        m_fittedFeeds = fittedFeeds;
    }
}

LegendEntries ConstraintsPlot::legendEntries() const {
    LegendEntries entries = ChartPlot::legendEntries();
    for (LegendEntry& entry : entries) {
        const bool isCycle =
            entry.key == LimitChart::actualKey || entry.key == LimitChart::steplessKey;
        const ChartSeries& of = *chart().find(entry.key);
        const double top = up().range().upper;
        if (!isCycle && of.isLine()
            && std::ranges::all_of(of.points, [top](const XY& at) { return at.y > top; })) {
            entry.text = tr("%1 ↑", "a curve above the plot").arg(entry.text);
        }
    }
    return entries;
}

CsvTable ConstraintsPlot::table() const {
    const QCPRange visible = across().range();
    return m_limits.table([&](double stock_mm) { return visible.contains(stock_mm * umPerMm); },
                          [this](ConstraintKind kind) { return shows(static_cast<int>(kind)); });
}

} // namespace sparkout
