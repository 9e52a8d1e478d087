// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/setup_state.h"

#include "core/file/project_file.h"

#include <algorithm>
#include <utility>

namespace sparkout {

Project SurfaceState::withRuns() const {
    Project whole = project;
    whole.runs = *runs;
    return whole;
}

std::optional<std::size_t> SetupState::indexOf(int id) const {
    const auto found = std::ranges::find_if(
        surfaces, [id](const SurfaceStatePtr& surface) { return surface->id == id; });
    return found == surfaces.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - surfaces.begin()));
}

Setup SetupState::setup() const {
    Setup made;
    for (const SurfaceStatePtr& surface : surfaces) {
        made.surfaces.push_back({surface->name, surface->withRuns()});
    }
    made.times = times;
    made.wear = wear;
    return made;
}

SurfaceState surfaceState(int id, std::string name, Project project, const SurfaceState* before) {
    SurfaceState made;
    made.id = id;
    made.name = std::move(name);
    if (before && *before->runs == project.runs) {
        made.runs = before->runs;
    } else {
        made.runs = std::make_shared<const std::vector<KeptRun>>(std::move(project.runs));
    }
    project.runs.clear();
    made.project = std::move(project);
    return made;
}

bool sameState(const SetupState& a, const SetupState& b) {
    const auto isSame = [](const SurfaceStatePtr& one, const SurfaceStatePtr& other) {
        return one == other
               || (one->id == other->id && one->name == other->name && one->runs == other->runs
                   && std::ranges::is_permutation(one->open, other->open)
                   && sameProject(one->project, other->project));
    };
    return std::ranges::equal(a.surfaces, b.surfaces, isSame) && a.times == b.times
           && a.wear == b.wear;
}

} // namespace sparkout
