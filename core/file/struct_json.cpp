// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/struct_json.h"

#include "core/file/output_json.h"
#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/project/project.h"
#include "core/project/range_check.h"
#include "core/project/validate.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json complianceJson(const GivenCompliance& compliance) {
    if (const auto* zones = std::get_if<ZoneCompliance>(&compliance)) {
        return {{"rz1", zones->rz1}, {"nz", zones->nz}, {"rz2", zones->rz2}};
    }
    const auto* sections = std::get_if<std::vector<double>>(&compliance);
    return sections ? ordered_json(*sections) : ordered_json(nullptr);
}

ordered_json levelsJson(const Levels& levels) {
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        return {{"from", stepped->from}, {"to", stepped->to}, {"step", stepped->step}};
    }
    const auto* list = std::get_if<std::vector<double>>(&levels);
    return list ? ordered_json(*list) : ordered_json(nullptr);
}

ordered_json choiceJson(const Field& field, const void* owner) {
    return field.choices[static_cast<std::size_t>(field.getChoice(owner))].key;
}

ordered_json countOrWordJson(const Field& field, const void* owner) {
    if (const int* number = field.wholeNumber(owner)) {
        return *number;
    }
    return field.getChoice(owner) < 0 ? ordered_json(nullptr) : choiceJson(field, owner);
}

ordered_json listJson(const Field& field, const void* owner) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < field.size(owner); ++i) {
        list.push_back(writeByTable(*field.nested, field.itemIn(owner, i)));
    }
    return list;
}

ordered_json fieldJson(const Field& field, const void* owner) {
    switch (field.kind) {
    case Kind::number: return field.as<double>(owner);
    case Kind::optionalNumber: return jsonOrNull(field.as<std::optional<double>>(owner));
    case Kind::integer: return field.as<int>(owner);
    case Kind::optionalInteger: return jsonOrNull(field.as<std::optional<int>>(owner));
    case Kind::boolean: return field.as<bool>(owner);
    case Kind::text: return field.as<std::string>(owner);
    case Kind::choice: return choiceJson(field, owner);
    case Kind::numberList: return field.as<std::vector<double>>(owner);
    case Kind::optionalNumberList:
        return jsonOrNull(field.as<std::optional<std::vector<double>>>(owner));
    case Kind::object: return writeByTable(*field.nested, field.objectIn(owner));
    case Kind::optionalObject: {
        const void* object = field.objectIn(owner);
        return object ? writeByTable(*field.nested, object) : ordered_json(nullptr);
    }
    case Kind::objectList: return listJson(field, owner);
    case Kind::countOrWord: return countOrWordJson(field, owner);
    case Kind::compliance: return complianceJson(field.as<GivenCompliance>(owner));
    case Kind::levels: return levelsJson(field.as<Levels>(owner));
    case Kind::numberRows: return jsonOrNull(field.as<NumberRows>(owner));
    case Kind::samples: return field.as<Samples>(owner).values();
    case Kind::jsonText: // through json: in the order of the keys, as it is read again
        return nlohmann::json::parse(field.as<JsonText>(owner).text);
    }
    return nullptr;
}

/// Whether a member that older files lack has its default.
bool isDefault(const Field& field, const void* owner, const ordered_json& value,
               const StructInfo& table) {
    const bool holdsSparse = field.kind == Kind::object || field.kind == Kind::objectList;
    return holdsSparse ? value.empty() : field.same(owner, table.defaults);
}

} // namespace

ordered_json writeByTable(const StructInfo& table, const void* owner,
                          const std::vector<std::string>& skip) {
    ordered_json object = ordered_json::object();
    for (const Field& field : table.fields) {
        if (std::find(skip.begin(), skip.end(), field.key) != skip.end()) {
            continue;
        }
        ordered_json value = fieldJson(field, owner);
        // The table's defaults are written in full, for the reference page and the schema.
        if (field.sparse && owner != table.defaults && isDefault(field, owner, value, table)) {
            continue;
        }
        if (!value.is_null() || !fieldJson(field, table.defaults).is_null()) {
            object[field.key] = std::move(value);
        }
    }
    return object;
}

namespace {

using nlohmann::json;

class Reader {
public:
    Reader(Issues& issues, std::vector<MissingKey>& missing)
        : m_issues(issues), m_missing(missing) {}

