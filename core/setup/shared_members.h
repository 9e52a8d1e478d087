// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

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

} // namespace sparkout
