// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/result_tables.h"

#include "core/quality/finished_surface.h"
#include "core/quality/roughness.h"
#include "core/units.h"
#include "ui/charts/margin_model.h"
#include "ui/charts/verdict_model.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>

namespace sparkout {

namespace {

struct ResultTables {
    Q_DECLARE_TR_FUNCTIONS(ResultTables)
};

/// Of a zone with several sections.
void addFormHeads(QStringList& header) {
    header << ResultTables::tr("Cylindricity, µm") << ResultTables::tr("Total runout, µm")
           << ResultTables::tr("Taper, µm") << ResultTables::tr("Crown, µm");
}
void addForm(std::vector<CsvCell>& cells, const ZoneForm& zone, const FinishedSurface& surface) {
    for (const double value_mm : {zone.cylindricity_mm, zone.totalRunout_mm, zone.profile.taper_mm,
                                  zone.profile.crown_mm}) {
        cells.push_back(surface.isWhole() ? CsvCell(value_mm * units::umPerMm) : CsvCell());
    }
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
        const auto known = [&c](double value) { return c.isWhole ? CsvCell(value) : CsvCell(); };
        const bool range = Names::isRange(c.kind);
        table.rows.push_back(
            {Names::constraint(c.kind), Names::where(c), known(c.value), c.limit, known(c.margin),
             unitText(requirementOf(c.kind).unit), range ? CsvCell() : known(100 * usageOf(c)),
             range && c.limit > 0 ? CsvCell(c.value / c.limit) : CsvCell(), lightName(c),
             c.at ? CsvCell(Names::place(*c.at, operation)) : CsvCell()});
    }
    return table;
}

CsvTable formTable(const Outcome& outcome) {
    CsvTable table;
    table.header << ResultTables::tr("Zone or section")
                 << ResultTables::tr("Roundness, minimum zone, µm");
    addFormHeads(table.header);
    const FinishedSurface surface(outcome.result.project);
    for (std::size_t i = 0; i < outcome.accuracy.zones.size(); ++i) {
        const double roundness_mm = outcome.accuracy.sections.at(i).minimumZone.deviation();
        std::vector<CsvCell> cells{
            Names::zone(outcome.result.sections.at(i).zone, static_cast<int>(i)),
            surface.isWhole() ? CsvCell(roundness_mm * units::umPerMm) : CsvCell()};
        addForm(cells, outcome.accuracy.zones[i], surface);
        table.rows.push_back(std::move(cells));
    }
    return table;
}

CsvTable zoneTable(const Outcome& outcome) {
    const SimulationResult& result = outcome.result;
    CsvTable table;
    table.header << ResultTables::tr("Zone or section")
                 << ResultTables::tr("From the headstock end, mm")
                 << ResultTables::tr("Compliance, mm/N")
                 << ResultTables::tr("Minimum diameter from nominal, µm")
                 << ResultTables::tr("Maximum diameter from nominal, µm")
                 << ResultTables::tr("Radial runout, µm")
                 << ResultTables::tr("Roundness, minimum zone, µm")
                 << ResultTables::tr("Roundness, least squares, µm")
                 << ResultTables::tr("Maximum normal force, N");
    const bool rough = std::ranges::any_of(
        result.sections, [](const SectionResult& section) { return section.lastCut.has_value(); });
    if (rough) {
        table.header << ResultTables::tr("Roughness Ra, µm");
    }
    const std::vector<ZoneForm>& forms = outcome.accuracy.zones;
    if (!forms.empty()) {
        addFormHeads(table.header);
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
            cells.push_back(section.lastCut ? stated(
                                RoughnessModel(result.project).roughness(section.lastCut->depth_mm))
                                            : CsvCell());
        }
        if (!forms.empty()) {
            addForm(cells, forms.at(i), surface);
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

} // namespace sparkout