    void readObject(const json& object, const StructInfo& table, void* owner,
                    const std::string& path, const std::vector<std::string>& skip) {
        if (!object.is_object()) {
            refuse(path, object, Phrase::object);
            return;
        }
        for (const auto& [key, value] : object.items()) {
            if (!table.find(key) && std::find(skip.begin(), skip.end(), key) == skip.end()) {
                report(IssueCode::unknownKey, path + "/" + pathStep(key), json(key),
                       allKeys(table));
            }
        }
        for (const Field& field : table.fields) {
            const std::string fieldPath = path + "/" + field.key;
            const auto found = object.find(field.key);
            if (found != object.end()) {
                readField(*found, field, owner, fieldPath);
                continue;
            }
            m_missing.push_back({&field, owner, fieldPath});
            if (field.kind == Kind::object) { // its required members are missing, too
                readObject(json::object(), *field.nested, field.object(owner, true), fieldPath, {});
            }
        }
    }

private:
    /// A fault beyond the limit of the list is not composed.
    bool full() const { return m_issues.size() >= limits::issues; }

    void report(IssueCode code, const std::string& path, const json& value, Detail limit) {
        if (!full()) {
            m_issues.push_back({code, Severity::error, path, quoted(value), std::move(limit)});
        }
    }

    void refuse(const std::string& path, const json& value, Phrase expected) {
        report(IssueCode::wrongType, path, value, expected);
    }

    static Keys allKeys(const StructInfo& table) {
        Keys all;
        for (const Field& field : table.fields) {
            all.keys.emplace_back(field.key);
        }
        return all;
    }

    std::optional<double> number(const json& value, const std::string& path) {
        if (!value.is_number()) {
            refuse(path, value, Phrase::number);
            return std::nullopt;
        }
        return value.get<double>() + 0.0; // −0 becomes 0
    }

    std::optional<int> wholeNumber(const json& value, const Field& field, const std::string& path) {
        const double number = value.is_number() ? value.get<double>() : 0.5;
        if (number != std::floor(number)) {
            refuse(path, value, Phrase::wholeNumber);
            return std::nullopt;
        }
        if (std::abs(number) > std::numeric_limits<int>::max()) {
            report(IssueCode::outOfRange, path, value, Bounds{field.hard, field.unit});
            return std::nullopt;
        }
        return static_cast<int>(number);
    }

    std::optional<std::vector<double>> numbers(const json& value, const std::string& path) {
        if (!value.is_array()) {
            refuse(path, value, Phrase::listOfNumbers);
            return std::nullopt;
        }
        std::vector<double> list;
        if (isTooLong(value, limits::listNumbers, path)) {
            return std::nullopt;
        }
        for (const json& item : value) {
            const auto entry = number(item, path + "/" + std::to_string(list.size()));
            list.push_back(entry.value_or(0));
        }
        return list;
    }

    void readChoice(const json& value, const Field& field, void* owner, const std::string& path) {
        if (!value.is_string()) {
            refuse(path, value, Phrase::text);
            return;
        }
        if (const auto choice = choiceOf(value, field)) {
            field.setChoice(owner, *choice);
        } else {
            report(IssueCode::notOneOf, path, value, allowedIn(field));
        }
    }

    /// The choice that a text names.
    static std::optional<int> choiceOf(const json& value, const Field& field) {
        for (std::size_t i = 0; value.is_string() && i < field.choices.size(); ++i) {
            if (value.get_ref<const std::string&>() == field.choices[i].key) {
                return static_cast<int>(i);
            }
        }
        return std::nullopt;
    }

    bool isTooLong(const json& list, double mostItems, const std::string& path) {
        const bool isLong = static_cast<double>(list.size()) > mostItems;
        if (isLong) {
            report(IssueCode::wrongCount, path, list.size(), Bounds{{.high = mostItems}});
        }
        return isLong;
    }

    void readList(const json& value, const Field& field, void* owner, const std::string& path) {
        if (!value.is_array()) {
            refuse(path, value, Phrase::listOfObjects);
            return;
        }
        constexpr double usualItems = limits::listItems;
        const double mostItems =
            std::isfinite(field.hard.high) ? std::max(field.hard.high, usualItems) : usualItems;
        if (isTooLong(value, mostItems, path)) {
            return;
        }
        field.resize(owner, value.size());
        for (std::size_t i = 0; i < value.size(); ++i) {
            readObject(value[i], *field.nested, field.at(owner, i), path + "/" + std::to_string(i),
                       {});
        }
    }

