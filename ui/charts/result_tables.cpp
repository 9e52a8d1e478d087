// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/result_tables.h"

#include "core/project/machine.h"
#include "core/quality/finished_surface.h"
#include "core/quality/form_outputs.h"
#include "core/quality/light.h"
#include "core/quality/roughness.h"
#include "core/units.h"
#include "ui/charts/margin_model.h"
#include "ui/charts/verdict_table.h"
#include "ui/tables/output_cells.h"
#include "ui/text/names.h"
#include "ui/text/output_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>
#include <string_view>

namespace sparkout {

namespace {

struct ResultTables {
    Q_DECLARE_TR_FUNCTIONS(ResultTables)
};

/// For a zone with several sections.
ZoneFormFigures formOf(const Outcome& outcome, std::size_t zone) {
    return {&outcome.accuracy.sections.at(zone), &outcome.accuracy.zones.at(zone),
            FinishedSurface(outcome.result.project).isWhole()};
}

/// The roundness is listed among a zone's other outputs.
std::span<const Output<ZoneFormFigures>> withoutRoundness() {
    return zoneFormOutputs().subspan(1);
}

QString formText(const OutputRow& row, const std::optional<double>& value_um,
                 const Machine& machine) {
    const std::string_view key = row.key;
    return !value_um                                ? QStringLiteral("—")
           : key == "taper_um" || key == "crown_um" ? Names::signedMicrometres(*value_um)
           : key == "total_runout_um" ? Names::formAmount(*value_um, isRunoutKnown(machine))
                                      : Names::formAmount(*value_um, isRoundnessKnown(machine));
}

} // namespace

CsvTable requirementTable(const std::vector<ConstraintResult>& requirements, Operation operation) {
    CsvTable table;
    table.ownUnits = true;
    table.header << ResultTables::tr("Requirement") << ResultTables::tr("Zone or section")
                 << ResultTables::tr("Value") << ResultTables::tr("Limit")
                 << ResultTables::tr("Margin") << ResultTables::tr("Unit")
                 << ResultTables::tr("Used up, %")
                 << ResultTables::tr("Setting / nearer end of the range")
                 << ResultTables::tr("Verdict") << ResultTables::tr("Worst place");
    for (const ConstraintResult& c : requirements) {
        const auto known = [isKnown = marginKnown(c) == MarginKnown::exactly](double value) {
            return isKnown ? CsvCell(value) : CsvCell();
        };
        const bool range = Names::isRange(c.kind);
        table.rows.push_back(
            {Names::constraint(c.kind), Names::where(c), c.isWhole ? CsvCell(c.value) : CsvCell(),
             c.limit, known(statedMargin(c)), unitText(requirementOf(c.kind).unit),
             range ? CsvCell() : known(100 * usageOf(c)),
             range && c.limit > 0 ? CsvCell(c.value / c.limit) : CsvCell(), lightName(c),
             c.at ? CsvCell(Names::place(*c.at, operation)) : CsvCell()});
    }
    return table;
}

CsvTable formTable(const Outcome& outcome) {
    CsvTable table;
    table.header << ResultTables::tr("Zone or section");
    addOutputHeads(table.header, zoneFormOutputs());
    for (std::size_t i = 0; i < outcome.accuracy.zones.size(); ++i) {
        const ZoneFormFigures form = formOf(outcome, i);
        std::vector<CsvCell>& cells = table.rows.emplace_back();
        cells.emplace_back(Names::zone(outcome.result.sections.at(i).zone, static_cast<int>(i)));
        addOutputCells(cells, zoneFormOutputs(), &form);
    }
    return table;
}

ValueTable formValues(const Outcome& outcome) {
    ValueTable table;
    if (outcome.accuracy.zones.empty()) {
        return table;
    }
    table.corner = ResultTables::tr("Quantity");
    for (const Output<ZoneFormFigures>& row : zoneFormOutputs()) {
        table.rows.push_back({outputLabel(row), outputName(row), outputHint(row), row.key});
    }
    table.cells.resize(table.rows.size());
    for (std::size_t i = 0; i < outcome.accuracy.zones.size(); ++i) {
        const Zone zone = outcome.result.sections.at(i).zone;
        const int index = static_cast<int>(i);
        table.columns.push_back({Names::zone(zone, index), Names::zoneFull(zone, index), {}});
        const ZoneFormFigures form = formOf(outcome, i);
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            const Output<ZoneFormFigures>& row = zoneFormOutputs()[r];
            table.cells[r].push_back(
                {formText(row, outputNumber(row, row.of(form)), *outcome.result.project.machine),
                 {},
                 {}});
        }
    }
    return table;
}

