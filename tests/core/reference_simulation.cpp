// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/reference_simulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace reference {
namespace {

using nlohmann::json;
using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real sizeTolerance = 1e-9L; // [mm] a threshold counts as reached this much early
constexpr Real noRemoval = 1e-9L;     // [mm] a pass that removes no more than this removes nothing
constexpr int idleRevolutionsAllowed =
    100; // plunge: so many in a row without removal end the cycle
constexpr long long visitLimit = 50'000'000;

// ---------------------------------------------------------------- reading the project

bool given(const json& object, const char* key) {
    return object.contains(key) && !object.at(key).is_null();
}

Real number(const json& object, const char* key) {
    return object.at(key).get<double>();
}

Real number(const json& object, const char* key, Real otherwise) {
    return given(object, key) ? number(object, key) : otherwise;
}

int integer(const json& object, const char* key, int otherwise) {
    return given(object, key) ? object.at(key).get<int>() : otherwise;
}

std::string text(const json& object, const char* key, const char* otherwise) {
    return given(object, key) ? object.at(key).get<std::string>() : otherwise;
}

json part(const json& project, const char* key) {
    return given(project, key) ? project.at(key) : json::object();
}

// ---------------------------------------------------------------- what the cycle works on

enum class StageEnd { Threshold, Count, Size }; // Count and Size are spark-out stages

struct Stage {
    Real radial_feed = 0; // traverse: mm per double stroke; plunge: mm/min; spark-out: 0
    Real axial_feed = 0;  // mm/min, traverse only
    Real stock = 0;       // Π_z [mm]
    StageEnd end = StageEnd::Threshold;
    int count = 0; // length of a spark-out by count
};

// A zone or a section: all it carries from pass to pass is its radii.
struct Body {
    Real gamma = 0;           // γ [mm/N]
    std::vector<Real> radius; // R_k [mm]
    bool reported = true;     // false: the extra section of a gauge in a free position
    Real length = 0;          // of the surface it stands for [mm]
};

// What a stage adds up to; energy in N·m, time in min.
struct Sums {
    Real volume = 0, energy = 0, time = 0, ground = 0;
    Real a = 0, P_y = 0, P_z = 0; // the largest
};

struct Cycle {
    // the inputs
    bool traverse = false;
    bool internal = false;
    Real d = 0, R_t = 0;                    // nominal diameter, target radius [mm]
    Real R_max0 = 0, R_min0 = 0;            // largest and smallest radius of the blank [mm]
    int K = 0;                              // radii per section
    Real length = 0, B = 0, o1 = 0, o2 = 0; // [mm]
    Real n = 0;                             // [rev/min]
    Real S_rad = 0;                         // plunge-in feed [mm/min]
    Real V_k = 0;                           // [m/s]
    Real k_s = 0, k_r = 0;                  // normal force [N/mm², N/mm^1.5]
    Real z_s = 0, z_r = 0;                  // tangential force, the same way
    long long N1 = 0, N2 = 0;               // dwells [rev]
    bool position_control = false;
    std::string rule;
    Real geometric_runout_um = 0;
    std::vector<Stage> stages;
    std::size_t gauge = 0; // the body that carries the gauge

