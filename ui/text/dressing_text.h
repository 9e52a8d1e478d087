// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/dressing_interval.h"

#include <QCoreApplication>
#include <QString>

#include <utility>
#include <vector>

namespace sparkout {

/// What is known of the parts between dressings, in words.
class DressingText {
    Q_DECLARE_TR_FUNCTIONS(DressingText)
public:
    using Facts = std::vector<std::pair<QString, QString>>; ///< of a name and its value

    /// Parts, what ends them, what a part removes, and with rates the best intervals.
    static Facts facts(const Setup& setup, const DressingInterval& interval);
    /// Why nothing is known; empty: something is.
    static QString refusal(const DressingInterval& interval);
    static QString parts(const DressingInterval& interval); ///< "636", "at least 10000"
    static QString end(const Setup& setup, const WornFailure& end);
};

} // namespace sparkout
