// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/remarks.h"

#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/units.h"

#include <cmath>

namespace sparkout {

namespace {

/// Whether the gauge's last reading has metal beyond the drawing's limit.
bool endsOversize(const SimulationResult& result) {
    const Part& part = result.project.part;
    const double deviation = result.gaugeReading_mm - part.diameter_mm;
    return part.surface == Surface::external
               ? deviation > part.upper_deviation_um / units::umPerMm + diameterSlack_mm
               : deviation < part.lower_deviation_um / units::umPerMm - diameterSlack_mm;
}

/// In whole hundredths of a micrometre.
std::string shortMm(double value) {
    return numberText(std::round(value * 1e5) / 1e5) + " mm";
}

} // namespace

Issues remarksOn(const SimulationResult& result) {
    const auto& stages = result.project.cycle.stages;
    if (result.status != RunStatus::completed || stages.empty()) {
        return {};
    }
    const Stage& last = stages.back();
    const bool leaves = last.spark_out.mode == SparkOut::Mode::count && last.stock_mm > 0;
    if (!leaves || !endsOversize(result)) {
        return {};
    }
    return {{IssueCode::sparkOutLeaves, Severity::warning,
             "/cycle/stages/" + std::to_string(stages.size() - 1) + "/stock_mm",
             shortMm(result.remainingStock_mm), shortMm(last.stock_mm)}};
}

} // namespace sparkout
