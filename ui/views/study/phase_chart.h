// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/project/project.h"
#include "ui/chart/line_chart.h"

#include <QCoreApplication>
#include <QString>

#include <memory>
#include <optional>

namespace sparkout {

/// Texts of the sweep view about the check of all stocks.
class PhaseText {
    Q_DECLARE_TR_FUNCTIONS(PhaseText)
public:
    static QString progress(qint64 done, qint64 parts, double left_s);
    static QString counted(const PhaseDecision& decision); ///< number of parts of the range
    static QString undecidable(); ///< under position control, with an alternative
    /// Whether it is fit for every stock, or for which it fails, one line each.
    static QString verdict(const PhaseDecision& decision);
    /// The share of the batch rejected by its stock alone; empty if no law of the batch gives the
    /// stock.
    static QString share(const Project& project, const PhaseDecision& decision);
    /// The result at one stock of the range: steps, time, diameters, whether it is fit.
    static QString stock(const PhaseDecision& decision, double stock_mm);
    static QString steps(const DecidedPiece& decided);        ///< "12 + 5 + 3"
    static QString pieceVerdict(const DecidedPiece& decided); ///< "fit", "unfit: …"
    static QString millimetres(double stock_mm);

    /// Diameters less the nominal one over all zones or sections; empty without diameters.
    static std::optional<DeviationRange> sizes(const PieceEnd& end);

private:
    static QString reason(RunStatus status, const std::optional<ConstraintResult>& worst);
};

/// The result of checking all stocks of a project: an immutable value.
struct PhaseOutcome {
    Project project;
    PhaseDecision decision;
};

using PhaseOutcomePtr = std::shared_ptr<const PhaseOutcome>;

/// Size against stock: the largest and the smallest diameter of all zones or sections over the
/// stock, piece by piece, against the tolerance band; stocks that fail are hatched. Within a piece
/// the diameters are linear in the stock, so the picture is exact.
class PhaseChart {
    Q_DECLARE_TR_FUNCTIONS(PhaseChart)
public:
    enum Key { largestKey, smallestKey, toleranceKey, failsKey, statedKey }; ///< keys of the legend

    static LineChart of(const PhaseOutcomePtr& phases); ///< null: only axes

private:
    static ChartTable table(const PhaseDecision& decision);
};

} // namespace sparkout
