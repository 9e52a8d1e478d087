// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/export_file.h"

#include "core/batch/judgement.h"
#include "core/process/profile.h"
#include "core/project/part.h"
#include "core/quality/run_summary.h"
#include "core/simulation/progress.h"
#include "core/units.h"
#include "ui/dialogs/table_file.h"
#include "ui/results/result_tables.h"
#include "ui/results/run_table.h"
#include "ui/table/sheet.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "words/judgement_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace sparkout {

namespace {

struct ExportFile {
    Q_DECLARE_TR_FUNCTIONS(ExportFile)
};

TableFormat tableFormatOf(ExportFormat format) {
    switch (format) {
    case ExportFormat::csvRussian: return TableFormat::csvRussian;
    case ExportFormat::csvEnglish: return TableFormat::csvEnglish;
    default: return TableFormat::xlsx;
    }
}

struct TraceSheet {
    Q_DECLARE_TR_FUNCTIONS(TraceSheet)
};

constexpr int timeDecimals = 6, lengthDecimals = 7, umDecimals = 4, forceDecimals = 3;

std::vector<SheetColumn> columnsFor(const Operation& operation) {
    const QString mm = unitText("mm");
    std::vector<SheetColumn> columns{
        {TraceSheet::tr("Time"), unitText("min"), timeDecimals},
        {operation->travels ? TraceSheet::tr("Double stroke") : TraceSheet::tr("Revolution"),
         {},
         0},
        {TraceSheet::tr("Stage"), {}, 0},
        {operation->travels ? TraceSheet::tr("Zone") : TraceSheet::tr("Section")}};
    if (operation->travels) {
        columns.push_back({TraceSheet::tr("Step")});
        columns.push_back({TraceSheet::tr("Pass of the step"), {}, 0});
    }
    columns.push_back({TraceSheet::tr("Radius no."), {}, 0});
    columns.push_back({TraceSheet::tr("Programmed feed"), mm, lengthDecimals});
    columns.push_back({TraceSheet::tr("Actual feed"), mm, lengthDecimals});
    columns.push_back({TraceSheet::tr("Accumulated actual feed"), mm, lengthDecimals});
    columns.push_back({TraceSheet::tr("Radius from nominal"), unitText("µm"), umDecimals});
    columns.push_back({TraceSheet::tr("Normal force"), unitText("N"), forceDecimals});
    return columns;
}

/// The common texts of a pass's rows.
struct PassTexts {
    std::vector<QString> zones; ///< by zone or section
    std::vector<QString> steps;
};

PassTexts textsFor(const SimulationResult& result) {
    PassTexts texts;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        texts.zones.push_back(Names::zone(result.sections[i].zone, static_cast<int>(i)));
    }
    for (int step = 0; step <= static_cast<int>(Step::e5); ++step) {
        texts.steps.push_back(Names::step(static_cast<Step>(step)));
    }
    return texts;
}

void fillRow(const Outcome& outcome, const PassTexts& texts, const Pass& pass, std::size_t radius,
             std::vector<CsvCell>& cells) {
    const Project& project = outcome.result.project;
    const Visit& visit = outcome.trajectory.visits[pass.firstVisit + radius];
    const Place& place = pass.place;
    auto cell = cells.begin();
    const auto put = [&cell](CsvCell value) { *cell++ = std::move(value); };
    put(visit.time_s / units::secondsPerMinute);
    put(double(place.cycleCount));
    put(double(place.stage));
    put(texts.zones[sectionOf(place)]);
    if (project.operation->travels) {
        put(texts.steps[static_cast<std::size_t>(place.step)]);
        put(double(place.revolution));
    }
    put(double(radius));
    put(visit.programmed_mm);
    put(visit.actual_mm);
    put(visit.accumulated_mm);
    put((visit.radius_mm - project.part->diameter_mm / 2) * units::umPerMm);
    put(visit.normalForce_n);
}

Sheet sheetOfPasses(const OutcomePtr& outcome, const QString& name,
                    std::vector<std::uint32_t> passes) {
    Sheet sheet;
    sheet.name = name;
    sheet.columns = columnsFor(outcome->result.project.operation);
    const auto radii = static_cast<std::size_t>(outcome->trajectory.radii);
    sheet.rows = passes.size() * radii;
    sheet.fill = [outcome, radii, texts = textsFor(outcome->result),
                  passes = std::move(passes)](std::size_t row, std::vector<CsvCell>& cells) {
        fillRow(*outcome, texts, outcome->trajectory.passes[passes[row / radii]], row % radii,
                cells);
    };
    return sheet;
}

