// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/shop_numbers.h"

#include <QString>
#include <QStringList>

namespace sparkout {

/// The rows of the table of the shop's numbers.
enum class ShopRow {
    count,
    time,
    removalRate,
    meanRemovalRate,
    chip,
    aggressiveness,
    overlap,
    energy,
    peakPower,
    meanPower,
    normalForce,
    rotationRatio
};

} // namespace sparkout

/// The words and numbers of that table, plain text.
namespace sparkout::shop {

[[nodiscard]] QString label(ShopRow row, Operation operation); ///< short, as read in its place
[[nodiscard]] QString name(ShopRow row, Operation operation);  ///< the same standing alone
[[nodiscard]] QString hint(ShopRow row);                       ///< formula, meaning, usual band

/// Three significant digits, three decimals at most, but one digit always. 0 for what is not
/// positive.
[[nodiscard]] QString number(double value);
/// The number of a stage, or of the cycle, in the unit of its name; nothing where there is none.
/// Not the rotation ratio.
[[nodiscard]] std::optional<double> amount(ShopRow row, const ShopColumn& column);
/// The same as a text.
[[nodiscard]] QString value(ShopRow row, const ShopColumn& column);
/// Where a peak was or what a number is made of; empty for most.
[[nodiscard]] QString detail(ShopRow row, const ShopColumn& column, Operation operation);
[[nodiscard]] BandSide band(ShopRow row, const ShopColumn& column);

/// What lies outside its band and what that means, a sentence each.
[[nodiscard]] QStringList remarks(const ShopNumbers& shop);

} // namespace sparkout::shop
