// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/constraints/constraints_plot.h"

#include "core/units.h"
#include "ui/plot/free_place.h"
#include "ui/plot/hair_line.h"
#include "ui/plot/quantity_line.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

using style::Drawn;
using units::umPerMm;

constexpr double lowest_um = 1e-6;    ///< replaces 0 on a logarithmic axis
constexpr double feedHeadroom = 1.15; ///< headroom above the highest value
constexpr double visibleLimits = 3;   ///< times the deepest cut, of limits that rise beyond
constexpr double decades = 1e-4;      ///< least visible share of the deepest cut
constexpr double forbidden_um = 1e6;  ///< far above all plots
constexpr int forbiddenAlpha = 34;
constexpr int markPadding = 4;              ///< around its text
constexpr int namePadding = 2, nameGap = 4; ///< beside the name of a limit, and below it
constexpr double pieceWidth = 9;            ///< width of the band along the binding limit [px]
constexpr int pieceAlpha = 120;
constexpr double markSize = 13, cutSize = 3.5, exceededSize = 6;

void setPoints(QCPGraph& graph, const LimitPoints& points) {
    QVector<double> x, y;
    for (const LimitPoint& point : points) {
        x << point.stock_mm * umPerMm;
        y << std::max(point.depth_mm * umPerMm, lowest_um);
    }
    graph.setData(x, y, true);
}

QString inTwoLines(QString text) {
    return text.replace(QStringLiteral(": "), QStringLiteral(":\n"));
}

/// Puts the unit on a line of its own, since the plot may be low.
QString axisLabel(QString text) {
    return text.replace(QStringLiteral(", "), QStringLiteral(",\n"));
}

} // namespace

ConstraintsPlot::ConstraintsPlot(QWidget* parent) : ViewPlot(parent), m_rect(addCell()) {
    build();
    m_moment = new HairLine(*this, HairLine::Role::moment);
    connect(this, &QCustomPlot::afterLayout, this, &ConstraintsPlot::placeMark);
    built();
}

void ConstraintsPlot::build() {
    m_rect->setMinimumMargins(QMargins(0, 6, 14, 0));
    stockAxis()->setRangeReversed(true);
    m_ceiling = addLine(*m_rect);
    m_stepless = addLine(*m_rect);
    m_stepless->setChannelFillGraph(m_ceiling);
    for (const ConstraintKind kind : depthLimitKinds()) {
        m_limits[kind] = addLine(*m_rect);
        setKeyed(static_cast<int>(kind), {m_limits[kind]});
    }
    for (const auto& [key, line] :
         {std::pair(accuracyKey, &m_accuracy), std::pair(estimateKey, &m_estimate),
          std::pair(publishedKey, &m_published), std::pair(programmedKey, &m_programmed),
          std::pair(machineKey, &m_machine)}) {
        *line = addLine(*m_rect);
        setKeyed(key, {*line});
    }
    for (int i = 0; i < graphCount(); ++i) {
        graph(i)->setAdaptiveSampling(false);
    }
    for (QCPCurve** curve : {&m_actual, &m_exceeded, &m_mark}) {
        *curve = addCurve(*m_rect);
    }
    setKeyed(steplessKey, {m_stepless, m_ceiling});
    setKeyed(actualKey, {m_actual, m_exceeded});
    m_exceeded->setLineStyle(QCPCurve::lsNone);
    m_mark->setLineStyle(QCPCurve::lsNone);
    m_markText = new QCPItemText(this);
    m_markText->setSelectable(false);
    m_markText->setClipToAxisRect(true);
    m_markText->position->setType(QCPItemPosition::ptAbsolute);
    m_markText->setPadding(QMargins(markPadding, markPadding, markPadding, markPadding));
    m_markText->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_markLine = new QCPItemLine(this);
    m_markLine->setSelectable(false);
    m_markLine->setClipToAxisRect(true);
    for (QCPItemPosition* end : {m_markLine->start, m_markLine->end}) {
        end->setType(QCPItemPosition::ptAbsolute);
    }
    connect(feedAxis(), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
            &ConstraintsPlot::contentChanged); // the legend lists what is out of view
    connect(feedAxis(), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
            &ConstraintsPlot::followFeeds);
}

