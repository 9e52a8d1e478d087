// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/trace_sheet.h"

#include "core/project/part.h"
#include "core/simulation/progress.h"
#include "core/units.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

struct TraceSheet {
    Q_DECLARE_TR_FUNCTIONS(TraceSheet)
};

constexpr int timeDecimals = 6, lengthDecimals = 7, umDecimals = 4, forceDecimals = 3;

std::vector<SheetColumn> columnsFor(const Operation& operation) {
    const QString mm = unitText("mm");
    std::vector<SheetColumn> columns{
        {TraceSheet::tr("Time"), unitText("min"), timeDecimals},
        {operation->countsStrokes ? TraceSheet::tr("Double stroke") : TraceSheet::tr("Revolution"),
         {},
         0},
        {TraceSheet::tr("Stage"), {}, 0},
        {operation->hasZones ? TraceSheet::tr("Zone") : TraceSheet::tr("Section")}};
    if (operation->countsStrokes) {
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
    if (project.operation->countsStrokes) {
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

} // namespace

Sheet traceSheet(const OutcomePtr& outcome, const QString& name) {
    std::vector<std::uint32_t> passes(outcome->trajectory.passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        passes[i] = static_cast<std::uint32_t>(i);
    }
    return sheetOfPasses(outcome, name, std::move(passes));
}

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

} // namespace sparkout
