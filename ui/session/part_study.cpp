// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/part_study.h"

#include "core/project/batch.h"
#include "core/project/optimisation.h"
#include "core/setup/worn_project.h"

#include <atomic>
#include <functional>
#include <utility>

namespace sparkout {

void PartStudy::runAll(const Setup& setup, SurfaceStudy::Kind kind, std::int64_t parts, One one) {
    run(parts, [this, setup, kind, one = std::move(one)](const Means& means) {
        Setup present = setup;
        std::vector<SurfaceStudyPtr> studies;
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
        return [this, studies = std::move(studies), stopped = means.stop.stop_requested()] {
            for (const SurfaceStudyPtr& study : studies) {
                emit surfaceDone(study);
            }
            emit finished(stopped);
        };
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

void PartStudy::startSearches(const Setup& setup) {
    runAll(setup, SurfaceStudy::Kind::search, static_cast<std::int64_t>(setup.surfaces.size()),
           [](SurfaceStudy& study, Setup& present, const Project& project, const Means& means) {
               study.isSetUp = project.optimisation.has_value();
               if (study.isSetUp) {
                   study.search =
                       runWholeSearch(project, {}, means.stop, [](const SearchState&) {});
                   if (const FoundCycle* best = study.search->best()) {
                       Project& own = present.surfaces[study.surface].project;
                       own = withFound(std::move(own), *best);
                   }
               }
               means.done->fetch_add(1, std::memory_order_relaxed);
           });
}

} // namespace sparkout
