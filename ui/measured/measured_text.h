// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/adequacy.h"
#include "core/measured/hold_out.h"
#include "core/measured/measured_table.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <vector>

namespace sparkout {

/// Measured values and their comparison with the model, in the current language.
class MeasuredText {
    Q_DECLARE_TR_FUNCTIONS(MeasuredText)
public:
    static QString quantity(MeasuredQuantity quantity); ///< "Roundness"
    static QString trace(TraceQuantity quantity);       ///< "Wheel power"
    static QString place(const Project& project, int place);
    static QString brief(MeasuredQuantity quantity);                           ///< "Diameter"
    static QString name(const Project& project, const MeasuredStatistics& of); ///< brief, place

    static QString column(ColumnQuantity quantity); ///< contents of a column
    static QString unit(ColumnUnit unit);           ///< "mm"; a dash for none
    static QString fault(const CellFault& fault);   ///< "Line 3, column 2: …"

    // A value of a comparison for tables; a dash if it is missing.
    static QString value(double value_um, MeasuredQuantity quantity);
    static QString width(double width_um, MeasuredQuantity quantity); ///< width of an interval
    static QString mean(const AdequacyRow& row);
    static QString bias(const AdequacyRow& row); ///< "−0.7 ± 0.5 (1.6)"
    static QString predicted(const Project& project, const AdequacyRow& row);
    static QString scatter(const AdequacyRow& row); ///< F with its bounds by chance
    static QString share(const AdequacyRow& row);
    static QString verdict(AdequacyVerdict verdict);
    static QString briefVerdict(AdequacyVerdict verdict); ///< a word or two
    /// The overall judgement, in sentences: the finding, the quantities, the consequence.
    static QStringList judgement(const Project& project, const std::vector<AdequacyRow>& rows);

    /// A sentence for each comparison with a trace that no calibration used.
    static QStringList holdOut(const Project& project, const std::vector<HoldOutRow>& rows);

private:
    static QStringList where(const std::vector<AdequacyRow>& rows); ///< other possible causes
    /// "Diameter: RZ1, NZ; Ra: RZ1".
    static QString listed(const Project& project, const std::vector<AdequacyRow>& rows,
                          AdequacyVerdict verdict);
    static QString consequence(const std::vector<AdequacyRow>& rows, AdequacyVerdict verdict);
};

} // namespace sparkout
