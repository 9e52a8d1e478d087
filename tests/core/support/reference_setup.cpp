// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/reference_setup.h"

#include <cmath>
#include <numbers>

namespace sparkout::reference {

using nlohmann::json;

namespace {

using Real = long double;

/// What all surfaces share, with what one of them has beside it.
json joined(const json& shared, const json& own) {
    json whole = shared;
    for (const auto& [key, value] : own.items()) {
        const bool both = whole.contains(key) && whole[key].is_object() && value.is_object();
        whole[key] = both ? joined(whole[key], value) : value;
    }
    return whole;
}

Real given(const json& object, const char* key, Real otherwise) {
    const bool is = object.contains(key) && !object.at(key).is_null();
    return is ? Real(object.at(key).get<double>()) : otherwise;
}

/// The wheel after so much was removed: blunter by what each millimetre of its width has removed,
/// smaller by the ring that has worn off.
json worn(const json& dressed, const json& wear, Real removed_mm3, Real perContact_mm2) {
    json wheel = dressed;
    const Real B = dressed.at("width_mm").get<double>();
    const Real D = dressed.at("diameter_mm").get<double>();
    const Real eta = dressed.at("dullness").get<double>()
                     + given(wear, "dulling_per_mm2", 0)
                           * std::pow(removed_mm3 / B, given(wear, "dulling_exponent", 1));
    wheel["dullness"] = static_cast<double>(eta > 1 ? 1 : eta);
    if (const Real G = given(wear, "grinding_ratio", 0); G > 0) {
        const Real area = std::numbers::pi_v<Real> / 4 * D * D - removed_mm3 / G / B;
        const Real smaller = std::sqrt(area / (std::numbers::pi_v<Real> / 4));
        wheel["diameter_mm"] = static_cast<double>(smaller);
        const Real ring = std::numbers::pi_v<Real> / 4 * D * D - perContact_mm2 / G;
        const Real ground = std::sqrt(ring / (std::numbers::pi_v<Real> / 4)); // where it grinds
        wheel["radius_wear_um"] =
            static_cast<double>(given(dressed, "radius_wear_um", 0) + (D - ground) * 500);
    }
    return wheel;
}

void addTimes(const json& times, SetupResult& setup) {
    const auto n = static_cast<Real>(setup.surfaces.size());
    Real cycles = 0;
    for (const SurfaceResult& surface : setup.surfaces) {
        cycles += surface.result.time_min;
    }
    Real seconds = given(times, "handling_s", 0); // once a part
    for (Real i = 0; i < n; ++i) {                // for every surface, between every two
        seconds += given(times, "approach_s", 0);
        seconds += given(times, "retreat_s", 0);
        seconds += given(times, "gauging_s", 0);
        seconds += i > 0 ? given(times, "positioning_s", 0) : 0;
    }
    const Real main = given(times, "main_min", cycles);
    const Real auxiliary = given(times, "auxiliary_min", seconds / 60);
    const Real service = given(times, "service_percent", 0) / 100 * (main + auxiliary);
    const Real piece = given(times, "piece_min", main + auxiliary + service);
    const Real preparation = given(times, "preparation_min", 0);
    setup.main_min = static_cast<double>(main);
    setup.auxiliary_min = static_cast<double>(auxiliary);
    setup.piece_min = static_cast<double>(piece);
    setup.preparation_min = static_cast<double>(preparation);
    setup.calculation_min =
        static_cast<double>(piece + preparation / given(times, "batch_size", 1));
}

} // namespace

SetupResult simulateSetup(const json& file) {
    json shared = file;
    for (const char* key : {"format", "version", "surfaces", "times", "wear"}) {
        shared.erase(key);
    }
    SetupResult setup;
    setup.completed = true;
    Real removed_mm3 = 0, perContact_mm2 = 0;
    for (const json& own : file.at("surfaces")) {
        SurfaceResult surface;
        surface.project = joined(shared, own);
        surface.project["wheel"] = worn(shared.at("wheel"), file.value("wear", json::object()),
                                        removed_mm3, perContact_mm2);
        json& machine = surface.project["machine"];
        if (machine.value("wheel_speed_control", "constant_speed") == "constant_revolutions") {
            const double of = shared.at("wheel").at("diameter_mm");
            const double now = surface.project["wheel"].at("diameter_mm");
            machine["wheel_speed_m_s"] = machine.at("wheel_speed_m_s").get<double>() / of * now;
        }
        surface.result = simulate(surface.project);
        for (const StageSums& stage : surface.result.stages) {
            surface.removed_mm3 += stage.volume_mm3;
        }
        removed_mm3 += surface.removed_mm3;
        const bool plunges = surface.project.at("operation") == "plunge";
        const Real contact = plunges ? surface.project.at("part").at("length_mm").get<double>()
                                     : shared.at("wheel").at("width_mm").get<double>();
        perContact_mm2 += surface.removed_mm3 / contact;
        setup.completed = setup.completed && surface.result.status == "completed";
        setup.surfaces.push_back(surface);
    }
    if (setup.completed) {
        addTimes(file.value("times", json::object()), setup);
    }
    return setup;
}

} // namespace sparkout::reference
