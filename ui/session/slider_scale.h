// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// What a slider is made for.
struct SliderSpec {
    Range usual;   ///< what it spans; the value it holds may lie outside
    Range allowed; ///< what it never leaves
    bool integer = false;
    bool zero = false;          ///< zero is to be reached, too
    std::optional<double> step; ///< of the machine; counted from usual.low

    friend bool operator==(const SliderSpec&, const SliderSpec&) = default;
};

/// The slider of an input: the usual range, or the machine's own where it states one for a feed or
/// a speed. Zero is reached where it is allowed.
[[nodiscard]] SliderSpec sliderSpec(const Project& project, const std::string& path,
                                    const Field& field);

/// Where a value stands on a slider, and at which values the slider stops: round ones, about a
/// hundred over its length. Even where the range allows, wider to small values where it begins at
/// zero, logarithmic where it spans more than a factor of twenty.
class SliderScale {
public:
    /// The scale extends, to round ends, to hold the value.
    explicit SliderScale(const SliderSpec& spec = {}, std::optional<double> value = {});

    [[nodiscard]] double low() const { return m_low; }
    [[nodiscard]] double high() const { return m_high; }
    [[nodiscard]] bool extended() const;              ///< beyond the usual range
    [[nodiscard]] double shareOf(double value) const; ///< 0 at the low end, 1 at the high one
    [[nodiscard]] double valueAt(double share) const; ///< a round value
    /// The round value so many steps up or down, as arrow keys go.
    [[nodiscard]] double stepped(double value, int steps) const;
    /// The same in great steps: ten of the small ones, on a logarithmic scale 1, 2, 5, 10 …
    [[nodiscard]] double leapt(double value, int leaps) const;

private:
    enum class Kind { even, fromZero, logarithmic };

    [[nodiscard]] double slopeAt(double value) const; ///< d value / d share
    [[nodiscard]] double stepAt(double value) const;
    void findStops();

    SliderSpec m_spec;
    double m_low = 0;
    double m_high = 1;
    Kind m_kind = Kind::even;
    std::vector<double> m_stops; ///< rising
};

} // namespace sparkout
