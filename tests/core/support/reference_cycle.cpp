// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/reference_cycle.h"

#include "core/simulation/traverse.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout::reference {

using nlohmann::json;

namespace {

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
    c.threshold = text(material, "force_law", "sources") == "threshold";
    if (c.threshold) {
        const Real K_0 = number(material, "specific_force_mpa", 50'000);
        const Real likeShear =
            K_0 * number(material, "shear_strain", 2.8) / number(material, "shear_factor", 1.9);
        c.k_s = K_0 * ratio;
        c.k_r = number(material, "threshold_force_n_mm", 0.5L);
        c.z_s = number(material, "specific_tangential_force_mpa", likeShear) * ratio;
        c.z_r = friction * c.k_r;
        return;
    }
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

// Which radii stand in a gap: those from its first edge on, up to the other.
std::vector<bool> gapsOf(const json& partJson, int K) {
    std::vector<bool> gap(static_cast<std::size_t>(K), false);
    for (const json& one : partJson.value("gaps", json::array())) {
        const Real from = number(one, "from_deg"), width = number(one, "width_deg");
        for (int k = 0; k < K; ++k) {
            for (const int turn : {-1, 0, 1, 2}) {
                const Real beyond = Real(360) * k / K + 360 * turn - from;
                gap[k] = gap[k] || (beyond > -1e-9L && beyond < width - 1e-9L);
            }
        }
    }
    return gap;
}

// The largest and the smallest measured deviation that are outside the gaps [µm].
std::pair<Real, Real> measuredRange(const std::vector<double>& um, const std::vector<bool>& gap) {
    std::vector<Real> there;
    for (std::size_t k = 0; k < um.size(); ++k) {
        if (!gap.at(k)) {
            there.push_back(um[k]);
        }
    }
    const auto [smallest, largest] = std::minmax_element(there.begin(), there.end());
    return {*largest, *smallest};
}

// R_k of the blank, from its largest radius and its runout [mm].
std::vector<Real> blank(const json& partJson, const Cycle& c, Real runout) {
    const int K = c.K;
    const Real R_max = c.R_max0;
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
            const Real largest = measuredRange(um, c.gap).first;
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
    c.gap = gapsOf(partJson, c.K);
    const Real upper = number(partJson, "upper_deviation_um") / 1000;
    const Real lower = number(partJson, "lower_deviation_um") / 1000;
    c.R_t = c.d / 2 + (upper + lower) / 4;
    if (given(partJson, "target_diameter_mm")) {
        c.R_t = number(partJson, "target_diameter_mm") / 2;
    }
    Real runout = number(partJson, "initial_runout_mm");
    if (text(partJson, "profile", "ellipse") == "measured") {
        const auto um = partJson.at("radii_um").get<std::vector<double>>();
        const auto [largest, smallest] = measuredRange(um, c.gap);
        runout = (largest - smallest) / 1000;
    }
    const Real stock = number(partJson, "stock_mm");
    c.R_max0 = c.internal ? c.R_t - stock : c.R_t + stock + runout;
    c.R_min0 = c.R_max0 - runout;
    return blank(partJson, c, runout);
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
        const std::string infeed = text(machine, "reversal_infeed", "entry");
        c.entry_share = infeed == "entry" ? 1 : infeed == "exit" ? 0 : 0.5L;
    }
}

// What makes the wheel run out of true, and how the work speed varies.
void readRunout(Cycle& c, const json& project) {
    const json wheel = part(project, "wheel"), machine = part(project, "machine");
    const json runout = part(wheel, "runout"), varied = part(machine, "work_speed_variation");
    c.n_k = c.V_k * 60'000 / (pi * number(wheel, "diameter_mm"));
    c.psi_0 = number(runout, "phase_deg", 0) * pi / 180;
    c.speed_variation =
        number(varied, "percent", given(machine, "work_speed_variation") ? 10 : 0) / 100;
    c.variation_period = number(varied, "period_s", 5) / 60;
    const bool byGrade = given(runout, "balance_grade_mm_s");
    if (!byGrade && !given(runout, "unbalance_g_mm")) {
        c.e = number(runout, "amplitude_um", 0) / 1000;
        c.L = integer(runout, "lobes", 1);
        return;
    }
    const Real omega = 2 * pi * c.n_k / 60; // [rad/s]
    const Real U = byGrade ? number(runout, "rotor_mass_kg") * number(runout, "balance_grade_mm_s")
                                 / omega // [kg·mm]
                           : number(runout, "unbalance_g_mm") / 1000;
    const Real force_n = U / 1000 * omega * omega;
    c.e = force_n / number(part(machine, "stiffness_n_um"), "wheel_head") / 1000;
    if (given(machine, "wheel_head_frequency_hz")) {
        const Real nearness = c.n_k / 60 / number(machine, "wheel_head_frequency_hz");
        c.e *= std::min(1 / std::abs(1 - nearness * nearness), Real(10));
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
            stage.continuous = c.traverse ? number(stageJson, "continuous_feed_mm_min", 0) : 0;
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
        const Real ends[] = {0, c.B - c.o1, c.length - (c.B - c.o2), c.length};
        for (int zone = 0; zone < 3; ++zone) {
            Body& body = c.bodies[zone];
            body.middle = (ends[zone] + ends[zone + 1]) / 2;
            body.length = ends[zone + 1] - ends[zone];
        }
        for (const int reversal : {0, 2}) { // the wheel does not reach the wall of a blind bore
            c.bodies[reversal].length = std::min(c.bodies[reversal].length, c.B);
        }
        c.gauge = 1;
        for (int zone = 0; zone < 3; ++zone) {
            c.bodies[zone].zone = zone;
        }
        c.zone_sections = integer(project, "zone_sections", 1);
        for (int zone = 0; zone < 3 && c.zone_sections > 1; ++zone) {
            c.bodies[zone].counted = false;
            // of what the wheel reaches: from the wall's strip on, or up to it
            const Real reached = c.bodies[zone].length;
            const Real start = zone == 0 ? ends[1] - reached : ends[zone];
            for (int i = 0; i < c.zone_sections; ++i) {
                Body body = c.bodies[zone];
                body.reported = false;
                body.counted = true;
                body.length = reached / c.zone_sections;
                body.middle = start + (i + 0.5L) * body.length;
                c.bodies.push_back(body);
            }
        }
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

} // namespace

Cycle readCycle(const json& project) {
    Cycle c;
    const json gauge = part(project, "gauge");
    c.traverse = project.at("operation") == "traverse";
    c.position_control = text(gauge, "control", "gauge") == "position";
    c.rule = text(gauge, "rule", "min");
    const std::vector<Real> radius = readPart(c, project);
    readMachine(c, project);
    readRunout(c, project);
    c.gauge_delay = number(gauge, "delay_s", number(part(project, "machine"), "gauge_delay_s", 0));
    c.feed_change_delay = number(part(project, "machine"), "feed_change_delay_s", 0);
    c.least_overlap = number(project, "least_overlap", 0);
    c.least_overlap_last = number(project, "least_overlap_last", 0);
    c.least_steps = integer(project, "least_steps", 0);
    readForceLaw(c, project);
    readStages(c, project);
    placeBodies(c, project, radius);
    if (c.position_control && given(gauge, "datum_mm")) {
        const Real touch = c.internal ? c.R_t - c.R_min0 : c.R_max0 - c.R_t;
        c.t_P = touch - number(gauge, "datum_mm");
    }
    if (c.position_control) { // the gauge feeds from the touch, wherever the wheel's surface is
        c.wear = number(part(project, "wheel"), "radius_wear_um", 0) / 1000;
    }
    return c;
}

} // namespace sparkout::reference
