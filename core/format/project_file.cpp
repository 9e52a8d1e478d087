// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/project_file.h"

#include "core/format/difference.h"
#include "core/format/project_json.h"
#include "core/format/strict_json.h"

#include <string>

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
    const std::string path = firstDifference(a, b);
    // The texts of kept runs may differ with equal values.
    return path.empty() || (path.starts_with("/runs") && writeProject(a) == writeProject(b));
}

} // namespace sparkout
