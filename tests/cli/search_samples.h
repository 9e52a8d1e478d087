// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/support/project_samples.h"

/// Files whose search takes a moment, and for ever.
namespace cli {

using nlohmann::json;

/// The shaft 30h6 with a grid of 1143 cycles.
inline json shaft() {
    json file = json::parse(sparkout::samples::readText(
        sparkout::samples::sourcePath("resources/examples/shaft-30h6-factory.sparkout")));
    file["optimisation"] = {{"stages", json::array({1, 2})},
                            {"stock_step_mm", 0.01},
                            {"radial_feed_mm", {0.002, 0.004, 0.006}},
                            {"axial_feed_mm_min", {800, 1600, 2400}}};
    return file;
}

/// The same with so many cycles that no search comes to its end.
inline json endless() {
    json file = shaft();
    file["optimisation"]["stages"] = json::array({5});
    file["optimisation"]["stock_step_mm"] = 0.001;
    file["optimisation"]["radial_feed_mm"] = {{"from", 0.001}, {"to", 0.012}, {"step", 0.0005}};
    file["optimisation"]["axial_feed_mm_min"] = {{"from", 300}, {"to", 3600}, {"step", 100}};
    return file;
}

} // namespace cli
