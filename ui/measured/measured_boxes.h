// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/adequacy.h"
#include "core/project/project.h"
#include "ui/chart/bar_chart.h"
#include "ui/table/value_table.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace sparkout {

/// Measured and predicted parts as boxes, for the views "Measured" and "Overview" and for the
/// passport.
class MeasuredBoxes {
    Q_DECLARE_TR_FUNCTIONS(MeasuredBoxes)
public:
    enum Kind : std::size_t { predictedKind, measuredKind };
    static std::vector<BoxKind> kinds(); ///< kinds of boxes of a chart, in that order

    static std::optional<BarBox> predicted(const PredictedRange& range);
    /// Quartiles of listed parts; for a summary those of a normal distribution with its mean and s.
    static std::optional<BarBox> measured(const MeasuredStatistics& of);
    /// A place as a category, on two lines: "RZ1", then the kind.
    static QString category(const QString& place, Kind kind);
    static QString summaryRemark(); ///< how the box of a summary is computed

    /// One quantity, place by place; empty without data.
    static BarChart chart(const Project& project, const std::vector<AdequacyRow>& rows,
                          MeasuredQuantity quantity);
    /// The quantities with rows.
    static std::vector<MeasuredQuantity> quantities(const std::vector<AdequacyRow>& rows);

private:
    static void addLimits(BarChart& chart, const Project& project, MeasuredQuantity quantity);
};

/// Measured and predicted values: a row for each quantity in a zone or section; copied with all its
/// numbers.
[[nodiscard]] ValueTable adequacyTable(const Project& project,
                                       const std::vector<AdequacyRow>& rows);

} // namespace sparkout
