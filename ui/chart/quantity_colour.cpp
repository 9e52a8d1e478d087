// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/quantity_colour.h"

#include "core/simulation/feed_curves.h"
#include "core/simulation/progress.h"
#include "ui/text/names.h"

#include <QCoreApplication>
#include <QPainter>
#include <QStringList>

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
    return own == Tone::blue && isDark(palette) ? Tone::vermilion : own; // where blue means the sky
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

namespace {

class FeedText {
    Q_DECLARE_TR_FUNCTIONS(FeedText)
public:
    static QString name(Quantity quantity);
    static QString withUnit(Quantity quantity);
    static QString where(const FeedPoint& p, double time_s, const FeedSeries& series);
    static QString values(const FeedPoint& p, const FeedSeries& series);

private:
    static QString spread(const Spread& s, bool sign);
};

QString FeedText::name(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmed: return tr("programmed feed");
    case Quantity::actual: return tr("actual feed");
    case Quantity::programmedSum: return tr("accumulated programmed feed");
    case Quantity::actualSum: return tr("accumulated actual feed");
    case Quantity::came: return tr("radius before the pass");
    case Quantity::left: return tr("radius after the pass");
    case Quantity::axialFeed: return tr("axial feed");
    case Quantity::force: return tr("normal force");
    }
    return {};
}

QString FeedText::withUnit(Quantity quantity) {
    switch (quantity) {
    case Quantity::axialFeed: return tr("%1, mm/min").arg(name(quantity));
    case Quantity::force: return tr("%1, N").arg(name(quantity));
    default: return tr("%1, µm").arg(name(quantity));
    }
}

QString FeedText::spread(const Spread& s, bool sign) {
    const auto text = [sign](double v) {
        return sign ? Names::signedMicrometres(v) : Names::micrometres(v);
    };
    if (s.max - s.min < 0.005) {
        return text(s.mean);
    }
    return QStringLiteral("%1 (%2…%3)").arg(text(s.mean), text(s.min), text(s.max));
}

QString FeedText::where(const FeedPoint& p, double time_s, const FeedSeries& series) {
    QStringList parts{Names::place(p.place, series.operation)};
    if (series.operation->travels && p.place.revolution > 0) {
        parts << tr("pass %1").arg(p.place.revolution);
    }
    if (p.radius >= 0) {
        parts << tr("radius %1").arg(p.radius);
    }
    return parts.join(QStringLiteral(", ")) + QStringLiteral(" — ") + Names::time(time_s, 4);
}

QString FeedText::values(const FeedPoint& p, const FeedSeries& series) {
    QStringList parts;
    parts << tr("feed: programmed %1, actual %2 µm")
                 .arg(spread(p.programmed_um, false), spread(p.actual_um, false));
    parts << tr("accumulated: programmed %1, actual %2 µm")
                 .arg(spread(p.programmedSum_um, false), spread(p.actualSum_um, false));
    parts << tr("radius before %1, after %2 µm")
                 .arg(spread(p.came_um, true), spread(p.left_um, true));
    if (series.operation->axial() && p.axialFeed_mm_min > 0) {
        parts << tr("axial feed %1 mm/min").arg(Names::significant(p.axialFeed_mm_min));
    }
    parts << tr("force %1 N").arg(Names::significant(p.force_n.mean));
    return parts.join(QStringLiteral("; "));
}

} // namespace

QString quantityName(Quantity quantity) {
    return FeedText::name(quantity);
}

QString quantityWithUnit(Quantity quantity) {
    return FeedText::withUnit(quantity);
}

Digits quantityDigits(Quantity quantity) {
    switch (quantity) {
    case Quantity::came:
    case Quantity::left: return Digits::signedHundredths;
    case Quantity::axialFeed:
    case Quantity::force: return Digits::significant;
    default: return Digits::hundredths;
    }
}

QString feedText(const FeedPoints& points, double time_s, const FeedSeries& series,
                 bool wholeStrokes) {
    const FeedPoint* const at = feedPointAt(points, time_s);
    return at ? FeedText::where(*at, wholeStrokes ? at->end_s : time_s, series) + u'\n'
                    + FeedText::values(*at, series)
              : QString();
}

QString strokeStepName(StrokeStep step) {
    QStringList codes;
    QString meaning;
    for (const Zone zone : {Zone::rz1, Zone::nz, Zone::rz2}) {
        const Step of = stepOf(zone, step);
        if (of != Step::none) {
            codes << Names::step(of);
            meaning = Names::stepMeaning(zone, of);
        }
    }
    return codes.isEmpty() ? QString() : QStringLiteral("%1 %2").arg(codes.join(u'/'), meaning);
}

} // namespace sparkout
