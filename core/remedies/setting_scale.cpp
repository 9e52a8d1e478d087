// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remedies/setting_scale.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

// For a decade: 1.00 to 1.99, then 2.0 to 9.9.
constexpr std::int64_t fine = 100, perDecade = 180;

/// Relative difference below which two values count as equal.
constexpr double lastBits = 1e-9;

/// The double nearest to m·10^exponent.
double decimal(std::int64_t m, std::int64_t exponent) {
    const double power = std::pow(10.0, static_cast<double>(std::abs(exponent)));
    const auto mantissa = static_cast<double>(m);
    return exponent < 0 ? mantissa / power : mantissa * power;
}

double slackAt(double value) {
    return lastBits * std::max(std::abs(value), 1e-9);
}

} // namespace

SettingScale SettingScale::steps(double base, double step) {
    return {Kind::steps, base, step};
}

SettingScale SettingScale::digits() {
    return {Kind::digits, 0, 0};
}

SettingScale SettingScale::revolutions(double speed_rpm) {
    return {Kind::revolutions, 0, units::secondsPerMinute / speed_rpm};
}

double SettingScale::at(std::int64_t place) const {
    if (m_kind == Kind::digits) {
        const std::int64_t rest = (place % perDecade + perDecade) % perDecade;
        const std::int64_t decade = (place - rest) / perDecade;
        return rest < fine ? decimal(fine + rest, decade - 2)
                           : decimal(20 + rest - fine, decade - 1);
    }
    const double value = m_base + static_cast<double>(place) * m_step;
    const double decimals = m_kind == Kind::revolutions ? 1e3 : 1e10;
    return std::round(value * decimals) / decimals;
}

std::int64_t SettingScale::about(double value) const {
    if (m_kind != Kind::digits) {
        return std::llround((value - m_base) / m_step);
    }
    const double decade = std::floor(std::log10(value));
    const double leading = value / std::pow(10.0, decade);
    const double rest = leading < 2 ? (leading - 1) * 100 : 100 + (leading - 2) * 10;
    return static_cast<std::int64_t>(decade) * perDecade + std::llround(rest);
}

std::int64_t SettingScale::lastBelow(double value) const {
    std::int64_t place = about(value) + 1;
    while (at(place) >= value - slackAt(value)) {
        --place;
    }
    return place;
}

std::int64_t SettingScale::firstAbove(double value) const {
    std::int64_t place = about(value) - 1;
    while (at(place) <= value + slackAt(value)) {
        ++place;
    }
    return place;
}

} // namespace sparkout
