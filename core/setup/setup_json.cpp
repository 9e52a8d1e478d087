// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup_json.h"

#include "core/format/output_json.h"
#include "core/format/strict_json.h"
#include "core/quality/result_json.h"

#include <utility>

namespace sparkout {

using nlohmann::ordered_json;

namespace {

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
    {{.key = "holds", .hint = "whether every requirement of every surface holds"},
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
