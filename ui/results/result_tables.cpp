// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/result_tables.h"

#include "core/project/machine.h"
#include "core/quality/ranges.h"
#include "core/quality/result_json.h"
#include "core/quality/roughness.h"
#include "core/quality/shop_numbers.h"
#include "core/quality/verdict.h"
#include "core/units.h"
#include "ui/results/margin_model.h"
#include "ui/results/verdict_table.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

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

namespace {

struct ShopText {
    Q_DECLARE_TR_FUNCTIONS(ShopText)
};

/// The stages and the cycle, which is the last.
std::vector<const ShopColumn*> columnsOf(const ShopNumbers& shop) {
    std::vector<const ShopColumn*> columns;
    for (const ShopColumn& stage : shop.stages) {
        columns.push_back(&stage);
    }
    columns.push_back(&shop.cycle);
    return columns;
}

bool isTime(const OutputRow& row) {
    return std::string_view(row.unitShown()) == "min";
}

ValueHead headOf(const OutputRow& row, Operation operation, const TimeUnit& unit) {
    const bool revolutions = !operation->travels;
    if (isTime(row)) {
        const QString name = unit.titled(outputLabel(row));
        return {name, name, outputHint(row), row.key};
    }
    return {outputBrief(row, revolutions), outputName(row, revolutions), outputHint(row), row.key};
}

QString textOf(const OutputRow& row, const OutputValue& value, const TimeUnit& unit) {
    const std::optional<double> time_min =
        isTime(row) ? outputNumber(row, value) : std::optional<double>();
    return time_min ? threeDigits(unit.of(*time_min * units::secondsPerMinute))
                    : outputText(row, value);
}

/// Where a peak was, or what a number is made of; empty for most.
QString detailOf(std::string_view key, const ShopColumn& column, Operation operation) {
    if (column.depth_mm.value <= 0) {
        return {};
    }
    if (key == "peak_power_w") {
        return Names::place(column.power_w.at, operation);
    }
    if (key == "peak_normal_force_n") {
        return Names::place(column.normalForce_n.at, operation);
    }
    if (key == "specific_energy_j_mm3" || key == "mean_power_w") {
        return ShopText::tr("%1 kJ for %2 mm³ in %3 of grinding")
            .arg(Names::significant(column.energy_j / units::jPerKj),
                 Names::significant(column.removedVolume_mm3), Names::time(column.time_s));
    }
    if (key == "removal_rate_mm3_mm_s" || key == "equivalent_chip_um" || key == "aggressiveness") {
        return ShopText::tr("a = %1 µm: %2")
            .arg(Names::significant(column.depth_mm.value * units::umPerMm),
                 Names::place(column.depth_mm.at, operation));
    }
    return {};
}

QString sideText(BandSide side) {
    switch (side) {
    case BandSide::below: return ShopText::tr("below the usual");
    case BandSide::above: return ShopText::tr("above the usual");
    default: return {};
    }
}

/// Adds `text` with the stages of a side as %1; nothing if there are none.
void addRemark(QStringList& sentences, const ShopNumbers& shop,
               BandSide (ShopColumn::*band)() const, BandSide side, const QString& text) {
    QStringList stages;
    for (std::size_t z = 0; z < shop.stages.size(); ++z) {
        if ((shop.stages[z].*band)() == side) {
            stages << QString::number(z + 1);
        }
    }
    if (!stages.isEmpty()) {
        sentences << text.arg(stages.join(QStringLiteral(", ")));
    }
}

} // namespace

ValueTable shopTable(const Outcome& outcome) {
    const ShopNumbers& shop = outcome.shop;
    const Operation operation = outcome.result.project.operation;
    ValueTable table;
    table.corner = ShopText::tr("Quantity");
    table.remarks = ShopText::tr("Outside the usual");
    if (shop.stages.empty()) {
        return table;
    }
    for (std::size_t z = 1; z <= shop.stages.size(); ++z) {
        table.columns.push_back({QString::number(z), ShopText::tr("Stage %1").arg(z), {}});
    }
    table.columns.push_back({ShopText::tr("Cycle"), ShopText::tr("Whole cycle"), {}});
    const std::vector<const ShopColumn*> columns = columnsOf(shop);
    const TimeUnit unit(shop.cycle.time_s);
    for (const Output<ShopColumn>& row : shopColumnOutputs()) {
        std::vector<ValueCell> cells;
        bool hasValue = false;
        for (const ShopColumn* column : columns) {
            const OutputValue value = row.of(*column);
            hasValue = hasValue || value.index() != 0;
            cells.push_back({textOf(row, value, unit), sideText(row.bandOf(*column)),
                             detailOf(row.key, *column, operation)});
        }
        if (!row.detail && (hasValue || !row.sparse)) {
            table.rows.push_back(headOf(row, operation, unit));
            table.cells.push_back(std::move(cells));
        }
    }
    for (const Output<ShopNumbers>& row : shopOutputs()) { // shown in the cycle's column
        if (!row.detail) {
            std::vector<ValueCell> cells(columns.size());
            cells.back() = {outputText(row, row.of(shop)),
                            row.bandOf(shop) == BandSide::above
                                ? ShopText::tr("near a whole number")
                                : QString(),
                            {}};
            table.rows.push_back(headOf(row, operation, unit));
            table.cells.push_back(std::move(cells));
        }
    }
    return table;
}

CsvTable stageTable(const ShopNumbers& shop, Operation operation) {
    CsvTable table;
    table.header << ShopText::tr("Stage");
    addOutputHeads(table.header, shopColumnOutputs(), !operation->travels);
    addOutputHeads(table.header, shopOutputs());
    const auto add = [&](CsvCell name, const ShopColumn& column, const ShopNumbers* whole) {
        std::vector<CsvCell>& cells = table.rows.emplace_back();
        cells.push_back(std::move(name));
        addOutputCells(cells, shopColumnOutputs(), &column);
        addOutputCells(cells, shopOutputs(), whole);
    };
    for (std::size_t z = 0; z < shop.stages.size(); ++z) {
        add(static_cast<double>(z + 1), shop.stages[z], nullptr);
    }
    add(ShopText::tr("Cycle"), shop.cycle, &shop);
    return table;
}

QStringList shopRemarks(const ShopNumbers& shop) {
    QStringList sentences;
    addRemark(sentences, shop, &ShopColumn::specificEnergyBand, BandSide::below,
              ShopText::tr("Specific energy below %2 J/mm³ (stage %1) is implausibly low; the "
                           "wheel's dullness or the flow stress may be set too low.")
                  .arg(QStringLiteral("%1"), Names::significant(leastSpecificEnergy_j_mm3, 2)));
    addRemark(sentences, shop, &ShopColumn::specificEnergyBand, BandSide::above,
              ShopText::tr("Specific energy above %2 J/mm³ (stage %1): the wheel rubs more than "
                           "it cuts, as it does late in spark-out or when dull.")
                  .arg(QStringLiteral("%1"), Names::significant(mostSpecificEnergy_j_mm3, 2)));
    addRemark(sentences, shop, &ShopColumn::overlapBand, BandSide::below,
              ShopText::tr("Overlap below 1 (stage %1): the table advances more than the wheel's "
                           "width in a revolution, strips stay unground."));
    if (shop.ratioNearInteger()) {
        sentences << ShopText::tr("Wheel and work turn %1 : 1, near a whole number: waves of the "
                                  "wheel print onto one another. Change the work speed a little.")
                         .arg(threeDigits(shop.rotationRatio));
    }
    return sentences;
}

} // namespace sparkout