    void readCountOrWord(const json& value, const Field& field, void* owner,
                         const std::string& path) {
        if (value.is_number()) {
            if (const auto count = wholeNumber(value, field, path)) {
                field.setNumber(owner, *count);
            }
        } else if (const auto word = choiceOf(value, field); word || value.is_null()) {
            field.setChoice(owner, word.value_or(-1));
        } else {
            refuse(path, value, field.expected());
        }
    }

    void readCompliance(const json& value, const Field& field, void* owner,
                        const std::string& path) {
        auto& compliance = field.as<GivenCompliance>(owner);
        if (value.is_null()) {
            compliance = std::monostate{};
        } else if (value.is_array()) {
            compliance = numbers(value, path).value_or(std::vector<double>{});
        } else if (value.is_object()) {
            compliance = readZones(value, path);
        } else {
            refuse(path, value, Phrase::zonesOrListOrNull);
        }
    }

    ZoneCompliance readZones(const json& value, const std::string& path) {
        ZoneCompliance zones;
        const std::pair<const char*, double*> members[] = {
            {"rz1", &zones.rz1}, {"nz", &zones.nz}, {"rz2", &zones.rz2}};
        for (const auto& [key, target] : members) {
            if (value.contains(key)) {
                *target = number(value.at(key), path + "/" + key).value_or(0);
            } else {
                m_issues.push_back({IssueCode::missingKey,
                                    Severity::error,
                                    path + "/" + key,
                                    {},
                                    Phrase::numberOfZone});
            }
        }
        for (const auto& [key, item] : value.items()) {
            if (key != "rz1" && key != "nz" && key != "rz2") {
                report(IssueCode::unknownKey, path + "/" + pathStep(key), json(key),
                       Keys{{"rz1", "nz", "rz2"}});
            }
        }
        return zones;
    }

    void readLevels(const json& value, const Field& field, void* owner, const std::string& path) {
        auto& levels = field.as<Levels>(owner);
        if (value.is_null()) {
            levels = std::monostate{};
        } else if (value.is_array()) {
            if (!isTooLong(value, limits::levels, path)) {
                levels = numbers(value, path).value_or(std::vector<double>{});
            }
        } else if (value.is_object() && value.size() == 3 && value.contains("from")
                   && value.contains("to") && value.contains("step")) {
            levels = SteppedLevels{number(value.at("from"), path + "/from").value_or(0),
                                   number(value.at("to"), path + "/to").value_or(0),
                                   number(value.at("step"), path + "/step").value_or(0)};
        } else {
            refuse(path, value, Phrase::listOrSteps);
        }
    }

    void readRows(const json& value, const Field& field, void* owner, const std::string& path) {
        auto& rows = field.as<NumberRows>(owner);
        rows.reset();
        if (value.is_null()) {
            return;
        }
        if (!value.is_array()) {
            refuse(path, value, Phrase::rowsOrNull);
            return;
        }
        if (isTooLong(value, limits::listItems, path)) {
            return;
        }
        rows.emplace();
        for (const json& row : value) {
            const std::string rowPath = path + "/" + std::to_string(rows->size());
            rows->push_back(numbers(row, rowPath).value_or(std::vector<double>{}));
        }
    }

    /// For kinds that may be null: clears the member and returns true.
    static bool clearIfNull(const json& value, const Field& field, void* owner) {
        if (!value.is_null()) {
            return false;
        }
        switch (field.kind) {
        case Kind::optionalNumber: field.as<std::optional<double>>(owner).reset(); return true;
        case Kind::optionalInteger: field.as<std::optional<int>>(owner).reset(); return true;
        case Kind::optionalNumberList:
            field.as<std::optional<std::vector<double>>>(owner).reset();
            return true;
        case Kind::optionalObject: field.reset(owner); return true;
        default: return false;
        }
    }

