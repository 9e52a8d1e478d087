// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport_inputs.h"

#include "core/batch/scenario_source.h"
#include "core/project/batch.h"
#include "core/project/leaves.h"
#include "core/project/member.h"
#include "core/study/batch_edits.h"
#include "core/version.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_text.h"

#include <QFileInfo>

#include <algorithm>
#include <array>

namespace sparkout::report {

namespace {

constexpr std::int64_t mostDrawn = 4096; ///< parts whose factors are looked through

QString factorUnit(FactorKind kind) {
    return cell(unitText(tableOf<Factors>().fields[static_cast<std::size_t>(kind)].unit));
}

QString rangeText(double low, double high) {
    return printedNumber(low) + u'…' + printedNumber(high);
}

/// Smallest and largest value of each factor over the parts.
std::vector<std::pair<double, double>> drawnRanges(const ScenarioSource& source) {
    std::vector<std::pair<double, double>> ranges;
    for (std::int64_t part = 0; part < std::min(source.parts(), mostDrawn); ++part) {
        const std::vector<double> values = source.values(part);
        for (std::size_t f = 0; f < values.size(); ++f) {
            if (part == 0) {
                ranges.emplace_back(values[f], values[f]);
            } else {
                ranges[f].first = std::min(ranges[f].first, values[f]);
                ranges[f].second = std::max(ranges[f].second, values[f]);
            }
        }
    }
    return ranges;
}

Table correlations(const std::vector<GivenFactor>& factors,
                   const std::vector<std::vector<double>>& matrix) {
    Table table;
    table.head = {PassportInputs::tr("Correlation")};
    table.texts = {true};
    for (std::size_t i = 0; i < matrix.size(); ++i) { // those of zones are independent
        table.head << BatchText::factor(factors[i]);
        QStringList row{BatchText::factor(factors[i])};
        for (std::size_t j = 0; j < matrix.size(); ++j) {
            row << printedNumber(matrix.at(i).at(j));
        }
        table.rows.push_back(row);
    }
    return table;
}

/// A form of a factor's distribution that is not the given one.
bool isOtherForm(const Leaf& leaf, bool isNumber) {
    if (leaf.owner == nullptr || isNumber || !leaf.path.starts_with("/batch/factors/")) {
        return false;
    }
    const bool isList = leaf.field->kind == sparkout::Kind::optionalNumberList;
    return isList ? !leaf.field->as<std::optional<std::vector<double>>>(leaf.owner)
                  : leaf.field->kind == sparkout::Kind::optionalInteger;
}

/// Typed values stay unchanged; a wheel worn by other surfaces has all the digits of a double.
QString inNineDigits(double value) {
    constexpr qsizetype typed = 12;
    const QString exact = printedNumber(value);
    return exact.size() > typed ? printedNumber(value, 9) : exact;
}

} // namespace

Facts PassportInputs::drawing(const Project& project) {
    Facts facts{{inputFact(project, "/part/upper_deviation_um"),
                 inputFact(project, "/part/lower_deviation_um")}};
    for (const char* path : {"/part/target_diameter_mm", "/part/tolerance/radial_runout_um",
                             "/part/tolerance/roundness_um", "/part/tolerance/cylindricity_um",
                             "/part/tolerance/total_runout_um", "/part/tolerance/roughness_ra_um",
                             "/machine/wheel_drive_kw", "/machine/work_drive_kw"}) {
        const ConstMember member = findMember(project, path);
        auto [name, value] = inputFact(project, path);
        const bool given = numberIn(*member.field, member.owner).has_value();
        facts.facts.emplace_back(name, given ? value : inputText(member.field->nullMeaning));
    }
    return facts;
}

QString PassportInputs::law(const GivenFactor& factor) {
    const Factor& law = factor.law;
    switch (formOf(law)) {
    case FactorForm::constant: return tr("constant %1").arg(printedNumber(law.uniform->front()));
    case FactorForm::uniform:
        return tr("uniform, %1").arg(rangeText(law.uniform->front(), law.uniform->back()));
    case FactorForm::normal: {
        const QString normal =
            tr("normal, mean %1, standard deviation %2")
                .arg(printedNumber(law.normal->front()), printedNumber(law.normal->back()));
        return law.within ? tr("%1, truncated to %2", "normal distribution")
                                .arg(normal, rangeText(law.within->front(), law.within->back()))
                          : normal;
    }
    case FactorForm::triangular:
        return tr("triangular, %1, most frequent %2")
            .arg(rangeText(law.triangular->front(), law.triangular->back()),
                 printedNumber(law.triangular->at(1)));
    case FactorForm::measured:
        return tr("as measured, %n value(s), %1", nullptr, static_cast<int>(law.measured->size()))
            .arg(rangeText(*std::ranges::min_element(*law.measured),
                           *std::ranges::max_element(*law.measured)));
    case FactorForm::grows: {
        const QString grows =
            tr("grows part by part from %1 to %2")
                .arg(printedNumber(law.grows->front()), printedNumber(law.grows->back()));
        if (law.parts_between_dressings && factor.kind == FactorKind::gaugeAge) {
            return tr("%1, %n part(s) between settings of the gauge", nullptr,
                      *law.parts_between_dressings)
                .arg(grows);
        }
        return law.parts_between_dressings
                   ? tr("%1, %n part(s) between dressings", nullptr, *law.parts_between_dressings)
                         .arg(grows)
                   : tr("%1 over the whole batch").arg(grows);
    }
    }
    return cell({});
}

std::vector<Block> PassportInputs::scenarios(const Subject& subject) {
    if (!subject.batch) {
        return {
            Paragraph{
                tr("This project describes no batch, so the passport covers only the nominal part: "
                   "it gives no scatter, no capability and no share out of tolerance.")},
            Paragraph{tr("A batch is added on the page Batch of the inputs, where each factor "
                         "that scatters gets its distribution, or with “Add a typical batch” in "
                         "the view Batch.")}};
    }
    const BatchOutcome& outcome = *subject.batch;
    const Batch& batch = *outcome.result.project.batch;
    const ScenarioSource source(outcome.result.project);
    const std::vector<GivenFactor>& factors = source.factors();
    const bool drawn = outcome.summary.isSample && !factors.empty();
    std::vector<Block> blocks;
    blocks.push_back(Facts{
        {{tr("Parts run"), QString::number(outcome.summary.parts)},
         {tr("Scenarios"),
          choiceText(choicesOf<Scenarios>()[static_cast<std::size_t>(batch.scenarios)].label)},
         {tr("Seed"), drawn ? QString::number(batch.seed) : tr("none is drawn")},
         {tr("Correlation of the factors"),
          batch.correlation ? tr("as in the table below") : tr("independent")}}});
    if (factors.empty()) {
        blocks.push_back(Paragraph{BatchText::run(outcome)});
        return blocks;
    }
    Table table;
    table.head = {tr("Factor"), tr("Unit"), tr("Distribution"), tr("Minimum tried"),
                  tr("Maximum tried")};
    table.texts = {true, true, true};
    const auto ranges = drawnRanges(source);
    for (std::size_t f = 0; f < factors.size(); ++f) {
        table.rows.push_back({BatchText::factor(factors[f]), factorUnit(factors[f].kind),
                              law(factors[f]), Names::significant(ranges[f].first),
                              Names::significant(ranges[f].second)});
    }
    blocks.push_back(std::move(table));
    if (source.parts() > mostDrawn) {
        blocks.push_back(Paragraph{
            tr("Minimum and maximum tried: of the first %n parts.", nullptr, int(mostDrawn))});
    }
    if (batch.correlation) {
        blocks.push_back(correlations(factors, *batch.correlation));
    }
    return blocks;
}

Table PassportInputs::inputs(const Project& project) {
    constexpr std::array<std::string_view, 7> left{
        "/title", "/author",   "/notes", "/optimisation",
        "/sweep", "/measured", "/runs"}; // no part of what is computed
    Table table;
    table.head = {tr("Input"), tr("Value"), tr("Unit")};
    table.texts = {true, true, true};
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        const Field& field = *leaf.field;
        const bool isRead = !field.relevant || field.relevant(project, leaf.owner);
        if (!isRead || std::ranges::any_of(left, [&leaf](std::string_view path) {
                return leaf.path.starts_with(path);
            })) {
            continue;
        }
        const std::optional<double> number = singleNumberIn(field, leaf.owner);
        if (isOtherForm(leaf, number.has_value())) {
            continue;
        }
        const QString value = number ? inNineDigits(*number)
                              : field.kind == sparkout::Kind::text
                                  ? oneLine(field.as<std::string>(leaf.owner))
                                  : fieldText(field, leaf.owner);
        table.rows.push_back({locationText(leaf.path), cell(value), cell(unitText(field.unit))});
    }
    return table;
}

