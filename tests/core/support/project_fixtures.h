// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/project_file.h"
#include "core/process/profile.h"
#include "core/simulation/simulate.h"
#include "tests/whole_project.h"
#include "words/issue_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// Projects and small measures that the engine's tests share. The formulas here are written a
/// second time on purpose: a test must not ask the engine for the law it holds the engine against.
namespace sparkout::fixtures {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// |a − b| ≤ tolerance; false for NaN.
inline bool within(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

/// |a − b| ≤ relative·max(|a|, |b|); false for NaN.
inline bool close(double a, double b, double relative) {
    return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

/// What a depth counted from first touch can be off by after so many passes: t_П and Σa are each
/// rounded once a pass, each rounding is at most half an ε of the largest t_П [mm].
inline double rounding(double programmed_mm, double passes) {
    return 2 * epsilon * programmed_mm * (passes + 2);
}

inline Project read(const nlohmann::json& json) {
    const ReadResult result = readProject(json.dump());
    if (!result.project) {
        const auto error = std::ranges::find(result.issues, Severity::error, &Issue::severity);
        const Issue issue = error == result.issues.end() ? Issue{} : *error;
        throw std::runtime_error("refused: " + issue.path + " " + issueSentence(issue));
    }
    return *result.project;
}

/// A slender stepped shaft off the middle between unequal centres, so that no two sections are
/// alike.
inline void putOnSlenderShaft(Project& p) {
    p.part->shaft.segments = {{60, 22}, {80, 30}, {50, 18}};
    p.part->shaft.ground_from_mm = 70;
    p.machine->compliance_mm_per_n = std::monostate{};
    p.machine->stiffness_n_um = Stiffness{40, 20, 50};
}

/// A stage of a plunge cycle.
inline Stage plungeStage(double feed_mm_min, double stock_mm) {
    Stage stage;
    stage.radial_feed_mm_min = feed_mm_min;
    stage.stock_mm = stock_mm;
    return stage;
}

/// A stage of a traverse cycle.
inline Stage strokeStage(double radialFeed_mm, double axialFeed_mm_min, double stock_mm) {
    Stage stage;
    stage.radial_feed_mm = radialFeed_mm;
    stage.axial_feed_mm_min = axialFeed_mm_min;
    stage.stock_mm = stock_mm;
    return stage;
}

inline SparkOut count(int passes) {
    return {SparkOut::Mode::count, passes};
}
inline SparkOut untilSize() {
    return {SparkOut::Mode::untilSize, 0};
}

/// A last stage that feeds nothing; with an axial feed for traverse.
inline Stage sparkStage(SparkOut end, double stock_mm = 0,
                        std::optional<double> axialFeed_mm_min = std::nullopt) {
    Stage stage;
    stage.axial_feed_mm_min = axialFeed_mm_min;
    stage.stock_mm = stock_mm;
    stage.spark_out = end;
    return stage;
}

/// The full-law case of the vectors' page: σ_i 2000, η 0.02, B 40, d 30, D 600, n 180, V_k 35;
/// one section, a round blank, fed 5 µm a revolution; ends by the gauge.
inline Project plunge() {
    Project project;
    project.operation = Operation::plunge;
    project.part->diameter_mm = 30;
    project.part->length_mm = 40;
    project.part->stock_mm = 0.2;
    project.part->initial_runout_mm = 0;
    project.part->radii_per_section = 4;
    project.material->flow_stress_mpa = 2000;
    project.wheel->diameter_mm = 600;
    project.wheel->width_mm = 40;
    project.wheel->dullness = 0.02;
    project.machine->wheel_speed_m_s = 35;
    project.machine->work_speed_rpm = 180;
    project.machine->compliance_mm_per_n = std::vector<double>{2e-5};
    project.sections = 1;
    project.cycle->stages = {plungeStage(0.9, 0.2)};
    return project;
}

/// The shaft 30h6 of the project file's page: three zones, two stages.
inline Project traverse() {
    Project project;
    project.operation = Operation::traverse;
    project.part->radii_per_section = 12;
    project.machine->dwell_entry_s = 0.333;
    project.machine->dwell_exit_s = 0.667;
    project.machine->compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
    project.cycle->stages = {strokeStage(0.004, 1800, 0.11), strokeStage(0.001, 300, 0.04)};
    return project;
}

inline Project plungeOfThree() {
    Project p = plunge();
    p.part->radii_per_section = 24;
    p.part->initial_runout_mm = 0.03;
    p.sections = 3;
    p.machine->compliance_mm_per_n = std::vector<double>{4e-5, 2e-5, 7e-5};
    p.cycle->stages = {plungeStage(1.2, 0.15), plungeStage(0.3, 0.05), sparkStage(count(7))};
    return p;
}

/// On a slender shaft, of which no two sections are alike.
inline Project slender(int sections, bool coupled = true) {
    Project p = plunge();
    p.part->radii_per_section = 12;
    p.part->initial_runout_mm = 0.02;
    putOnSlenderShaft(p);
    p.sections = sections;
    p.sections_coupled = coupled;
    return p;
}

/// A shaft of a thousand segments on a thousand rests.
inline Project restedShaft() {
    Project p = plunge();
    p.part->length_mm = 400;
    p.machine->compliance_mm_per_n = std::monostate{};
    p.machine->stiffness_n_um = Stiffness{40, 20, 50};
    for (int i = 0; i < 1000; ++i) {
        p.part->shaft.segments.push_back({1.0, 20.0 + i % 7});
        p.part->shaft.steady_rests.push_back({0.5 + i, 1.0 + i % 5});
    }
    p.part->shaft.ground_from_mm = 300;
    return p;
}

/// The shaft 30h6 with its steps between yielding centres, on one rest.
inline Project steppedTraverse() {
    Project project = traverse();
    project.machine->compliance_mm_per_n = std::monostate();
    project.machine->stiffness_n_um = Stiffness{60, 40, 50};
    project.part->shaft.segments = {{40, 25}, {120, 30}, {40, 20}};
    project.part->shaft.ground_from_mm = 50;
    project.part->shaft.steady_rests = {{100, 30}};
    return project;
}

/// The coefficients of P_y(a) = b·(k_s·a + k_r·√a), MODEL-2 written out.
struct Law {
    double ks = 0, kr = 0;

    explicit Law(const Project& p) {
        const double d = p.part->diameter_mm;
        const double D = p.wheel->diameter_mm;
        const double De = p.part->surface == Surface::external ? d * D / (D + d) : d * D / (d - D);
        const double speeds =
            std::numbers::pi * d * p.machine->work_speed_rpm / (p.machine->wheel_speed_m_s * 60e3);
        ks = p.material->shear_factor * p.material->flow_stress_mpa * speeds;
        kr = p.wheel->dullness * p.material->flow_stress_mpa * std::sqrt(De) / 3;
    }
    [[nodiscard]] double force(double b, double a) const {
        return b * (ks * a + kr * std::sqrt(a));
    }
};

/// A result with everything that happened.
struct Traced {
    SimulationResult result;
    Trajectory trajectory;

    explicit Traced(const Project& project) { result = simulateUnchecked(project, &trajectory); }
    [[nodiscard]] const Visit& visit(const Pass& pass, int k) const {
        return trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)];
    }
    /// The passes of one zone or section, in order.
    [[nodiscard]] std::vector<Pass> passesOf(int section) const {
        std::vector<Pass> passes;
        for (const Pass& pass : trajectory.passes) {
            if (pass.place.section == section) {
                passes.push_back(pass);
            }
        }
        return passes;
    }
};

/// Depth of a radius below first touch before anything is cut, from the blank [mm].
inline std::vector<double> blankDepths(const Project& project) {
    return makeBlank(*project.part).depth_mm;
}

inline bool sameBits(const StageSums& a, const StageSums& b) {
    return a.length_mm == b.length_mm && a.removed_mm2 == b.removed_mm2
           && a.rootLength_mm15 == b.rootLength_mm15 && a.depth_mm.value == b.depth_mm.value
           && a.normalForce_n.value == b.normalForce_n.value && a.power_w.value == b.power_w.value;
}

/// Whether two runs came out the same to the last bit.
inline bool sameBits(const SimulationResult& a, const SimulationResult& b) {
    bool same =
        a.status == b.status && a.time_s == b.time_s && a.cycleCount == b.cycleCount
        && a.countsByStage == b.countsByStage && a.timeByStage_s == b.timeByStage_s
        && a.gaugeReading_mm == b.gaugeReading_mm && a.remainingStock_mm == b.remainingStock_mm
        && a.peakNormalForce_n == b.peakNormalForce_n && a.peakPower_w == b.peakPower_w
        && a.visits == b.visits && a.sections.size() == b.sections.size()
        && std::equal(a.sumsByStage.begin(), a.sumsByStage.end(), b.sumsByStage.begin(),
                      b.sumsByStage.end(),
                      [](const StageSums& x, const StageSums& y) { return sameBits(x, y); });
    for (std::size_t i = 0; same && i < a.sections.size(); ++i) {
        same = a.sections[i].radii_mm == b.sections[i].radii_mm
               && a.sections[i].radialRunout_mm == b.sections[i].radialRunout_mm
               && a.sections[i].diameterDeviationMin_mm == b.sections[i].diameterDeviationMin_mm
               && a.sections[i].diameterDeviationMax_mm == b.sections[i].diameterDeviationMax_mm
               && a.sections[i].peakNormalForce_n == b.sections[i].peakNormalForce_n
               && a.sections[i].compliance_mm_per_n == b.sections[i].compliance_mm_per_n;
    }
    return same;
}

} // namespace sparkout::fixtures
