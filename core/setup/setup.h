// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/wheel_wear.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The values shared by all surfaces of a set-up: they appear once in its file, at the path they
/// have in the file of a single surface. All others belong to a surface.

namespace sparkout {

struct Project;
struct Setup;

[[nodiscard]] std::span<const std::string_view> sharedMembers(); ///< as JSON pointers

/// Whether a path names a shared member, or something in one.
[[nodiscard]] bool isShared(std::string_view path);
/// Whether a path names an object that has shared members among others.
[[nodiscard]] bool holdsShared(std::string_view path);

/// Copies the shared values of another project, with their calibrations.
void copyShared(const Project& from, Project& to);
[[nodiscard]] bool haveSameShared(const Project& a, const Project& b);

/// Whether the records of shared inputs are the same.
[[nodiscard]] bool haveSameSharedCalibrations(const Project& a, const Project& b);

/// Returns the factor of Ra that follows from the measured Ra of the wheel, which all surfaces
/// share: by the cycle of the first surface for which it can be computed. Empty if the wheel has a
/// factor already, or if none can be computed.
[[nodiscard]] std::optional<double> factorOfMeasuredRa(const Setup& setup);
/// Gives the wheel of every surface this factor.
void shareMeasuredRa(Setup& setup);

/// Gives every surface the records of shared inputs that hold in one of them.
void shareCalibrations(Setup& setup);

/// The components of the standard times of a set-up. A time given as a total replaces its
/// sum, see PieceTime.
struct SetupTimes {
    double approach_s = 0;               ///< wheel to a surface [s]
    double retreat_s = 0;                ///< wheel from it [s]
    double gauging_s = 0;                ///< measuring a surface after its cycle [s]
    double positioning_s = 0;            ///< table from one surface to the next [s]
    double handling_s = 0;               ///< clamping and taking off a part [s]
    std::optional<double> main_min;      ///< T_o; not given: the cycles' times [min]
    std::optional<double> auxiliary_min; ///< T_a; not given: the sum of the times above [min]
    double service_percent = 0;          ///< share of T_o + T_a for service and rest [%]
    double preparation_min = 0;          ///< T_p, for the batch [min]
    int batch_size = 1;                  ///< number of parts that share it
    std::optional<double> piece_min;     ///< T_1; not given: (T_o + T_a)·(1 + service/100) [min]
    friend bool operator==(const SetupTimes&, const SetupTimes&) = default;
};

template <>
const StructInfo& tableOf<SetupTimes>();

/// The standard times of a part in one set-up, in minutes.
struct PieceTime {
    double main_min = 0;        ///< T_o, as given or the sum of the cycles
    double auxiliary_min = 0;   ///< T_a, as given or n·(approach + retreat + gauging)
                                ///< + (n − 1)·positioning + handling for n surfaces
    double piece_min = 0;       ///< T_1, as given or (T_o + T_a)·(1 + service/100)
    double preparation_min = 0; ///< T_p, as given
    double calculation_min = 0; ///< T_1 + T_p/N, including the part's share of the set-up time
    /// T_1, T_a, one of its times or the service is entered; otherwise T_1 is the time of the
    /// cycles alone.
    bool isPieceEntered = false;
};

/// The time of a piece with this many surfaces whose cycles take `cycles_min` together.
[[nodiscard]] PieceTime pieceTime(const SetupTimes& times, std::size_t surfaces, double cycles_min);

/// One surface of a set-up: the project of its cycle, including what all surfaces share.
struct GroundSurface {
    std::string name; ///< empty in a file with one surface
    Project project;
};

namespace limits {
inline constexpr std::size_t surfaces = 20;
} // namespace limits

/// A part ground in one set-up: its surfaces in the order in which they are ground. They share the
/// part's body and supports, the material, the wheel and the machine.
struct Setup {
    std::vector<GroundSurface> surfaces; ///< at least one
    SetupTimes times;
    WheelWear wear;

    /// Whether it is one surface without a name, times and wear: the contents of a file of version
    /// 1.
    [[nodiscard]] bool isPlain() const;
    /// Finds a surface by its name, otherwise by its number from 1.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view nameOrNumber) const;
};

/// The path of a surface's project in a file of several: "/surfaces/2".
[[nodiscard]] std::string surfacePath(std::size_t surface);

/// The set-up of a file with one surface.
[[nodiscard]] Setup plainSetup(Project project);

/// Faults of the set-up besides those of its projects: ranges of times and wear, names.
[[nodiscard]] Issues checkSetup(const Setup& setup);

} // namespace sparkout
