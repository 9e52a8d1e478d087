// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup_json.h"

#include "core/format/strict_json.h"
#include "core/quality/result_json.h"

#include <utility>

namespace sparkout {

using nlohmann::ordered_json;

std::string setupJson(const Setup& setup, const SetupRun& run) {
    ordered_json surfaces = ordered_json::array();
    for (const SurfaceRun& surface : run.surfaces) {
        ordered_json one = {{"name", surface.name}};
        one.update(ordered_json::parse(resultJson(surface.result, surface.constraints)));
        surfaces.push_back(std::move(one));
    }
    const bool isCompleted = run.isCompleted(setup);
    const auto minutes = [isCompleted](double time) {
        return isCompleted ? ordered_json(time) : ordered_json(nullptr);
    };
    const ordered_json part = {
        {"completed", isCompleted},
        {"holds", run.holds(setup)},
        {"main_time_min", minutes(run.time.main_min)},
        {"auxiliary_time_min", minutes(run.time.auxiliary_min)},
        {"piece_time_min", minutes(run.time.piece_min)},
        {"preparation_time_min", minutes(run.time.preparation_min)},
        {"calculation_time_min", minutes(run.time.calculation_min)},
    };
    return printJson({{"surfaces", std::move(surfaces)}, {"part", part}});
}

} // namespace sparkout
