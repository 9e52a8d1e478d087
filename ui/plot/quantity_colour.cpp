// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/quantity_colour.h"

#include "core/simulation/feed_curves.h"

#include <QPainter>

#include <algorithm>
#include <array>

namespace sparkout::style {

namespace {

struct Row {
    Drawn what;
    std::optional<Tone> tone; ///< empty: the colour of texts
};

constexpr Row table[] = {
    {Drawn::programmedFeed, Tone::blue},
    {Drawn::actualFeed, Tone::vermilion},
    {Drawn::radiusBefore, Tone::green},
    {Drawn::radiusAfter, Tone::purple},
    {Drawn::axialFeed, Tone::orange},
    {Drawn::force, std::nullopt},
    {Drawn::oddStage, Tone::sky},
    {Drawn::evenStage, Tone::yellow},
    {Drawn::measuredValue, Tone::blue},
    {Drawn::simulatedValue, Tone::vermilion},
    {Drawn::measuredDifference, Tone::purple},
    {Drawn::profile, Tone::vermilion},
    {Drawn::blank, Tone::orange},
    {Drawn::target, Tone::blue},
    {Drawn::referenceCircle, Tone::purple},
    {Drawn::toleranceField, Tone::green},
    {Drawn::endZone, Tone::sky},
    {Drawn::middleZone, Tone::yellow},
    {Drawn::wheel, Tone::orange},
    {Drawn::gauge, Tone::blue},
    {Drawn::bestGaugePlace, Tone::green},
    {Drawn::presentGaugePlace, Tone::vermilion},
    {Drawn::allDiameters, Tone::sky},
    {Drawn::wheelHead, Tone::blue},
    {Drawn::headstock, Tone::green},
    {Drawn::tailstock, Tone::orange},
    {Drawn::bending, Tone::purple},
    {Drawn::rests, Tone::vermilion},
    {Drawn::independentSections, Tone::blue},
    {Drawn::coupledSections, Tone::orange},
    {Drawn::couplingDifference, Tone::purple},
    {Drawn::limit, Tone::vermilion},
    {Drawn::forbidden, Tone::vermilion},
    {Drawn::everyRequirementHolds, Tone::green},
    {Drawn::holds, Tone::green},
    {Drawn::close, Tone::orange},
    {Drawn::fails, Tone::vermilion},
    {Drawn::refused, Tone::vermilion},
    {Drawn::sizeNotReached, Tone::orange},
    {Drawn::frequency, Tone::sky},
    {Drawn::cumulativeShare, Tone::vermilion},
    {Drawn::mean, Tone::blue},
    {Drawn::goodPart, Tone::blue},
    {Drawn::partOutside, Tone::vermilion},
    {Drawn::worstPart, Tone::orange},
    {Drawn::quickestCycle, Tone::vermilion},
    {Drawn::lowerBound, Tone::orange},
    {Drawn::yourCycle, Tone::blue},
    {Drawn::steplessLimit, Tone::green},
};

constexpr bool isWhole() {
    std::size_t next = 0;
    for (const Row& row : table) {
        if (row.what != static_cast<Drawn>(next++)) {
            return false;
        }
    }
    return next == static_cast<std::size_t>(Drawn::count_);
}
static_assert(isWhole(), "a row for each thing that is drawn, in the order of the enumeration");

constexpr std::array series{Tone::blue, Tone::orange,    Tone::green, Tone::purple,
                            Tone::sky,  Tone::vermilion, Tone::yellow};
constexpr std::array depthLimits{Tone::blue, Tone::orange, Tone::green, Tone::sky, Tone::purple};
constexpr std::array steps{Tone::orange, Tone::green,  Tone::sky,  Tone::orange,
                           Tone::purple, Tone::yellow, Tone::blue, Tone::sky};

} // namespace

Drawn drawnAs(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmed:
    case Quantity::programmedSum: return Drawn::programmedFeed;
    case Quantity::actual:
    case Quantity::actualSum: return Drawn::actualFeed;
    case Quantity::came: return Drawn::radiusBefore;
    case Quantity::left: return Drawn::radiusAfter;
    case Quantity::axialFeed: return Drawn::axialFeed;
    case Quantity::force: break;
    }
    return Drawn::force;
}

QColor colour(Drawn what, const QPalette& palette) {
    const std::optional<Tone> own = table[static_cast<std::size_t>(what)].tone;
    return own ? tone(*own, palette) : palette.color(QPalette::Text);
}

Tone oneOfSeries(std::size_t index) {
    return series[index % series.size()];
}

