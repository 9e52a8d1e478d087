// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/project_file.h"
#include "core/issue.h"
#include "words/issue_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

/// Project files and walks over the tables that several tests share.
namespace sparkout::samples {

using nlohmann::json;

/// Sizes shrink under the sanitizers (SPARKOUT_QUICK) and grow with SPARKOUT_LONG.
inline int sized(int usual, int quick, int longer) {
    return std::getenv("SPARKOUT_QUICK") ? quick : std::getenv("SPARKOUT_LONG") ? longer : usual;
}

inline std::string readText(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// What stands between bars.
inline std::vector<std::string> listOf(const std::string& text) {
    std::vector<std::string> list;
    std::istringstream stream(text);
    for (std::string one; std::getline(stream, one, '|');) {
        list.push_back(one);
    }
    return list;
}

inline std::filesystem::path sourcePath(const std::string& path) {
    return std::filesystem::path(SPARKOUT_SOURCE_DIR) / path;
}

/// Names of tests/data/projects: valid projects; "everything" gives every key of the tables.
inline const std::vector<std::string>& names() {
    static const std::vector<std::string> all{
        "balance-grade-traverse", "complete",          "everything",         "internal-plunge",
        "smallest-plunge",        "smallest-traverse", "stiffness-traverse", "unbalanced-traverse"};
    return all;
}

inline std::string text(const std::string& name) {
    return readText(sourcePath("tests/data/projects/" + name + ".sparkout"));
}

/// Of a file of the sources.
inline Project projectIn(const std::string& path) {
    return readProject(readText(sourcePath(path))).project.value();
}

inline json sample(const std::string& name) {
    return json::parse(text(name));
}

inline Project project(const std::string& name) {
    return readProject(text(name)).project.value();
}

inline Issues faults(const json& file) {
    return readProject(file.dump()).issues;
}

inline const Issue* find(const Issues& issues, const std::string& path) {
    const auto found = std::find_if(issues.begin(), issues.end(),
                                    [&](const Issue& issue) { return issue.path == path; });
    return found == issues.end() ? nullptr : &*found;
}

/// The file with another value, as JSON, at a place; without a value the place is taken out.
inline json changedAt(json file, const std::string& pointer, const std::string& value) {
    const json::json_pointer at(pointer);
    if (value.empty()) {
        file.at(at.parent_pointer()).erase(at.back());
    } else {
        file[at] = json::parse(value);
    }
    return file;
}

inline bool holds(const Issues& issues, IssueCode code, const std::string& path) {
    return std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) {
        return issue.code == code && issue.path == path;
    });
}

inline std::string listed(const Issues& issues) {
    std::string lines;
    for (const Issue& issue : issues) {
        lines += issue.path + ": " + issueSentence(issue) + '\n';
    }
    return lines.empty() ? "no issues" : lines;
}

/// One row of the tables where it stands, list items as "*".
struct Place {
    const StructInfo* table;
    const Field* field;
    std::string path;
};

inline void collect(const StructInfo& table, const std::string& path, std::vector<Place>& places) {
    for (const Field& field : table.fields) {
        const std::string fieldPath = path + "/" + field.key;
        places.push_back({&table, &field, fieldPath});
        if (field.nested) {
            collect(*field.nested, fieldPath + (field.kind == Kind::objectList ? "/*" : ""),
                    places);
        }
    }
}

/// Every row of every table.
inline const std::vector<Place>& places() {
    static const std::vector<Place> all = [] {
        std::vector<Place> list;
        collect(tableOf<Project>(), {}, list);
        return list;
    }();
    return all;
}

/// A row in a project: the struct that holds it, its path with indices, and the path of places().
struct Spot {
    const StructInfo* table;
    const Field* field;
    void* owner;
    std::string path;
    std::string place;
};

inline void collect(const StructInfo& table, void* owner, const std::string& path,
                    const std::string& place, std::vector<Spot>& spots) {
    for (const Field& field : table.fields) {
        const std::string at = path + "/" + field.key;
        const std::string general = place + "/" + field.key;
        spots.push_back({&table, &field, owner, at, general});
        if (field.kind == Kind::objectList) {
            for (std::size_t i = 0; i < field.size(owner); ++i) {
                collect(*field.nested, field.at(owner, i), at + "/" + std::to_string(i),
                        general + "/*", spots);
            }
        } else if (field.nested) {
            if (void* object = field.object(owner, false)) {
                collect(*field.nested, object, at, general, spots);
            }
        }
    }
}

/// Every row of a project, as far as its objects and list items are given.
inline std::vector<Spot> spots(Project& project) {
    std::vector<Spot> list;
    collect(tableOf<Project>(), &project, {}, {}, list);
    return list;
}

} // namespace sparkout::samples
