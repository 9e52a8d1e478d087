// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/citations.h"
#include "ui/report/handout/handout_step.h"

#include <QCoreApplication>

#include <functional>
#include <optional>
#include <set>
#include <string_view>

namespace sparkout::report {

/// What the hand-out sets its readers to do, and the inputs they do it with.
class HandoutTask {
    Q_DECLARE_TR_FUNCTIONS(HandoutTask)
public:
    static Facts header(const Project& project, const QString& file, const QDate& date);
    static QString task(const Outcome& outcome); ///< with the time the cycle takes
    static QString part(const Project& project); ///< what is ground
    /// Those that stand in the formulas, and what the step's feed and stock come from.
    static Table inputs(const Outcome& outcome, const std::optional<HandoutStep>& step,
                        const std::set<QString>& symbols, Citations& citations,
                        const std::function<bool(std::string_view path)>& hides = {});
};

} // namespace sparkout::report
