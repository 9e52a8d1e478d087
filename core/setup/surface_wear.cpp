// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/surface_wear.h"

#include "core/format/project_file.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/shared_members.h"
#include "core/simulation/simulate.h"

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

} // namespace sparkout
