// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/removed_volumes.h"

#include "core/format/project_file.h"

#include <algorithm>

namespace sparkout {

namespace {

Project withoutRuns(const Project& project) {
    Project bare = project;
    bare.runs.clear();
    return bare;
}

} // namespace

std::optional<double> RemovedVolumes::find(const Project& project) const {
    const Project bare = withoutRuns(project);
    const std::lock_guard lock(m_mutex);
    const auto found = std::ranges::find_if(
        m_known, [&bare](const auto& each) { return sameProject(each.first, bare); });
    return found == m_known.end() ? std::nullopt : std::optional(found->second);
}

void RemovedVolumes::add(const Project& project, double removed_mm3) {
    Project bare = withoutRuns(project);
    const std::lock_guard lock(m_mutex);
    if (m_known.size() >= most) {
        m_known.pop_front();
    }
    m_known.emplace_back(std::move(bare), removed_mm3);
}

} // namespace sparkout
