// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/requirements/constraints_plot.h"

#include "core/project/machine.h"
#include "core/units.h"
#include "ui/chart/free_place.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

using style::Drawn;
using units::umPerMm;

constexpr double lowest_um = 1e-6;    ///< replaces 0 on a logarithmic axis
constexpr double stockRoom = 0.02;    ///< room beside the cycle, relative to it
constexpr double feedHeadroom = 1.15; ///< headroom above the highest value
constexpr double visibleLimits = 3;   ///< times the deepest cut, of limits that rise beyond
constexpr double decades = 1e-4;      ///< least visible share of the deepest cut
constexpr double forbidden_um = 1e6;  ///< far above all plots
constexpr int forbiddenAlpha = 34;
constexpr double pieceWidth = 9; ///< width of the ribbon along the binding limit [px]
constexpr int pieceAlpha = 120;
constexpr double markSize = 13, cutSize = 3.5, exceededSize = 6;

double ratio(double value, double limit) {
    return limit > 0 ? value / limit : HUGE_VAL;
}

XY drawnPoint(double stock_mm, double depth_mm) {
    return {stock_mm * umPerMm, std::max(depth_mm * umPerMm, lowest_um)};
}

std::vector<XY> drawnLine(const LimitPoints& points) {
    std::vector<XY> line;
    for (const LimitPoint& point : points) {
        line.push_back(drawnPoint(point.stock_mm, point.depth_mm));
    }
    return line;
}

ChartSpan feedSpan(const LineChart& chart, int key) {
    ChartSpan span;
    if (const ChartSeries* of = chart.find(key)) {
        for (const XY& point : of->points) {
            span.add(point.y);
        }
    }
    return span;
}

/// The range of the feeds: the cuts, and always part of the stepless limit.
ChartSpan visibleFeeds(const LineChart& chart) {
    const ChartSpan cuts = feedSpan(chart, LimitChart::actualKey);
    const ChartSpan limit = feedSpan(chart, LimitChart::steplessKey);
    double high = cuts.empty() ? 1 : cuts.high;
    if (!limit.empty()) {
        high =
            cuts.empty()
                ? limit.high
                : std::max(high, std::min(limit.high, std::max(visibleLimits * high, limit.low)));
    }
    if (!chart.up.isLogarithmic) {
        return {0, high * feedHeadroom};
    }
    const double least = std::min({high, limit.low, cuts.low});
    const double top = std::max(high, limit.high) * 2;
    return {std::clamp(least / 2, high * decades, top / 10), top};
}

} // namespace

LimitChart::LimitChart(OutcomePtr outcome, int group, std::optional<ConstraintResult> requirement)
    : m_outcome(std::move(outcome)), m_group(group) {
    if (const LimitGroup* of = cuts()) {
        for (const ConstraintKind kind : depthLimitKinds()) {
            if (!LimitNames::isGuess(kind, m_outcome->result.project)) {
                m_limits[kind] = limitCurve(m_outcome->limits, *of, kind);
            }
        }
        m_stepless = steplessLimit(m_outcome->limits, *of);
        for (const AccuracyProof proof : {AccuracyProof::proved, AccuracyProof::estimate}) {
            if (auto by = accuracyLimit(m_outcome->result, m_outcome->limits, *of, proof)) {
                m_accuracy[proof] = std::move(by->curve);
            }
        }
        m_published =
            publishedAccuracy(m_outcome->result, m_outcome->trajectory, m_outcome->limits, *of);
        m_programmed = programmedSteps(m_outcome->result, m_outcome->limits, *of);
        findEnvelope();
    }
    setMarked(std::move(requirement));
}

void LimitChart::findEnvelope() {
    if (const auto infeed_mm = greatestInfeed_mm(m_outcome->result.project)) {
        const auto [least_mm, deepest_mm] = stocks_mm();
        m_machineFeed = {{least_mm, *infeed_mm}, {deepest_mm, *infeed_mm}};
    }
    std::vector<BoundCurve> curves;
    for (const auto& [kind, points] : m_limits) {
        if (requirementOf(kind).bindsEveryPass()) {
            curves.push_back({LimitBound::requirement, kind, points});
        }
    }
    curves.push_back({LimitBound::accuracy, {}, accuracy(AccuracyProof::proved)});
    curves.push_back({LimitBound::feed, {}, m_machineFeed});
    m_envelope = envelopeOf(curves);
}

