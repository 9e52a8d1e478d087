// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup_file.h"
#include "tests/core/support/random_project.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>

/// Files of set-ups put together by hand from files of single surfaces.
namespace sparkout::setup_samples {

/// Where the file of several surfaces has what they share: once, at its top.
inline const char* const sharedPlaces[] = {"/title",
                                           "/author",
                                           "/notes",
                                           "/coolant",
                                           "/card",
                                           "/material",
                                           "/wheel",
                                           "/part/name",
                                           "/part/shaft/segments",
                                           "/part/shaft/youngs_modulus_gpa",
                                           "/part/shaft/mounting",
                                           "/part/shaft/steady_rests",
                                           "/part/shaft/quill",
                                           "/machine/name",
                                           "/machine/wheel_speed_m_s",
                                           "/machine/wheel_speed_control",
                                           "/machine/stiffness_n_um",
                                           "/machine/wheel_head_frequency_hz",
                                           "/machine/geometric_runout_um",
                                           "/machine/wheel_drive_kw",
                                           "/machine/work_drive_kw",
                                           "/machine/wheel_contact",
                                           "/machine/feed_change_delay_s",
                                           "/machine/limits"};

inline void move(nlohmann::json& from, const nlohmann::json::json_pointer& place,
                 nlohmann::json* to) {
    if (!from.contains(place)) {
        return;
    }
    if (to) {
        (*to)[place] = from.at(place);
    }
    from.at(place.parent_pointer()).erase(place.back());
}

/// The first project gives what is shared; of the others only what is their own remains.
inline nlohmann::json setupOf(const std::vector<nlohmann::json>& projects) {
    nlohmann::json file = {{"format", "sparkout-project"}, {"version", 2}};
    for (std::size_t i = 0; i < projects.size(); ++i) {
        nlohmann::json own = projects[i];
        own.erase("format");
        own.erase("version");
        for (const char* place : sharedPlaces) {
            move(own, nlohmann::json::json_pointer(place), i == 0 ? &file : nullptr);
        }
        own["name"] = "surface " + std::string(1, static_cast<char>('A' + i));
        file["surfaces"].push_back(std::move(own));
    }
    return file;
}

/// Random surfaces that fit what they share.
inline std::optional<sparkout::Setup> randomSetup(std::uint64_t seed) {
    std::vector<nlohmann::json> projects;
    for (std::uint64_t i = 0; i < 1 + seed % 4; ++i) {
        projects.push_back(randomProject(seed * 7 + i));
    }
    return sparkout::readSetup(setupOf(projects).dump()).setup;
}

} // namespace sparkout::setup_samples