/// Ties the right axis to the left, with feeds in mm/min; hidden where a cut belongs to a stroke.
void ConstraintsPlot::followFeeds() {
    const std::optional<double> perMinute = m_chart.perMinute();
    minuteAxis()->setTicks(perMinute.has_value());
    minuteAxis()->setTickLabels(perMinute.has_value());
    minuteAxis()->setSubTicks(perMinute && feedAxis()->subTicks());
    minuteAxis()->setLabel(perMinute ? tr("mm/min") : QString());
    if (perMinute) {
        const QCPRange feeds = feedAxis()->range();
        minuteAxis()->setRange(feeds.lower * *perMinute, feeds.upper * *perMinute);
    }
}

void ConstraintsPlot::setRun(OutcomePtr outcome, int group) {
    const bool same = !m_chart.isEmpty() && m_chart.group() == group && !m_fitNext;
    m_fitNext = false;
    m_chart = LimitChart(std::move(outcome), group, m_chart.requirement());
    fill();
    feedAxis()->setLabel(axisLabel(m_chart.feedLabel()));
    if (same) {
        refit();
    } else {
        fit();
    }
    emit contentChanged();
}

void ConstraintsPlot::fill() {
    for (const auto& [kind, graph] : m_limits) {
        setPoints(*graph, m_chart.limit(kind));
    }
    const LimitPoints& stepless = m_chart.stepless();
    setPoints(*m_stepless, stepless);
    LimitPoints ceiling;
    if (!stepless.empty()) {
        ceiling = {{stepless.front().stock_mm, forbidden_um / umPerMm},
                   {stepless.back().stock_mm, forbidden_um / umPerMm}};
    }
    setPoints(*m_ceiling, ceiling);
    setPoints(*m_accuracy, m_chart.accuracy(AccuracyProof::proved));
    setPoints(*m_estimate, m_chart.accuracy(AccuracyProof::estimate));
    setPoints(*m_published, m_chart.published());
    setPoints(*m_programmed, m_chart.programmed());
    setPoints(*m_machine, m_chart.machineFeed());
    fillEnvelope();
    followFeeds();
    fillCuts(m_chart.cuts() ? *m_chart.cuts() : LimitGroup());
    fillMark();
    showChoice();
}

void ConstraintsPlot::fillCuts(const LimitGroup& group) {
    QVector<double> x, y, aboveX, aboveY;
    for (const LimitedCut& cut : group.cuts) {
        const double stock_um = cut.stock_mm * umPerMm, depth_um = cut.depth_mm * umPerMm;
        x << stock_um;
        y << std::max(depth_um, lowest_um);
        if (cut.usage > 1) {
            aboveX << stock_um;
            aboveY << depth_um;
        }
    }
    m_actual->setData(x, y);
    m_exceeded->setData(aboveX, aboveY);
}

/// Bands behind all lines.
void ConstraintsPlot::fillEnvelope() {
    for (QCPCurve* curve : m_pieces) {
        removePlottable(curve);
    }
    for (QCPItemText* name : m_names) {
        removeItem(name);
    }
    m_pieces.clear();
    m_names.clear();
    for (const BoundCurve& piece : m_chart.envelope()) {
        QVector<double> x, y;
        for (const LimitPoint& point : piece.points) {
            x << point.stock_mm * umPerMm;
            y << std::max(point.depth_mm * umPerMm, lowest_um);
        }
        QCPCurve* const curve = addCurve(*m_rect);
        curve->setLayer(QStringLiteral("bands"));
        curve->setData(x, y);
        auto* const name = new QCPItemText(this);
        name->setSelectable(false);
        name->setClipToAxisRect(true);
        anchor({name->position}, *m_rect);
        name->setText(LimitChart::boundName(piece));
        name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        name->setPadding(QMargins(namePadding, 0, namePadding, nameGap));
        setKeyed(envelopeKey, {curve});
        m_pieces.push_back(curve);
        m_names.push_back(name);
    }
    restyleEnvelope();
}

