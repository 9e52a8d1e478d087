// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/handout_task.h"

#include "core/process/system_compliance.h"
#include "core/project/leaves.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/progress.h"
#include "ui/report/handout/worked_step.h"
#include "ui/report/parts/cell_text.h"
#include "ui/report/parts/input_fact.h"
#include "ui/report/parts/operation_setup.h"
#include "ui/text/example_texts.h"
#include "ui/text/field_text.h"
#include "ui/text/formula_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/verdict/verdict_text.h"

#include <QFileInfo>

#include <algorithm>

namespace sparkout::report {

namespace {

/// Inputs behind the step's feed, width and stock that are not in a formula.
constexpr const char* behindFormulas[] = {"/part/upper_deviation_um", "/part/lower_deviation_um",
                                          "/part/length_mm",          "/part/stock_mm",
                                          "/part/initial_runout_mm",  "/wheel/width_mm"};

bool entersFormulas(const Leaf& leaf, const Project& project, const std::set<QString>& symbols,
                    int stage) {
    const Field& field = *leaf.field;
    const QString path = QString::fromStdString(leaf.path);
    if (!*field.symbol || !*field.source || field.kind == sparkout::Kind::compliance
        || (field.relevant && !field.relevant(project, leaf.owner))) {
        return false;
    }
    const bool input = path.startsWith(u"/part/") || path.startsWith(u"/material/")
                       || path.startsWith(u"/wheel/") || path.startsWith(u"/machine/");
    const bool body = path.startsWith(u"/part/shaft/"); // its d and l are not the part's
    return (input && !body && symbols.contains(QString::fromUtf8(field.symbol)))
           || std::ranges::count(behindFormulas, leaf.path) > 0
           || (stage > 0 && path.startsWith(QStringLiteral("/cycle/stages/%1/").arg(stage - 1)));
}

} // namespace

Facts HandoutTask::header(const Project& project, const QString& file, const QDate& date) {
    Facts facts = OperationSetup::header(project, date);
    facts.facts.insert(
        facts.facts.begin(),
        {{tr("Course"), cell(manyLines(exampleTitle(project.title)).simplified())},
         {tr("Project file"), cell(manyLines(QFileInfo(file).fileName()).simplified())}});
    return facts;
}

QString HandoutTask::part(const Project& project) {
    const Part& part = *project.part;
    const QString ground =
        part.surface == Surface::external
            ? tr("A shaft of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of "
                 "stock per side and a runout of %4 mm.")
            : tr("A bore of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of "
                 "stock per side and a runout of %4 mm.");
    return ground.arg(drawnSize(part), printedNumber(part.length_mm), printedNumber(part.stock_mm),
                      printedNumber(part.initial_runout_mm));
}

QString HandoutTask::task(const Outcome& outcome) {
    return part(outcome.result.project) + u' '
           + tr("By the model the cycle takes %1. Follow one step of it, formula by formula, and "
                "find what limits the feed there.")
                 .arg(verdict::time(outcome.result));
}

Table HandoutTask::inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                          const std::set<QString>& symbols, Citations& citations,
                          const std::function<bool(std::string_view path)>& hides) {
    const Project& project = outcome.result.project;
    std::optional<Place> at;
    if (step) {
        at = outcome.trajectory.passes[step->pass].place;
    }
    Table table;
    table.head = {tr("Symbol"), tr("Value"), tr("Unit"), tr("Meaning"), tr("Source")};
    table.texts = {true, false, true, true, true};
    table.symbols = true;
    const auto add = [&](const char* symbol, const QString& value, const char* unit,
                         const QString& meaning, const QString& source) {
        table.rows.push_back({QString::fromUtf8(symbol), value, cell(unitText(unit)), meaning,
                              citations.cite(source)});
    };
    const int stage = at ? at->stage : 0; // 0: none
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        const Field& field = *leaf.field;
        const auto value = entersFormulas(leaf, project, symbols, stage)
                               ? singleNumberIn(field, leaf.owner)
                               : std::nullopt;
        if (value && !(hides && hides(leaf.path))) {
            add(field.symbol, printedNumber(*value), field.unit, inputText(field.label),
                QString::fromLatin1(field.source));
        }
    }
    if (at && !(hides && hides("/machine/compliance_mm_per_n"))) {
        const bool given =
            !std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
        const double gamma = compliantPoints(project)[sectionOf(*at)].gamma_mm_n;
        add("γ", formulaNumber({"γ", gamma, "mm/N"}).replace(u'-', QChar(0x2212)), "mm/N",
            tr("Compliance of the system, %1").arg(Names::zone(at->zone, at->section)),
            given ? QStringLiteral("MODEL-3") : QStringLiteral("MODEL-6"));
    }
    return table;
}

} // namespace sparkout::report
