// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/verdict_text.h"

#include "core/units.h"
#include "ui/text/names.h"

#include <QCoreApplication>

namespace sparkout::verdict {

namespace {

struct VerdictText {
    Q_DECLARE_TR_FUNCTIONS(VerdictText)
};

QString minutes(double time_s) {
    return VerdictText::tr("%1 min").arg(Names::significant(time_s / units::secondsPerMinute));
}

} // namespace

/// In seconds first below two minutes, as grinders count a plunge.
QString time(const SimulationResult& result) {
    const QString seconds = Names::significant(result.time_s, 4);
    return result.time_s < shortTime_s
               ? VerdictText::tr("%1 s (%2)").arg(seconds, minutes(result.time_s))
               : VerdictText::tr("%1 (%2 s)").arg(minutes(result.time_s), seconds);
}

QString status(const SimulationResult& result) {
    if (result.status != RunStatus::cannotReachSize && result.status != RunStatus::tooLong) {
        return Names::status(result.status);
    }
    return VerdictText::tr("%1: the gauge reads %2 mm, %3 µm per side remain")
        .arg(Names::status(result.status), Names::millimetres(result.gaugeReading_mm),
             Names::micrometres(result.remainingStock_mm * units::umPerMm));
}

} // namespace sparkout::verdict
