// SPDX-License-Identifier: GPL-3.0-or-later
// What comes out of the cycle and its batch, against the drawing.
#include "ui/report/documents/passport_parts.h"

#include "core/batch/scenario_source.h"
#include "ui/charts/verdict_model.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_figures.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/verdict/verdict_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr int factorDigits = 6;

QString limitsText(const Characteristic& of) {
    if (of.low && of.high) {
        return plainNumber(*of.low) + u'…' + plainNumber(*of.high);
    }
    return of.high  ? QStringLiteral("≤ ") + plainNumber(*of.high)
           : of.low ? QStringLiteral("≥ ") + plainNumber(*of.low)
                    : cell({});
}

/// The nominal part, measured as each part of the batch is.
std::vector<QString> nominalTexts(const Outcome& outcome,
                                  const std::vector<Characteristic>& characteristics) {
    PartOutcome part;
    measure(outcome.result, characteristics, part);
    std::vector<QString> texts;
    for (std::size_t i = 0; i < characteristics.size(); ++i) {
        const bool measured = i < part.values.size() && std::isfinite(part.values[i]);
        texts.push_back(measured ? BatchText::value(part.values[i], characteristics[i]) : cell({}));
    }
    return texts;
}

QString percentText(double order) {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    return numbers.toString(100 * order, 'g', 6) + QStringLiteral("\u00a0%");
}

/// A text whose numbers keep their percent signs.
QString unparted(QString text) {
    return text.replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"));
}

/// The requirements of one part, the worst of each kind, without the settings.
Table worstRequirements(const Outcome& outcome) {
    Outcome worst;
    worst.result = outcome.result;
    worst.constraints = worstByKind(outcome.constraints);
    std::erase_if(worst.constraints, [](const ConstraintResult& c) {
        return requirementOf(c.kind).scope == ConstraintScope::setting;
    });
    return Passport::requirements(worst);
}

} // namespace

const CharacteristicSummary* Passport::leastCapable(const BatchSummary& summary) {
    const CharacteristicSummary* least = nullptr;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.ppk && (!least || of.ppk->value < least->ppk->value)) {
            least = &of;
        }
    }
    return least;
}

const CharacteristicSummary* Passport::deciding(const BatchSummary& summary) {
    const CharacteristicSummary* most = nullptr;
    for (const CharacteristicSummary& of : summary.characteristics) {
        if (of.outside.count > (most ? most->outside.count : 0)) {
            most = &of;
        }
    }
    return most ? most : leastCapable(summary);
}

Fitness Passport::fitness(const Subject& subject) {
    return verdict::overallLight(*subject.outcome) == Light::fails ? Fitness::unfit
           : subject.batch ? weigh(subject.batch->summary, subject.batch->result).fitness
                           : Fitness::conditional;
}

QString Passport::decision(const Subject& subject) {
    return verdict::overallLight(*subject.outcome) == Light::fails ? tr("the nominal part fails")
           : subject.batch ? BatchText::decision(*subject.batch)
                           : tr("the nominal part holds; no batch is described, so its scatter is "
                                "not weighed");
}

std::vector<Block> Passport::verdict(const Subject& subject) {
    const Outcome& outcome = *subject.outcome;
    Facts facts{{{tr("The cycle, by the prediction"), BatchText::fitness(fitness(subject))},
                 {tr("What decided"), decision(subject)}}};
    QStringList reasons;
    if (outcome.result.status != RunStatus::completed) {
        reasons << sparkout::verdict::status(outcome.result);
    }
    reasons << tr("Nominal part: %1.").arg(sparkout::verdict::overall(outcome));
    if (subject.batch) {
        const BatchSummary& summary = subject.batch->summary;
        facts.facts.emplace_back(tr("Parts of the batch that are not good"),
                                 BatchText::share(summary.bad));
        if (const CharacteristicSummary* least = leastCapable(summary)) {
            facts.facts.emplace_back(tr("Least Ppk"), QStringLiteral("%1: %2").arg(
                                                          BatchText::capability(least->ppk),
                                                          BatchText::full(least->characteristic)));
        }
        reasons << BatchText::run(*subject.batch) + u' ' + BatchText::counts(summary);
        for (const CharacteristicSummary& of : summary.characteristics) {
            if (of.outside.count > 0) {
                reasons << tr("%1: out of tolerance %2.")
                               .arg(BatchText::full(of.characteristic),
                                    BatchText::share(of.outside));
            }
        }
        if (summary.bad.count > 0) {
            reasons << tr("Worst part, number %1: %2.")
                           .arg(summary.worstPart)
                           .arg(sparkout::verdict::overall(*subject.worst));
        }
    } else {
        facts.facts.emplace_back(tr("Parts of the batch that are not good"),
                                 tr("no batch is described"));
    }
    facts.facts.emplace_back(tr("Machining time"), sparkout::verdict::time(outcome.result));
    const QString caution =
        tr("This is the prediction of a model, to be confirmed at the machine; it is no assessment "
           "of conformity and replaces no measurement.");
    std::vector<Block> blocks{facts};
    for (const QString& reason : reasons) {
        blocks.push_back(Paragraph{reason});
    }
    blocks.push_back(Paragraph{
        subject.batch
            ? tr("The cycle conforms when the nominal part and every part that was run reach size "
                 "and hold every requirement, and the lower 95 % bounds of all Ppk reach %1; it "
                 "conforms conditionally when no more parts fail than the share allowed, or when "
                 "the capability or the expected share outside falls short or is not known. %2")
                  .arg(Names::significant(subject.batch->result.project.batch->least_ppk), caution)
            : tr("Without a batch the cycle conforms conditionally when the nominal part reaches "
                 "size and holds every requirement. %1")
                  .arg(caution)});
    return blocks;
}

