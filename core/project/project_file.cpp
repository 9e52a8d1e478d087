// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_file.h"

#include "core/project/strict_json.h"
#include "core/project/table_reader.h"
#include "core/project/validate.h"

#include <algorithm>

namespace sparkout {

namespace {

using nlohmann::json;

constexpr const char* formatName = "sparkout-project";

/// The header decides whether the rest is worth reading.
bool headerIsOurs(const json& root, Issues& issues) {
    if (!root.is_object()) {
        issues.push_back({IssueCode::wrongType, Severity::error, {}, quoted(root), "object"});
        return false;
    }
    const std::string expected = '"' + std::string(formatName) + '"';
    const std::string versions = "1…" + std::to_string(projectVersion);
    if (!root.contains("format")) {
        issues.push_back({IssueCode::missingKey, Severity::error, "/format", {}, expected});
    } else if (root.at("format") != formatName) {
        issues.push_back({IssueCode::wrongFormat, Severity::error, "/format",
                          quoted(root.at("format")), expected});
    }
    if (!root.contains("version")) {
        issues.push_back({IssueCode::missingKey, Severity::error, "/version", {}, versions});
    } else if (const json& version = root.at("version"); !version.is_number_integer()) {
        issues.push_back(
            {IssueCode::wrongType, Severity::error, "/version", quoted(version), "whole number"});
    } else if (version > projectVersion) {
        issues.push_back(
            {IssueCode::newerVersion, Severity::error, "/version", quoted(version), versions});
    } else if (version < 1) {
        issues.push_back(
            {IssueCode::outOfRange, Severity::error, "/version", quoted(version), versions});
    }
    return !hasErrors(issues);
}

void reportMissing(const std::vector<MissingKey>& missing, const Project& project,
                   Issues& issues) {
    for (const MissingKey& key : missing) {
        const Field& field = *key.field;
        if (field.kind != Kind::object && field.required
            && field.required(project, key.owner)) {
            issues.push_back({IssueCode::missingKey, Severity::error, key.path, {},
                              allowedText(field)});
        }
    }
}

/// What a kept run was run with is a project of its own.
void checkRuns(const Project& project, Issues& issues) {
    for (std::size_t i = 0; i < project.runs.size(); ++i) {
        for (Issue& issue : readProject(project.runs[i].inputs.text).issues) {
            if (issue.severity == Severity::error) {
                issue.path = "/runs/" + std::to_string(i) + "/inputs" + issue.path;
                issues.push_back(std::move(issue));
            }
        }
    }
}

} // namespace

ReadResult readProject(std::string_view text) {
    ReadResult result;
    const auto root = parseStrictly(text, result.issues);
    if (!root || !headerIsOurs(*root, result.issues)) {
        return result;
    }
    Project project;
    std::vector<MissingKey> missing;
    readByTable(*root, tableOf<Project>(), &project, {}, result.issues, missing,
                {"format", "version"});
    reportMissing(missing, project, result.issues);
    checkRuns(project, result.issues);
    // A value that could not be read is reported already; its rest of a default is not judged.
    for (Issue& issue : validate(project)) {
        const bool known = std::any_of(result.issues.begin(), result.issues.end(),
                                       [&](const Issue& other) { return other.path == issue.path; });
        if (!known) {
            result.issues.push_back(std::move(issue));
        }
    }
    if (!hasErrors(result.issues)) {
        result.project = std::move(project);
    }
    if (result.issues.size() > limits::issues) {
        result.issues.resize(limits::issues);
    }
    return result;
}

std::string writeProject(const Project& project) {
    nlohmann::ordered_json root = {{"format", formatName}, {"version", projectVersion}};
    root.update(writeByTable(tableOf<Project>(), &project));
    return printJson(root);
}

bool sameProject(const Project& a, const Project& b) {
    return writeProject(a) == writeProject(b);
}

} // namespace sparkout
