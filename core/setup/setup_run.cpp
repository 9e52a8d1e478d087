// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup_run.h"

#include "core/file/output_json.h"
#include "core/file/strict_json.h"
#include "core/quality/result_json.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/worn_project.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

/// Defined when every surface is completed.
template <double PieceTime::*time_min>
constexpr Output<SetupRunOf> timeRow(const char* key, const char* hint) {
    return {{.key = key, .unit = "min", .hint = hint}, [](const SetupRunOf& r) {
                return r.run.isCompleted(r.setup) ? std::optional(r.run.time.*time_min)
                                                  : std::nullopt;
            }};
}

constexpr Output<SetupRunOf> partRows[] = {
    {{.key = "completed", .hint = "whether every surface reaches its size"},
     [](const SetupRunOf& r) { return r.run.isCompleted(r.setup); }},
    {{.key = "holds", .hint = "whether every requirement of every surface is met"},
     [](const SetupRunOf& r) { return r.run.holds(r.setup); }},
    timeRow<&PieceTime::main_min>("main_time_min", "main time: as given, or the sum of the cycles"),
    timeRow<&PieceTime::auxiliary_min>(
        "auxiliary_time_min", "auxiliary time: as given, or of the steps between the cycles"),
    timeRow<&PieceTime::piece_min>("piece_time_min",
                                   "piece time: as given, or both with the share of service"),
    timeRow<&PieceTime::preparation_min>("preparation_time_min",
                                         "preparation of the batch, as given"),
    timeRow<&PieceTime::calculation_min>("calculation_time_min",
                                         "piece time with its share of the preparation"),
};

} // namespace

bool SurfaceRun::holds() const {
    return isCompleted() && std::ranges::all_of(constraints, &ConstraintResult::holds);
}

SurfaceRun runSurface(const std::string& name, const Project& project,
                      const std::stop_token& stop) {
    SurfaceRun run{name, simulate(project, nullptr, stop), {}, 0};
    run.constraints = evaluateConstraints(run.result);
    run.removed_mm3 = removedVolume_mm3(run.result);
    return run;
}

bool SetupRun::isCompleted(const Setup& setup) const {
    return surfaces.size() == setup.surfaces.size()
           && std::ranges::all_of(surfaces, &SurfaceRun::isCompleted);
}

bool SetupRun::holds(const Setup& setup) const {
    return isCompleted(setup) && std::ranges::all_of(surfaces, &SurfaceRun::holds);
}

SetupRun runSetup(const Setup& setup, const std::stop_token& stop) {
    SetupRun run;
    RemovedMetal removed;
    double cycles_min = 0;
    for (std::size_t i = 0; i < setup.surfaces.size() && !stop.stop_requested(); ++i) {
        WornProject made = wornProject(setup, i, removed);
        if (!made.issues.empty()) {
            run.issues = std::move(made.issues);
            break;
        }
        run.surfaces.push_back(runSurface(setup.surfaces[i].name, made.project, stop));
        removed += run.surfaces.back().removed();
        cycles_min += run.surfaces.back().result.time_s / units::secondsPerMinute;
    }
    if (run.isCompleted(setup)) {
        run.time = pieceTime(setup.times, setup.surfaces.size(), cycles_min);
    }
    return run;
}

std::span<const Output<SetupRunOf>> setupOutputs() {
    return partRows;
}

std::string setupJson(const Setup& setup, const SetupRun& run,
                      const std::function<std::string(const SurfaceRun&)>& surfaceJson) {
    ordered_json surfaces = ordered_json::array();
    for (const SurfaceRun& surface : run.surfaces) {
        ordered_json one = {{"name", surface.name}};
        one.update(ordered_json::parse(
            surfaceJson ? surfaceJson(surface) : resultJson(surface.result, surface.constraints)));
        surfaces.push_back(std::move(one));
    }
    return printJson(
        {{"surfaces", std::move(surfaces)}, {"part", outputsJson(setupOutputs(), {setup, run})}});
}

} // namespace sparkout
