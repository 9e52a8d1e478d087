// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// Specification of a slider.
struct SliderSpec {
    Range usual;   ///< range of the slider; its value may be outside
    Range allowed; ///< range that the value never leaves
    bool integer = false;
    bool zero = false;          ///< zero can be reached, too
    std::optional<double> step; ///< step of the machine, from usual.low

    friend bool operator==(const SliderSpec&, const SliderSpec&) = default;
};

/// Returns the slider of an input: the usual range, or the machine's range where it states one for
/// a feed or a speed. Zero can be reached where it is allowed.
[[nodiscard]] SliderSpec sliderSpec(const Project& project, const std::string& path,
                                    const Field& field);

/// Positions of values on a slider, and the round values at which it stops, about a hundred over
/// its length. The scale is linear where the range allows, expanded at small values where it begins
/// at zero, logarithmic where it spans more than a factor of twenty.
class SliderScale {
public:
    /// The scale is extended to round ends so that it contains the value.
    explicit SliderScale(const SliderSpec& spec = {}, std::optional<double> value = {});

    [[nodiscard]] double low() const { return m_low; }
    [[nodiscard]] double high() const { return m_high; }
    [[nodiscard]] bool extended() const; ///< returns whether the scale exceeds the usual range
    [[nodiscard]] double shareOf(double value) const; ///< 0 at the low end, 1 at the high one
    [[nodiscard]] double valueAt(double share) const; ///< a round value
    /// Returns the round value this number of steps up or down, as for arrow keys.
    [[nodiscard]] double stepped(double value, int steps) const;
    /// As stepped(), in large steps: ten small ones, on a logarithmic scale 1, 2, 5, 10 …
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
