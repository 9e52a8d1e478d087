// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/result_tables.h"

#include "core/project/machine.h"
#include "core/quality/result_json.h"
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
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

struct ResultTables {
    Q_DECLARE_TR_FUNCTIONS(ResultTables)
};

/// The roundness is listed among a zone's other outputs.
std::span<const Output<ZoneFigures>> withoutRoundness() {
    return zoneFormOutputs().subspan(1);
}

QString formText(const OutputRow& row, const std::optional<double>& value_um,
                 const Machine& machine) {
    return !value_um          ? QStringLiteral("—")
           : row.knowsMachine ? Names::formAmount(*value_um, row.knowsMachine(machine))
                              : Names::signedMicrometres(*value_um);
}

/// The outputs of zones that stand in a table: some apply to no zone.
std::vector<Output<ZoneFigures>> zoneColumns(const std::vector<ZoneFigures>& zones) {
    std::vector<Output<ZoneFigures>> columns;
    std::ranges::copy_if(zoneOutputs(), std::back_inserter(columns), [&zones](const auto& row) {
        return !row.stated || std::ranges::any_of(zones, row.stated);
    });
    return columns;
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
    for (const ZoneFigures& zone : zonesOf(outcome.result, outcome.accuracy)) {
        if (zone.form) {
            std::vector<CsvCell>& cells = table.rows.emplace_back();
            cells.emplace_back(Names::zone(zone.section->zone));
            addOutputCells(cells, zoneFormOutputs(), &zone);
        }
    }
    return table;
}

ValueTable formValues(const Outcome& outcome) {
    ValueTable table;
    if (outcome.accuracy.zones.empty()) {
        return table;
    }
    table.corner = ResultTables::tr("Quantity");
    for (const Output<ZoneFigures>& row : zoneFormOutputs()) {
        table.rows.push_back({outputLabel(row), outputName(row), outputHint(row), row.key});
    }
    table.cells.resize(table.rows.size());
    for (const ZoneFigures& zone : zonesOf(outcome.result, outcome.accuracy)) {
        table.columns.push_back(
            {Names::zone(zone.section->zone), Names::zoneFull(zone.section->zone), {}});
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            const Output<ZoneFigures>& row = zoneFormOutputs()[r];
            table.cells[r].push_back(
                {formText(row, outputNumber(row, row.of(zone)), *zone.project->machine), {}, {}});
        }
    }
    return table;
}

CsvTable zoneTable(const Outcome& outcome) {
    const Machine& machine = *outcome.result.project.machine;
    const std::vector<ZoneFigures> zones = zonesOf(outcome.result, outcome.accuracy);
    const std::vector<Output<ZoneFigures>> columns = zoneColumns(zones);
    CsvTable table;
    table.header << ResultTables::tr("Zone or section");
    addOutputHeads(table.header, positionOutputs());
    for (const Output<ZoneFigures>& row : columns) {
        if (*row.label) {
            table.header << Names::ofMachine(outputName(row),
                                             !row.knowsMachine || row.knowsMachine(machine));
        }
    }
    if (!outcome.result.ifEven.empty()) {
        addOutputHeads(table.header, evenLobesOutputs());
    }
    if (!outcome.accuracy.zones.empty()) {
        addOutputHeads(table.header, withoutRoundness());
    }
    for (const ZoneFigures& zone : zones) {
        std::vector<CsvCell>& cells = table.rows.emplace_back();
        cells.emplace_back(
            Names::zone(zone.section->zone, static_cast<int>(table.rows.size()) - 1));
        addOutputCells(cells, positionOutputs(), zone.section);
        addOutputCells(cells, std::span<const Output<ZoneFigures>>(columns), &zone);
        if (zone.ifEven) {
            addOutputCells(cells, evenLobesOutputs(), &zone);
        }
        if (zone.form) {
            addOutputCells(cells, withoutRoundness(), &zone);
        }
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