QString LimitChart::boundName(const BoundCurve& piece) {
    switch (piece.bound) {
    case LimitBound::feed: return tr("machine's feed");
    case LimitBound::accuracy: return tr("accuracy");
    case LimitBound::requirement: return LimitNames::limit(piece.kind);
    case LimitBound::stock: break;
    }
    return {};
}

QString LimitChart::boundAt(double stock_mm) const {
    const auto at = std::ranges::find_if(m_envelope, [stock_mm](const BoundCurve& piece) {
        return piece.points.front().stock_mm <= stock_mm
               && stock_mm <= piece.points.back().stock_mm;
    });
    return at == m_envelope.end() ? QString() : boundName(*at);
}

const LimitGroup* LimitChart::cuts() const {
    return m_outcome && m_group >= 0 ? &m_outcome->limits.groups[static_cast<std::size_t>(m_group)]
                                     : nullptr;
}

const LimitPoints& LimitChart::limit(ConstraintKind kind) const {
    static const LimitPoints off;
    const auto found = m_limits.find(kind);
    return found == m_limits.end() ? off : found->second;
}

void LimitChart::setMarked(std::optional<ConstraintResult> requirement) {
    m_requirement = std::move(requirement);
    m_marked.reset();
    const LimitGroup* group = cuts();
    if (group && m_requirement) {
        m_marked = limitedCutOf(m_outcome->result, m_outcome->trajectory, *m_requirement);
        if (m_marked && limitGroupAt(m_outcome->limits, m_marked->place) != m_group) {
            m_marked.reset();
        }
    } else if (group && group->worst.depth_mm > 0 && !m_stepless.empty()) {
        m_marked = group->worst;
    }
}

std::pair<double, double> LimitChart::stocks_mm() const {
    return m_outcome ? std::pair(m_outcome->limits.least_mm, m_outcome->limits.deepest_mm)
                     : std::pair(0.0, 0.0);
}

std::vector<DepthLimit> LimitChart::limitsOf(const LimitedCut& cut) const {
    std::vector<DepthLimit> limits =
        depthLimits(m_outcome->result.project, cut.width_mm, cut.stock_mm);
    std::erase_if(limits, [this](const DepthLimit& l) { return limit(l.kind).empty(); });
    return limits;
}

QString LimitChart::markText() const {
    if (!m_marked) {
        return {};
    }
    if (m_requirement) {
        return QStringLiteral("%1: %2").arg(Names::constraint(m_requirement->kind),
                                            LimitNames::percent(1 - m_requirement->relativeMargin));
    }
    const std::vector<DepthLimit> limits = limitsOf(*m_marked);
    const DepthLimit* binding = bindingOf(limits);
    return binding ? tr("nearest to its feed limit: %1, %2")
                         .arg(LimitNames::limit(binding->kind),
                              LimitNames::percent(ratio(m_marked->depth_mm, binding->depth_mm)))
                   : QString();
}

QString LimitChart::valuesAt(const LimitedCut& cut) const {
    const auto um = [](double value_mm) { return Names::significant(value_mm * umPerMm); };
    std::vector<DepthLimit> limits = limitsOf(cut);
    std::ranges::sort(limits, {}, &DepthLimit::depth_mm);
    const DepthLimit* binding = bindingOf(limits);
    QStringList parts;
    for (const DepthLimit& limit : limits) {
        parts << QStringLiteral("%1 %2").arg(LimitNames::limit(limit.kind), um(limit.depth_mm));
        if (&limit == binding) {
            parts.back() +=
                tr(" (%1 used)").arg(LimitNames::percent(ratio(cut.depth_mm, limit.depth_mm)));
        }
    }
    QString text = tr("%1: stock left %2 µm, actual feed %3 µm, width %4 mm")
                       .arg(Names::place(cut.place, m_outcome->result.project.operation),
                            Names::signedMicrometres(cut.stock_mm * umPerMm), um(cut.depth_mm),
                            Names::significant(cut.width_mm));
    if (!parts.isEmpty()) {
        text += u'\n' + tr("Allowed feed, µm: %1").arg(parts.join(QStringLiteral("; ")));
    }
    const QString bound = boundAt(cut.stock_mm); // the requirement is marked above
    if (!bound.isEmpty() && !(binding && bound == LimitNames::limit(binding->kind))) {
        text += (parts.isEmpty() ? QStringLiteral("\n") : QStringLiteral("; "))
                + tr("binds: %1").arg(bound);
    }
    return text;
}

