// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/grinding_scene.h"

#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <algorithm>

namespace sparkout {

namespace {

/// The travelled share of the way from entry to exit, 0…1.
double wayDone(const Trajectory& trajectory, const Progress& moment) {
    const Place& at = trajectory.passes[moment.open].place;
    const double share = (moment.radius + 1.0) / trajectory.radii;
    if (at.zone == Zone::rz2) {
        return 1; // it is at the exit
    }
    return at.step == Step::e3 ? share : at.step == Step::e4 ? 1 - share : 0;
}

/// The wheel's position for a travelled share, from the entry's overrun to that of the exit.
Stretch wheelAt(const Project& project, double way) {
    const double L = project.part->length_mm, B = project.wheel->width_mm;
    if (!project.operation->travels) {
        return {(L - B) / 2, (L + B) / 2};
    }
    const double first = -project.machine->overrun_entry_mm;
    const double travel =
        L - B + project.machine->overrun_entry_mm + project.machine->overrun_exit_mm;
    const double from = first + way * travel;
    return project.machine->entry_side == EntrySide::tailstock ? Stretch{L - from - B, L - from}
                                                               : Stretch{from, from + B};
}

std::size_t surfaceAt(const std::vector<SceneSurface>& surfaces, double x_mm) {
    const auto away = [x_mm](const SceneSurface& surface) {
        return std::max({surface.stretch.from_mm - x_mm, x_mm - surface.stretch.to_mm, 0.0});
    };
    return static_cast<std::size_t>(std::ranges::min_element(surfaces, {}, away)
                                    - surfaces.begin());
}

class SceneBuilder {
public:
    SceneBuilder(const SimulationResult& result, const Trajectory& trajectory,
                 const Progress& moment)
        : m_result(result), m_trajectory(trajectory), m_moment(moment) {
        const Part& part = *result.project.part;
        m_first_mm = makeBlank(part).firstTouchRadius_mm;
        m_scene.operation = result.project.operation;
        m_scene.removalSign = part.surface == Surface::external ? 1 : -1;
        m_scene.edge_mm = m_first_mm;
        m_scene.gauge_mm = gaugePlace();
        m_scene.radius = moment.isBlank() ? 0 : moment.radius;
    }

    GrindingScene build() {
        addSurfaces();
        const bool blank = m_moment.isBlank();
        m_scene.wheel = wheelAt(m_result.project, blank ? 0 : wayDone(m_trajectory, m_moment));
        m_scene.leading =
            surfaceAt(m_scene.surfaces, (m_scene.wheel.from_mm + m_scene.wheel.to_mm) / 2);
        if (!blank) {
            cut();
        }
        return std::move(m_scene);
    }

private:
    [[nodiscard]] double gaugePlace() const {
        const Project& project = m_result.project;
        const double middle =
            m_result.sections[static_cast<std::size_t>(gaugeSection(project))].position_mm;
        return project.operation->travels ? middle : project.gauge->position_mm.value_or(middle);
    }

    void addSurfaces() {
        const LastVisits last = lastVisits(m_trajectory, m_result.sections.size(), m_moment);
        const std::vector<Stretch> stretches = groundStretches(m_result.project);
        const Blank blank = makeBlank(*m_result.project.part);
        const auto k = static_cast<std::size_t>(m_scene.radius);
        for (std::size_t i = 0; i < last.size(); ++i) {
            // In a gap there is nothing to grind: the surface is at its target.
            const double depth = blank.isGap(k) ? blank.totalInfeed_mm : blank.depthAt(i)[k];
            const double untouched = m_first_mm - m_scene.removalSign * depth;
            const bool ground = last[i][k] && !last[i][k]->isGap();
            m_scene.surfaces.push_back({m_result.sections[i].zone, static_cast<int>(i),
                                        stretches[i], ground ? last[i][k]->radius_mm : untouched,
                                        0});
        }
    }

    /// Every simultaneous pass deflects its section; in traverse one of them deflects the part.
    void cut() {
        const bool travels = m_scene.operation->travels;
        if (m_moment.end - m_moment.open == 1) {
            m_scene.leading = sectionOf(m_trajectory.passes[m_moment.open].place);
        }
        double push = 0;
        for (std::size_t i = m_moment.open; i < m_moment.end; ++i) {
            const Pass& pass = m_trajectory.passes[i];
            const Visit& visit =
                m_trajectory.visits[pass.firstVisit + static_cast<std::size_t>(m_scene.radius)];
            const std::size_t at = sectionOf(pass.place);
            const double edge =
                m_first_mm - m_scene.removalSign * (visit.programmed_mm + visit.wave_mm);
            const double yield =
                visit.actual_mm > 0 ? m_scene.removalSign * (visit.radius_mm - edge) : 0;
            if (!travels) {
                m_scene.surfaces[at].yield_mm = yield;
            }
            if (at == m_scene.leading) {
                m_scene.edge_mm = edge;
                m_scene.programmed_mm = visit.programmed_mm;
                m_scene.cut_mm = visit.actual_mm;
                m_scene.force_n = visit.normalForce_n;
                push = yield;
            }
        }
        for (SceneSurface& surface : m_scene.surfaces) {
            surface.yield_mm = travels ? push : surface.yield_mm;
        }
    }

    const SimulationResult& m_result;
    const Trajectory& m_trajectory;
    const Progress& m_moment;
    double m_first_mm = 0;
    GrindingScene m_scene;
};

} // namespace

GrindingScene grindingScene(const SimulationResult& result, const Trajectory& trajectory,
                            const Progress& moment) {
    return trajectory.passes.empty() ? GrindingScene{}
                                     : SceneBuilder(result, trajectory, moment).build();
}

} // namespace sparkout