/// Places a name on the visible part of a piece that is wider than it: of some positions along it,
/// above and below, the one that covers the least, the middle first.
void ConstraintsPlot::placeNames(FreePlace& places) {
    const QCPRange stocks = stockAxis()->range();
    const QFontMetrics metrics(font());
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
        const BoundCurve& piece = m_chart.envelope()[i];
        const double from = std::max(piece.points.front().stock_mm * umPerMm, stocks.lower),
                     to = std::min(piece.points.back().stock_mm * umPerMm, stocks.upper);
        const double width =
            std::abs(stockAxis()->coordToPixel(from) - stockAxis()->coordToPixel(to));
        const QSizeF size(metrics.horizontalAdvance(m_names[i]->text()) + 2 * namePadding,
                          metrics.height() + nameGap);
        m_names[i]->setVisible(false);
        if (from >= to || !shows(envelopeKey) || size.width() >= width) {
            continue;
        }
        QRectF chosen;
        int least = std::numeric_limits<int>::max();
        for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {
            const double stock = from + share * (to - from);
            double depth = piece.points.front().depth_mm;
            for (const LimitPoint& point : piece.points) {
                depth = point.stock_mm * umPerMm <= stock ? point.depth_mm : depth;
            }
            const double high = std::max(depth * umPerMm, lowest_um);
            const QPointF at(stockAxis()->coordToPixel(stock), feedAxis()->coordToPixel(high));
            if (high >= feedAxis()->range().upper
                || std::min(share, 1 - share) * width < size.width() / 2) {
                continue;
            }
            for (const bool below : {false, true}) {
                const QRectF place(
                    {at.x() - size.width() / 2, below ? at.y() : at.y() - size.height()}, size);
                const int covered = places.coveredIn(place);
                if (covered < least && place.top() >= m_rect->top()
                    && place.bottom() <= m_rect->bottom()) {
                    least = covered;
                    chosen = place;
                    m_names[i]->position->setCoords(stock, high);
                    m_names[i]->setPositionAlignment(Qt::AlignHCenter
                                                     | (below ? Qt::AlignTop : Qt::AlignBottom));
                    m_names[i]->setVisible(true);
                }
            }
        }
        places.addSpot(chosen);
    }
}

void ConstraintsPlot::setMarked(const std::optional<ConstraintResult>& requirement) {
    m_chart.setMarked(requirement);
    fillMark();
}

void ConstraintsPlot::fillMark() {
    const std::optional<LimitedCut>& cut = marked();
    m_mark->data()->clear();
    if (cut) {
        m_mark->addData(cut->stock_mm * umPerMm, std::max(cut->depth_mm * umPerMm, lowest_um));
    }
    m_markText->setText(m_chart.markText());
    m_markText->setVisible(cut.has_value());
}

/// The drawn points of a curve, in pixels of the plot.
template <typename Drawn>
QPolygonF ConstraintsPlot::pixelsOf(const Drawn& drawn) const {
    QPolygonF points;
    if (drawn.visible()) {
        for (auto point = drawn.data()->constBegin(); point != drawn.data()->constEnd(); ++point) {
            points << QPointF(stockAxis()->coordToPixel(point->key),
                              feedAxis()->coordToPixel(point->value));
        }
    }
    return points;
}

