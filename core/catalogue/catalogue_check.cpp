// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/catalogue/catalogue_check.h"

#include "core/file/strict_json.h"
#include "core/project/range_check.h"

#include <algorithm>

namespace sparkout::catalogue {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

bool isValue(Kind kind) {
    switch (kind) {
    case Kind::text:
    case Kind::object:
    case Kind::optionalObject: return false;
    default: return true;
    }
}

void refuse(Issues& issues, IssueCode code, std::string path, Detail value, Detail limit) {
    issues.push_back({code, Severity::error, std::move(path), std::move(value), std::move(limit)});
}

/// A path inside a value without list indices: the key of its source.
std::string keyOf(const std::string& path) {
    std::string key = path;
    for (std::size_t slash = key.rfind('/'); slash != std::string::npos; slash = key.rfind('/')) {
        if (key.find_first_not_of("0123456789", slash + 1) != std::string::npos) {
            break;
        }
        key.resize(slash);
    }
    return key;
}

void checkRange(const ordered_json& number, const ValueSource& source, const std::string& path,
                Issues& issues) {
    if (!source.range || source.range->size() != 2 || !number.is_number()) {
        return;
    }
    const Range range{(*source.range)[0], (*source.range)[1]};
    if (!range.contains(number.get<double>())) {
        refuse(issues, IssueCode::outOfRange, path, Amount{number.get<double>()}, Bounds{range});
    }
}

void checkRows(const NumberRows& rows, const std::string& path, Issues& issues) {
    for (std::size_t i = 0; rows && i < rows->size(); ++i) {
        const auto& row = (*rows)[i];
        const std::string at = path + "/" + std::to_string(i);
        if (row.size() != 2) {
            refuse(issues, IssueCode::wrongCount, at, countOf(row.size()), Count{2});
        } else if (row[1] <= 0) {
            refuse(issues, IssueCode::outOfRange, at + "/1", Amount{row[1]},
                   Bounds{{.low = 0, .lowOpen = true}});
        } else if (i > 0 && (*rows)[i - 1].size() == 2 && row[0] <= (*rows)[i - 1][0]) {
            refuse(issues, IssueCode::outOfRange, at + "/0", Amount{row[0]},
                   Bounds{{.low = (*rows)[i - 1][0], .lowOpen = true}});
        }
    }
}

} // namespace

void eachValue(const ordered_json& value, const StructInfo& table, const std::string& prefix,
               const std::function<void(const std::string&, const ordered_json&)>& visit) {
    for (const Field& field : table.fields) {
        const auto found = value.find(field.key);
        if (found == value.end() || found->is_null()) {
            continue;
        }
        const std::string key = prefix + field.key;
        if (isValue(field.kind)) {
            visit(key, *found);
        } else if (field.nested && found->is_object()) {
            eachValue(*found, *field.nested, key + "/", visit);
        }
    }
}

ordered_json givenPart(const ordered_json& value, const StructInfo& table,
                       const std::vector<ValueSource>& sources, const std::string& prefix) {
    ordered_json given = ordered_json::object();
    for (const Field& field : table.fields) {
        const auto found = value.find(field.key);
        if (found == value.end() || found->is_null()) {
            continue;
        }
        const std::string key = prefix + field.key;
        if (isValue(field.kind)) {
            if (sourceOf(sources, key)) {
                given[field.key] = *found;
            }
        } else if (field.kind == Kind::text) {
            if (!found->get_ref<const std::string&>().empty()) {
                given[field.key] = *found;
            }
        } else if (field.nested && found->is_object()) {
            ordered_json part = givenPart(*found, *field.nested, sources, key + "/");
            if (!part.empty()) {
                given[field.key] = std::move(part);
            }
        }
    }
    return given;
}

