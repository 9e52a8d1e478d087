// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/project_file.h"

#include "core/format/strict_json.h"
#include "core/format/table_reader.h"
#include "core/format/table_writer.h"
#include "core/project/conditions.h"
#include "core/project/range_check.h"
#include "core/project/validate.h"

#include <algorithm>

namespace sparkout {

namespace {

using nlohmann::json;

constexpr const char* projectFormat = "sparkout-project";

/// The header decides whether the rest is worth reading.
Issues checkHeader(const json& root) {
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
    const Bounds versions{{1, projectVersion}};
    if (!root.contains("version")) {
        add(IssueCode::missingKey, "/version", {}, versions);
    } else if (const json& version = root.at("version"); !version.is_number_integer()) {
        add(IssueCode::wrongType, "/version", quoted(version), Phrase::wholeNumber);
    } else if (version.get<double>() > projectVersion) {
        add(IssueCode::newerVersion, "/version", quoted(version), versions);
    } else if (version.get<double>() < 1) {
        add(IssueCode::outOfRange, "/version", quoted(version), versions);
    }
    return issues;
}

/// `conditional`: whether keys that are required only sometimes are reported too.
/// Keys that may be null in memory are missing from unfinished work too; the others cannot be.
bool mayBeNull(const Field& field) {
    return field.kind == Kind::optionalNumber || field.kind == Kind::optionalInteger
           || field.kind == Kind::optionalNumberList || field.kind == Kind::optionalObject;
}

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

/// What a kept run was run with is a project of its own.
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

ReadResult readProject(std::string_view text) {
    return readProject(text, {});
}

ReadResult readProject(std::string_view text, const std::stop_token& stop) {
    ReadResult result;
    Issues& issues = result.issues;
    const auto root = parseStrictly(text, issues, stop);
    if (stop.stop_requested()) {
        return {};
    }
    if (!root) {
        return result;
    }
    if (Issues header = checkHeader(*root); !header.empty()) {
        issues.insert(issues.end(), header.begin(), header.end());
        return result;
    }
    Project project;
    std::vector<MissingKey> missing;
    readByTable(*root, tableOf<Project>(), &project, {}, issues, missing, {"format", "version"});
    // Without a readable operation nobody knows which rules apply.
    const bool operationKnown = root->contains("operation") && !isReported(issues, "/operation");
    reportMissing(missing, project, operationKnown, false, issues);
    const bool readable = !hasErrors(issues);
    // A kept run is a record. Faults in one, as an older or stricter version may see them, cost
    // neither the record nor the work around it.
    checkRuns(project, issues, stop);
    if (stop.stop_requested()) {
        return {};
    }
    reportMissing(missing, project, operationKnown, true, issues);
    // A value that could not be read is reported already; its rest of a default is not judged.
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

std::string writeProject(const Project& project) {
    nlohmann::ordered_json root = {{"format", projectFormat}, {"version", projectVersion}};
    root.update(writeByTable(tableOf<Project>(), &project));
    return printJson(root);
}

bool sameProject(const Project& a, const Project& b) {
    // Kept runs may be megabytes, and an edit hardly ever touches them. Their texts may differ
    // and still be the same values.
    if (a.runs != b.runs) {
        return writeProject(a) == writeProject(b);
    }
    const auto rest = [](const Project& project) {
        return printJson(writeByTable(tableOf<Project>(), &project, {"runs"}));
    };
    return rest(a) == rest(b);
}

} // namespace sparkout