Tone limitOfDepth(std::size_t index) {
    return depthLimits[std::min(index, depthLimits.size() - 1)];
}

Tone stepOfStroke(std::size_t index, const QPalette& palette) {
    const Tone own = steps.at(index);
    return own == Tone::blue && isDark(palette) ? Tone::vermilion : own; // where blue is the sky
}

namespace {

struct Line {
    Qt::PenStyle dash = Qt::SolidLine;
    double weight = 1.5;
};

struct LineRow {
    Drawn what;
    Line line;
};

constexpr LineRow lines[] = {
    {Drawn::programmedFeed, {Qt::DashLine, 1.5}},
    {Drawn::actualFeed, {Qt::SolidLine, 1.5}},
    {Drawn::radiusBefore, {Qt::DotLine, 1.5}},
    {Drawn::radiusAfter, {Qt::DashDotLine, 1.8}},
    {Drawn::axialFeed, {Qt::DashDotDotLine, 1.8}},
    {Drawn::force, {Qt::SolidLine, 2.5}},
    {Drawn::measuredValue, {Qt::SolidLine, 1.2}},
    {Drawn::simulatedValue, {Qt::DashLine, 1.8}},
    {Drawn::measuredDifference, {Qt::DotLine, 1.5}},
    {Drawn::profile, {Qt::SolidLine, 1.9}},
    {Drawn::blank, {Qt::DotLine, 1.4}},
    {Drawn::target, {Qt::DashLine, 1.3}},
    {Drawn::referenceCircle, {Qt::DashDotDotLine, 1.3}},
    {Drawn::toleranceField, {Qt::SolidLine, 1}},
    {Drawn::gauge, {Qt::DashDotLine, 1.2}},
    {Drawn::independentSections, {Qt::SolidLine, 2}},
    {Drawn::coupledSections, {Qt::DashLine, 2}},
    {Drawn::couplingDifference, {Qt::DotLine, 2}},
    {Drawn::limit, {Qt::DashLine, 1.5}},
};

constexpr std::array depthLimitLines{Line{Qt::DashLine, 1.6}, Line{Qt::DashDotLine, 1.6},
                                     Line{Qt::DashLine, 2.6}, Line{Qt::DashDotDotLine, 1.6},
                                     Line{Qt::DotLine, 1.6}};

QPen penOf(const Line& line, const QColor& colour) {
    return {colour, line.weight, line.dash};
}

} // namespace

QPen line(Drawn what, const QColor& colour) {
    const auto* const found = std::ranges::find(lines, what, &LineRow::what);
    return penOf(found == std::end(lines) ? Line() : found->line, colour);
}

QPen lineOfDepthLimit(std::size_t index, const QColor& colour) {
    return penOf(depthLimitLines[std::min(index, depthLimitLines.size() - 1)], colour);
}

} // namespace sparkout::style

namespace sparkout {

namespace {

constexpr double dashWidth = 1.6;
constexpr double thicker = 1.2; ///< factor on the width for each repetition of the patterns

const std::array<QVector<qreal>, 6>& runDashes() {
    static const std::array<QVector<qreal>, 6> all{
        QVector<qreal>{4, 2}, QVector<qreal>{1, 1.5}, QVector<qreal>{6, 1.5, 1, 1.5},
        QVector<qreal>{8, 3}, QVector<qreal>{2, 2},   QVector<qreal>{6, 1.5, 1, 1.5, 1, 1.5}};
    return all;
}

} // namespace

QVector<qreal> runDash(int number) {
    return number > 0 ? runDashes()[static_cast<std::size_t>(number - 1) % runDashes().size()]
                      : QVector<qreal>();
}

QPen runPen(int number, const QColor& colour) {
    const int round = number > 0 ? (number - 1) / static_cast<int>(runDashes().size()) : 0;
    QPen pen(colour, dashWidth + thicker * round, Qt::SolidLine, Qt::FlatCap);
    if (const QVector<qreal> dash = runDash(number); !dash.isEmpty()) {
        pen.setDashPattern(dash);
    }
    return pen;
}

QPixmap runSample(int number, const QColor& colour, const QSize& size, qreal ratio) {
    QPixmap sample((QSizeF(size) * ratio).toSize());
    sample.setDevicePixelRatio(ratio);
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setPen(runPen(number, colour));
    const double middle = size.height() / 2.0;
    painter.drawLine(QLineF(0, middle, size.width(), middle));
    return sample;
}

} // namespace sparkout
