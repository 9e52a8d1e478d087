// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/limit_series.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace sparkout {

/// A requirement that is not held against anything, and the input that turns it on.
struct OffLimit {
    ConstraintKind kind;
    std::string path;
};

/// Words of the view "Constraints".
class LimitNames {
    Q_DECLARE_TR_FUNCTIONS(LimitNames)
public:
    static QString limit(ConstraintKind kind);     ///< of the feed: "burn", "wheel drive"
    static QString group(const LimitGroup& group); ///< "RZ1, wheel standing"
    static QString percent(double share);          ///< "87 %"; ">999 %"
    /// What is off of the limits of the feed, every cut's first, and of the drawing's tolerances in
    /// the order of their inputs.
    static std::vector<OffLimit> off(const Project& project);
    /// What is off in a sentence, plain, and as rich text whose links are the inputs' paths. Empty:
    /// nothing is off.
    static QString notChecked(const Project& project);
    static QString notCheckedLinks(const Project& project);
    /// Whether the limit of the feed is no number: that of roughness that is not calibrated.
    static bool isGuess(ConstraintKind kind, const Project& project);
    static QString guessed(); ///< the sentence in place of it
    /// notCheckedLinks(), and where roughness is a guess that sentence.
    static QString missingLinks(const Project& project);

private:
    static QString notChecked(const QStringList& names);
};

} // namespace sparkout
