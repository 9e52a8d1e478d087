// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/batch_text.h"

#include "core/digits.h"
#include "core/project/batch.h"
#include "core/quality/constraints.h"
#include "core/quality/roughness.h"
#include "ui/chart/plot_view.h"
#include "ui/text/field_text.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

struct BatchFigures {
    Q_DECLARE_TR_FUNCTIONS(BatchFigures)
};

using Figures = CharacteristicFigures;

const QString dash = QStringLiteral("–");

/// The displayed percentiles: those of ±3s of a normal quantity, and the median.
struct ShownPercentile {
    const char* key;
    double order;
};
constexpr ShownPercentile shownPercentiles[] = {
    {"low_percentile", 0.00135}, {"median", 0.5}, {"high_percentile", 0.99865}};

QString percentileName(double order) {
    return order == 0.5 ? BatchFigures::tr("Median")
                        : BatchFigures::tr("Percentile %1 %").arg(QLocale().toString(100 * order));
}

QString percentileHint(double order) {
    const QString text =
        order < 0.5 ? BatchFigures::tr("%1 % of the parts lie below this value, as below mean − 3 "
                                       "s of a normal quantity; given for 741 parts or more")
        : order > 0.5 ? BatchFigures::tr("%1 % of the parts lie above this value, as above mean + "
                                         "3 s of a normal quantity; given for 741 parts or more")
                      : QString();
    return text.isEmpty() ? text : text.arg(QLocale().toString(100 * std::min(order, 1 - order)));
}

QString percentileText(const Figures& figures, double order) {
    const auto found = std::ranges::find(figures.of->percentiles, order, &Percentile::order);
    return figures.isSample && found != figures.of->percentiles.end()
               ? BatchText::percentile(*found, *figures.of)
               : dash;
}

QString textOf(const Output<Figures>& row, const Figures& figures) {
    const Characteristic& of = figures.of->characteristic;
    const std::string_view key = row.key;
    const OutputValue value = row.of(figures);
    if (key == "normality_probability") {
        return BatchText::normality(*figures.of);
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return key == "standard_deviation" ? BatchText::scatter(*number, of)
                                           : BatchText::value(*number, of);
    }
    if (const auto* interval = std::get_if<Interval>(&value)) {
        return BatchText::range(*interval, of);
    }
    if (const auto* estimate = std::get_if<Estimate>(&value)) {
        return BatchText::capability(*estimate);
    }
    const auto* const share = std::get_if<Share>(&value);
    return share ? BatchText::share(*share) : dash;
}

class Filler {
public:
    Filler(ValueTable& table, const std::vector<Figures>& places)
        : m_table(table), m_places(places) {}

    template <class Text>
    void add(ValueHead head, Text text) {
        std::vector<ValueCell> cells;
        for (const Figures& place : m_places) {
            cells.push_back({.text = text(place)});
        }
        m_table.addRow(std::move(head), std::move(cells));
    }

private:
    ValueTable& m_table;
    const std::vector<Figures>& m_places;
};

} // namespace

ValueTable batchFigures(const BatchSummary& summary, const std::string& name, bool tellsIndices) {
    ValueTable table;
    std::vector<Figures> places;
    for (const std::size_t place : placesOf(summary, name)) {
        places.push_back({&summary.characteristics[place], summary.isSample, summary.drifts});
        const Characteristic& of = places.back().of->characteristic;
        const bool isOfWheel = of.requirement && of.requirement->kind == ConstraintKind::waviness;
        const auto nameOf = isOfWheel ? Names::ofWheel : Names::ofMachine;
        table.columns.push_back(
            {BatchText::where(of), nameOf(BatchText::full(of), of.knowsMachine), {}});
    }
    if (places.empty()) {
        return table;
    }
    Filler filler(table, places);
    for (const Output<Figures>& row : characteristicOutputs()) {
        const std::string_view key = row.key;
        if (key == "pp") {
            for (const ShownPercentile& each : shownPercentiles) {
                filler.add({percentileName(each.order), {}, percentileHint(each.order), each.key},
                           [&each](const Figures& of) { return percentileText(of, each.order); });
            }
        }
        if (row.detail || !*row.label) {
            continue;
        }
        const bool isHidden =
            !tellsIndices && (key == "mean_interval_95" || key == "pp" || key == "ppk");
        const QString label = key == "normality_probability"
                                  ? BatchText::shortNormalityName(summary)
                                  : outputBrief(row);
        filler.add({label, {}, outputHint(row), row.key},
                   [&](const Figures& of) { return isHidden ? dash : textOf(row, of); });
    }
    return table;
}

