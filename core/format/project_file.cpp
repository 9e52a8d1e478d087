// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/project_file.h"

#include "core/format/project_json.h"
#include "core/format/strict_json.h"
#include "core/format/table_writer.h"

#include <string>
#include <vector>

namespace sparkout {

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
    // Kept runs may be megabytes, and an edit hardly ever touches them. Their texts may differ
    // and still be the same values.
    if (a.runs != b.runs) {
        return writeProject(a) == writeProject(b);
    }
    std::vector<std::string> same{"runs"};
    if (a.measured.isSharedWith(b.measured)) {
        same.emplace_back("measured");
    }
    const auto rest = [&same](const Project& project) {
        return printJson(writeByTable(tableOf<Project>(), &project, same));
    };
    return rest(a) == rest(b);
}

} // namespace sparkout
