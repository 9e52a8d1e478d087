// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/worn_project.h"

#include "core/file/project_file.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace sparkout {

double nominalVolume_mm3(const Project& project) {
    const Part& part = *project.part;
    return std::numbers::pi * part.diameter_mm * part.stock_mm * part.length_mm
           * engagedShare(part);
}

Setup dressedSetup(Setup setup) {
    shareMeasuredRa(setup); // the factor of Ra is kept while the wheel dulls
    for (GroundSurface& each : setup.surfaces) {
        each.project.wheel->radius_wear_um = 0;
    }
    return setup;
}

SurfaceWear::SurfaceWear(Setup of, std::size_t at)
    : setup(dressedSetup(std::move(of))), surface(at) {
    for (GroundSurface& each : setup.surfaces) {
        each.project.batch.reset();
        each.project.optimisation.reset();
        each.project.sweep.reset();
        each.project.measured.reset();
        each.project.runs.clear();
    }
}

SurfaceWear::SurfaceWear(const Project& project) : SurfaceWear(plainSetup(project), 0) {}

bool sameWear(const SurfaceWear& a, const SurfaceWear& b) {
    if (!a.wear().isGiven() && !b.wear().isGiven()) {
        return true;
    }
    const std::size_t count = a.setup.surfaces.size();
    bool same = a.wear() == b.wear() && a.surface == b.surface && b.setup.surfaces.size() == count;
    for (std::size_t i = 0; same && i < count; ++i) {
        same =
            i == a.surface || sameProject(a.setup.surfaces[i].project, b.setup.surfaces[i].project);
    }
    return same;
}

WheelCourse::WheelCourse(const SurfaceWear& surface, const std::stop_token& stop)
    : m_surface(&surface) {
    grindOthers(0, surface.surface, stop);
    m_before = m_part;
}

WheelCourse WheelCourse::ofCycle(double removed_mm3, const std::stop_token& stop) const {
    WheelCourse course = *this;
    course.m_part += removedMetal(dressed(), removed_mm3);
    course.grindOthers(m_surface->surface + 1, m_surface->setup.surfaces.size(), stop);
    return course;
}

void WheelCourse::putWheel(Project& project, std::int64_t part) const {
    *project.wheel = *dressed().wheel;
    project.machine->wheel_speed_m_s = dressed().machine->wheel_speed_m_s;
    wearWheel(project, m_surface->wear(), before(part));
}

bool WheelCourse::isWornOut(std::int64_t part) const {
    return sparkout::isWornOut(*dressed().wheel, m_surface->wear(), before(part));
}

void WheelCourse::grindOthers(std::size_t from, std::size_t to, const std::stop_token& stop) {
    for (std::size_t i = from; i < to && !stop.stop_requested(); ++i) {
        Project worn = m_surface->setup.surfaces[i].project;
        wearWheel(worn, m_surface->wear(), m_part);
        const SimulationResult result = simulate(worn, nullptr, stop);
        const bool completed = result.status == RunStatus::completed;
        m_part +=
            removedMetal(worn, completed ? removedVolume_mm3(result) : nominalVolume_mm3(worn));
    }
}

namespace {

Project withoutRuns(const Project& project) {
    Project bare = project;
    bare.runs.clear();
    return bare;
}

Issues errorsOf(const Project& project) {
    Issues issues = validate(project);
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    return issues;
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

WornProject wornProject(const Setup& setup, std::size_t surface, const RemovedMetal& removed) {
    WornProject made{surface, setup.surfaces[surface].project, {}};
    const bool isWorn = removed.volume_mm3 > 0 && setup.wear.isGiven();
    if (isWorn || setup.surfaces.size() > 1) { // all surfaces share the factor of the measured Ra
        if (const std::optional<double> factor = factorOfMeasuredRa(setup)) {
            made.project.wheel->roughness_factor = *factor;
        }
    }
    if (isWorn) {
        wearWheel(made.project, setup.wear, removed);
        made.issues = errorsOf(made.project);
    }
    return made;
}

WornProject wornProject(const Setup& setup, std::size_t surface, const std::stop_token& stop,
                        RemovedVolumes* known) {
    RemovedMetal removed;
    for (std::size_t i = 0; i < surface && setup.wear.isGiven() && !stop.stop_requested(); ++i) {
        WornProject before = wornProject(setup, i, removed);
        if (removed.volume_mm3 <= 0) { // in an unfinished set-up
            before.issues = errorsOf(before.project);
        }
        if (!before.issues.empty()) {
            return before;
        }
        std::optional<double> volume_mm3 = known ? known->find(before.project) : std::nullopt;
        if (!volume_mm3) {
            volume_mm3 = runSurface({}, before.project, stop).removed_mm3;
            if (known && !stop.stop_requested()) {
                known->add(before.project, *volume_mm3);
            }
        }
        removed += removedMetal(before.project, *volume_mm3);
    }
    return wornProject(setup, surface, removed);
}

} // namespace sparkout