QString figureText(const CharacteristicFigures& figures, std::string_view key) {
    const auto row = std::ranges::find_if(
        characteristicOutputs(), [key](const Output<Figures>& each) { return each.key == key; });
    return row == characteristicOutputs().end() ? dash : textOf(*row, figures);
}

CsvTable batchFiguresTable(const BatchSummary& summary) {
    CsvTable table;
    table.ownUnits = true;
    table.header << BatchFigures::tr("Where") << BatchFigures::tr("Characteristic")
                 << BatchFigures::tr("Unit");
    addOutputHeads(table.header, characteristicOutputs());
    table.header << BatchFigures::tr("Normality, test");
    const std::vector<Figures> all = figuresOf(summary);
    if (summary.isSample && !all.empty()) {
        for (const Percentile& percentile : all.front().of->percentiles) {
            addEstimateHeads(table.header, percentileName(percentile.order));
        }
    }
    for (const Figures& figures : all) {
        const Characteristic& of = figures.of->characteristic;
        std::vector<CsvCell>& row = table.rows.emplace_back();
        row = {BatchText::where(of), BatchText::name(of), unitText(of.unit)};
        addOutputCells(row, characteristicOutputs(), &figures);
        const auto& normality = figures.of->normality;
        row.push_back(normality ? CsvCell(BatchText::test(normality->test)) : CsvCell());
        for (const Percentile& percentile : figures.of->percentiles) {
            if (summary.isSample) {
                const bool isStated = BatchText::isStated(percentile, *figures.of);
                row.push_back(isStated ? CsvCell(percentile.value) : CsvCell());
                addIntervalCells(row, isStated ? percentile.interval : std::nullopt);
            }
        }
    }
    return table;
}

namespace {

constexpr double doubtful = 0.05; ///< probability below which a distribution is called not normal

/// Formats a share that never rounds to 0 or to 100 %.
QString percent(double share) {
    const double hundredth = 100 * share;
    const double toEnd = std::min(hundredth, 100 - hundredth);
    int decimals = hundredth > 0 && hundredth < 10 ? 1 : 0;
    if (toEnd > 1e-6 && toEnd < 1) {
        decimals = std::max(1, static_cast<int>(std::ceil(-std::log10(toEnd))));
    }
    return Names::fixed(hundredth, decimals);
}

int decimalsOf(const Characteristic& characteristic) {
    return std::clamp(static_cast<int>(std::lround(-std::log10(characteristic.resolution))), 0, 6);
}

} // namespace

QString BatchText::name(const Characteristic& characteristic) {
    return characteristic.requirement   ? Names::constraint(characteristic.requirement->kind)
           : characteristic.section < 0 ? tr("Machining time")
                                        : tr("Mean diameter");
}

QString BatchText::shortName(const Characteristic& characteristic) {
    return characteristic.requirement   ? Names::constraintBrief(characteristic.requirement->kind)
           : characteristic.section < 0 ? name(characteristic)
                                        : tr("Diameter");
}

QString BatchText::where(const Characteristic& characteristic) {
    return characteristic.section < 0 ? tr("whole part")
                                      : Names::zone(characteristic.zone, characteristic.section);
}

QString BatchText::full(const Characteristic& characteristic) {
    return characteristic.section < 0
               ? name(characteristic)
               : QStringLiteral("%1, %2").arg(name(characteristic),
                                              Names::within(where(characteristic)));
}

QString BatchText::axis(const Characteristic& characteristic) {
    return QStringLiteral("%1, %2").arg(name(characteristic), unitText(characteristic.unit));
}

QString BatchText::factor(const GivenFactor& factor) {
    const QString name = inputText(factorLabel(factor));
    if (factor.place < 0) {
        return name;
    }
    const Zone zone = factor.isOfZone ? static_cast<Zone>(factor.place) : Zone::section;
    return QStringLiteral("%1, %2").arg(name, Names::within(Names::zone(zone, factor.place)));
}

QString BatchText::factorAxis(const GivenFactor& of) {
    const char* unit = tableOf<Factors>().fields[static_cast<std::size_t>(of.kind)].unit;
    return *unit ? QStringLiteral("%1, %2").arg(factor(of), unitText(unit)) : factor(of);
}

QString BatchText::value(double value, const Characteristic& characteristic) {
    if (characteristic.isEstimate) {
        return Names::estimate(value, value * roughnessSpread * roughnessSpread);
    }
    const Requirement* const row = characteristic.requirement;
    return row && !row->isDeviation ? scatter(value, characteristic) : mark(value, characteristic);
}

QString BatchText::scatter(double deviation, const Characteristic& characteristic) {
    return characteristic.isEstimate ? value(deviation, characteristic)
                                     : Names::amountFixed(deviation, decimalsOf(characteristic));
}

