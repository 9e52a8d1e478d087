// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <optional>
#include <string>

namespace sparkout {

/// How a number reads in the window and on paper where the file has another: sections are counted
/// from 0 in files and from 1 by people. In the inputs, stock may read on the diameter. Numbers of
/// other inputs read as they are.
struct ShownScale {
    double factor = 1;
    double shift = 0; ///< after the factor

    /// Of an input, by its row or its path.
    [[nodiscard]] static ShownScale of(const Field& field);
    [[nodiscard]] static ShownScale at(const std::string& path);
    /// Of an input where it is entered, in its hints and messages.
    [[nodiscard]] static ShownScale ofInput(const Field& field);
    /// Of the numbers of a message.
    [[nodiscard]] static ShownScale of(const Issue& issue);

    [[nodiscard]] double shown(double kept) const { return kept * factor + shift; }
    [[nodiscard]] double kept(double shown) const { return (shown - shift) / factor; }
    [[nodiscard]] std::optional<double> shown(const std::optional<double>& kept) const;
    [[nodiscard]] std::optional<double> kept(const std::optional<double>& shown) const;
    [[nodiscard]] Range shown(Range kept) const;
    [[nodiscard]] Detail shown(Detail kept) const; ///< of a message: its numbers, nothing else

    friend bool operator==(const ShownScale&, const ShownScale&) = default;
};

} // namespace sparkout
