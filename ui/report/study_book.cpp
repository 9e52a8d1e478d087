// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/study_book.h"

#include "core/project/batch.h"
#include "core/project/sweep.h"
#include "core/study/search_outputs.h"
#include "core/units.h"
#include "core/version.h"
#include "ui/dialogs/table_file.h"
#include "ui/report/passport_sections.h"
#include "ui/results/run_table.h"
#include "ui/text/example_texts.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"
#include "ui/views/study/batch_charts.h"
#include "ui/views/study/batch_text.h"
#include "ui/views/study/found_table.h"
#include "ui/views/study/margin_front_plot.h"
#include "ui/views/study/optimise_text.h"
#include "ui/views/study/sensitivity_plot.h"
#include "ui/views/study/sweep_shown.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace sparkout {

namespace {

struct StudyBook {
    Q_DECLARE_TR_FUNCTIONS(StudyBook)
};

struct NamedSheet {
    QString name;
    CsvTable table;
};

/// Rows of a name, a value and its unit.
CsvTable facts() {
    CsvTable table;
    table.ownUnits = true;
    table.header << StudyBook::tr("Quantity") << StudyBook::tr("Value") << StudyBook::tr("Unit");
    return table;
}

void addFact(CsvTable& table, const QString& name, CsvCell value, const QString& unit = {}) {
    table.rows.push_back({name, std::move(value), unit});
}

void addOrigin(CsvTable& table, const Project& project) {
    addFact(table, StudyBook::tr("Project"), exampleTitle(project.title));
    addFact(table, StudyBook::tr("Engine"), QString::fromUtf8(version));
}

/// The inputs whose keys in the file begin with one of these.
CsvTable inputsOf(const Project& project, const QStringList& keys) {
    CsvTable table = inputTable(project);
    std::erase_if(table.rows, [&keys](const std::vector<CsvCell>& row) {
        const auto* path = std::get_if<QString>(&row.back());
        return !path || std::ranges::none_of(keys, [path](const QString& key) {
            return path->startsWith(key);
        });
    });
    return table;
}

CsvCell shareCell(const std::optional<double>& share) {
    constexpr double whole = 100;
    return share ? CsvCell(whole * *share) : CsvCell();
}

QString unitOfFactor(FactorKind kind) {
    return unitText(tableOf<Factors>().fields[static_cast<std::size_t>(kind)].unit);
}

// --- batch --------------------------------------------------------------------------------------

CsvTable batchFacts(const BatchOutcome& outcome) {
    const BatchSummary& summary = outcome.summary;
    const Batch& batch = *outcome.result.project.batch;
    CsvTable table = facts();
    addOrigin(table, outcome.result.project);
    addFact(table, StudyBook::tr("Parts run"), static_cast<double>(summary.parts));
    addFact(table, StudyBook::tr("Parts of the batch"),
            static_cast<double>(outcome.result.batchParts));
    addFact(table, StudyBook::tr("Scenarios"),
            choiceText(choicesOf<Scenarios>()[static_cast<std::size_t>(batch.scenarios)].label));
    if (summary.isSample) {
        addFact(table, StudyBook::tr("Seed"), static_cast<double>(batch.seed));
    }
    addFact(table, StudyBook::tr("Extent of the run"), BatchText::run(outcome));
    addFact(table, StudyBook::tr("Verdict: the cycle"),
            BatchText::fitness(weigh(summary, outcome.result).fitness));
    addFact(table, StudyBook::tr("Deciding result"), BatchText::decision(outcome));
    const QString percent = unitText("%");
    addFact(table, StudyBook::tr("Rejected parts"), static_cast<double>(summary.bad.count));
    addFact(table, StudyBook::tr("Share of rejected parts"), shareCell(summary.bad.value), percent);
    if (summary.bad.interval) {
        addFact(table, StudyBook::tr("Share of rejected parts, 95 % from"),
                shareCell(summary.bad.interval->low), percent);
        addFact(table, StudyBook::tr("Share of rejected parts, 95 % to"),
                shareCell(summary.bad.interval->high), percent);
    }
    addFact(table, StudyBook::tr("Parts that did not reach size"),
            static_cast<double>(summary.failed));
    for (const GivenFactor& factor : outcome.factors) {
        addFact(table, StudyBook::tr("Factor: %1").arg(BatchText::factor(factor)),
                report::PassportInputs::law(factor), unitOfFactor(factor.kind));
    }
    return table;
}

CsvTable worstPart(const BatchOutcome& outcome) {
    CsvTable table = facts();
    const std::int64_t part = outcome.summary.worstPart;
    if (part < 0) {
        return table;
    }
    addFact(table, StudyBook::tr("Number of the part"), static_cast<double>(part + 1));
    const ScenarioSource source(outcome.result.project);
    const std::vector<double> values = source.values(part);
    for (std::size_t f = 0; f < values.size(); ++f) {
        const GivenFactor& factor = source.factors()[f];
        addFact(table, BatchText::factor(factor), values[f], unitOfFactor(factor.kind));
    }
    return table;
}

CsvTable correlationTable(const BatchOutcome& outcome) {
    CsvTable table;
    const auto& matrix = outcome.result.project.batch->correlation;
    if (!matrix) {
        return table;
    }
    table.header << StudyBook::tr("Factor");
    for (std::size_t i = 0; i < matrix->size(); ++i) { // those of zones are independent
        table.header << BatchText::factor(outcome.factors[i]);
        std::vector<CsvCell> row{BatchText::factor(outcome.factors[i])};
        row.insert(row.end(), matrix->at(i).begin(), matrix->at(i).end());
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<NamedSheet> batchSheets(const BatchOutcome& outcome, const SobolIndicesPtr& indices) {
    std::vector<NamedSheet> sheets{
        {StudyBook::tr("Batch", "of parts"), batchFacts(outcome)},
        {StudyBook::tr("Statistics"), batchFiguresTable(outcome.summary)},
        {StudyBook::tr("Rejects by cause"), BatchCharts::rejectsTable(outcome.summary)}};
    const auto addUnlessEmpty = [&sheets](const QString& name, CsvTable table) {
        if (!table.empty()) {
            sheets.push_back({name, std::move(table)});
        }
    };
    addUnlessEmpty(StudyBook::tr("Correlation"), correlationTable(outcome));
    addUnlessEmpty(StudyBook::tr("Rank regression"), SensitivityPlot::ranksTable(outcome));
    if (indices) {
        addUnlessEmpty(StudyBook::tr("Sobol indices"),
                       SensitivityPlot::sobolTable(outcome, *indices));
    }
    addUnlessEmpty(StudyBook::tr("Histograms"), BatchCharts::histogramsTable(outcome.summary));
    addUnlessEmpty(StudyBook::tr("Worst part"), worstPart(outcome));
    return sheets;
}

// --- sweep --------------------------------------------------------------------------------------

CsvTable pointsTable(const SweepResult& sweep) {
    std::vector<std::size_t> all(sweep.quantities.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return SweepShown::tableOf(sweep, all);
}

CsvTable sweepFacts(const SweepResult& sweep) {
    CsvTable table = facts();
    addOrigin(table, sweep.project);
    addFact(table, StudyBook::tr("Results"), SweepText::run(sweep));
    const CsvTable own = inputTable(sweep.project);
    for (const SweptInput& input : sweep.inputs) {
        const QString name = SweepText::input(input.axis.input),
                      unit = unitText(input.unit.c_str());
        const QString key = QString::fromStdString(input.axis.input);
        const auto row = std::ranges::find_if(own.rows, [&key](const std::vector<CsvCell>& each) {
            const auto* path = std::get_if<QString>(&each.back());
            return path && *path == key;
        });
        if (row != own.rows.end()) {
            addFact(table, StudyBook::tr("%1: of the project").arg(name), (*row)[3], unit);
        }
        const ShownScale shown = ShownScale::at(input.axis.input);
        addFact(table, StudyBook::tr("%1: from").arg(name), shown.shown(input.values.front()),
                unit);
        addFact(table, StudyBook::tr("%1: to").arg(name), shown.shown(input.values.back()), unit);
        addFact(table, StudyBook::tr("%1: values").arg(name),
                static_cast<double>(input.values.size()));
    }
    return table;
}

/// One quantity over two inputs: a row for each value of the first, a column for each value of the
/// second.
CsvTable mapTable(const SweepResult& sweep, std::size_t quantity) {
    const SweptInput &first = sweep.inputs[0], &second = sweep.inputs[1];
    CsvTable table;
    table.ownUnits = true;
    table.header << SweepText::inputAxis(first);
    for (const double value : second.values) {
        table.header << QStringLiteral("%1 %2").arg(SweepText::inputBrief(second.axis.input),
                                                    SweepText::inputValue(value, second));
    }
    const ShownScale shown = ShownScale::at(first.axis.input);
    for (std::size_t i = 0; i < first.values.size(); ++i) {
        std::vector<CsvCell> row{shown.shown(first.values[i])};
        for (std::size_t j = 0; j < second.values.size(); ++j) {
            const SweepPoint& point = sweep.points[sweep.index(i, j)];
            row.emplace_back(point.values.empty() ? SweepValue().value
                                                  : point.values[quantity].value);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<NamedSheet> sweepSheets(const SweepResult& sweep) {
    std::vector<NamedSheet> sheets{{StudyBook::tr("Sweep"), sweepFacts(sweep)},
                                   {StudyBook::tr("Points"), pointsTable(sweep)}};
    for (std::size_t q = 0; sweep.inputs.size() == 2 && q < sweep.quantities.size(); ++q) {
        const SweepQuantity& of = sweep.quantities[q];
        const QString place = of.section < 0 ? QString() : SweepText::where(of) + u' ';
        const QString unit =
            of.unit.empty() ? QString() : QStringLiteral(", ") + unitText(of.unit.c_str());
        sheets.push_back({place + SweepText::name(of) + unit, mapTable(sweep, q)});
    }
    return sheets;
}

// --- search -------------------------------------------------------------------------------------

CsvTable searchFacts(const SearchOutcome& outcome, const std::optional<double>& before_s) {
    CsvTable table = facts();
    addOrigin(table, outcome.project);
    const QString notes =
        outcome.ran() ? OptimiseText::notes(outcome) : OptimiseText::fault(outcome);
    if (!notes.isEmpty()) {
        addFact(table, StudyBook::tr("Notes"), notes);
    }
    for (const Output<SearchOutcome>& row : searchOutputs()) {
        const OutputValue value = row.of(outcome);
        const auto number = outputNumber(row, value);
        if (outcome.ran() && *row.label && !row.detail && number && std::isfinite(*number)) {
            addFact(table, outputLabel(row), *number, unitText(row.unitShown()));
        }
    }
    if (before_s) {
        addFact(table, StudyBook::tr("Time of your cycle"), *before_s / units::secondsPerMinute,
                unitText("min"));
    }
    return table;
}

CsvTable bindingTable(const SearchOutcome& outcome) {
    CsvTable table;
    table.header << StudyBook::tr("Requirement") << StudyBook::tr("Binds")
                 << StudyBook::tr("Times it cut");
    const auto cuts = outcome.cuts();
    for (const Requirement& row : requirementRows) {
        const bool binds =
            outcome.binding
            && std::ranges::find(*outcome.binding, row.kind) != outcome.binding->end();
        const auto cut = std::ranges::find(cuts, row.kind, [](const auto& c) { return c.first; });
        const double count = cut == cuts.end() ? 0 : static_cast<double>(cut->second);
        if (binds || count > 0) {
            const QString word = !outcome.binding ? StudyBook::tr("not known, it was stopped")
                                 : binds          ? StudyBook::tr("yes")
                                                  : StudyBook::tr("no");
            table.rows.push_back({Names::constraint(row.kind), word, count});
        }
    }
    return table;
}

std::vector<NamedSheet> searchSheets(const Study& study) {
    const SearchOutcome& outcome = *study.search;
    std::vector<NamedSheet> sheets{{StudyBook::tr("Search"), searchFacts(outcome, study.before_s)}};
    if (outcome.best()) {
        sheets.push_back({StudyBook::tr("Answer"),
                          answerTable(outcome, study.before_s, outcome.given.margin).asTable()});
    }
    sheets.push_back({StudyBook::tr("Settings"),
                      inputsOf(outcome.searched, {QStringLiteral("/optimisation/")})});
    if (const FoundCycle* found = outcome.answer()) {
        const Project project = withFound(outcome.project, *found);
        sheets.push_back({StudyBook::tr("Cycle found"),
                          inputsOf(project, {QStringLiteral("/cycle/"),
                                             QStringLiteral("/machine/work_speed_rpm"),
                                             QStringLiteral("/machine/dwell_")})});
    }
    sheets.push_back({StudyBook::tr("Best cycles"), foundTable(outcome, study.before_s).asTable()});
    sheets.push_back({StudyBook::tr("Time by stages"), StageCountPlot::tableOf(outcome)});
    if (!outcome.front().empty()) {
        sheets.push_back({StudyBook::tr("Margin by time"), MarginFrontPlot::tableOf(outcome)});
    }
    sheets.push_back({StudyBook::tr("Binding requirements"), bindingTable(outcome)});
    return sheets;
}

std::vector<NamedSheet> sheetsOfStudy(const Study& study) {
    switch (study.kind()) {
    case StudyKind::batch: return batchSheets(*study.batch, study.indices);
    case StudyKind::sweep: return sweepSheets(*study.sweep);
    case StudyKind::search: break;
    }
    return searchSheets(study);
}

} // namespace

const char* studyKey(StudyKind kind) {
    constexpr std::array keys{"batch", "sweep", "search"};
    return keys[static_cast<std::size_t>(kind)];
}

QString studyName(StudyKind kind) {
    switch (kind) {
    case StudyKind::batch: return StudyBook::tr("Batch", "of parts");
    case StudyKind::sweep: return StudyBook::tr("Sweep");
    case StudyKind::search: return StudyBook::tr("Search");
    }
    return {};
}

QString studyNote(StudyKind kind) {
    switch (kind) {
    case StudyKind::batch:
        return StudyBook::tr("Factors and verdict, statistics, rejects by cause, influence of the "
                             "factors, histograms and the worst part, each on a separate sheet.");
    case StudyKind::sweep:
        return StudyBook::tr("The inputs varied and every point; over two inputs every quantity on "
                             "a separate sheet, too.");
    case StudyKind::search:
        return StudyBook::tr(
            "The answer, the settings, the cycle found, the best cycles, the time by stages, the "
            "margin by time and the binding requirements, each on a separate sheet.");
    }
    return {};
}

Book studyBook(const Study& study) {
    const Project& project = study.project();
    Book book{
        exampleTitle(project.title), QString::fromStdString(project.author), programText(), {}};
    for (const NamedSheet& each : sheetsOfStudy(study)) {
        book.sheets.push_back(sheetOf(each.table, each.name));
    }
    return book;
}

Sheet studyMainSheet(const Study& study) {
    switch (study.kind()) {
    case StudyKind::batch:
        return sheetOf(batchFiguresTable(study.batch->summary), StudyBook::tr("Statistics"));
    case StudyKind::sweep: return sheetOf(pointsTable(*study.sweep), StudyBook::tr("Points"));
    case StudyKind::search: break;
    }
    return sheetOf(foundTable(*study.search, study.before_s).asTable(),
                   StudyBook::tr("Best cycles"));
}

} // namespace sparkout
