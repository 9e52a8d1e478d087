// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/verdict_text.h"

#include "core/units.h"
#include "ui/charts/verdict_why.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace sparkout::verdict {

namespace {

struct VerdictText {
    Q_DECLARE_TR_FUNCTIONS(VerdictText)
public:
    static QString broken(const ConstraintResult& c);
};

QString VerdictText::broken(const ConstraintResult& c) {
    const QString zone = Names::within(Names::where(c));
    const QString by = Names::amount(c.kind, std::abs(c.margin), false);
    const Requirement& row = requirementOf(c.kind);
    if (row.broken) {
        return requirementText(row.broken)
            .replace(QStringLiteral("%1"), zone)
            .replace(QStringLiteral("%2"), by)
            .replace(QStringLiteral("%3"), Names::value(c));
    }
    if (row.scope == ConstraintScope::setting) {
        return tr("%1 (%2): %3 %4 outside")
            .arg(Names::constraint(c.kind), zone, by, unitText(row.unit));
    }
    return tr("%1 (%2): %3 %4 above its limit")
        .arg(Names::constraint(c.kind), zone, by, unitText(row.unit));
}

QString minutes(double time_s) {
    return VerdictText::tr("%1 min").arg(Names::significant(time_s / units::secondsPerMinute));
}

} // namespace

/// Below two minutes in seconds first, as a grinder counts a plunge.
QString time(const SimulationResult& result) {
    constexpr double short_s = 120;
    const QString seconds = Names::significant(result.time_s, 4);
    return result.time_s < short_s
               ? VerdictText::tr("%1 s (%2)").arg(seconds, minutes(result.time_s))
               : VerdictText::tr("%1 (%2 s)").arg(minutes(result.time_s), seconds);
}

QString status(const SimulationResult& result) {
    if (result.status != RunStatus::cannotReachSize && result.status != RunStatus::tooLong) {
        return Names::status(result.status);
    }
    return VerdictText::tr("%1: the gauge reads %2 mm, %3 µm a side remain")
        .arg(Names::status(result.status), Names::millimetres(result.gaugeReading_mm),
             Names::micrometres(result.remainingStock_mm * units::umPerMm));
}

Light overallLight(const Outcome& outcome) {
    return verdictOf(outcome.result.status, outcome.constraints);
}

QString overall(const Outcome& outcome) {
    const ConstraintResult* c = worst(outcome);
    if (c && !c->holds) {
        const auto failing = std::ranges::count_if(
            outcome.constraints, [](const ConstraintResult& r) { return !r.holds && r.isWhole; });
        QString text = VerdictText::tr("Does not hold: %1").arg(VerdictText::broken(*c));
        if (failing > 1) {
            text += VerdictText::tr("; requirements that fail: %1").arg(failing);
        }
        return text;
    }
    if (outcome.result.status != RunStatus::completed) {
        return VerdictText::tr("Does not hold: the cycle does not end by itself");
    }
    if (!c) {
        return VerdictText::tr("The drawing requires nothing");
    }
    if (overallLight(outcome) == Light::close) {
        return VerdictText::tr("Meets the drawing, but close to the limit: %1 in %2")
            .arg(Names::constraint(c->kind), Names::within(Names::where(*c)));
    }
    return VerdictText::tr("Meets the drawing");
}

} // namespace sparkout::verdict
