// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/project_file.h"

#include "core/file/project_json.h"
#include "core/file/strict_json.h"

#include <string>

namespace sparkout {

namespace {

std::string difference(const StructInfo& table, const void* a, const void* b,
                       const std::string& path, InputFilter counts);

std::string difference(const Field& field, const void* a, const void* b, const std::string& path,
                       InputFilter counts) {
    if (!field.nested) {
        return field.same(a, b) ? std::string() : path;
    }
    if (field.kind != Kind::objectList) {
        const void* const ofA = field.objectIn(a);
        const void* const ofB = field.objectIn(b);
        if (ofA == ofB) {
            return {}; // shared, or not given in either
        }
        const bool both = ofA && ofB;
        return both ? difference(*field.nested, ofA, ofB, path, counts) : path;
    }
    if (field.size(a) != field.size(b)) {
        return path;
    }
    for (std::size_t i = 0; i < field.size(a); ++i) {
        const std::string item = path + "/" + std::to_string(i);
        if (std::string found =
                difference(*field.nested, field.itemIn(a, i), field.itemIn(b, i), item, counts);
            !found.empty()) {
            return found;
        }
    }
    return {};
}

std::string difference(const StructInfo& table, const void* a, const void* b,
                       const std::string& path, InputFilter counts) {
    for (const Field& field : table.fields) {
        const std::string at = path + "/" + field.key;
        if (counts && !counts(at)) {
            continue;
        }
        if (std::string found = difference(field, a, b, at, counts); !found.empty()) {
            return found;
        }
    }
    return {};
}

} // namespace

ReadResult readProject(std::string_view text) {
    return readProject(text, {});
}

ReadResult readProject(std::string_view text, const std::stop_token& stop) {
    Issues issues;
    const auto root = parseStrictly(text, issues, stop);
    if (stop.stop_requested()) {
        return {};
    }
    if (root) {
        const Issues header = checkHeader(*root, projectVersion);
        if (header.empty()) {
            return readProjectJson(*root, std::move(issues), stop);
        }
        issues.insert(issues.end(), header.begin(), header.end());
    }
    ReadResult refused;
    refused.issues = std::move(issues);
    return refused;
}

std::string writeProject(const Project& project) {
    nlohmann::ordered_json root = {{"format", projectFormat}, {"version", projectVersion}};
    root.update(projectJson(project));
    return printJson(root);
}

bool sameProject(const Project& a, const Project& b) {
    const std::string path = firstDifference(a, b);
    // The texts of kept runs may differ with equal values.
    return path.empty() || (path.starts_with("/runs") && writeProject(a) == writeProject(b));
}

std::string firstDifference(const Project& a, const Project& b, InputFilter counts) {
    return difference(tableOf<Project>(), &a, &b, {}, counts);
}

} // namespace sparkout
