// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/part_table.h"

#include "core/printable.h"
#include "core/project/validate.h"
#include "core/quality/result_names.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <cmath>
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
    std::string line = m_dialect.begin;
    for (std::size_t i = 0; i < names.size(); ++i) {
        line += (i > 0 ? std::string(1, m_dialect.separator) : std::string())
                + csvCell(names[i], m_dialect.separator);
    }
    return line + m_dialect.lineEnd;
}

void PartTable::put(std::string& line, double value) const {
    line += m_dialect.separator;
    if (!std::isfinite(value)) {
        return;
    }
    const std::size_t from = line.size();
    line += numberText(value);
    std::replace(line.begin() + static_cast<std::ptrdiff_t>(from), line.end(), '.',
                 m_dialect.decimal);
}

std::string PartTable::line(const PartRecord& record) const {
    const PartOutcome& outcome = record.outcome;
    const bool done = outcome.completed;
    const bool whole = done && !outcome.fails[static_cast<std::size_t>(ConstraintKind::overlap)];
    const auto word = [this](bool yes) { return yes ? m_dialect.yes : m_dialect.no; };
    std::string line = std::to_string(record.part + m_dialect.firstPart) + m_dialect.separator
                       + m_dialect.states[!done   ? 1
                                          : whole ? 0
                                                  : 2]
                       + m_dialect.separator + word(outcome.good);
    const double none = std::numeric_limits<double>::quiet_NaN();
    put(line, whole ? outcome.margin : none);
    for (const double value : record.factors) {
        put(line, value);
    }
    for (std::size_t i = 0; i < m_columns.characteristics.size(); ++i) {
        put(line, done ? outcome.values[i] : none);
    }
    for (const ConstraintKind kind : m_columns.requirements) {
        const auto at = static_cast<std::size_t>(kind);
        line += m_dialect.separator;
        const bool known = whole || !requirementOf(kind).isOfSurface(); // else it does not hold
        line += done && outcome.asked[at] ? word(known && !outcome.fails[at]) : std::string();
    }
    return line + m_dialect.lineEnd;
}

} // namespace sparkout
