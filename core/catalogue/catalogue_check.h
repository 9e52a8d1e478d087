// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

/// Checks shared by the reader and the writer of a catalogue: the given numbers and choices of an
/// entry's value, and their sources.
namespace sparkout::catalogue {

/// Calls visit(key, value) for each number or choice of a value's JSON; a list or table counts as
/// one.
void eachValue(const nlohmann::ordered_json& value, const StructInfo& table,
               const std::string& prefix,
               const std::function<void(const std::string&, const nlohmann::ordered_json&)>& visit);

/// The parts of a value's JSON with a source, and the texts that are not empty.
[[nodiscard]] nlohmann::ordered_json givenPart(const nlohmann::ordered_json& value,
                                               const StructInfo& table,
                                               const std::vector<ValueSource>& sources,
                                               const std::string& prefix = {});

/// What an entry changes: its given part, with null for an optional value that a source marks as
/// unknown, and for one that is missing from an object that is given or that every value has: the
/// limits are those of one machine, not of two.
[[nodiscard]] nlohmann::ordered_json appliedPart(const nlohmann::ordered_json& value,
                                                 const StructInfo& table,
                                                 const std::vector<ValueSource>& sources);

/// Whether a missing value may have this source, which marks it as unknown: the value is optional,
/// and the source claims no reference.
[[nodiscard]] bool mayBeUnknown(const StructInfo& table, const ValueSource& source);

/// Checks that every number and choice has a source, every source a value or the mark of an unknown
/// one, and that each number is in its stated range.
void checkSources(const nlohmann::json& value, const StructInfo& table,
                  const std::vector<ValueSource>& sources, const std::string& path, Issues& issues);

/// Checks the hard limits of the project's tables, through a project with the value under `key`.
void checkLimits(const Project& project, const std::string& key,
                 const std::vector<ValueSource>& sources, const std::string& path, Issues& issues);

/// Rows of two, at rising temperatures, of positive values.
void checkThermal(const ThermalData& data, const std::string& path, Issues& issues);

} // namespace sparkout::catalogue
