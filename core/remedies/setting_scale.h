// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sparkout {

/// The possible values of a setting, in order: each has a whole number, its place.
class SettingScale {
public:
    /// base + k·step.
    [[nodiscard]] static SettingScale steps(double base, double step);
    /// Positive numbers as people enter them: with two significant digits, three if the first one
    /// is 1, so that a step is at most a twentieth.
    [[nodiscard]] static SettingScale digits();
    /// Times of k whole revolutions [s], with three decimals.
    [[nodiscard]] static SettingScale revolutions(double speed_rpm);

    [[nodiscard]] double at(std::int64_t place) const;
    /// The last place with a value below, and the first with a value above. Values that differ by
    /// rounding count as equal.
    [[nodiscard]] std::int64_t lastBelow(double value) const;
    [[nodiscard]] std::int64_t firstAbove(double value) const;
    /// The last place with a value up to this one, and the first from it on.
    [[nodiscard]] std::int64_t lastUpTo(double value) const { return firstAbove(value) - 1; }
    [[nodiscard]] std::int64_t firstFrom(double value) const { return lastBelow(value) + 1; }

private:
    enum class Kind { steps, digits, revolutions };
    SettingScale(Kind kind, double base, double step) : m_kind(kind), m_base(base), m_step(step) {}

    [[nodiscard]] std::int64_t about(double value) const;

    Kind m_kind;
    double m_base, m_step;
};

} // namespace sparkout