QString BatchText::mark(double value, const Characteristic& characteristic) {
    return Names::fixed(value, decimalsOf(characteristic));
}

bool BatchText::isStated(const Percentile& percentile, const CharacteristicSummary& of) {
    const double beyond = std::min(percentile.order, 1 - percentile.order);
    return beyond == 0.5 || static_cast<double>(of.count) * beyond >= 1;
}

QString BatchText::percentile(const Percentile& percentile, const CharacteristicSummary& of) {
    return isStated(percentile, of) ? value(percentile.value, of.characteristic)
                                    : QStringLiteral("–");
}

QString BatchText::range(const Interval& interval, const Characteristic& characteristic) {
    const QString low = value(interval.low, characteristic);
    const QString high = value(interval.high, characteristic);
    const QString sign = QStringLiteral("≈\u00a0"); // once for both
    return low == high ? low : low + u'…' + (high.startsWith(sign) ? high.mid(sign.size()) : high);
}

QString BatchText::capability(const std::optional<Estimate>& capability,
                              std::optional<double> limit) {
    if (!capability) {
        return QStringLiteral("–");
    }
    const Interval& bounds = capability->interval;
    const int decimals = limit ? decimalsBeside(*limit, bounds.low, 2) : 2;
    return QStringLiteral("%1 (%2…%3)")
        .arg(Names::fixed(capability->value, decimals), Names::fixed(bounds.low, decimals),
             Names::fixed(bounds.high, decimals));
}

QString BatchText::brief(const Estimate& capability) {
    return Names::fixed(capability.value, 2);
}

QString BatchText::share(const Share& share) {
    if (!share.interval) {
        return tr("%1 (%2 %)").arg(share.count).arg(percent(share.value));
    }
    return tr("%1 (%2 %; %3…%4 %)")
        .arg(share.count)
        .arg(percent(share.value), percent(share.interval->low), percent(share.interval->high));
}

QString BatchText::normality(const CharacteristicSummary& summary) {
    if (!summary.normality) {
        return QStringLiteral("–");
    }
    const double probability = summary.normality->probability;
    const QString p = probability < 0.001 ? QStringLiteral("< %1").arg(Names::fixed(0.001, 3))
                                          : Names::fixed(probability, 3);
    return probability < doubtful ? tr("%1, not normal").arg(p) : p;
}

QString BatchText::test(NormalityTest test) {
    return test == NormalityTest::shapiroWilk ? tr("Shapiro–Wilk") : tr("Anderson–Darling");
}

std::optional<NormalityTest> BatchText::testOf(const BatchSummary& summary) {
    const auto tested = std::ranges::find_if(
        summary.characteristics, [](const auto& of) { return of.normality.has_value(); });
    return tested == summary.characteristics.end() ? std::nullopt
                                                   : std::optional(tested->normality->test);
}

QString BatchText::normalityName(const BatchSummary& summary) {
    const auto of = testOf(summary);
    return of ? tr("Normality, p (%1)", "name of the test").arg(test(*of)) : tr("Normality, p");
}

QString BatchText::shortNormalityName(const BatchSummary& summary) {
    const auto of = testOf(summary);
    return of ? tr("%1, p", "name of the test").arg(test(*of)) : tr("Normality, p");
}

QString BatchText::fitness(Fitness fitness) {
    switch (fitness) {
    case Fitness::fit: return tr("is fit");
    case Fitness::conditional: return tr("is conditionally fit");
    case Fitness::unfit: return tr("is unfit");
    }
    return {};
}

QString BatchText::decision(const BatchOutcome& outcome) {
    const BatchSummary& summary = outcome.summary;
    const BatchVerdict verdict = weigh(summary, outcome.result);
    const CharacteristicSummary* const of =
        verdict.characteristic ? &summary.characteristics[*verdict.characteristic] : nullptr;
    const auto inSentence = [&of] { return Names::inSentence(full(of->characteristic)); };
    const auto limit = [&verdict] { return Names::significant(verdict.limit); };
    const auto limitPercent = [&verdict] { return Names::significant(100 * verdict.limit); };
    switch (verdict.reason) {
    case BatchReason::noPart: return tr("no part was run");
    case BatchReason::partsFail:
        return verdict.limit > 0 ? tr("%1 % of the parts are rejected, more than the allowed %2 %")
                                       .arg(percent(verdict.value), limitPercent())
                                 : tr("not every part is good");
    case BatchReason::someFail:
        return tr("%1 % of the parts are rejected, no more than the allowed %2 %")
            .arg(percent(verdict.value), limitPercent());
    case BatchReason::stopped: return tr("not all parts of the batch were run");
    case BatchReason::noSample:
        return tr("every part that was run is good, but corner parts are not a sample, so Ppk is "
                  "not known");
    case BatchReason::fewParts: return tr("Ppk cannot be computed from one part");
    case BatchReason::outside:
        return tr("%1 % of the parts are expected out of tolerance, more than the allowed %2 %: %3")
            .arg(Names::significant(100 * verdict.value, 2), limitPercent(), inSentence());
    case BatchReason::ppk:
        return tr("Ppk %1, its lower bound below %2: %3")
            .arg(capability(of->ppk, verdict.limit), limit(), inSentence());
    case BatchReason::allHold:
        return of ? tr("every part is good, and the lower bound of Ppk is at least %1 everywhere; "
                       "lowest Ppk %2, %3")
                        .arg(limit(), capability(of->ppk, verdict.limit), inSentence())
                  : tr("every part is good, and the sizes hardly scatter");
    }
    return {};
}

