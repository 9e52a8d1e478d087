// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/phase_chart.h"

#include "core/batch/scenario_source.h"
#include "core/project/given_factors.h"
#include "core/project/part.h"
#include "core/units.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr qsizetype mostRangesNamed = 3, mostReasonsNamed = 2;
constexpr int stockDigits = 5, percentDigits = 3;
constexpr double leastShareNamed = 1e-6;

bool lies(double stock_mm, double from_mm, double to_mm) {
    return from_mm <= stock_mm && stock_mm <= to_mm;
}

bool sameReason(const FailingStocks& a, const FailingStocks& b) {
    return a.status == b.status && a.worst.has_value() == b.worst.has_value()
           && (!a.worst
               || (a.worst->kind == b.worst->kind && a.worst->zone == b.worst->zone
                   && a.worst->section == b.worst->section && a.worst->stage == b.worst->stage));
}

/// Overlapping ranges of neighbouring pieces with the same failure are joined.
std::vector<FailingStocks> joinedRanges(const std::vector<FailingStocks>& failing) {
    std::vector<FailingStocks> joined;
    for (const FailingStocks& each : failing) {
        if (!joined.empty() && sameReason(joined.back(), each)
            && each.stocks.from_mm <= joined.back().stocks.to_mm) {
            joined.back().stocks.to_mm = std::max(joined.back().stocks.to_mm, each.stocks.to_mm);
        } else {
            joined.push_back(each);
        }
    }
    return joined;
}

} // namespace

QString PhaseText::progress(qint64, qint64, double) {
    return tr("The stocks are being checked");
}

QString PhaseText::counted(const PhaseDecision& decision) {
    return tr("Pieces: %1").arg(decision.pieces.size());
}

QString PhaseText::undecidable() {
    return tr("Under position control the stocks within one infeed cannot be decided: the wheel "
              "touches the part at an unknown point within the first infeed. Vary the stock in a "
              "sweep, or let it scatter in a batch.");
}

QString PhaseText::millimetres(double stock_mm) {
    return printedNumber(stock_mm, stockDigits);
}

QString PhaseText::reason(RunStatus status, const std::optional<ConstraintResult>& worst) {
    if (status != RunStatus::completed) {
        return Names::status(status);
    }
    return worst ? QStringLiteral("%1, %2").arg(Names::inSentence(Names::constraint(worst->kind)),
                                                Names::within(Names::where(*worst)))
                 : QString();
}

QString PhaseText::verdict(const PhaseDecision& decision) {
    if (decision.hasTooMany) {
        return tr("The range has more than %1 pieces: enter a narrower range.")
            .arg(QLocale().toString(qulonglong{mostDecidedPieces}));
    }
    if (decision.holds()) {
        return tr("The cycle is fit for every stock per side from %1 to %2 mm.")
            .arg(millimetres(decision.range.from_mm), millimetres(decision.range.to_mm));
    }
    std::vector<std::pair<QString, QStringList>> byReason;
    for (const FailingStocks& each : joinedRanges(decision.failing)) {
        const QString why = reason(each.status, each.worst);
        auto found = std::ranges::find(byReason, why, &std::pair<QString, QStringList>::first);
        if (found == byReason.end()) {
            found = byReason.insert(byReason.end(), {why, {}});
        }
        found->second << tr("from %1 to %2")
                             .arg(millimetres(each.stocks.from_mm), millimetres(each.stocks.to_mm));
    }
    QStringList lines;
    for (const auto& [why, ranges] : byReason) {
        if (lines.size() == mostReasonsNamed) {
            lines << tr("With other stocks, other requirements are not met: see the table of the "
                        "plot.");
            break;
        }
        const auto more = ranges.size() - mostRangesNamed;
        lines << tr("The cycle is unfit for stocks per side %1 mm%2: %3.")
                     .arg(ranges.mid(0, mostRangesNamed).join(QStringLiteral(", ")),
                          more > 0 ? tr(" (further ranges: %1)").arg(more) : QString(), why);
    }
    return lines.join(u'\n');
}