/// Places the text beside the mark where it covers no curve, in two lines if one is too long.
void ConstraintsPlot::placeMark() {
    style::fitValueAxes(*m_rect, font());
    m_markLine->setVisible(false);
    FreePlace places(QRectF(m_rect->rect()).adjusted(1, 1, -1, -1));
    for (int i = 0; i < graphCount(); ++i) {
        if (graph(i) != m_ceiling) {
            places.addCurve(pixelsOf(*graph(i)));
        }
    }
    places.addCurve(pixelsOf(*m_actual));
    if (!marked()) {
        placeNames(places);
        return;
    }
    const QPointF at(stockAxis()->coordToPixel(marked()->stock_mm * umPerMm),
                     feedAxis()->coordToPixel(std::max(marked()->depth_mm * umPerMm, lowest_um)));
    constexpr double round = markSize / 2 + 2;
    places.addSpot({at - QPointF(round, round), QSizeF(2 * round, 2 * round)});
    placeNames(places);
    const auto placeOf = [&](const QString& text) {
        const QSizeF size = QFontMetricsF(font()).boundingRect(QRectF(), 0, text).size();
        return places.nearest(size + QSizeF(2 * markPadding, 2 * markPadding), at);
    };
    const QString line = m_chart.markText(), lines = inTwoLines(line);
    const FreePlace::Found flat = placeOf(line), high = placeOf(lines);
    const bool flatFits = flat.place.width() <= m_rect->width();
    const bool isFlat =
        flatFits && std::pair(flat.covered, flat.away) <= std::pair(high.covered, high.away);
    const FreePlace::Found& found = isFlat ? flat : high;
    m_markText->setText(isFlat ? line : lines);
    m_markText->position->setPixelPosition(found.place.topLeft());
    m_markLine->setVisible(found.away > markSize && !line.isEmpty());
    m_markLine->start->setPixelPosition(at);
    m_markLine->end->setPixelPosition(
        {std::clamp(at.x(), found.place.left(), found.place.right()),
         std::clamp(at.y(), found.place.top(), found.place.bottom())});
}

void ConstraintsPlot::setMoment(std::optional<double> stock_mm) {
    m_moment->setAt(stock_mm ? std::optional(*stock_mm * umPerMm) : std::nullopt);
}

std::optional<double> ConstraintsPlot::moment_um() const {
    return m_moment->at();
}

QCPGraph* ConstraintsPlot::limit(ConstraintKind kind) const {
    const auto found = m_limits.find(kind);
    return found != m_limits.end() && found->second->dataCount() > 0 ? found->second : nullptr;
}

double ConstraintsPlot::highestCut() const {
    double highest = 0;
    for (const QCPCurveData& point : *m_actual->data()) {
        highest = std::max(highest, point.value);
    }
    return highest;
}

/// The greatest feed to be visible: the cuts, and always part of the limit.
double ConstraintsPlot::highestFeed() const {
    const double cut = highestCut();
    bool found = false;
    const QCPRange limit = m_stepless->getValueRange(found);
    if (!found) {
        return cut > 0 ? cut : 1;
    }
    return cut > 0
               ? std::max(cut, std::min(limit.upper, std::max(visibleLimits * cut, limit.lower)))
               : limit.upper;
}

void ConstraintsPlot::fit() {
    fitStock();
    fitFeeds();
}

/// Refits each axis that the user has not zoomed, so that a run looks the same after an edit and
/// after its undo; also the stock axis if nothing of the cycle would remain visible.
void ConstraintsPlot::refit() {
    const QCPRange stock = stockAxis()->range();
    const QCPRange cycle = stocks_um();
    if (stock == m_fittedStock || cycle.upper < stock.lower || cycle.lower > stock.upper) {
        fitStock();
    }
    if (feedAxis()->range() == m_fittedFeeds) {
        fitFeeds();
    }
}

QCPRange ConstraintsPlot::stocks_um() const {
    const auto [least_mm, deepest_mm] = m_chart.stocks_mm();
    return {least_mm * umPerMm, deepest_mm * umPerMm};
}

void ConstraintsPlot::fitStock() {
    const QCPRange cycle = m_chart.isEmpty() ? QCPRange(0, 1) : stocks_um();
    const double border = 0.02 * cycle.size();
    style::setSafeRange(*stockAxis(), cycle.lower - border, cycle.upper + border);
    m_fittedStock = stockAxis()->range();
}

void ConstraintsPlot::fitFeeds() {
    const double high = highestFeed();
    bool found = false;
    const QCPRange limit = m_stepless->getValueRange(found);
    if (feedAxis()->scaleType() == QCPAxis::stLogarithmic) {
        double least = found ? std::min(high, limit.lower) : high;
        for (const QCPCurveData& point : *m_actual->data()) {
            least = std::min(least, point.value);
        }
        const double top = std::max(high, found ? limit.upper : 0) * 2;
        style::setSafeRange(*feedAxis(), std::clamp(least / 2, high * decades, top / 10), top);
    } else {
        style::setSafeRange(*feedAxis(), 0, high * feedHeadroom);
    }
    m_fittedFeeds = feedAxis()->range();
}