std::vector<Block> PassportInputs::recomputing(const Subject& subject) {
    const Project& project = subject.outcome->result.project;
    const QString file = manyLines(QFileInfo(subject.file).fileName()).simplified();
    const QString surface = subject.surfaceOption.isEmpty()
                                ? QString()
                                : QStringLiteral(" --surface ") + subject.surfaceOption;
    const QString command = QStringLiteral("sparkout --report passport \"%1\"%2 -o passport.pdf")
                                .arg(file.isEmpty() ? QStringLiteral("FILE") : file, surface);
    Facts facts{{{tr("Program"), QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version))},
                 {tr("Version of the engine"),
                  QString::fromStdString(subject.outcome->result.engineVersion)}}};
    if (subject.batch) {
        facts.facts.emplace_back(tr("Extent of the run"), BatchText::run(*subject.batch));
    }
    facts.facts.emplace_back(tr("Command to recompute it"), command);
    const QString how =
        project.batch
            ? tr("The same inputs and the same seed give the same numbers, with any number of "
                 "threads. All that the computation reads is in the appendix, each number with all "
                 "its digits.")
            : tr("The same inputs give the same numbers. All that the computation reads is in the "
                 "appendix, each number with all its digits.");
    return {facts, Paragraph{how}};
}

} // namespace sparkout::report
