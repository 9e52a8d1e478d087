// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/part_study.h"

#include "core/project/batch.h"
#include "core/project/optimisation.h"
#include "core/setup/worn_project.h"
#include "core/study/usual_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

namespace sparkout {

namespace {

constexpr std::int64_t steps = 1000; ///< resolution of a search's progress

/// The progress of a search: by its bound relative to its best, which it reaches at the end.
class SearchCount {
public:
    explicit SearchCount(std::atomic<std::int64_t>& done) : m_done(done) {}

    void note(const SearchState& state) { // on any thread
        const double share = state.best_s ? std::clamp(state.bound_s / *state.best_s, 0.0, 1.0) : 0;
        reach(std::llround(share * double(steps)));
    }
    void end() { reach(steps); }

private:
    void reach(std::int64_t count) {
        std::int64_t before = m_reached.load();
        while (before < count && !m_reached.compare_exchange_weak(before, count)) {
        }
        if (before < count) {
            m_done.fetch_add(count - before, std::memory_order_relaxed);
        }
    }

    std::atomic<std::int64_t>& m_done;
    std::atomic<std::int64_t> m_reached = 0;
};

/// The ticked options that apply to this project's search.
SearchWish wishOf(const Project& project, SearchTicks ticks) {
    const bool ofTime = objectiveOf(project) == SearchObjective::time;
    const bool ofMargin = project.optimisation->margin_within_min.has_value();
    return {.phases = ticks.phases && ofTime, .refine = ticks.refine && ofTime && !ofMargin};
}

} // namespace

void PartStudy::runAll(const Setup& setup, SurfaceStudy::Kind kind, std::int64_t parts, One one) {
    using Surfaces = std::vector<SurfaceStudyPtr>;
    const auto work = [setup, kind, one = std::move(one)](const Means& means) {
        Setup present = setup;
        Surfaces studies;
        for (std::size_t i = 0; i < setup.surfaces.size() && !means.stop.stop_requested(); ++i) {
            auto study = std::make_shared<SurfaceStudy>();
            study->kind = kind;
            study->surface = i;
            WornProject worn = wornProject(present, i, means.stop);
            if (means.stop.stop_requested()) {
                break;
            }
            study->issues = std::move(worn.issues);
            if (study->issues.empty()) {
                one(*study, present, worn.project, means);
            }
            studies.push_back(std::move(study));
        }
        return std::pair(std::move(studies), means.stop.stop_requested());
    };
    start(parts, work, [this](const std::pair<Surfaces, bool>& result) {
        for (const SurfaceStudyPtr& study : result.first) {
            emit surfaceDone(study);
        }
        emit finished(result.second);
    });
}

void PartStudy::startBatches(const Setup& setup) {
    std::int64_t parts = 0;
    for (const GroundSurface& surface : setup.surfaces) {
        parts += surface.project.batch ? partsOf(surface.project) : 0;
    }
    runAll(setup, SurfaceStudy::Kind::batch, parts,
           [](SurfaceStudy& study, Setup&, const Project& project, const Means& means) {
               study.isSetUp = project.batch.has_value();
               if (study.isSetUp) {
                   BatchOptions options;
                   options.threads = means.threads;
                   options.stop = means.stop;
                   options.done = means.done;
                   study.batch = runWholeBatch(project, options);
               }
           });
}

void PartStudy::startSearches(const Setup& setup, SearchTicks ticks) {
    runAll(setup, SurfaceStudy::Kind::search,
           steps * static_cast<std::int64_t>(setup.surfaces.size()),
           [ticks](SurfaceStudy& study, Setup& present, const Project& worn, const Means& means) {
               SearchCount progress(*means.done);
               const Project project = worn.optimisation ? worn : usualSearch(worn);
               SearchWish wish = wishOf(project, ticks);
               wish.wear = searchWear(present, study.surface);
               study.search =
                   search(project, wish, means.stop,
                          {.note = [&progress](const SearchState& s) { progress.note(s); }});
               if (const FoundCycle* found = study.search->answer()) {
                   Project& own = present.surfaces[study.surface].project;
                   own = withFound(std::move(own), *found);
               }
               progress.end();
           });
}

} // namespace sparkout