    void readField(const json& value, const Field& field, void* owner, const std::string& path) {
        if (clearIfNull(value, field, owner)) {
            return;
        }
        switch (field.kind) {
        case Kind::number:
            field.as<double>(owner) = number(value, path).value_or(field.as<double>(owner));
            break;
        case Kind::optionalNumber:
            field.as<std::optional<double>>(owner) = number(value, path);
            break;
        case Kind::integer:
            field.as<int>(owner) = wholeNumber(value, field, path).value_or(field.as<int>(owner));
            break;
        case Kind::optionalInteger:
            field.as<std::optional<int>>(owner) = wholeNumber(value, field, path);
            break;
        case Kind::boolean:
            value.is_boolean() ? void(field.as<bool>(owner) = value.get<bool>())
                               : refuse(path, value, Phrase::trueOrFalse);
            break;
        case Kind::text:
            value.is_string() ? void(field.as<std::string>(owner) = value.get<std::string>())
                              : refuse(path, value, Phrase::text);
            break;
        case Kind::choice: readChoice(value, field, owner, path); break;
        case Kind::numberList:
            field.as<std::vector<double>>(owner) =
                numbers(value, path).value_or(std::vector<double>{});
            break;
        case Kind::optionalNumberList:
            field.as<std::optional<std::vector<double>>>(owner) = numbers(value, path);
            break;
        case Kind::object:
        case Kind::optionalObject:
            readObject(value, *field.nested, field.object(owner, true), path, {});
            break;
        case Kind::objectList: readList(value, field, owner, path); break;
        case Kind::countOrWord: readCountOrWord(value, field, owner, path); break;
        case Kind::compliance: readCompliance(value, field, owner, path); break;
        case Kind::levels: readLevels(value, field, owner, path); break;
        case Kind::numberRows: readRows(value, field, owner, path); break;
        case Kind::samples:
            field.as<Samples>(owner) =
                Samples(numbers(value, path).value_or(std::vector<double>{}));
            break;
        case Kind::jsonText:
            value.is_object() ? void(field.as<JsonText>(owner).text = value.dump())
                              : refuse(path, value, Phrase::object);
            break;
        }
    }

    Issues& m_issues;
    std::vector<MissingKey>& m_missing;
};

} // namespace

void readByTable(const json& object, const StructInfo& table, void* owner, const std::string& path,
                 Issues& issues, std::vector<MissingKey>& missing,
                 const std::vector<std::string>& skip) {
    Reader(issues, missing).readObject(object, table, owner, path, skip);
}

void addIssue(Issues& issues, Issue issue) {
    if (issues.size() < limits::issues) {
        issues.push_back(std::move(issue));
    }
}

void readStruct(const json& object, const StructInfo& table, void* owner, const std::string& path,
                Issues& issues, const std::vector<std::string>& skip) {
    const std::size_t before = issues.size();
    std::vector<MissingKey> missing;
    readByTable(object, table, owner, path, issues, missing, skip);
    const Project none;
    for (const MissingKey& key : missing) {
        const Field& field = *key.field;
        if (field.kind != Kind::object && field.required && field.required(none, key.owner)) {
            addIssue(issues,
                     {IssueCode::missingKey, Severity::error, key.path, {}, allowedIn(field)});
        }
    }
    // A value that could not be read is reported already; the default left in its place is not
    // judged.
    const auto isReported = [&](const Issue& issue) {
        return std::any_of(issues.begin() + static_cast<std::ptrdiff_t>(before), issues.end(),
                           [&](const Issue& other) { return other.path == issue.path; });
    };
    for (Issue& issue : checkRanges(table, owner, path)) {
        if (!isReported(issue)) {
            addIssue(issues, std::move(issue));
        }
    }
}

Issues checkFileHeader(const json& root, const char* format, int newest) {
    if (!root.is_object()) {
        return {{IssueCode::wrongType, Severity::error, {}, quoted(root), Phrase::object}};
    }
    Issues issues;
    const auto add = [&](IssueCode code, const char* path, Detail value, Detail limit) {
        issues.push_back({code, Severity::error, path, std::move(value), std::move(limit)});
    };
    const Keys formats{{format}, Keys::Kind::choices};
    if (const auto found = root.find("format"); found == root.end()) {
        add(IssueCode::missingKey, "/format", {}, formats);
    } else if (*found != format) {
        add(IssueCode::notOneOf, "/format", quoted(*found), formats);
    }
    const Bounds versions{{1, static_cast<double>(newest)}};
    const auto given = root.find("version");
    if (given == root.end()) {
        add(IssueCode::missingKey, "/version", {}, versions);
    } else if (!given->is_number_integer()) {
        add(IssueCode::wrongType, "/version", quoted(*given), Phrase::wholeNumber);
    } else if (given->get<double>() > newest) {
        add(IssueCode::newerVersion, "/version", quoted(*given), versions);
    } else if (given->get<double>() < 1) {
        add(IssueCode::outOfRange, "/version", quoted(*given), versions);
    }
    return issues;
}

} // namespace sparkout