/// The trace, a row for every time a radius passed under the wheel, with the numbers of
/// `sparkout-cli simulate --trace`.
Sheet traceSheet(const OutcomePtr& outcome, const QString& name) {
    std::vector<std::uint32_t> passes(outcome->trajectory.passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        passes[i] = static_cast<std::uint32_t>(i);
    }
    return sheetOfPasses(outcome, name, std::move(passes));
}

/// With a sheet for each zone or section.
std::vector<Sheet> traceSheets(const OutcomePtr& outcome) {
    const auto& sections = outcome->result.sections;
    std::vector<std::vector<std::uint32_t>> passes(sections.size());
    for (std::size_t i = 0; i < outcome->trajectory.passes.size(); ++i) {
        passes[sectionOf(outcome->trajectory.passes[i].place)].push_back(
            static_cast<std::uint32_t>(i));
    }
    std::vector<Sheet> sheets;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        sheets.push_back(sheetOfPasses(
            outcome,
            TraceSheet::tr("Trace %1").arg(Names::zone(sections[i].zone, static_cast<int>(i))),
            std::move(passes[i])));
    }
    return sheets;
}

using units::umPerMm;

struct ResultParts {
    Q_DECLARE_TR_FUNCTIONS(ResultParts)
};

/// The values of a kept run, the gauge's reading and the longitudinal form of the part.
CsvTable wholeCycle(const Outcome& outcome) {
    const SimulationResult& result = outcome.result;
    CsvTable table =
        cycleTable(summarise(result, outcome.accuracy, outcome.constraints), result.project);
    const auto add = [&table](const QString& name, const char* unit, double value) {
        table.rows.push_back({name, unitText(unit), value});
    };
    add(ResultParts::tr("Gauge reading, diameter"), "mm", result.gaugeReading_mm);
    add(ResultParts::tr("Stock left per side by the gauge"), "µm",
        result.remainingStock_mm * umPerMm);
    add(ResultParts::tr("Taper"), "µm", outcome.accuracy.profile.taper_mm * umPerMm);
    add(ResultParts::tr("Crown"), "µm", outcome.accuracy.profile.crown_mm * umPerMm);
    table.rows.push_back(
        {ResultParts::tr("Engine"), QString(), QString::fromStdString(result.engineVersion)});
    return table;
}