ordered_json appliedPart(const ordered_json& value, const StructInfo& table,
                         const std::vector<ValueSource>& sources) {
    ordered_json applied = givenPart(value, table, sources);
    for (const ValueSource& source : sources) {
        if (!applied.contains(source.key) && mayBeUnknown(table, source)) {
            applied[source.key] = nullptr;
        }
    }
    for (const Field& field : table.fields) {
        const bool isAlways = field.nested && field.kind == Kind::object;
        if (!isAlways && (!field.nested || !applied.contains(field.key))) {
            continue;
        }
        ordered_json& part = applied[field.key];
        part = part.is_null() ? ordered_json::object() : part;
        for (const Field& inner : field.nested->fields) {
            const bool mayLack = inner.kind == Kind::optionalNumber
                                 || inner.kind == Kind::optionalInteger
                                 || inner.kind == Kind::optionalNumberList;
            if (mayLack && !part.contains(inner.key)) {
                part[inner.key] = nullptr;
            }
        }
    }
    return applied;
}

bool mayBeUnknown(const StructInfo& table, const ValueSource& source) {
    const Field* const field = table.find(source.key);
    return field && field->kind == Kind::optionalNumber && isEstimate(source);
}

void checkSources(const json& value, const StructInfo& table,
                  const std::vector<ValueSource>& sources, const std::string& path,
                  Issues& issues) {
    std::vector<std::string> keys;
    eachValue(ordered_json(value), table, {},
              [&](const std::string& key, const ordered_json& number) {
                  keys.push_back(key);
                  if (const ValueSource* source = sourceOf(sources, key)) {
                      checkRange(number, *source, path + "/value/" + key, issues);
                  } else {
                      refuse(issues, IssueCode::sourceMissing, path + "/value/" + key, Keys{{key}},
                             Keys{{"sources"}});
                  }
              });
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const ValueSource& source = sources[i];
        const std::string at = path + "/sources/" + std::to_string(i);
        const bool given = std::find(keys.begin(), keys.end(), source.key) != keys.end();
        if (!given && !mayBeUnknown(table, source)) {
            refuse(issues, IssueCode::unknownKey, at + "/key", quoted(json(source.key)),
                   Keys{keys});
        } else if (sourceOf(sources, source.key) != &source) {
            refuse(issues, IssueCode::duplicateKey, at + "/key", quoted(json(source.key)), {});
        }
        if (!given && source.range) { // an unknown value has none
            refuse(issues, IssueCode::missingKey, path + "/value/" + source.key, {},
                   Phrase::number);
        }
        if (source.range && source.range->size() != 2) {
            refuse(issues, IssueCode::wrongCount, at + "/range", countOf(source.range->size()),
                   Count{2});
        }
    }
}

void checkLimits(const Project& project, const std::string& key,
                 const std::vector<ValueSource>& sources, const std::string& path, Issues& issues) {
    const std::string inProject = "/" + key + "/";
    for (Issue& issue : checkRanges(project)) {
        if (issue.severity != Severity::error
            || issue.path.compare(0, inProject.size(), inProject) != 0) {
            continue;
        }
        const std::string inValue = issue.path.substr(inProject.size());
        if (sourceOf(sources, keyOf(inValue))) {
            issue.path = path;
            issue.path.append("/value/").append(inValue);
            issues.push_back(std::move(issue));
        }
    }
}

void checkThermal(const ThermalData& data, const std::string& path, Issues& issues) {
    const Field& density = *tableOf<ThermalData>().find("density_kg_m3");
    if (data.density_kg_m3 && !density.hard.contains(*data.density_kg_m3)) {
        refuse(issues, IssueCode::outOfRange, path + "/density_kg_m3",
               Amount{*data.density_kg_m3, density.unit}, Bounds{density.hard, density.unit});
    }
    checkRows(data.conductivity_w_mk_at_c, path + "/conductivity_w_mk_at_c", issues);
    checkRows(data.heat_capacity_j_kgk_at_c, path + "/heat_capacity_j_kgk_at_c", issues);
}

} // namespace sparkout::catalogue
