// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/project/project.h"

#include <QCoreApplication>
#include <QString>

#include <optional>

namespace sparkout {

/// What the view of sweeps says of the phases of the stock.
class PhaseText {
    Q_DECLARE_TR_FUNCTIONS(PhaseText)
public:
    static QString progress(qint64 done, qint64 parts, double left_s);
    static QString counted(const PhaseDecision& decision); ///< how many pieces
    static QString undecidable(); ///< under position control, and what can be done instead
    /// That it holds for every stock, or for which it fails, a line for what fails.
    static QString verdict(const PhaseDecision& decision);
    /// What of the batch fails by its stock alone; empty where no law of it gives the stock.
    static QString share(const Project& project, const PhaseDecision& decision);
    /// Of one stock of the range: steps, time, diameters, whether it holds.
    static QString stock(const PhaseDecision& decision, double stock_mm);
    static QString steps(const DecidedPiece& decided);        ///< "12 + 5 + 3"
    static QString pieceVerdict(const DecidedPiece& decided); ///< "fit", "unfit: …"
    static QString millimetres(double stock_mm);

    /// Diameters less the nominal one over all zones or sections; nothing where there are none.
    static std::optional<DeviationRange> sizes(const PieceEnd& end);

private:
    static QString reason(RunStatus status, const std::optional<ConstraintResult>& worst);
};

} // namespace sparkout
