// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/project_json.h"

#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/project/conditions.h"
#include "core/project/range_check.h"
#include "core/project/validate.h"

#include <algorithm>

namespace sparkout {

using nlohmann::json;

namespace {

/// Keys that may be null in memory are also missing from unfinished work; the others cannot be.
bool mayBeNull(const Field& field) {
    return field.kind == Kind::optionalNumber || field.kind == Kind::optionalInteger
           || field.kind == Kind::optionalNumberList || field.kind == Kind::optionalObject;
}

/// `conditional`: whether conditionally required keys are reported, too.
void reportMissing(const std::vector<MissingKey>& missing, const Project& project, bool conditional,
                   bool nullable, Issues& issues) {
    for (const MissingKey& key : missing) {
        const Field& field = *key.field;
        if (field.kind == Kind::object || !field.required || mayBeNull(field) != nullable
            || !(conditional || field.required == conditions::always)) {
            continue;
        }
        if (field.required(project, key.owner) && issues.size() < limits::issues) {
            issues.push_back(
                {IssueCode::missingKey, Severity::error, key.path, {}, allowedIn(field)});
        }
    }
}

/// The inputs of a kept run are a project of its own.
void checkRuns(const Project& project, Issues& issues, const std::stop_token& stop) {
    for (std::size_t i = 0; i < project.runs.size() && !stop.stop_requested(); ++i) {
        for (Issue& issue : readProject(project.runs[i].inputs.text, stop).issues) {
            if (issue.severity == Severity::error && issues.size() < limits::issues) {
                issue.path = "/runs/" + std::to_string(i) + "/inputs" + issue.path;
                issues.push_back(std::move(issue));
            }
        }
    }
}

bool isReported(const Issues& issues, const std::string& path) {
    return std::any_of(issues.begin(), issues.end(),
                       [&](const Issue& issue) { return issue.path == path; });
}

} // namespace

Issues checkHeader(const json& root, int newest) {
    if (!root.is_object()) {
        return {{IssueCode::wrongType, Severity::error, {}, quoted(root), Phrase::object}};
    }
    Issues issues;
    const auto add = [&](IssueCode code, const char* path, Detail value, Detail limit) {
        issues.push_back({code, Severity::error, path, std::move(value), std::move(limit)});
    };
    const Detail expected = quoted(projectFormat);
    if (!root.contains("format")) {
        add(IssueCode::missingKey, "/format", {}, expected);
    } else if (root.at("format") != projectFormat) {
        add(IssueCode::wrongFormat, "/format", quoted(root.at("format")), expected);
    }
    const Bounds versions{{1, static_cast<double>(newest)}};
    if (!root.contains("version")) {
        add(IssueCode::missingKey, "/version", {}, versions);
    } else if (const json& given = root.at("version"); !given.is_number_integer()) {
        add(IssueCode::wrongType, "/version", quoted(given), Phrase::wholeNumber);
    } else if (given.get<double>() > newest) {
        add(given == newestVersion ? IssueCode::severalSurfaces : IssueCode::newerVersion,
            "/version", quoted(given), versions);
    } else if (given.get<double>() < 1) {
        add(IssueCode::outOfRange, "/version", quoted(given), versions);
    }
    return issues;
}

ReadResult readProjectJson(const json& root, Issues found, const std::stop_token& stop) {
    ReadResult result;
    Issues& issues = result.issues;
    issues = std::move(found);
    Project project;
    std::vector<MissingKey> missing;
    readByTable(root, tableOf<Project>(), &project, {}, issues, missing, {"format", "version"});
    // Without a readable operation the applicable rules are unknown.
    const bool operationKnown = root.contains("operation") && !isReported(issues, "/operation");
    reportMissing(missing, project, operationKnown, false, issues);
    const bool readable = !hasErrors(issues);
    // A kept run is a record. Its faults, possibly found by another version, do not prevent loading
    // it or the project.
    checkRuns(project, issues, stop);
    if (stop.stop_requested()) {
        return {};
    }
    reportMissing(missing, project, operationKnown, true, issues);
    // A value that could not be read is reported already; the default left in its place is not
    // judged.
    const Issues unread = issues;
    for (Issue& issue : operationKnown ? validate(project) : checkRanges(project)) {
        if (!isReported(unread, issue.path)) {
            issues.push_back(std::move(issue));
        }
    }
    if (!hasErrors(issues)) {
        result.project = std::move(project);
    } else if (readable && operationKnown && !hasErrors(checkRanges(project))) {
        result.unfinished = std::move(project);
    }
    if (issues.size() > limits::issues) { // errors before warnings
        std::stable_sort(issues.begin(), issues.end(),
                         [](const Issue& a, const Issue& b) { return a.severity < b.severity; });
        issues.resize(limits::issues);
    }
    return result;
}

nlohmann::ordered_json projectJson(const Project& project) {
    return writeByTable(tableOf<Project>(), &project);
}

} // namespace sparkout
