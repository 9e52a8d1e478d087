// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/wheel_calibration.h"

#include "core/measured/calibration.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// Ra [µm] by the cycle in each zone or section with a factor of 1; 0 if unknown.
std::vector<double> computedRoughness(const Project& project) {
    Project plain = project;
    plain.runs.clear();
    plain.measured.reset();
    constexpr double any_um = 100; // keeps the last cut
    plain.part->tolerance.roughness_ra_um = any_um;
    const SimulationResult result = simulate(plain);
    std::vector<double> values(static_cast<std::size_t>(placeCount(project)), 0);
    if (result.status != RunStatus::completed) {
        return values;
    }
    const RoughnessModel model(plain, 1);
    for (std::size_t i = 0; i < values.size() && i < result.sections.size(); ++i) {
        if (const auto& last = result.sections[i].lastCut) {
            values[i] = model.roughness(*last) * units::umPerMm;
        }
    }
    return values;
}

// Solves P_y = b·(k_s·u² + k_r·u) for u = √a by the form of the root without cancellation.
double depthOfForce(const Project& project, double force_n, double width_mm) {
    const ForceLaw law = forceLaw(project);
    const double pressure = force_n / width_mm;
    const double u = 2 * pressure / (law.kr + std::sqrt(law.kr * law.kr + 4 * law.ks * pressure));
    return u * u;
}

Calibration calibrationOf(std::string input, double value, const std::string& data,
                          const std::string& date) {
    Calibration calibration;
    calibration.input = std::move(input);
    calibration.value = value;
    calibration.data = data;
    calibration.date = date;
    return calibration;
}

} // namespace

std::optional<RoughnessCalibration> roughnessFromParts(const Project& project) {
    if (!project.measured) {
        return std::nullopt;
    }
    const Measured& measured = *project.measured;
    const std::vector<double> computed = computedRoughness(project);
    std::vector<double> logarithms;
    RoughnessCalibration found;
    const auto add = [&](int place, double value_um, std::size_t parts) {
        const auto at = static_cast<std::size_t>(place);
        if (at < computed.size() && computed[at] > 0 && value_um > 0) {
            logarithms.push_back(std::log(value_um / computed[at]));
            found.count += parts;
        }
    };
    for (const MeasuredPart& part : measured.parts) {
        add(part.place, part.roughness_ra_um.value_or(0), 1);
    }
    for (const MeasuredSummary& summary : measured.summaries) {
        if (summary.quantity == MeasuredQuantity::roughness_ra) {
            add(summary.place, summary.mean_um, static_cast<std::size_t>(summary.count));
        }
    }
    if (logarithms.empty()) {
        return std::nullopt;
    }
    const auto n = static_cast<double>(logarithms.size());
    const double mean = std::accumulate(logarithms.begin(), logarithms.end(), 0.0) / n;
    found.factor = std::exp(mean);
    if (logarithms.size() >= 2) {
        double squares = 0;
        for (const double value : logarithms) {
            squares += (value - mean) * (value - mean);
        }
        constexpr double level = 0.95;
        const Interval interval =
            studentInterval(mean, std::sqrt(squares / (n - 1)),
                            static_cast<std::int64_t>(logarithms.size()), level);
        found.interval95 = Interval{std::exp(interval.low), std::exp(interval.high)};
    }
    found.wheel = project.wheel->marking;
    found.dressing = project.wheel->dressing;
    return found;
}

Project withRoughness(const Project& project, const RoughnessCalibration& found,
                      const std::string& data, const std::string& date) {
    Project made = project;
    made.wheel->roughness_factor = found.factor;
    Calibration calibration = calibrationOf("/wheel/roughness_factor", found.factor, data, date);
    calibration.count = static_cast<int>(found.count);
    if (found.interval95) {
        calibration.low = found.interval95->low;
        calibration.high = found.interval95->high;
    }
    recordCalibration(made, std::move(calibration));
    return made;
}

std::optional<StrengthsCalibration> strengthsFromLimit(const Project& project, LimitReading reading,
                                                       double value, double width_mm) {
    const auto wheel = selfSharpening(project);
    if (!wheel || hasThreshold(project) || !(value > 0) || !(width_mm > 0)) {
        return std::nullopt;
    }
    constexpr double mwPerKw = 1e6;
    StrengthsCalibration found;
    found.depth_mm = reading == LimitReading::normal_force
                         ? depthOfForce(project, value, width_mm)
                         : PowerModel(project).wheelLimitDepth(width_mm, value * mwPerKw);
    found.factor = wheel->load(found.depth_mm);
    return found;
}

Project withStrengths(const Project& project, const StrengthsCalibration& found,
                      const std::string& data, const std::string& date) {
    Project made = project;
    Wheel& wheel = *made.wheel;
    const std::pair<const char*, std::optional<double>*> strengths[] = {
        {"/wheel/grain_surface_energy_j_m2", &wheel.grain_surface_energy_j_m2},
        {"/wheel/grain_modulus_gpa", &wheel.grain_modulus_gpa},
        {"/wheel/bond_surface_energy_j_m2", &wheel.bond_surface_energy_j_m2},
        {"/wheel/bond_modulus_gpa", &wheel.bond_modulus_gpa}};
    for (const auto& [path, strength] : strengths) {
        if (*strength) {
            **strength *= found.factor;
            recordCalibration(made, calibrationOf(path, **strength, data, date));
        }
    }
    return made;
}

} // namespace sparkout