void ConstraintsPlot::setLogarithmic(bool on) {
    style::setLogarithmic(*feedAxis(), on);
    style::setLogarithmic(*minuteAxis(), on);
    feedAxis()->setSubTicks(on);
    followFeeds();
    fit();
}

// --- look ---------------------------------------------------------------------------------------

QPen ConstraintsPlot::penOf(int key) const {
    if (key == actualKey) {
        return style::line(Drawn::actualFeed, toned(Drawn::actualFeed));
    }
    if (key == steplessKey) {
        return {ink(), 3, Qt::SolidLine};
    }
    if (key == accuracyKey || key == estimateKey) {
        return {toned(Tone::purple), 2.6, key == accuracyKey ? Qt::SolidLine : Qt::DashDotLine};
    }
    if (key == publishedKey) {
        return {toned(Tone::orange), 2.6, Qt::DashDotDotLine};
    }
    if (key == machineKey) {
        return {ink(), 1.2, Qt::DashDotLine};
    }
    if (key == programmedKey) {
        return {toned(Drawn::programmedFeed), 3, Qt::DotLine};
    }
    const std::vector<ConstraintKind> kinds = depthLimitKinds();
    const auto place = static_cast<std::size_t>(
        std::ranges::find(kinds, static_cast<ConstraintKind>(key)) - kinds.begin());
    return style::lineOfDepthLimit(place, toned(style::limitOfDepth(place)));
}

LegendEntries ConstraintsPlot::legendEntries() const {
    LegendEntries entries;
    const auto add = [&](int key, const QString& name) {
        entries.push_back(lineEntry(key, penOf(key), name));
    };
    if (!m_chart.cuts()) {
        return entries;
    }
    add(actualKey, tr("actual feed"));
    if (!m_chart.stepless().empty()) {
        add(steplessKey, tr("stepless limit"));
    }
    const auto addLimit = [&](int key, const QCPGraph& graph, const QString& name) {
        bool found = false;
        const double least = graph.getValueRange(found).lower;
        if (found) {
            add(key, least > feedAxis()->range().upper
                         ? tr("%1 ↑", "a curve above the plot").arg(name)
                         : name);
        }
    };
    for (const ConstraintKind kind : depthLimitKinds()) {
        if (const QCPGraph* graph = limit(kind)) {
            addLimit(static_cast<int>(kind), *graph, LimitNames::limit(kind));
        }
    }
    // Short names that fit two lines; the read-out has the full ones.
    addLimit(accuracyKey, *m_accuracy, tr("accuracy"));
    addLimit(estimateKey, *m_estimate, tr("accuracy, estimate"));
    addLimit(publishedKey, *m_published, tr("runout (22)"));
    addLimit(programmedKey, *m_programmed, tr("programmed"));
    addLimit(machineKey, *m_machine, tr("machine's feed"));
    if (!m_chart.envelope().empty()) {
        entries.push_back(
            areaEntry(envelopeKey, colourOf(m_chart.envelope().front()), tr("band: what binds")));
    }
    return entries;
}

/// The colour of the limit it belongs to.
QColor ConstraintsPlot::colourOf(const BoundCurve& piece) const {
    const int key = piece.bound == LimitBound::feed       ? machineKey
                    : piece.bound == LimitBound::accuracy ? accuracyKey
                                                          : static_cast<int>(piece.kind);
    return style::thinned(penOf(key).color(), isDimmed() ? pieceAlpha / 3 : pieceAlpha);
}

void ConstraintsPlot::restyleEnvelope() {
    const QColor paper = style::thinned(palette().color(QPalette::Base), 200);
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
        QPen band(colourOf(m_chart.envelope()[i]), pieceWidth);
        band.setCapStyle(Qt::FlatCap);
        band.setJoinStyle(Qt::RoundJoin);
        m_pieces[i]->setPen(band);
        m_names[i]->setBrush(paper);
        m_names[i]->setColor(ink());
        m_names[i]->setFont(font());
    }
}

