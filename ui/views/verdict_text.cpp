// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict_text.h"

#include "core/units.h"
#include "ui/session/texts.h"
#include "ui/views/names.h"

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
    const QString zone = Names::zone(c.zone, c.section);
    const QString by = Names::micrometres(std::abs(c.margin));
    switch (c.kind) {
    case ConstraintKind::diameterMin:
        return tr("diameter in %1 is %2 µm below the lower limit").arg(zone, by);
    case ConstraintKind::diameterMax:
        return tr("diameter in %1 is %2 µm above the upper limit").arg(zone, by);
    case ConstraintKind::radialRunout:
        return tr("radial runout in %1 is %2 µm above its limit").arg(zone, by);
    }
    return {};
}

const ConstraintResult* worst(const std::vector<ConstraintResult>& constraints) {
    const auto it = std::ranges::min_element(constraints, {}, [](const ConstraintResult& c) {
        return std::pair(c.holds, c.relativeMargin);
    });
    return it == constraints.end() ? nullptr : &*it;
}

QString minutes(double time_s) {
    return VerdictText::tr("%1 min").arg(Names::significant(time_s / units::secondsPerMinute));
}

} // namespace

QString time(const SimulationResult& result) {
    return VerdictText::tr("%1 (%2 s)")
        .arg(minutes(result.time_s), Names::significant(result.time_s, 4));
}

QString status(const SimulationResult& result) {
    if (result.status != RunStatus::cannotReachSize && result.status != RunStatus::tooLong) {
        return Names::status(result.status);
    }
    return VerdictText::tr("%1: the gauge reads %2 mm, %3 µm a side remain")
        .arg(Names::status(result.status), Names::millimetres(result.gaugeReading_mm),
             Names::micrometres(result.remainingStock_mm * units::umPerMm));
}

QString unchecked(const SimulationResult& result) {
    QStringList names;
    for (const Field* field : uncheckedRequirements(result.project)) {
        names << inputText(field->label);
    }
    return names.isEmpty() ? QString()
                           : VerdictText::tr("Given, but not checked: %1")
                                 .arg(names.join(QStringLiteral(", ")));
}

Light overallLight(const Outcome& outcome) {
    const ConstraintResult* c = worst(outcome.constraints);
    if (outcome.result.status != RunStatus::completed || (c && !c->holds)) {
        return Light::fails;
    }
    const bool close = std::ranges::any_of(
        outcome.constraints, [](const ConstraintResult& r) { return lightOf(r) == Light::close; });
    return close ? Light::close : Light::holds;
}

QString overall(const Outcome& outcome) {
    const ConstraintResult* c = worst(outcome.constraints);
    if (c && !c->holds) {
        const auto failing =
            std::ranges::count(outcome.constraints, false, &ConstraintResult::holds);
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
        return VerdictText::tr("Holds the drawing, but close to the limit: %1 in %2")
            .arg(Names::constraint(c->kind), Names::zone(c->zone, c->section));
    }
    return VerdictText::tr("Holds the drawing");
}

} // namespace sparkout::verdict
