// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/handout_step.h"
#include "ui/report/handout/handout_view.h"

#include <QCoreApplication>

#include <functional>
#include <optional>
#include <set>

namespace sparkout::report {

/// The figures of the hand-out, drawn in the window's thread.
class HandoutFigures {
    Q_DECLARE_TR_FUNCTIONS(HandoutFigures)
public:
    static std::vector<Block> figures(const OutcomePtr& outcome,
                                      const std::optional<HandoutStep>& step,
                                      const std::set<HandoutView>& views,
                                      const std::function<void()>& breathe);

private:
    /// The double stroke of the step, or the revolutions around it.
    static std::optional<Figure> feedsAround(const OutcomePtr& outcome, const HandoutStep& step);
};

} // namespace sparkout::report