QString BatchText::run(const BatchOutcome& outcome) {
    const Batch& batch = *outcome.result.project.batch;
    const QString scenarios =
        choiceText(choicesOf<Scenarios>()[static_cast<std::size_t>(batch.scenarios)].label);
    if (outcome.factors.empty()) {
        return tr("Only the nominal part was run: no factor scatters.");
    }
    if (!outcome.summary.isSample) {
        return tr("%n part(s), %1.", nullptr, static_cast<int>(outcome.summary.parts))
            .arg(scenarios);
    }
    const QString what =
        tr("%1, seed %2", "Latin hypercube, seed 1").arg(scenarios).arg(batch.seed);
    if (outcome.result.status == BatchStatus::stopped) {
        return tr("Stopped after %1 of %2 parts, %3.")
            .arg(outcome.summary.parts)
            .arg(outcome.result.batchParts)
            .arg(what);
    }
    return tr("%n part(s), %1.", nullptr, static_cast<int>(outcome.summary.parts)).arg(what);
}

QString BatchText::notCounted(const Project& project) {
    QStringList names;
    for (const FactorKind kind : sparkout::notCounted(project)) {
        names << Names::inSentence(inputText(factorLabel(kind)));
    }
    return names.isEmpty() ? QStringLiteral("–") : names.join(QStringLiteral("; "));
}

QString BatchText::notCountedSentence(const Project& project) {
    return sparkout::notCounted(project).empty() ? QString()
                                                 : tr("Not counted: %1.").arg(notCounted(project));
}

QString BatchText::counts(const BatchSummary& summary) {
    QStringList texts;
    if (summary.parts > 0) {
        texts << tr("Rejected: %1.").arg(share(summary.bad));
    }
    if (summary.stripped > 0) {
        texts << tr("%1 of %2 parts have no size, form and Ra: strips stay uncut, so no Ppk is "
                    "given.")
                     .arg(summary.stripped)
                     .arg(summary.parts);
    }
    if (summary.failed > 0) {
        texts << tr("%n did not reach size.", nullptr, static_cast<int>(summary.failed));
    }
    return texts.join(u' ');
}

QString BatchText::verdict(const BatchOutcome& outcome) {
    const QString text =
        tr("The cycle %1: %2.", "verdict, reason")
            .arg(fitness(weigh(outcome.summary, outcome.result).fitness), decision(outcome));
    QStringList sentences{counts(outcome.summary), text};
    if (!outcome.notDecided.empty()) {
        sentences << tr("Not decided: %1.")
                         .arg(JudgementText::lines(outcome.notDecided).join(QStringLiteral("; ")));
    }
    return sentences.join(u' ').trimmed();
}

QString BatchText::progress(qint64 done, qint64 parts, double left_s) {
    return RunBar::withTimeLeft(tr("%1 of %2 parts").arg(done).arg(parts), left_s);
}

QString BatchText::part(const BatchOutcome& outcome, std::int64_t part) {
    QStringList texts;
    const ScenarioSource source(outcome.result.project);
    const std::vector<double> values = source.values(part);
    for (std::size_t f = 0; f < values.size(); ++f) {
        const GivenFactor& of = source.factors()[f];
        const char* unit = tableOf<Factors>().fields[static_cast<std::size_t>(of.kind)].unit;
        texts << QStringLiteral("%1 %2 %3")
                     .arg(factor(of), Names::significant(values[f]), unitText(unit))
                     .trimmed();
    }
    return tr("Part %1").arg(Names::part(part))
           + (texts.isEmpty() ? QString() : QStringLiteral(": "))
           + texts.join(QStringLiteral(", "));
}

} // namespace sparkout
