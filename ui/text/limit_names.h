// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/limit_series.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace sparkout {

/// A requirement without a limit, and the input that sets it.
struct OffLimit {
    ConstraintKind kind;
    std::string path;
};

/// Texts of the view "Constraints".
class LimitNames {
    Q_DECLARE_TR_FUNCTIONS(LimitNames)
public:
    static QString limit(ConstraintKind kind);     ///< limit of the feed: "burn", "wheel drive"
    static QString group(const LimitGroup& group); ///< "RZ1, wheel standing"
    static QString percent(double share);          ///< "87 %"; ">999 %"
    /// The limits of the feed that are off, those of every cut first, and the drawing's tolerances
    /// that are off, in the order of their inputs.
    static std::vector<OffLimit> off(const Project& project);
    /// A sentence on the limits that are off, plain or as rich text with links to the inputs. Empty
    /// if none is off.
    static QString notChecked(const Project& project);
    static QString notCheckedLinks(const Project& project);
    /// Whether the limit of the feed has no definite value: roughness that is not calibrated.
    static bool isGuess(ConstraintKind kind, const Project& project);
    static QString guessed(); ///< text shown instead
    /// notCheckedLinks(), plus guessed() if roughness is not calibrated.
    static QString missingLinks(const Project& project);

private:
    static QString notChecked(const QStringList& names);
};

} // namespace sparkout
