// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/handout_step.h"

#include <QCoreApplication>

#include <functional>
#include <optional>
#include <set>
#include <string_view>

namespace sparkout::report {

class Citations;

/// The task of the hand-out, and the inputs for it.
class HandoutTask {
    Q_DECLARE_TR_FUNCTIONS(HandoutTask)
public:
    static Facts header(const Project& project, const QString& file, const QDate& date);
    static QString task(const Outcome& outcome); ///< with the cycle time
    static QString part(const Project& project); ///< the ground part
    /// The inputs in the formulas, and those behind the step's feed and stock.
    static Table inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                        const std::set<QString>& symbols, Citations& citations,
                        const std::function<bool(std::string_view path)>& hides = {});
};

} // namespace sparkout::report