const LimitPoints& LimitChart::accuracy(AccuracyProof proof) const {
    static const LimitPoints none;
    const auto found = m_accuracy.find(proof);
    return found == m_accuracy.end() ? none : found->second;
}

std::optional<double> LimitChart::perMinute() const {
    const LimitGroup* group = cuts();
    if (!group || (!group->standing && m_outcome->result.project.operation->travels)) {
        return std::nullopt;
    }
    return m_outcome->result.project.machine->work_speed_rpm / umPerMm;
}

/// A cut belongs to a revolution where the wheel plunges or dwells, otherwise to a stroke.
QString LimitChart::feedLabel() const {
    const LimitGroup* group = cuts();
    const bool stroke = group && !group->standing && m_outcome->result.project.operation->travels;
    return stroke ? tr("Actual feed, µm per pass") : tr("Actual feed, µm per revolution");
}

LineChart LimitChart::chart(bool isLogarithmic) const {
    const auto [least_mm, deepest_mm] = stocks_mm();
    LineChart chart;
    chart.isFramed = true;
    chart.readSpan = {least_mm * umPerMm, deepest_mm * umPerMm};
    chart.across = {.label = tr("Stock left after the cut, µm"),
                    .range = isEmpty() ? ChartSpan{0, 1} : chart.readSpan,
                    .room = stockRoom,
                    .isReversed = true};
    chart.up = {.label = feedLabel(), .room = 0, .isLogarithmic = isLogarithmic};
    // The unit has a line of its own, since the plot may be low.
    chart.up.label.replace(QStringLiteral(", "), QStringLiteral(",\n"));
    if (const auto factor = perMinute()) {
        chart.second = {.label = tr("mm/min"), .isLogarithmic = isLogarithmic};
        chart.perValue = *factor;
    }
    if (cuts()) {
        addCuts(chart);
        addLimits(chart);
        addEnvelope(chart);
    }
    if (m_marked) {
        chart.series.push_back({.kind = ChartSeries::Kind::points,
                                .points = {drawnPoint(m_marked->stock_mm, m_marked->depth_mm)},
                                .mark = ChartSeries::Mark::ring,
                                .markSize = markSize});
    }
    chart.up.range = visibleFeeds(chart);
    return chart;
}

void LimitChart::addCuts(LineChart& chart) const {
    ChartSeries actual{.key = actualKey,
                       .name = tr("actual feed", "legend"),
                       .kind = ChartSeries::Kind::path,
                       .colour = Drawn::actualFeed,
                       .pen = style::line(Drawn::actualFeed, {}),
                       .mark = ChartSeries::Mark::disc,
                       .markSize = cutSize};
    ChartSeries exceeded{.key = actualKey,
                         .kind = ChartSeries::Kind::points,
                         .colour = Drawn::fails,
                         .mark = ChartSeries::Mark::square,
                         .markSize = exceededSize};
    for (const LimitedCut& cut : cuts()->cuts) {
        actual.points.push_back(drawnPoint(cut.stock_mm, cut.depth_mm));
        if (cut.usage > 1) {
            exceeded.points.push_back(actual.points.back());
        }
    }
    if (!actual.points.empty()) {
        chart.read(actual, tr("actual feed, µm"), Digits::significant);
    }
    chart.series = {std::move(actual), std::move(exceeded)};
    chart.pointText = [self = *this](std::size_t, std::size_t cut) {
        return self.valuesAt(self.cuts()->cuts[cut]);
    };
    chart.pointed = 1;
    chart.reach = HUGE_VAL;
}

