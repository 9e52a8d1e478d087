// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/shared_members.h"

#include "core/format/project_file.h"
#include "core/measured/calibrated_inputs.h"
#include "core/project/card_entries.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/setup/setup.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace sparkout {

namespace {

constexpr std::array<std::string_view, 25> members{"/title",
                                                   "/author",
                                                   "/notes",
                                                   "/coolant",
                                                   "/card",
                                                   "/part/name",
                                                   "/part/shaft/segments",
                                                   "/part/shaft/youngs_modulus_gpa",
                                                   "/part/shaft/mounting",
                                                   "/part/shaft/steady_rests",
                                                   "/part/shaft/quill",
                                                   "/material",
                                                   "/wheel",
                                                   "/machine/name",
                                                   "/machine/wheel_speed_m_s",
                                                   "/machine/wheel_speed_control",
                                                   "/machine/stiffness_n_um",
                                                   "/machine/geometric_runout_um",
                                                   "/machine/gauge_repeatability_um",
                                                   "/machine/gauge_drift_um_h",
                                                   "/machine/wheel_drive_kw",
                                                   "/machine/work_drive_kw",
                                                   "/machine/wheel_contact",
                                                   "/machine/feed_change_delay_s",
                                                   "/machine/limits"};

/// Whether one path is the other, or leads to it.
bool leadsTo(std::string_view path, std::string_view longer) {
    return longer.starts_with(path) && (longer.size() == path.size() || longer[path.size()] == '/');
}

} // namespace

std::span<const std::string_view> sharedMembers() {
    return members;
}

bool isShared(std::string_view path) {
    return std::ranges::any_of(members,
                               [path](std::string_view member) { return leadsTo(member, path); });
}

bool holdsShared(std::string_view path) {
    return !isShared(path) && std::ranges::any_of(members, [path](std::string_view member) {
        return leadsTo(path, member);
    });
}

namespace {

/// A record of `from` replaces an existing one.
void copyCalibrations(const Project& from, Project& to, bool onlyWhereNoneHolds) {
    if (!from.measured) {
        return;
    }
    for (const Calibration& record : from.measured->calibrations) {
        const Calibration* const before = calibrationOf(to, record.input);
        if (!isShared(record.input) || (before && *before == record)
            || (onlyWhereNoneHolds
                && (!hasCalibratedValue(from, record)
                    || (before && hasCalibratedValue(to, *before))))) {
            continue;
        }
        Measured& measured = to.measured ? *to.measured : to.measured.emplace();
        const auto found =
            std::ranges::find(measured.calibrations, record.input, &Calibration::input);
        if (found == measured.calibrations.end()) {
            measured.calibrations.push_back(record);
        } else {
            *found = record;
        }
    }
}

/// The calibrations of shared inputs.
std::vector<Calibration> sharedCalibrations(const Project& project) {
    std::vector<Calibration> records;
    if (project.measured) {
        std::ranges::copy_if(project.measured->calibrations, std::back_inserter(records),
                             [](const Calibration& record) { return isShared(record.input); });
    }
    return records;
}

} // namespace

std::optional<double> factorOfMeasuredRa(const Setup& setup) {
    for (const GroundSurface& surface : setup.surfaces) {
        if (surface.project.wheel->roughness_factor != 1) {
            return std::nullopt;
        }
        if (const std::optional<double> factor = factorOfMeasuredRa(surface.project)) {
            return factor;
        }
    }
    return std::nullopt;
}

void shareMeasuredRa(Setup& setup) {
    if (const std::optional<double> factor = factorOfMeasuredRa(setup)) {
        for (GroundSurface& surface : setup.surfaces) {
            surface.project.wheel->roughness_factor = *factor;
        }
    }
}

void shareCalibrations(Setup& setup) {
    for (GroundSurface& to : setup.surfaces) {
        for (const GroundSurface& from : setup.surfaces) {
            if (&from != &to) {
                copyCalibrations(from.project, to.project, true);
            }
        }
    }
}

void copyShared(const Project& from, Project& to) {
    to.title = from.title;
    to.author = from.author;
    to.notes = from.notes;
    to.coolant = from.coolant;
    *to.card = *from.card;
    to.part->name = from.part->name;
    Shaft& shaft = to.part->shaft;
    const double groundFrom_mm = shaft.ground_from_mm;
    shaft = from.part->shaft;
    shaft.ground_from_mm = groundFrom_mm;
    *to.material = *from.material;
    *to.wheel = *from.wheel;
    Machine& machine = *to.machine;
    const Machine& shared = *from.machine;
    machine.name = shared.name;
    machine.wheel_speed_m_s = shared.wheel_speed_m_s;
    machine.wheel_speed_control = shared.wheel_speed_control;
    machine.stiffness_n_um = shared.stiffness_n_um;
    machine.geometric_runout_um = shared.geometric_runout_um;
    machine.gauge_repeatability_um = shared.gauge_repeatability_um;
    machine.gauge_drift_um_h = shared.gauge_drift_um_h;
    machine.wheel_drive_kw = shared.wheel_drive_kw;
    machine.work_drive_kw = shared.work_drive_kw;
    machine.wheel_contact = shared.wheel_contact;
    machine.feed_change_delay_s = shared.feed_change_delay_s;
    machine.limits = shared.limits;
    copyCalibrations(from, to, false);
}

bool haveSameShared(const Project& a, const Project& b) {
    return firstDifference(
               a, b, [](std::string_view path) { return isShared(path) || holdsShared(path); })
        .empty();
}

bool haveSameSharedCalibrations(const Project& a, const Project& b) {
    return sharedCalibrations(a) == sharedCalibrations(b);
}

} // namespace sparkout
