// SPDX-License-Identifier: GPL-3.0-or-later
// The task, the inputs, the questions with their key, and the sources of the hand-out.
#include "ui/report/handout/course_handout_parts.h"

#include "core/process/system_compliance.h"
#include "core/project/leaves.h"
#include "core/simulation/progress.h"
#include "ui/report/parts/cycle_card_parts.h"
#include "ui/report/parts/report_values.h"
#include "ui/text/example_texts.h"
#include "ui/text/field_text.h"
#include "ui/text/formula_text.h"
#include "ui/text/names.h"
#include "ui/text/source_names.h"
#include "ui/text/texts.h"
#include "ui/views/verdict/verdict_text.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace sparkout::report {

namespace {

constexpr int percent = 100;

/// What the step's feed, width and stock come from without standing in a formula.
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

/// By how many percent, as far as the printed numbers tell.
QString change(const Answer& answer) {
    const QString before = askedNumber(answer.asked, answer.before);
    if (before == askedNumber(answer.asked, answer.after)) {
        return QStringLiteral("0");
    }
    if (before == askedNumber(answer.asked, 0)) {
        return QStringLiteral("–");
    }
    const double percents = percent * (answer.after - answer.before) / std::abs(answer.before);
    return (percents > 0 ? QStringLiteral("+") : QString())
           + Names::significant(percents).replace(u'-', QChar(0x2212));
}

} // namespace

QString Citations::cite(const QString& key) {
    if (!m_keys.contains(key)) {
        m_keys << key;
    }
    return QStringLiteral("[%1]").arg(key);
}

Facts CourseHandout::header(const Project& project, const QString& file, const QDate& date) {
    Facts facts = CycleCard::header(project, date);
    facts.facts.insert(
        facts.facts.begin(),
        {{tr("Course"), cell(manyLines(exampleTitle(project.title)).simplified())},
         {tr("Project file"), cell(manyLines(QFileInfo(file).fileName()).simplified())}});
    return facts;
}

QString CourseHandout::task(const Outcome& outcome) {
    const Project& project = outcome.result.project;
    const Part& part = project.part;
    const QString ground =
        part.surface == Surface::external
            ? tr("A shaft of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of "
                 "stock per side and a runout of %4 mm.")
            : tr("A bore of %1 is ground over a length of %2 mm. Its blank has at least %3 mm of "
                 "stock per side and a runout of %4 mm.");
    return ground.arg(drawnSize(part), plainNumber(part.length_mm), plainNumber(part.stock_mm),
                      plainNumber(part.initial_runout_mm))
           + u' '
           + tr("By the model the cycle takes %1. Follow one step of it, formula by formula, and "
                "find what limits the feed there.")
                 .arg(verdict::time(outcome.result));
}

Table CourseHandout::inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                            const std::set<QString>& symbols, Citations& citations) {
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
        if (value) {
            add(field.symbol, plainNumber(*value), field.unit, inputText(field.label),
                QString::fromLatin1(field.source));
        }
    }
    if (at) {
        const bool given =
            !std::holds_alternative<std::monostate>(project.machine.compliance_mm_per_n);
        const double gamma = compliantPoints(project)[sectionOf(*at)].gamma_mm_n;
        add("γ", formulaNumber({"γ", gamma, "mm/N"}).replace(u'-', QChar(0x2212)), "mm/N",
            tr("Compliance of the system, %1").arg(Names::zone(at->zone, at->section)),
            given ? QStringLiteral("MODEL-3") : QStringLiteral("MODEL-6"));
    }
    return table;
}

std::vector<Block> CourseHandout::questions(const std::vector<Exercise>& exercises) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        blocks.emplace_back(
            Paragraph{QStringLiteral("%1. %2").arg(QString::number(i + 1), exercises[i].question)});
    }
    return blocks;
}

std::vector<Block> CourseHandout::answers(const std::vector<Exercise>& exercises,
                                          Operation operation) {
    std::vector<Block> blocks;
    blocks.emplace_back(Paragraph{
        tr("Computed by the engine: it has run the whole cycle with that one input changed.")});
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        const Exercise& exercise = exercises[i];
        blocks.emplace_back(
            Paragraph{QStringLiteral("%1. %2").arg(QString::number(i + 1), exercise.reason)});
        Table table;
        table.head = {tr("Asked for"), tr("Before"), tr("Changed"), tr("Difference, %")};
        table.texts = {true};
        for (const Answer& answer : exercise.answers) {
            table.rows.push_back({askedName(answer.asked, operation),
                                  askedNumber(answer.asked, answer.before),
                                  askedNumber(answer.asked, answer.after), change(answer)});
        }
        blocks.emplace_back(table);
    }
    return blocks;
}

Table CourseHandout::sources(const Citations& citations) {
    Table table;
    table.head = {tr("Key"), tr("Source")};
    table.texts = {true, true};
    for (const QString& key : citations.keys()) {
        table.rows.push_back({key, cell(sourceText(key.toStdString()))});
    }
    return table;
}

} // namespace sparkout::report
