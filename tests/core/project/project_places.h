// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/project_file.h"
#include "core/file/struct_json.h"
#include "core/project/validate.h"
#include "tests/core/support/project_mutator.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/rapidcheck_runs.h"

#include <QTest>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

/// Every place of a project file, and values for it.
namespace sparkout::project_places {

using nlohmann::json;
using samples::fromSeed;
using samples::holds;
using samples::Mutator;

/// Which rows have been seen away from their defaults, and in which forms.
class Coverage {
public:
    void add(Project& project) {
        m_written.clear();
        for (const samples::Spot& spot : samples::spots(project)) {
            const json value = valueOf(*spot.table, spot.owner, *spot.field);
            if (value != valueOf(*spot.table, spot.table->defaults, *spot.field)) {
                m_seen.insert(spot.place);
            }
            if (spot.field->kind == Kind::compliance || spot.field->kind == Kind::levels
                || spot.field->kind == Kind::countOrWord) {
                m_seen.insert(spot.place + " " + value.type_name());
            }
        }
    }

    std::string missing() const {
        std::string text;
        for (const samples::Place& place : samples::places()) {
            for (const char* form : formsOf(*place.field)) {
                const std::string name = place.path + form;
                text += m_seen.count(name) ? "" : name + '\n';
            }
        }
        return text;
    }

    /// How many rows and forms there are to be seen.
    static std::size_t leaves() {
        std::size_t count = 0;
        for (const samples::Place& place : samples::places()) {
            count += formsOf(*place.field).size();
        }
        return count;
    }

private:
    static std::vector<const char*> formsOf(const Field& field) {
        switch (field.kind) {
        case Kind::object: return {}; // its members count
        case Kind::compliance:
        case Kind::levels: return {"", " null", " array", " object"};
        case Kind::countOrWord: return {"", " null", " number", " string"};
        default: return {""};
        }
    }

    json valueOf(const StructInfo& table, const void* owner, const Field& field) {
        auto& object = m_written[{&table, owner}];
        if (object.is_null()) {
            object = writeByTable(table, owner);
        }
        const auto found = object.find(field.key);
        return found == object.end() ? json(nullptr) : json(*found);
    }

    std::set<std::string> m_seen;
    std::map<std::pair<const StructInfo*, const void*>, nlohmann::ordered_json> m_written;
};

/// The text a written project reads back to, checked; empty when all is well.
inline std::string roundTripFault(const Project& project) {
    const std::string text = writeProject(project);
    const ReadResult read = readProject(text);
    if (!read.project) {
        return "refused: " + samples::listed(read.issues) + text;
    }
    if (!sameProject(project, *read.project)) {
        return "another project: " + text;
    }
    return writeProject(*read.project) == text ? "" : "other bytes: " + text;
}

/// Eight values of wrong type for a kind.
inline std::vector<json> wrongValues(Kind kind) {
    const json object = {{"x", 1}};
    switch (kind) {
    case Kind::number:
        return {nullptr, true, "", "7", "text", json::array(), json::object(), object};
    case Kind::optionalNumber:
        return {true, false, "", "7", json::array(), json{7}, json::object(), object};
    case Kind::integer: return {nullptr, true, 1.5, "7", "", json::array(), json{7}, object};
    case Kind::optionalInteger: return {true, 1.5, "7", "", json::array(), json{7}, false, object};
    case Kind::boolean: return {nullptr, 0, 1, "true", "", json::array(), json{true}, object};
    case Kind::text:
    case Kind::choice:
        return {nullptr, true, 0, 1.5, json::array(), json{"a"}, json::object(), object};
    case Kind::numberList:
    case Kind::samples:
        return {nullptr, true, 1, "1", json{"1"}, json{nullptr}, json::array({json::array({1})}),
                object};
    case Kind::optionalNumberList:
    case Kind::numberRows:
        return {false, true, 1, "1", json{"1"}, json{nullptr}, json::array({json::array({"1"})}),
                object};
    case Kind::object:
        return {nullptr, true, 0, 1.5, "", json::array(), json::array({json::object()}), object};
    case Kind::optionalObject:
        return {false, true, 0, 1.5, "", json::array(), json::array({json::object()}), object};
    case Kind::objectList:
        return {nullptr, true, 0, "", json{1}, json{nullptr}, json::array({json::array()}), object};
    case Kind::countOrWord: return {true, false, 1.5, "5", "none", json::array(), json{5}, object};
    case Kind::compliance:
        return {true, 1e-4, "1e-4", json{"1"}, json{nullptr}, json{true}, json::object(), object};
    case Kind::levels:
        return {true,
                1,
                "1",
                json{"1"},
                json{nullptr},
                json::array({json::array({1})}),
                json::object(),
                json{{"from", 0.1}, {"to", "x"}, {"step", 1}}};
    case Kind::jsonText: return {nullptr, true, 0, 1.5, "{}", json::array(), json{1}, ""};
    }
    return {};
}

/// Paths of the numbers a row may hold, relative to it, with what to put around each.
inline std::vector<std::pair<std::string, std::function<json(double)>>>
numbersOf(const Field& field) {
    const auto list = [count = field.count](double x) {
        return json(std::vector<double>(count ? count : 4, x));
    };
    switch (field.kind) {
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger:
    case Kind::countOrWord: return {{"", [](double x) { return json(x); }}};
    case Kind::numberList:
    case Kind::samples:
    case Kind::optionalNumberList: return {{"/0", list}};
    case Kind::compliance:
        return {{"/0", list}, {"/nz", [](double x) {
                                   return json{{"rz1", 1e-5}, {"nz", x}, {"rz2", 1e-5}};
                               }}};
    case Kind::levels:
        return {{"/0", list}, {"/step", [](double x) {
                                   return json{{"from", 0.5}, {"to", 0.5}, {"step", x}};
                               }}};
    case Kind::numberRows: return {{"/0/0", [=](double x) { return json::array({list(x)}); }}};
    default: return {};
    }
}

inline void sampleRows() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : samples::names()) {
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
}

inline void placeRows() {
    QTest::addColumn<int>("index");
    const auto step = std::size_t(samples::sized(1, 3, 1));
    for (std::size_t i = 0; i < samples::places().size(); i += step) {
        QTest::newRow(samples::places()[i].path.c_str()) << static_cast<int>(i);
    }
}

/// The row in the sample "everything": the first item of each list.
inline std::string pathInEverything(const samples::Place& place) {
    std::string path = place.path;
    for (std::size_t star; (star = path.find('*')) != std::string::npos;) {
        path[star] = '0';
    }
    return path;
}

} // namespace sparkout::project_places