QString PhaseText::share(const Project& project, const PhaseDecision& decision) {
    if (!decision.isDecided) {
        return {};
    }
    const std::vector<GivenFactor> factors = givenFactors(project);
    const auto stock = std::ranges::find(factors, FactorKind::stock, &GivenFactor::kind);
    if (stock == factors.end() || stock->isLaw()) {
        return {};
    }
    const FailingShare shares =
        failingShare(decision, [&stock](double stock_mm) { return factorRank(*stock, stock_mm); });
    const auto percent = [](double share) {
        return printedNumber(100 * share, percentDigits) + QStringLiteral("\u00a0%");
    };
    const QString failing = tr("Rejected by stock alone: %1.").arg(percent(shares.failing));
    return shares.undecided < leastShareNamed
               ? failing
               : failing + u' '
                     + tr("The stock of %1 lies outside the range.").arg(percent(shares.undecided));
}

QString PhaseText::steps(const DecidedPiece& decided) {
    QStringList counts;
    for (const int count : decided.piece.counts) {
        counts << QString::number(count);
    }
    return counts.join(QStringLiteral(" + "));
}

QString PhaseText::pieceVerdict(const DecidedPiece& decided) {
    if (decided.holdsWhole()) {
        return tr("fit");
    }
    const QString why = reason(decided.piece.status, decided.worst);
    return decided.holds ? tr("fit from %1 to %2 mm, otherwise unfit: %3")
                               .arg(millimetres(decided.holds->from_mm),
                                    millimetres(decided.holds->to_mm), why)
                         : tr("unfit: %1").arg(why);
}

std::optional<DeviationRange> PhaseText::sizes(const PieceEnd& end) {
    if (end.deviations.empty()) {
        return std::nullopt;
    }
    DeviationRange all = end.deviations.front();
    for (const DeviationRange& each : end.deviations) {
        all.least_mm = std::min(all.least_mm, each.least_mm);
        all.most_mm = std::max(all.most_mm, each.most_mm);
    }
    return std::isfinite(all.least_mm) && std::isfinite(all.most_mm) ? std::optional(all)
                                                                     : std::nullopt;
}

QString PhaseText::stock(const PhaseDecision& decision, double stock_mm) {
    const auto found = std::ranges::find_if(decision.pieces, [&](const DecidedPiece& each) {
        return lies(stock_mm, each.piece.from_mm, each.piece.to_mm);
    });
    if (found == decision.pieces.end()) {
        return {};
    }
    QString text = tr("Stock %1 mm: steps %2, %3")
                       .arg(millimetres(stock_mm), steps(*found), Names::time(found->time_s));
    const auto low = sizes(found->low), high = sizes(found->high);
    if (low && high) {
        const double length_mm = found->piece.to_mm - found->piece.from_mm;
        const double share = length_mm > 0 ? (stock_mm - found->piece.from_mm) / length_mm : 0;
        const auto between = [share](double from_mm, double to_mm) {
            return Names::signedMicrometres((from_mm + share * (to_mm - from_mm)) * units::umPerMm);
        };
        text +=
            tr(", diameters %1…%2 µm from nominal")
                .arg(between(low->least_mm, high->least_mm), between(low->most_mm, high->most_mm));
    }
    const auto failing = std::ranges::find_if(decision.failing, [&](const FailingStocks& each) {
        return lies(stock_mm, each.stocks.from_mm, each.stocks.to_mm);
    });
    return text + QStringLiteral("; ")
           + (failing == decision.failing.end()
                  ? tr("all requirements are met")
                  : tr("unfit: %1").arg(reason(failing->status, failing->worst)));
}

using style::Drawn;

namespace {

constexpr double phaseRoom = 0.05; ///< room beside and above the curves
constexpr int phaseFieldAlpha = 60, failingAlpha = 38;

void addPiece(ChartSeries& line, const PhasePiece& piece, double from_mm, double to_mm) {
    line.points.push_back({piece.from_mm, from_mm * units::umPerMm});
    line.points.push_back({piece.to_mm, to_mm * units::umPerMm});
    line.points.push_back({piece.to_mm, std::numeric_limits<double>::quiet_NaN()});
}

} // namespace