CsvTable zoneTable(const Outcome& outcome) {
    const SimulationResult& result = outcome.result;
    const Machine& machine = *result.project.machine;
    CsvTable table;
    table.header << ResultTables::tr("Zone or section")
                 << ResultTables::tr("From the headstock end, mm")
                 << ResultTables::tr("Compliance, mm/N")
                 << ResultTables::tr("Minimum diameter from nominal, µm")
                 << ResultTables::tr("Maximum diameter from nominal, µm")
                 << Names::ofMachine(ResultTables::tr("Radial runout, µm"), isRunoutKnown(machine))
                 << Names::ofMachine(ResultTables::tr("Roundness, minimum zone, µm"),
                                     isRoundnessKnown(machine))
                 << Names::ofMachine(ResultTables::tr("Roundness, least squares, µm"),
                                     isRoundnessKnown(machine))
                 << ResultTables::tr("Maximum normal force, N");
    const bool rough = std::ranges::any_of(
        result.sections, [](const SectionResult& section) { return section.lastCut.has_value(); });
    if (rough) {
        table.header << ResultTables::tr("Roughness Ra, µm");
    }
    const RoughnessFactor factor = roughnessFactor(result.project);
    if (rough && !factor.isMeasured()) {
        table.header << ResultTables::tr("Maximum roughness Ra of the estimate, µm");
    }
    if (!result.ifEven.empty()) {
        table.header << ResultTables::tr("Minimum diameter with even lobes, from nominal, µm")
                     << ResultTables::tr("Maximum diameter with even lobes, from nominal, µm");
    }
    const std::vector<ZoneForm>& forms = outcome.accuracy.zones;
    if (!forms.empty()) {
        addOutputHeads(table.header, withoutRoundness());
    }
    using units::umPerMm;
    const FinishedSurface surface(result.project);
    const auto stated = [&surface](double value_mm) {
        return surface.isWhole() ? CsvCell(value_mm * umPerMm) : CsvCell();
    };
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        const SectionAccuracy& form = outcome.accuracy.sections.at(i);
        std::vector<CsvCell> cells{Names::zone(section.zone, static_cast<int>(i)),
                                   section.position_mm,
                                   section.compliance_mm_per_n,
                                   stated(section.diameterDeviationMin_mm),
                                   stated(section.diameterDeviationMax_mm),
                                   stated(section.radialRunout_mm),
                                   stated(form.minimumZone.deviation()),
                                   stated(form.leastSquares.deviation()),
                                   section.peakNormalForce_n};
        if (rough) {
            for (const double f : std::set{factor.least, factor.most}) {
                cells.push_back(section.lastCut ? stated(
                                    RoughnessModel(result.project, f).roughness(*section.lastCut))
                                                : CsvCell());
            }
        }
        if (i < result.ifEven.size()) {
            cells.push_back(stated(result.ifEven[i].least_mm));
            cells.push_back(stated(result.ifEven[i].most_mm));
        }
        if (!forms.empty()) {
            const ZoneFormFigures figures = formOf(outcome, i);
            addOutputCells(cells, withoutRoundness(), &figures);
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

} // namespace sparkout
