// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/setup.h"

#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/measured/calibrated_inputs.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/range_check.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr std::array<std::string_view, 27> members{"/title",
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
                                                   "/machine/wheel_head_frequency_hz",
                                                   "/machine/geometric_runout_um",
                                                   "/machine/gauge_repeatability_um",
                                                   "/machine/gauge_drift_um_h",
                                                   "/machine/gauge_delay_s",
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
    machine.wheel_head_frequency_hz = shared.wheel_head_frequency_hz;
    machine.geometric_runout_um = shared.geometric_runout_um;
    machine.gauge_repeatability_um = shared.gauge_repeatability_um;
    machine.gauge_drift_um_h = shared.gauge_drift_um_h;
    machine.gauge_delay_s = shared.gauge_delay_s;
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

template <>
const StructInfo& tableOf<SetupTimes>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            SetupTimes, approach_s, .label = SPARKOUT_NOOP("Input", "Approach"), .unit = "s",
            .hard = {0, 3600},
            .hint = SPARKOUT_NOOP("Input",
                                  "Time of the wheel's approach to a surface, for each surface.")),
        SPARKOUT_FIELD(
            SetupTimes, retreat_s, .label = SPARKOUT_NOOP("Input", "Retreat"), .unit = "s",
            .hard = {0, 3600},
            .hint = SPARKOUT_NOOP("Input",
                                  "Time of the wheel's retreat from a surface, for each surface.")),
        SPARKOUT_FIELD(
            SetupTimes, gauging_s, .label = SPARKOUT_NOOP("Input", "Gauging"), .unit = "s",
            .hard = {0, 3600},
            .hint = SPARKOUT_NOOP("Input",
                                  "Time of gauging a surface after its cycle, for each surface.")),
        SPARKOUT_FIELD(
            SetupTimes, positioning_s, .label = SPARKOUT_NOOP("Input", "Table positioning"),
            .unit = "s", .hard = {0, 3600},
            .hint =
                SPARKOUT_NOOP("Input", "Time of moving the table from one surface to the next.")),
        SPARKOUT_FIELD(SetupTimes, handling_s,
                       .label = SPARKOUT_NOOP("Input", "Loading and unloading"), .unit = "s",
                       .hard = {0, 36000},
                       .hint = SPARKOUT_NOOP("Input", "Clamping a part and taking it off.")),
        SPARKOUT_FIELD(SetupTimes, main_min, .label = SPARKOUT_NOOP("Input", "Main time"),
                       .symbol = SPARKOUT_NOOP("Input", "T_o"), .unit = "min", .hard = {0, 100000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "the sum of the cycles"),
                       .hint = SPARKOUT_NOOP("Input", "Time in which stock is removed.")),
        SPARKOUT_FIELD(
            SetupTimes, auxiliary_min, .label = SPARKOUT_NOOP("Input", "Auxiliary time"),
            .symbol = SPARKOUT_NOOP("Input", "T_a"), .unit = "min", .hard = {0, 100000},
            .nullMeaning = SPARKOUT_NOOP("Input", "the sum of the times above"),
            .hint = SPARKOUT_NOOP("Input", "Work done for every part besides the cycles."),
            .formula = SPARKOUT_NOOP(
                "Input", "n·(approach + retreat + gauging) + (n − 1)·positioning + handling"),
            .source = "MODEL-12"),
        SPARKOUT_FIELD(SetupTimes, service_percent,
                       .label = SPARKOUT_NOOP("Input", "Service and rest"), .unit = "%",
                       .hard = {0, 100}, .soft = {0, 30},
                       .hint = SPARKOUT_NOOP("Input", "Serving the machine, and rest, as a share "
                                                      "of main and auxiliary time.")),
        SPARKOUT_FIELD(SetupTimes, preparation_min,
                       .label = SPARKOUT_NOOP("Input", "Preparation time"),
                       .symbol = SPARKOUT_NOOP("Input", "T_p"), .unit = "min", .hard = {0, 100000},
                       .hint = SPARKOUT_NOOP("Input", "Preparing the machine for a batch and "
                                                      "clearing it afterwards.")),
        SPARKOUT_FIELD(SetupTimes, batch_size, .label = SPARKOUT_NOOP("Input", "Batch size"),
                       .symbol = "N", .hard = {1, 10000000},
                       .hint = SPARKOUT_NOOP("Input", "Parts that share the preparation time.")),
        SPARKOUT_FIELD(SetupTimes, piece_min, .label = SPARKOUT_NOOP("Input", "Piece time"),
                       .symbol = SPARKOUT_NOOP("Input", "T_1"), .unit = "min", .hard = {0, 100000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "from the times above"),
                       .hint = SPARKOUT_NOOP("Input", "The time that a part takes, without its "
                                                      "share of the preparation."),
                       .formula = SPARKOUT_NOOP("Input", "(T_o + T_a)·(1 + service/100)"),
                       .source = "MODEL-12"),
    };
    static const StructInfo info =
        makeTable<SetupTimes>(SPARKOUT_NOOP("Struct", "Standard times"), rows);
    return info;
}

