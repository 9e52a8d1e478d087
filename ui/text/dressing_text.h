// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/dressing_interval.h"

#include <QCoreApplication>
#include <QString>

#include <utility>
#include <vector>

namespace sparkout {

/// Texts about the number of parts between dressings.
class DressingText {
    Q_DECLARE_TR_FUNCTIONS(DressingText)
public:
    using Facts = std::vector<std::pair<QString, QString>>; ///< pairs of a name and its value

    /// Parts, the reason of the end, the removal per part, and with given rates the best intervals.
    static Facts facts(const Setup& setup, const DressingInterval& interval);
    /// The reason why the number is not known; empty if it is.
    static QString refusal(const DressingInterval& interval);
    static QString parts(const DressingInterval& interval); ///< "636", "at least 10000"
    static QString end(const Setup& setup, const WornFailure& end);
};

} // namespace sparkout