LineChart PhaseChart::of(const PhaseOutcomePtr& phases) {
    LineChart chart;
    chart.across = {.label = tr("Stock per side, mm"), .room = phaseRoom / 2};
    chart.up = {.label = tr("Deviation of the diameter from nominal, µm"), .room = phaseRoom};
    if (!phases) {
        return chart;
    }
    const PhaseDecision& decision = phases->decision;
    const Part& part = *phases->project.part;
    ChartSeries largest{.key = largestKey,
                        .name = tr("maximum diameter"),
                        .colour = style::oneOfSeries(0),
                        .pen = runPen(0, {})};
    ChartSeries smallest{.key = smallestKey,
                         .name = tr("minimum diameter"),
                         .colour = style::oneOfSeries(1),
                         .pen = runPen(1, {})};
    for (const DecidedPiece& each : decision.pieces) {
        const auto low = PhaseText::sizes(each.low), high = PhaseText::sizes(each.high);
        if (low && high) {
            addPiece(largest, each.piece, low->most_mm, high->most_mm);
            addPiece(smallest, each.piece, low->least_mm, high->least_mm);
        }
    }
    chart.series = {std::move(largest), std::move(smallest)};
    chart.zones = {{.ranges = {{part.lower_deviation_um, part.upper_deviation_um}},
                    .isUpright = false,
                    .key = toleranceKey,
                    .name = tr("tolerance band"),
                    .colour = Drawn::toleranceField,
                    .alpha = phaseFieldAlpha,
                    .sight = InSight::always}};
    ChartZone failing{.key = failsKey,
                      .name = tr("unfit stocks"),
                      .colour = Drawn::fails,
                      .alpha = failingAlpha,
                      .hatch = Hatch::rising};
    for (const StockRange& each : decision.failingRanges()) {
        failing.ranges.push_back({each.from_mm, each.to_mm});
    }
    if (!failing.ranges.empty()) {
        chart.zones.push_back(std::move(failing));
    }
    chart.rules = {{.at = part.stock_mm,
                    .key = statedKey,
                    .name = tr("stated stock"),
                    .pen = linePen(1.5, Qt::DotLine)}};
    chart.across.range = {decision.range.from_mm, decision.range.to_mm};
    chart.placeText = [phases](double stock_mm) {
        return PhaseText::stock(phases->decision, stock_mm);
    };
    chart.table = [phases] { return table(phases->decision); };
    return chart;
}

ChartTable PhaseChart::table(const PhaseDecision& decision) {
    std::size_t stages = 0;
    double longest_s = 0;
    for (const DecidedPiece& each : decision.pieces) {
        stages = std::max(stages, each.piece.counts.size());
        longest_s = std::max(longest_s, each.time_s);
    }
    const TimeUnit unit(longest_s);
    ChartTable table;
    QStringList& header = table.cells.header;
    header << tr("From stock per side, mm") << tr("To stock per side, mm");
    for (std::size_t i = 0; i < stages; ++i) {
        header << tr("Steps of stage %1").arg(i + 1);
    }
    header << unit.titled(tr("Time")) << tr("Minimum deviation of the diameter, µm")
           << tr("Maximum deviation of the diameter, µm") << tr("Verdict");
    for (const DecidedPiece& each : decision.pieces) {
        std::vector<CsvCell> row{each.piece.from_mm, each.piece.to_mm};
        for (std::size_t i = 0; i < stages; ++i) {
            row.push_back(i < each.piece.counts.size() ? CsvCell(double(each.piece.counts[i]))
                                                       : CsvCell());
        }
        row.emplace_back(unit.of(each.time_s));
        const auto low = PhaseText::sizes(each.low), high = PhaseText::sizes(each.high);
        row.push_back(low && high ? CsvCell(low->least_mm * units::umPerMm) : CsvCell());
        row.push_back(low && high ? CsvCell(high->most_mm * units::umPerMm) : CsvCell());
        row.emplace_back(PhaseText::pieceVerdict(each));
        table.cells.rows.push_back(std::move(row));
        table.places.push_back({.across = {each.piece.from_mm, each.piece.to_mm}});
    }
    return table;
}

} // namespace sparkout
