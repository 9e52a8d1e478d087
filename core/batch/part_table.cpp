// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/part_table.h"

#include "core/quality/result_names.h"
#include "core/simulation/simulate.h"
#include "core/tables/csv_line.h"

#include <algorithm>
#include <limits>

namespace sparkout {

PartColumns PartColumns::of(const ScenarioSource& source, const std::stop_token& stop) {
    PartColumns columns{source.factors(), characteristicsOf(source.nominal()), {}};
    std::array<bool, constraintKinds> asked{};
    for (const ConstraintResult& constraint :
         evaluateConstraints(simulateUnchecked(source.nominal(), nullptr, stop))) {
        asked[static_cast<std::size_t>(constraint.kind)] = true;
    }
    for (const Requirement& row : requirementRows) {
        if (asked[static_cast<std::size_t>(row.kind)]
            || std::ranges::find(columns.characteristics, &row, &Characteristic::requirement)
                   != columns.characteristics.end()) {
            columns.requirements.push_back(row.kind);
        }
    }
    return columns;
}

std::string placeKey(const Characteristic& characteristic) {
    return sectionOrPart(characteristic.zone, characteristic.section);
}

std::vector<std::string> PartTable::keys(const PartColumns& columns) {
    std::vector<std::string> keys{"part", "status", "good", "least_relative_margin"};
    for (const GivenFactor& factor : columns.factors) {
        keys.emplace_back(factorKey(factor));
    }
    for (const Characteristic& of : columns.characteristics) {
        keys.push_back(std::string(of.name) + ' ' + placeKey(of) + " [" + of.unit + ']');
    }
    for (const ConstraintKind kind : columns.requirements) {
        keys.push_back(std::string(requirementOf(kind).key) + " holds");
    }
    return keys;
}

std::string PartTable::head(const std::vector<std::string>& names) const {
    CsvLine line(m_dialect.table);
    for (const std::string& name : names) {
        line.text(name);
    }
    return m_dialect.begin + line.end(m_dialect.lineEnd);
}

std::string PartTable::line(const PartRecord& record) const {
    const PartOutcome& outcome = record.outcome;
    const bool done = outcome.completed;
    const bool whole = done && !outcome.fails[static_cast<std::size_t>(ConstraintKind::overlap)];
    const auto word = [this](bool yes) { return yes ? m_dialect.yes : m_dialect.no; };
    CsvLine line(m_dialect.table);
    line.whole(record.part + m_dialect.firstPart)
        .text(m_dialect.states[!done   ? 1
                               : whole ? 0
                                       : 2])
        .text(word(outcome.good));
    const double none = std::numeric_limits<double>::quiet_NaN();
    line.number(whole ? outcome.margin : none);
    for (const double value : record.factors) {
        line.number(value);
    }
    for (std::size_t i = 0; i < m_columns.characteristics.size(); ++i) {
        line.number(done ? outcome.values[i] : none);
    }
    for (const ConstraintKind kind : m_columns.requirements) {
        const auto at = static_cast<std::size_t>(kind);
        const bool known = whole || !requirementOf(kind).isOfSurface(); // otherwise: not met
        line.text(done && outcome.asked[at] ? word(known && !outcome.fails[at]) : std::string());
    }
    return line.end(m_dialect.lineEnd);
}

} // namespace sparkout