/// The final radii less the nominal one: a row for each angle, a column for each zone or section.
CsvTable finalProfiles(const SimulationResult& result) {
    const double nominal_mm = result.project.part->diameter_mm / 2;
    CsvTable table;
    table.header << ResultParts::tr("Radius no.") << ResultParts::tr("Angle, °");
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        table.header << ResultParts::tr("%1: radius from nominal, µm")
                            .arg(Names::zone(result.sections[i].zone, static_cast<int>(i)));
    }
    const std::size_t radii = result.sections.empty() ? 0 : result.sections[0].radii_mm.size();
    for (std::size_t k = 0; k < radii; ++k) {
        std::vector<CsvCell> row{double(k), double(k) * 360.0 / double(radii)};
        for (const SectionResult& section : result.sections) {
            row.emplace_back((section.radii_mm[k] - nominal_mm) * umPerMm);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

CsvTable tableOfPart(const Outcome& outcome, ResultPart part) {
    const Project& project = outcome.result.project;
    switch (part) {
    case ResultPart::inputs: return inputTable(project);
    case ResultPart::cycle: return wholeCycle(outcome);
    case ResultPart::stages: return stageTable(outcome.shop, project.operation);
    case ResultPart::zones: return zoneTable(outcome);
    case ResultPart::profiles: return finalProfiles(outcome.result);
    case ResultPart::requirements: return requirementTable(outcome.constraints, project.operation);
    case ResultPart::trace: break;
    }
    return {};
}

} // namespace

bool ExportChoice::hasTrace() const {
    return format != ExportFormat::json
           && std::ranges::find(parts, ResultPart::trace) != parts.end();
}

QString exportSuffix(ExportFormat format) {
    return format == ExportFormat::json ? QStringLiteral("json")
                                        : tableFormatSuffix(tableFormatOf(format));
}

QString exportFilter(ExportFormat format) {
    return format == ExportFormat::json ? ExportFile::tr("JSON files (*.json)")
                                        : tableFormatFilter(tableFormatOf(format));
}

QString exportObstacle(const OutcomePtr& outcome, const ExportChoice& choice) {
    if (!choice.hasTrace()) {
        return {};
    }
    if (traceRows(*outcome) == 0) {
        return ExportFile::tr("There is no trace: the run has %1 rows and a trace at most %2, so "
                              "only the results are kept.")
            .arg(QLocale().toString(outcome->result.visits), QLocale().toString(maxRecordedVisits));
    }
    if (choice.format != ExportFormat::xlsx) {
        return {};
    }
    const Book book = bookOf(outcome, choice.parts);
    const Sheet* sheet = sheetTooLong(book.sheets);
    return sheet ? tooLongText(sheet->name, sheet->rows) : QString();
}

std::function<QByteArray(const KeepGoing&)> studyWork(const Study& study, ExportFormat format) {
    if (format == ExportFormat::xlsx) {
        return [book = studyBook(study)](const KeepGoing& keepGoing) {
            return xlsxBytes(book, keepGoing);
        };
    }
    return [sheet = studyMainSheet(study), dialect = dialectOf(tableFormatOf(format))](
               const KeepGoing& keepGoing) { return csvBytes(sheet, dialect, keepGoing); };
}

std::function<QByteArray(const KeepGoing&)> exportWork(const OutcomePtr& outcome,
                                                       const ExportChoice& choice) {
    switch (choice.format) {
    case ExportFormat::xlsx:
        return [book = bookOf(outcome, choice.parts)](const KeepGoing& keepGoing) {
            return xlsxBytes(book, keepGoing);
        };
    case ExportFormat::csvRussian:
    case ExportFormat::csvEnglish:
        return [sheet = partSheet(outcome, choice.parts.front()),
                dialect = dialectOf(tableFormatOf(choice.format))](const KeepGoing& keepGoing) {
            return csvBytes(sheet, dialect, keepGoing);
        };
    case ExportFormat::json: break;
    }
    return [outcome](const KeepGoing&) { return resultJsonBytes(*outcome); };
}

QString partName(ResultPart part, Operation operation) {
    switch (part) {
    case ResultPart::inputs: return ResultParts::tr("Inputs");
    case ResultPart::cycle: return ResultParts::tr("Whole cycle");
    case ResultPart::stages: return ResultParts::tr("Stages");
    case ResultPart::zones:
        return operation->travels ? ResultParts::tr("Zones") : ResultParts::tr("Sections");
    case ResultPart::profiles: return ResultParts::tr("Final profiles");
    case ResultPart::requirements: return ResultParts::tr("Requirements");
    case ResultPart::trace: return ResultParts::tr("Trace");
    }
    return {};
}

const char* partKey(ResultPart part) {
    constexpr std::array keys{"inputs",   "cycle",        "stages", "zones",
                              "profiles", "requirements", "trace"};
    return keys[static_cast<std::size_t>(part)];
}

Sheet partSheet(const OutcomePtr& outcome, ResultPart part) {
    const QString name = partName(part, outcome->result.project.operation);
    return part == ResultPart::trace ? traceSheet(outcome, name)
                                     : sheetOf(tableOfPart(*outcome, part), name);
}

Book bookOf(const OutcomePtr& outcome, const std::vector<ResultPart>& parts) {
    const Project& project = outcome->result.project;
    Book book{
        exampleTitle(project.title), QString::fromStdString(project.author), programText(), {}};
    for (const ResultPart part : parts) {
        if (part == ResultPart::trace) {
            for (Sheet& sheet : traceSheets(outcome)) {
                book.sheets.push_back(std::move(sheet));
            }
        } else {
            book.sheets.push_back(partSheet(outcome, part));
        }
    }
    return book;
}

std::size_t traceRows(const Outcome& outcome) {
    return outcome.trajectory.visits.size();
}

QByteArray resultJsonBytes(const Outcome& outcome) {
    return QByteArray::fromStdString(judgedResultJson(
        outcome.result, outcome.constraints,
        judge(outcome.result, outcome.constraints, judgeStocks(outcome.result), {}, {}, false)));
}

} // namespace sparkout
