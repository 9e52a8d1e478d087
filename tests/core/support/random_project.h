// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>

/// A valid, plausible random project in the form of the project file; the same seed gives the same
/// project everywhere. Together the seeds cover every option of the cycle (operation, surface,
/// profiles, gauge rules and positions, both kinds of control, delays, spark-out stages, stocks
/// that do not sum up, limits of practice), with cycles of at most some 300 double strokes or 1500
/// revolutions. Every compliance is given in the project, in "machine" and, for some gauges in a
/// free position, in "gauge".
nlohmann::json randomProject(std::uint64_t seed);

/// The same project with a force that has a threshold, its numbers drawn by the seed too.
nlohmann::json withThreshold(nlohmann::json project, std::uint64_t seed);

/// The same project with a wheel that runs out of true.
nlohmann::json withWheelRunout(nlohmann::json project, std::uint64_t seed);
