// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <optional>
#include <string>

namespace sparkout {

/// The display of a number that differs from the file: sections are counted from 0 in files and
/// from 1 on screen and paper; in the inputs, stock may be on the diameter. Other numbers are
/// unchanged.
struct ShownScale {
    double factor = 1;
    double shift = 0; ///< added after the factor

    /// For an input, by its row or its path.
    [[nodiscard]] static ShownScale of(const Field& field);
    [[nodiscard]] static ShownScale at(const std::string& path);
    /// For an input where it is entered, and in its hints and messages.
    [[nodiscard]] static ShownScale ofInput(const Field& field);
    /// For the numbers of a message.
    [[nodiscard]] static ShownScale of(const Issue& issue);

    [[nodiscard]] double shown(double kept) const { return kept * factor + shift; }
    [[nodiscard]] double kept(double shown) const { return (shown - shift) / factor; }
    [[nodiscard]] std::optional<double> shown(const std::optional<double>& kept) const;
    [[nodiscard]] std::optional<double> kept(const std::optional<double>& shown) const;
    [[nodiscard]] Range shown(Range kept) const;
    [[nodiscard]] Detail shown(Detail kept) const; ///< converts only numbers

    friend bool operator==(const ShownScale&, const ShownScale&) = default;
};

} // namespace sparkout