void ConstraintsPlot::restyle() {
    ViewPlot::restyle();
    for (const auto& [kind, graph] : m_limits) {
        graph->setPen(penOf(static_cast<int>(kind)));
    }
    const QColor forbidden =
        style::filling(style::colour(Drawn::forbidden, palette()),
                       isDimmed() ? forbiddenAlpha / 3 : forbiddenAlpha, palette());
    m_stepless->setPen(penOf(steplessKey));
    m_stepless->setBrush(forbidden);
    m_ceiling->setPen(Qt::NoPen);
    m_accuracy->setPen(penOf(accuracyKey));
    m_estimate->setPen(penOf(estimateKey));
    m_published->setPen(penOf(publishedKey));
    m_programmed->setPen(penOf(programmedKey));
    m_machine->setPen(penOf(machineKey));
    restyleEnvelope();
    const QPen actual = penOf(actualKey);
    m_actual->setPen(actual);
    m_actual->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, actual.color(), actual.color(), cutSize));
    const QColor alarm = toned(Drawn::fails);
    m_exceeded->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssSquare, alarm, alarm, exceededSize));
    const QColor text = ink();
    m_mark->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 2), Qt::NoBrush, markSize));
    const QColor paper = style::thinned(palette().color(QPalette::Base), 200);
    m_markText->setBrush(paper);
    m_markText->setColor(text);
    m_markText->setFont(font());
    m_markLine->setPen(QPen(text, 1));
}

void ConstraintsPlot::setTexts() {
    stockAxis()->setLabel(tr("Stock left after the cut, µm"));
    feedAxis()->setLabel(axisLabel(m_chart.feedLabel()));
    m_markText->setText(m_chart.markText());
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        m_names[i]->setText(LimitChart::boundName(m_chart.envelope()[i]));
    }
    followFeeds();
}

// --- numbers ------------------------------------------------------------------------------------

/// The values of the cut nearest to the mouse on the screen.
QString ConstraintsPlot::valuesAt(const QPointF& at) const {
    const LimitGroup* group = m_chart.cuts();
    if (!group || group->cuts.empty() || !m_rect->rect().contains(at.toPoint())) {
        return {};
    }
    const auto away = [&](const LimitedCut& cut) {
        const double x = stockAxis()->coordToPixel(cut.stock_mm * umPerMm);
        const double y = feedAxis()->coordToPixel(std::max(cut.depth_mm * umPerMm, lowest_um));
        return std::hypot(x - at.x(), y - at.y());
    };
    return m_chart.valuesAt(*std::ranges::min_element(group->cuts, {}, away));
}

ReadCurves ConstraintsPlot::readCurves() const {
    ReadCurves curves;
    const auto add = [&](const auto& drawn, const QString& name) {
        if (drawn->visible() && !drawn->data()->isEmpty()) {
            curves.push_back({QString(), name, Digits::significant,
                              [drawn](double x) { return valueAt(*drawn, x); }});
        }
    };
    add(m_actual, tr("actual feed, µm"));
    add(m_stepless, tr("stepless limit, µm"));
    for (const auto& [kind, graph] : m_limits) {
        add(graph, tr("limit: %1, µm").arg(LimitNames::limit(kind)));
    }
    add(m_accuracy, tr("limit: %1, µm").arg(tr("accuracy, proved")));
    add(m_estimate, tr("limit: %1, µm").arg(tr("accuracy at steady feed, estimate")));
    add(m_published, tr("limit: %1, µm").arg(tr("runout in every pass, as published (22)")));
    add(m_programmed, tr("programmed feed, µm"));
    add(m_machine, tr("limit: %1, µm").arg(tr("machine's maximum feed")));
    return curves;
}

CsvTable ConstraintsPlot::table() const {
    const QCPRange visible = stockAxis()->range();
    return m_chart.table([&](double stock_mm) { return visible.contains(stock_mm * umPerMm); },
                         [this](ConstraintKind kind) { return shows(static_cast<int>(kind)); });
}

} // namespace sparkout