PieceTime pieceTime(const SetupTimes& times, std::size_t surfaces, double cycles_min) {
    const auto n = static_cast<double>(surfaces);
    const double auxiliary_s = n * (times.approach_s + times.retreat_s + times.gauging_s)
                               + (n - 1) * times.positioning_s + times.handling_s;
    PieceTime piece;
    piece.main_min = times.main_min.value_or(cycles_min);
    piece.auxiliary_min = times.auxiliary_min.value_or(auxiliary_s / units::secondsPerMinute);
    piece.piece_min = times.piece_min.value_or((piece.main_min + piece.auxiliary_min)
                                               * (1 + times.service_percent / 100));
    piece.preparation_min = times.preparation_min;
    piece.isPieceEntered =
        times.piece_min || times.auxiliary_min || auxiliary_s > 0 || times.service_percent > 0;
    piece.calculation_min = piece.piece_min + times.preparation_min / times.batch_size;
    return piece;
}

bool Setup::isPlain() const {
    const auto isDefault = [](const StructInfo& table, const void* owner) {
        return writeByTable(table, owner) == writeByTable(table, table.defaults);
    };
    return surfaces.size() == 1 && surfaces.front().name.empty()
           && isDefault(tableOf<SetupTimes>(), &times) && isDefault(tableOf<WheelWear>(), &wear);
}

std::optional<std::size_t> Setup::find(std::string_view nameOrNumber) const {
    const auto named = std::ranges::find(surfaces, nameOrNumber, &GroundSurface::name);
    if (named != surfaces.end()) {
        return static_cast<std::size_t>(named - surfaces.begin());
    }
    std::size_t number = 0;
    const char* const last = nameOrNumber.data() + nameOrNumber.size();
    const auto [end, error] = std::from_chars(nameOrNumber.data(), last, number);
    const bool isNumber = error == std::errc() && end == last;
    return isNumber && number >= 1 && number <= surfaces.size() ? std::optional(number - 1)
                                                                : std::nullopt;
}

std::string surfacePath(std::size_t surface) {
    return "/surfaces/" + std::to_string(surface);
}

Setup plainSetup(Project project) {
    Setup setup;
    setup.surfaces.push_back({{}, std::move(project)});
    return setup;
}

Issues checkSetup(const Setup& setup) {
    Issues issues = checkRanges(tableOf<SetupTimes>(), &setup.times, "/times");
    const Issues wear = checkRanges(tableOf<WheelWear>(), &setup.wear, "/wear");
    issues.insert(issues.end(), wear.begin(), wear.end());
    if (setup.surfaces.size() < 2) {
        return issues; // the name does not matter
    }
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const std::string& name = setup.surfaces[i].name;
        const std::string path = "/surfaces/" + std::to_string(i) + "/name";
        const auto first = std::ranges::find(setup.surfaces, name, &GroundSurface::name);
        const auto at = static_cast<std::size_t>(first - setup.surfaces.begin());
        if (name.empty()) {
            issues.push_back({IssueCode::missingKey, Severity::error, path, {}, Phrase::text});
        } else if (at < i) {
            issues.push_back({IssueCode::sameName, Severity::error, path,
                              quoted(nlohmann::json(name)), countOf(at + 1)});
        }
    }
    return issues;
}

} // namespace sparkout