    // the state
    std::vector<Body> bodies;
    Real t_P = 0;      // accumulated programmed infeed [mm]
    std::size_t z = 0; // the stage
    int passes_in_stage = 0;
    Real largest_removal = 0; // since the pass (double stroke or revolution) began [mm]
    int idle_revolutions = 0;
    long long visits = 0;
    Real peak_P_y = 0, peak_P_z = 0; // [N]
    Real time = 0;                   // [min]
    std::vector<Sums> sums;          // stage by stage
};

void readForceLaw(Cycle& c, const json& project) {
    const json material = part(project, "material");
    const json wheel = part(project, "wheel");
    const Real D = number(wheel, "diameter_mm");
    const Real eta = number(wheel, "dullness");
    const Real sigma = number(material, "flow_stress_mpa");
    const Real friction = number(material, "friction", 0.3);
    const Real D_e = c.internal ? c.d * D / (c.d - D) : c.d * D / (c.d + D);
    const Real V_d = pi * c.d * c.n;           // [mm/min]
    const Real ratio = V_d / (c.V_k * 60'000); // V_k from m/s to mm/min
    c.k_s = number(material, "shear_factor", 1.9) * sigma * ratio;
    c.k_r = eta * sigma * std::sqrt(D_e) / 3;
    c.z_s = number(material, "shear_strain", 2.8) * sigma * ratio;
    c.z_r = friction * eta * sigma * std::sqrt(D_e) / 3;
}

// The dwell in whole revolutions.
long long dwellRevolutions(Real dwell_s, Real n) {
    if (dwell_s == 0) {
        return 0;
    }
    const Real x = dwell_s / 60 * n;
    return std::max(1LL, static_cast<long long>(std::floor(x + 0.5L + 1e-9L)));
}

// R_k of the blank, from its largest radius and its runout [mm].
std::vector<Real> blank(const json& partJson, int K, Real R_max, Real runout) {
    const std::string profile = text(partJson, "profile", "ellipse");
    std::vector<Real> radius;
    for (int k = 0; k < K; ++k) {
        const Real phi = 2 * pi * k / K;
        if (profile == "eccentric") {
            const Real r = R_max - runout / 2;
            const Real e = runout / 2;
            const Real sine = e * std::sin(phi);
            radius.push_back(e * std::cos(phi) + std::sqrt(r * r - sine * sine));
        } else if (profile == "lobes") {
            const int lobes = integer(partJson, "lobes", 3);
            radius.push_back(R_max - runout / 2 + runout / 2 * std::cos(lobes * phi));
        } else if (profile == "measured") {
            const auto um = partJson.at("radii_um").get<std::vector<double>>();
            const Real largest = *std::max_element(um.begin(), um.end());
            radius.push_back(R_max + (um.at(k) - largest) / 1000);
        } else {
            const Real p = R_max;
            const Real q = R_max - runout;
            const Real x = q * std::cos(phi);
            const Real y = p * std::sin(phi);
            radius.push_back(p * q / std::sqrt(x * x + y * y));
        }
    }
    return radius;
}

std::vector<Real> readPart(Cycle& c, const json& project) {
    const json partJson = part(project, "part");
    c.internal = text(partJson, "surface", "external") == "internal";
    c.d = number(partJson, "diameter_mm");
    c.length = number(partJson, "length_mm");
    c.K = integer(partJson, "radii_per_section", 36);
    const Real upper = number(partJson, "upper_deviation_um") / 1000;
    const Real lower = number(partJson, "lower_deviation_um") / 1000;
    c.R_t = c.d / 2 + (upper + lower) / 4;
    if (given(partJson, "target_diameter_mm")) {
        c.R_t = number(partJson, "target_diameter_mm") / 2;
    }
    Real runout = number(partJson, "initial_runout_mm");
    if (text(partJson, "profile", "ellipse") == "measured") {
        const auto um = partJson.at("radii_um").get<std::vector<double>>();
        const auto [smallest, largest] = std::minmax_element(um.begin(), um.end());
        runout = (Real(*largest) - Real(*smallest)) / 1000;
    }
    const Real stock = number(partJson, "stock_mm");
    c.R_max0 = c.internal ? c.R_t - stock : c.R_t + stock + runout;
    c.R_min0 = c.R_max0 - runout;
    return blank(partJson, c.K, c.R_max0, runout);
}

void readMachine(Cycle& c, const json& project) {
    const json machine = part(project, "machine");
    c.B = number(part(project, "wheel"), "width_mm");
    c.V_k = number(machine, "wheel_speed_m_s");
    c.n = number(machine, "work_speed_rpm");
    c.geometric_runout_um = number(machine, "geometric_runout_um", 0);
    if (c.traverse) {
        c.S_rad = number(machine, "plunge_feed_mm_min");
        c.o1 = number(machine, "overrun_entry_mm");
        c.o2 = number(machine, "overrun_exit_mm");
        c.N1 = dwellRevolutions(number(machine, "dwell_entry_s"), c.n);
        c.N2 = dwellRevolutions(number(machine, "dwell_exit_s"), c.n);
    }
}

void readStages(Cycle& c, const json& project) {
    for (const json& stageJson : project.at("cycle").at("stages")) {
        Stage stage;
        if (given(stageJson, "spark_out")) {
            const json& sparkOut = stageJson.at("spark_out");
            stage.end = sparkOut.is_string() ? StageEnd::Size : StageEnd::Count;
            stage.count = sparkOut.is_string() ? 0 : sparkOut.get<int>();
            stage.stock = number(stageJson, "stock_mm", 0);
        } else {
            stage.radial_feed =
                number(stageJson, c.traverse ? "radial_feed_mm" : "radial_feed_mm_min");
            stage.stock = number(stageJson, "stock_mm");
        }
        if (c.traverse) {
            stage.axial_feed = number(stageJson, "axial_feed_mm_min");
        }
        c.stages.push_back(stage);
    }
}

// γ at a position along the ground length, linear between the middles of the sections.
Real interpolated(const std::vector<Real>& gamma, Real length, Real position) {
    const Real slice = length / gamma.size();
    if (position <= slice / 2) {
        return gamma.front();
    }
    for (std::size_t j = 0; j + 1 < gamma.size(); ++j) {
        const Real middle = (j + 0.5L) * slice;
        if (position <= middle + slice) {
            const Real share = (position - middle) / slice;
            return gamma[j] + (gamma[j + 1] - gamma[j]) * share;
        }
    }
    return gamma.back();
}

void placeBodies(Cycle& c, const json& project, const std::vector<Real>& radius) {
    const json compliance = project.at("machine").at("compliance_mm_per_n");
    const json gauge = part(project, "gauge");
    if (c.traverse) {
        for (const char* zone : {"rz1", "nz", "rz2"}) {
            c.bodies.push_back({number(compliance, zone), radius, true});
        }
        c.bodies[0].length = c.B - c.o1;
        c.bodies[2].length = c.B - c.o2;
        c.bodies[1].length = c.length - c.bodies[0].length - c.bodies[2].length;
        c.gauge = 1;
        return;
    }
    const int J = integer(project, "sections", 4);
    std::vector<Real> gamma;
    for (int j = 0; j < J; ++j) {
        gamma.push_back(compliance.at(j).get<double>());
        c.bodies.push_back({gamma.back(), radius, true, c.length / J});
    }
    c.gauge = integer(gauge, "section", J / 2);
    if (given(gauge, "position_mm")) {
        const Real between = interpolated(gamma, c.length, number(gauge, "position_mm"));
        c.bodies.push_back({number(gauge, "compliance_mm_per_n", between), radius, false});
        c.gauge = c.bodies.size() - 1;
    }
}

Cycle readCycle(const json& project) {
    Cycle c;
    const json gauge = part(project, "gauge");
    c.traverse = project.at("operation") == "traverse";
    c.position_control = text(gauge, "control", "gauge") == "position";
    c.rule = text(gauge, "rule", "min");
    const std::vector<Real> radius = readPart(c, project);
    readMachine(c, project);
    readForceLaw(c, project);
    readStages(c, project);
    placeBodies(c, project, radius);
    if (c.position_control && given(gauge, "datum_mm")) {
        const Real touch = c.internal ? c.R_t - c.R_min0 : c.R_max0 - c.R_t;
        c.t_P = touch - number(gauge, "datum_mm");
    }
    return c;
}

// ---------------------------------------------------------------- cutting

// The wheel advances by b along the body in each revolution and stays K-th of one on each radius.
void addToStage(Sums& sums, const Cycle& c, const Body& body, Real b, Real a, Real P_y, Real P_z) {
    const Real minutes = body.length / b / c.n / c.K;
    sums.volume += pi * c.d / c.K * a * body.length;
    sums.energy += P_z * c.V_k * minutes * 60; // N · m/s · s
    sums.time += minutes;
    sums.ground += body.length / c.K;
    sums.a = std::max(sums.a, a);
    sums.P_y = std::max(sums.P_y, P_y);
    sums.P_z = std::max(sums.P_z, P_z);
}

// One radius passes under the wheel, which has been fed to t.
void visit(Cycle& c, Body& body, int k, Real b, Real t) {
    ++c.visits;
    Real& R = body.radius[k];
    const Real h = c.internal ? t - (R - c.R_min0) : t - (c.R_max0 - R);
    const Real a = depthOfCut(h, body.gamma, b, c.k_s, c.k_r);
    R = c.internal ? R + a : R - a;
    c.largest_removal = std::max(c.largest_removal, a);
    if (body.reported) {
        const Real P_y = b * (c.k_s * a + c.k_r * std::sqrt(a));
        const Real P_z = b * (c.z_s * a + c.z_r * std::sqrt(a));
        c.peak_P_y = std::max(c.peak_P_y, P_y);
        c.peak_P_z = std::max(c.peak_P_z, P_z);
        addToStage(c.sums[c.z], c, body, b, a, P_y, P_z);
    }
}

// Whole revolutions or strokes at constant infeed t_P.
void passes(Cycle& c, Body& body, Real b, long long count) {
    for (long long m = 0; m < count; ++m) {
        for (int k = 0; k < c.K; ++k) {
            visit(c, body, k, b, c.t_P);
        }
    }
}

Real laterStocks(const Cycle& c) {
    Real sum = 0;
    for (std::size_t j = c.z + 1; j < c.stages.size(); ++j) {
        sum += c.stages[j].stock;
    }
    return sum;
}

// The t_P at which the stage ends under position control.
Real targetInfeed(const Cycle& c) {
    const Real whole = c.internal ? c.R_t - c.R_min0 : c.R_max0 - c.R_t;
    return whole - laterStocks(c);
}

// The feed of this double stroke or revolution; position control cuts the last one of a stage
// short.
Real infeedOfThisPass(const Cycle& c) {
    const Stage& stage = c.stages[c.z];
    Real step = c.traverse ? stage.radial_feed : stage.radial_feed / c.n;
    if (c.position_control && stage.end == StageEnd::Threshold) {
        step = std::max(Real(0), std::min(step, targetInfeed(c) - c.t_P));
    }
    return step;
}

long long plungeInRevolutions(const Cycle& c, Real S_t) {
    return static_cast<long long>(std::ceil(c.n * S_t / c.S_rad - 1e-9L));
}

void doubleStroke(Cycle& c) {
    const Stage& stage = c.stages[c.z];
    const Real S_t = infeedOfThisPass(c);
    const long long N_E1 = plungeInRevolutions(c, S_t);
    const Real b1 = c.B - c.o1;                           // plunge passes in РЗ1
    const Real b2 = c.B - c.o2;                           // plunge passes in РЗ2
    const Real b = std::min(stage.axial_feed / c.n, c.B); // traverse passes
    Body& rz1 = c.bodies[0];
    Body& nz = c.bodies[1];
    Body& rz2 = c.bodies[2];

    // plunge-in
    for (long long m = 1; m <= N_E1; ++m) {
        for (int k = 0; k < c.K; ++k) {
            const Real fed = c.S_rad / c.n * (m - 1 + Real(k + 1) / c.K);
            visit(c, rz1, k, b1, c.t_P + std::min(S_t, fed));
        }
    }
    c.t_P += S_t;
    // entry dwell
    passes(c, rz1, b1, c.N1);
    // working stroke
    passes(c, rz1, b, 1);
    passes(c, nz, b, 1);
    passes(c, rz2, b, 1);
    // exit dwell
    passes(c, rz2, b2, c.N2);
    // return stroke
    passes(c, rz1, b, 1);
    passes(c, nz, b, 1);
    passes(c, rz2, b, 1);
    // entry dwell
    passes(c, rz1, b1, c.N1);

    const Real travel = c.length - c.B + c.o1 + c.o2;
    c.time += (N_E1 + 2 * c.N1 + c.N2) / c.n + 2 * travel / stage.axial_feed;
}

void revolution(Cycle& c) {
    const Real step = infeedOfThisPass(c);
    for (Body& body : c.bodies) {
        for (int k = 0; k < c.K; ++k) {
            visit(c, body, k, c.length, c.t_P + step * Real(k + 1) / c.K);
        }
    }
    c.t_P += step;
    c.time += 1 / c.n;
}

long long visitsOfNextPass(const Cycle& c) {
    if (!c.traverse) {
        return static_cast<long long>(c.bodies.size()) * c.K;
    }
    return (plungeInRevolutions(c, infeedOfThisPass(c)) + 2 * c.N1 + c.N2 + 6) * c.K;
}

// ---------------------------------------------------------------- control

// Π_rem by the gauge [mm].
Real remainingStock(const Cycle& c) {
    const std::vector<Real>& R = c.bodies[c.gauge].radius;
    Real smallest = R[0] + R[c.K / 2];
    Real largest = smallest;
    Real sum = 0;
    for (int k = 0; k < c.K / 2; ++k) {
        const Real D = R[k] + R[k + c.K / 2];
        smallest = std::min(smallest, D);
        largest = std::max(largest, D);
        sum += D;
    }
    Real reading = sum / (c.K / 2);
    if (c.rule == "min") {
        reading = c.internal ? largest : smallest;
    } else if (c.rule == "max") {
        reading = c.internal ? smallest : largest;
    }
    return c.internal ? c.R_t - reading / 2 : reading / 2 - c.R_t;
}

bool stageHasEnded(const Cycle& c) {
    const Stage& stage = c.stages[c.z];
    if (stage.end == StageEnd::Count) {
        return c.passes_in_stage >= stage.count;
    }
    if (stage.end == StageEnd::Threshold && c.position_control) {
        return c.t_P >= targetInfeed(c) - sizeTolerance;
    }
    return remainingStock(c) <= laterStocks(c) + sizeTolerance;
}

// After a pass of a spark-out until size: has it stopped removing anything?
bool progressHasStopped(Cycle& c) {
    if (c.largest_removal > noRemoval) {
        c.idle_revolutions = 0;
        return false;
    }
    ++c.idle_revolutions;
    return c.traverse || c.idle_revolutions >= idleRevolutionsAllowed;
}

void run(Cycle& c, Result& result) {
    for (;;) {
        if (c.visits + visitsOfNextPass(c) > visitLimit) {
            result.status = "too_long";
            return;
        }
        const bool untilSize = c.stages[c.z].end == StageEnd::Size;
        c.largest_removal = 0;
        if (c.traverse) {
            doubleStroke(c);
        } else {
            revolution(c);
        }
        ++result.passes;
        ++result.passes_by_stage[c.z];
        ++c.passes_in_stage;
        while (stageHasEnded(c)) {
            ++c.z;
            c.passes_in_stage = 0;
            if (c.z == c.stages.size()) {
                result.status = "completed";
                return;
            }
        }
        if (untilSize && progressHasStopped(c)) {
            result.status = "cannot_reach_size";
            return;
        }
    }
}

Place measured(const Cycle& c, const Body& body) {
    Place place;
    const std::vector<Real>& R = body.radius;
    Real smallest = R[0] + R[c.K / 2];
    Real largest = smallest;
    for (int k = 0; k < c.K; ++k) {
        const Real D = R[k] + R[(k + c.K / 2) % c.K];
        smallest = std::min(smallest, D);
        largest = std::max(largest, D);
        place.radii_um.push_back((R[k] - c.d / 2) * 1000);
    }
    const auto [lowest, highest] = std::minmax_element(R.begin(), R.end());
    place.diameter_deviation_min_um = static_cast<double>((smallest - c.d) * 1000);
    place.diameter_deviation_max_um = static_cast<double>((largest - c.d) * 1000);
    place.radial_runout_um =
        static_cast<double>((*highest - *lowest) * 1000 + c.geometric_runout_um);
    return place;
}

StageSums inDoubles(const Sums& sums, Real V_k) {
    StageSums stage;
    stage.volume_mm3 = static_cast<double>(sums.volume);
    stage.energy_j = static_cast<double>(sums.energy);
    stage.grinding_min = static_cast<double>(sums.time);
    stage.ground_mm = static_cast<double>(sums.ground);
    stage.largest_depth_mm = static_cast<double>(sums.a);
    stage.peak_normal_force_n = static_cast<double>(sums.P_y);
    stage.peak_power_w = static_cast<double>(sums.P_z * V_k);
    return stage;
}

} // namespace

long double depthOfCut(long double h, long double gamma, long double b, long double k_s,
                       long double k_r) {
    if (h <= 0) {
        return 0;
    }
    // The left side of the balance grows with a, is below h at a = 0 and not below h at a = h.
    long double low = 0;
    long double high = h;
    for (;;) {
        const long double a = low + (high - low) / 2;
        if (a <= low || a >= high) {
            return high; // no number lies between the two any more
        }
        const long double P_y = b * (k_s * a + k_r * std::sqrt(a));
        if (a + gamma * P_y < h) {
            low = a;
        } else {
            high = a;
        }
    }
}

Result simulate(const json& project) {
    Cycle c = readCycle(project);
    Result result;
    result.passes_by_stage.assign(c.stages.size(), 0);
    c.sums.resize(c.stages.size());
    run(c, result);
    for (const Sums& sums : c.sums) {
        result.stages.push_back(inDoubles(sums, c.V_k));
    }
    result.time_min = static_cast<double>(c.time);
    result.peak_normal_force_n = static_cast<double>(c.peak_P_y);
    result.peak_power_w = static_cast<double>(c.peak_P_z * c.V_k); // N · m/s
    for (const Body& body : c.bodies) {
        if (body.reported) {
            result.places.push_back(measured(c, body));
        }
    }
    return result;
}

} // namespace reference