void LimitChart::addLimits(LineChart& chart) const {
    const auto add = [&chart](int key, const LimitPoints& points, const QString& name,
                              const QString& read, const ChartColour& colour, const QPen& pen) {
        if (!points.empty()) {
            chart.series.push_back({.key = key,
                                    .name = name,
                                    .colour = colour,
                                    .pen = pen,
                                    .points = drawnLine(points)});
            chart.read(chart.series.back(), read, Digits::significant);
        }
    };
    const auto limitOf = [](const QString& name) { return tr("limit: %1, µm").arg(name); };
    add(steplessKey, m_stepless, tr("stepless limit"), tr("stepless limit, µm"), {}, linePen(3));
    if (const ChartSeries* stepless = chart.find(steplessKey)) {
        const std::vector<XY> edge = stepless->points;
        chart.series.push_back(
            {.key = steplessKey,
             .kind = ChartSeries::Kind::band,
             .colour = Drawn::forbidden,
             .points = {{edge.front().x, forbidden_um}, {edge.back().x, forbidden_um}},
             .lower = edge,
             .alpha = forbiddenAlpha,
             .sight = InSight::never});
    }
    const std::vector<ConstraintKind> kinds = depthLimitKinds();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const QString name = LimitNames::limit(kinds[i]);
        add(static_cast<int>(kinds[i]), limit(kinds[i]), name, limitOf(name),
            style::limitOfDepth(i), style::lineOfDepthLimit(i, {}));
    }
    // Short names that fit two lines of the legend; the cursors have the full ones.
    add(accuracyKey, accuracy(AccuracyProof::proved), tr("accuracy"),
        limitOf(tr("accuracy, proved")), Tone::purple, linePen(2.6));
    add(estimateKey, accuracy(AccuracyProof::estimate), tr("accuracy, estimate"),
        limitOf(tr("accuracy at steady feed, estimate")), Tone::purple,
        linePen(2.6, Qt::DashDotLine));
    add(publishedKey, m_published, tr("runout (22)"),
        limitOf(tr("runout in every pass, as published (22)")), Tone::orange,
        linePen(2.6, Qt::DashDotDotLine));
    add(programmedKey, m_programmed, tr("programmed"), tr("programmed feed, µm"),
        Drawn::programmedFeed, linePen(3, Qt::DotLine));
    add(machineKey, m_machineFeed, tr("machine's feed", "legend"),
        limitOf(tr("machine's maximum feed")), {}, linePen(1.2, Qt::DashDotLine));
}

/// Ribbons in the colours of the limits they belong to.
void LimitChart::addEnvelope(LineChart& chart) const {
    for (const BoundCurve& piece : m_envelope) {
        int key = static_cast<int>(piece.kind);
        if (piece.bound != LimitBound::requirement) {
            key = piece.bound == LimitBound::feed ? machineKey : accuracyKey;
        }
        chart.series.push_back({.key = envelopeKey,
                                .name = tr("band: binding requirement"),
                                .kind = ChartSeries::Kind::ribbon,
                                .colour = chart.find(key)->colour,
                                .pen = linePen(pieceWidth),
                                .points = drawnLine(piece.points),
                                .alpha = pieceAlpha});
    }
}

CsvTable LimitChart::table(const std::function<bool(double)>& inSight,
                           const std::function<bool(ConstraintKind)>& wanted) const {
    CsvTable table;
    const LimitGroup* group = cuts();
    if (!group) {
        return table;
    }
    const bool strokes = m_outcome->result.project.operation->travels;
    table.header << tr("stage") << (strokes ? tr("double stroke") : tr("revolution"))
                 << tr("stock left, µm") << tr("actual feed, µm") << tr("width of cut, mm");
    bool named = false;
    for (const LimitedCut& cut : group->cuts) {
        if (!inSight(cut.stock_mm)) {
            continue;
        }
        const std::vector<DepthLimit> limits = limitsOf(cut);
        std::vector<CsvCell> row{double(cut.place.stage), double(cut.place.cycleCount),
                                 cut.stock_mm * umPerMm, cut.depth_mm * umPerMm, cut.width_mm};
        for (const DepthLimit& limit : limits) {
            if (wanted(limit.kind)) {
                row.emplace_back(limit.depth_mm * umPerMm);
                if (!named) {
                    table.header << tr("limit: %1, µm").arg(LimitNames::limit(limit.kind));
                }
            }
        }
        if (const DepthLimit* binding = bindingOf(limits)) {
            row.insert(row.end(), {binding->depth_mm * umPerMm, LimitNames::limit(binding->kind)});
            if (!named) {
                table.header << tr("stepless limit, µm") << tr("binding");
            }
        }
        named = true;
        table.rows.push_back(std::move(row));
    }
    return table;
}

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
