// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/struct_reader.h"

#include "core/format/strict_json.h"
#include "core/format/table_reader.h"
#include "core/project/project.h"
#include "core/project/range_check.h"
#include "core/project/validate.h"

#include <algorithm>
#include <utility>

namespace sparkout {

using nlohmann::json;

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
    const auto version = root.find("version");
    if (version == root.end()) {
        add(IssueCode::missingKey, "/version", {}, versions);
    } else if (!version->is_number_integer()) {
        add(IssueCode::wrongType, "/version", quoted(*version), Phrase::wholeNumber);
    } else if (version->get<double>() > newest) {
        add(IssueCode::newerVersion, "/version", quoted(*version), versions);
    } else if (version->get<double>() < 1) {
        add(IssueCode::outOfRange, "/version", quoted(*version), versions);
    }
    return issues;
}

} // namespace sparkout