Table Passport::nominal(const Outcome& outcome) {
    const std::vector<Characteristic> all = characteristicsOf(outcome.result.project);
    const std::vector<QString> texts = nominalTexts(outcome, all);
    Table table;
    table.head = {tr("Characteristic"), tr("Unit"), tr("Limits"), tr("Nominal part")};
    table.texts = {true, true};
    for (std::size_t i = 0; i < all.size(); ++i) {
        table.rows.push_back(
            {BatchText::full(all[i]), unitText(all[i].unit), limitsText(all[i]), texts[i]});
    }
    return table;
}

Table Passport::values(const Subject& subject) {
    const BatchSummary& summary = subject.batch->summary;
    const std::vector<QString> texts =
        nominalTexts(*subject.outcome, characteristicsOf(subject.outcome->result.project));
    Table table;
    table.head = {tr("Characteristic"), tr("Unit"),     tr("Limits"),
                  tr("Nominal part"),   tr("Smallest"), tr("Mean"),
                  tr("Largest"),        tr("s"),        tr("Mean, 95 %")};
    table.texts = {true, true};
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        const CharacteristicSummary& of = summary.characteristics[i];
        QStringList row{BatchText::full(of.characteristic), unitText(of.characteristic.unit),
                        limitsText(of.characteristic), texts[i]};
        for (const auto figure : {BatchFigures::least, BatchFigures::mean, BatchFigures::most,
                                  BatchFigures::deviation, BatchFigures::meanInterval}) {
            row << BatchFigures::text(of, summary.isSample, figure);
        }
        table.rows.push_back(row);
    }
    if (table.rows.empty()) { // no part reached size
        table.rows.push_back(QStringList(table.head.size(), cell({})));
    }
    return table;
}

Table Passport::capability(const BatchSummary& summary) {
    Table table;
    table.head = {tr("Characteristic"), tr("Pp"), tr("Ppk"), tr("Out of tolerance"),
                  BatchText::normalityName(summary)};
    table.texts = {true};
    for (const CharacteristicSummary& of : summary.characteristics) {
        QStringList row{BatchText::full(of.characteristic)};
        for (const auto figure : {BatchFigures::pp, BatchFigures::ppk, BatchFigures::outside,
                                  BatchFigures::normality}) {
            row << unparted(BatchFigures::text(of, summary.isSample, figure));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table Passport::percentiles(const BatchSummary& summary) {
    Table table;
    table.head = {tr("Characteristic")};
    table.texts = {true};
    for (const Percentile& percentile : summary.characteristics.front().percentiles) {
        table.head << percentText(percentile.order);
    }
    for (const CharacteristicSummary& of : summary.characteristics) {
        QStringList row{BatchText::full(of.characteristic)};
        for (const Percentile& percentile : of.percentiles) {
            row << BatchText::percentile(percentile, of);
        }
        while (row.size() < table.head.size()) {
            row << cell({}); // no part has such a value
        }
        table.rows.push_back(row);
    }
    return table;
}

std::vector<Block> Passport::worst(const Subject& subject) {
    const BatchSummary& summary = subject.batch->summary;
    const ScenarioSource source(subject.batch->result.project);
    const std::vector<double> values = source.values(summary.worstPart);
    std::vector<Block> blocks{
        Paragraph{tr("Of the %n part(s), the first of which is number 0, number %1 has the least "
                     "margin. %2.",
                     nullptr, static_cast<int>(summary.parts))
                      .arg(summary.worstPart)
                      .arg(sparkout::verdict::overall(*subject.worst))}};
    if (!values.empty()) {
        Facts facts;
        for (std::size_t f = 0; f < values.size(); ++f) {
            const FactorKind kind = source.factors()[f].kind;
            const char* unit = tableOf<Factors>().fields[static_cast<std::size_t>(kind)].unit;
            const QString value = Names::significant(values[f], factorDigits);
            facts.facts.emplace_back(BatchText::factor(kind),
                                     *unit ? withUnit(value, unit) : value);
        }
        blocks.push_back(std::move(facts));
    }
    if (!subject.worst->constraints.empty()) {
        blocks.push_back(worstRequirements(*subject.worst));
    }
    return blocks;
}

Table Passport::requirements(const Outcome& outcome) {
    Table table;
    table.head = {tr("Zone or section"),
                  tr("Requirement"),
                  tr("Value"),
                  tr("Limit"),
                  tr("Margin"),
                  tr("Unit"),
                  tr("Where in the cycle"),
                  tr("Verdict")};
    table.texts = {true, true, false, false, false, true, true, true};
    for (const ConstraintResult& c : outcome.constraints) {
        table.rows.push_back({Names::where(c), Names::constraint(c.kind), Names::value(c),
                              Names::limit(c), Names::margin(c), requirementUnit(c.kind),
                              c.at ? Names::moment(*c.at, outcome.result.project.operation)
                              : requirementOf(c.kind).scope == ConstraintScope::setting
                                  ? tr("a setting")
                                  : tr("at the end"),
                              lightName(c)});
    }
    return table;
}

} // namespace sparkout::report
