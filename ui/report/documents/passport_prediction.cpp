// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport_prediction.h"

#include "core/batch/scenario_source.h"
#include "core/judgement/judgement.h"
#include "core/project/batch.h"
#include "ui/charts/verdict_table.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_figures.h"
#include "ui/views/batch/batch_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr int factorDigits = 6;

QString limitsText(const Characteristic& of) {
    if (of.low && of.high) {
        return printedNumber(*of.low) + u'…' + printedNumber(*of.high);
    }
    return of.high  ? QStringLiteral("≤ ") + printedNumber(*of.high)
           : of.low ? QStringLiteral("≥ ") + printedNumber(*of.low)
                    : cell({});
}

/// The values of the nominal part, measured like those of the batch.
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
    return printedNumber(100 * order, 6) + QStringLiteral("\u00a0%");
}

/// The requirements of one part, the worst of each kind.
Table worstRequirements(const Outcome& outcome) {
    Outcome worst;
    worst.result = outcome.result;
    worst.constraints = worstByKind(outcome.constraints);
    return PassportPrediction::requirements(worst);
}

bool isSetting(const ConstraintResult& constraint) {
    return requirementOf(constraint.kind).scope == ConstraintScope::setting;
}

} // namespace

Table PassportPrediction::nominal(const Outcome& outcome) {
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

Table PassportPrediction::values(const Subject& subject) {
    const BatchSummary& summary = subject.batch->summary;
    const std::vector<QString> texts =
        nominalTexts(*subject.outcome, characteristicsOf(subject.outcome->result.project));
    Table table;
    table.head = {tr("Characteristic"), tr("Unit"), tr("Limits"), tr("Nominal part"), tr("Min."),
                  tr("Mean"),           tr("Max."), tr("s"),      tr("Mean, 95 %")};
    table.texts = {true, true};
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        const CharacteristicSummary& of = summary.characteristics[i];
        QStringList row{BatchText::full(of.characteristic), unitText(of.characteristic.unit),
                        limitsText(of.characteristic), texts[i]};
        for (const char* figure :
             {"min", "mean", "max", "standard_deviation", "mean_interval_95"}) {
            row << figureText({&of, summary.isSample, summary.drifts}, figure);
        }
        table.rows.push_back(row);
    }
    if (table.rows.empty()) { // no part reached size
        table.rows.push_back(QStringList(table.head.size(), cell({})));
    }
    return table;
}

Table PassportPrediction::capability(const BatchSummary& summary) {
    Table table;
    table.head = {tr("Characteristic"), tr("Pp"), tr("Ppk"), tr("Out of tolerance"),
                  BatchText::normalityName(summary)};
    table.texts = {true};
    for (const CharacteristicSummary& of : summary.characteristics) {
        QStringList row{BatchText::full(of.characteristic)};
        for (const char* figure : {"pp", "ppk", "outside", "normality_probability"}) {
            row << figureText({&of, summary.isSample, summary.drifts}, figure);
        }
        table.rows.push_back(row);
    }
    return table;
}

Table PassportPrediction::percentiles(const BatchSummary& summary) {
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

std::vector<Block> PassportPrediction::worst(const Subject& subject) {
    const BatchSummary& summary = subject.batch->summary;
    const ScenarioSource source(subject.batch->result.project);
    const std::vector<double> values = source.values(summary.worstPart);
    std::vector<Block> blocks{Paragraph{
        tr("Of the %n part(s) number %1 has the minimum margin. %2.", nullptr,
           static_cast<int>(summary.parts))
            .arg(Names::part(summary.worstPart),
                 summary.bad.count == 0 ? tr("It meets all requirements")
                                        : JudgementText::headline(judge(
                                            subject.worst->result, subject.worst->constraints)))}};
    if (!values.empty()) {
        Facts facts;
        for (std::size_t f = 0; f < values.size(); ++f) {
            const GivenFactor& factor = source.factors()[f];
            const char* unit =
                tableOf<Factors>().fields[static_cast<std::size_t>(factor.kind)].unit;
            const QString value = Names::significant(values[f], factorDigits);
            facts.facts.emplace_back(BatchText::factor(factor),
                                     *unit ? withUnit(value, unit) : value);
        }
        blocks.push_back(std::move(facts));
    }
    if (!subject.worst->constraints.empty()) {
        blocks.push_back(worstRequirements(*subject.worst));
    }
    return blocks;
}

Table PassportPrediction::requirements(const Outcome& outcome) {
    Table table;
    table.head = {
        tr("Zone or section"), tr("Requirement"),        tr("Unit"),   tr("Value"), tr("Limit"),
        tr("Margin"),          tr("Where in the cycle"), tr("Verdict")};
    table.texts = {true, true, true, false, false, false, true, true};
    for (const ConstraintResult& c : outcome.constraints) {
        if (!isSetting(c)) {
            const RequirementCells cells(c);
            table.rows.push_back(
                {Names::where(c), Names::constraint(c.kind), requirementUnit(c.kind), cells.value(),
                 Names::limit(c), cells.margin(),
                 c.at ? Names::moment(*c.at, outcome.result.project.operation) : tr("at the end"),
                 cells.verdict()});
        }
    }
    return table;
}

Table PassportPrediction::settings(const Outcome& outcome) {
    Table table;
    table.head = {tr("Stage or cycle"), tr("Requirement"), tr("Unit"),   tr("Value"),
                  tr("Limit"),          tr("Margin"),      tr("Verdict")};
    table.texts = {true, true, true, false, false, false, true};
    for (const ConstraintResult& c : outcome.constraints) {
        if (isSetting(c)) {
            table.rows.push_back({Names::where(c), Names::constraint(c.kind),
                                  requirementUnit(c.kind), Names::value(c), Names::limit(c),
                                  Names::margin(c), lightName(c)});
        }
    }
    return table;
}

} // namespace sparkout::report
