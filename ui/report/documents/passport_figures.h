// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/study/outcome.h"
#include "ui/report/format/report.h"
#include "ui/views/overview/overview_charts.h"

#include <QCoreApplication>

#include <optional>
#include <string>

namespace sparkout::report {

/// The figures of the accuracy passport, drawn in the window's thread.
class PassportFigures {
    Q_DECLARE_TR_FUNCTIONS(PassportFigures)
public:
    static Figure histograms(const BatchSummary& summary, const std::string& name);
    static Figure alongThePart(const Outcome& outcome);
    static Figure crossSections(const Outcome& outcome);
    /// A chart of the overview; empty without data.
    static std::optional<Figure> bars(OverviewChart which, BarChart chart);
    static std::optional<Figure> bars(const QString& name, BarChart chart); ///< for any other chart
};

} // namespace sparkout::report
