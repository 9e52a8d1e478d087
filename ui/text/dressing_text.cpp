// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/dressing_text.h"

#include "core/project/optimisation.h"
#include "core/quality/requirement.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>

namespace sparkout {

namespace {

QString count(std::int64_t parts) {
    return QLocale().toString(static_cast<qlonglong>(parts));
}

QString amount(const ConstraintResult& worst, double value) {
    const QString unit = unitText(requirementOf(worst.kind).unit);
    constexpr int digits = 4; // shows a wheel that has just become too dull as close to the limit
    const QString number = Names::significant(value, digits);
    return unit.isEmpty() ? number : number + QChar::Nbsp + unit;
}

} // namespace

DressingText::Facts DressingText::facts(const Setup& setup, const DressingInterval& interval) {
    Facts facts{{tr("Parts per dressing"), parts(interval)}};
    if (interval.end) {
        facts.emplace_back(tr("Limited by"), end(setup, *interval.end));
    }
    facts.emplace_back(tr("Removed per part"),
                       tr("%1 mm³").arg(Names::fixed(interval.partVolume_mm3, 0)));
    const Cost* rates = ratesOf(setup);
    const auto quickest = rates ? quickestInterval(interval, rates->dressing_s) : std::nullopt;
    const auto cheapest = rates ? cheapestInterval(interval, *rates) : std::nullopt;
    if (quickest && cheapest) {
        facts.emplace_back(tr("Quickest"),
                           tr("after %1 parts: %2 s a part with its share of the "
                              "dressing")
                               .arg(count(quickest->parts), Names::fixed(quickest->value, 2)));
        facts.emplace_back(tr("Cheapest"),
                           tr("after %1 parts: %2 a part")
                               .arg(count(cheapest->parts), Names::fixed(cheapest->value, 3)));
    }
    return facts;
}

QString DressingText::refusal(const DressingInterval& interval) {
    if (!interval.issues.empty()) {
        return Names::refusal(interval.issues);
    }
    switch (interval.fault) {
    case DressingFault::none: return {};
    case DressingFault::noWear:
        return tr("The wear of the wheel is not given: enter a dulling c or a grinding ratio G.");
    case DressingFault::firstFails: return tr("The first part after dressing does not reach size.");
    }
    return {};
}

QString DressingText::parts(const DressingInterval& interval) {
    if (interval.isEndless) {
        return tr("any number: the wheel does not get duller, and every part is good");
    }
    return interval.end ? count(interval.parts) : tr("at least %1").arg(count(interval.parts));
}

QString DressingText::end(const Setup& setup, const WornFailure& end) {
    const QString surface = QString::fromStdString(setup.surfaces[end.surface].name);
    QString which = tr("part %1").arg(count(end.part));
    if (!surface.isEmpty()) {
        which += QStringLiteral(", ") + printableText(surface);
    }
    if (end.scenario) {
        which += QStringLiteral(", ") + tr("part %1 of its batch").arg(count(*end.scenario + 1));
    }
    if (!end.worst) {
        return end.issues.empty() ? tr("%1: it does not reach size").arg(which)
                                  : tr("%1: %2").arg(which, Names::refusal(end.issues, 1));
    }
    const ConstraintResult& worst = *end.worst;
    return tr("%1: %2, %3: %4, limit %5")
        .arg(which, Names::inSentence(Names::constraint(worst.kind)), Names::where(worst),
             amount(worst, worst.value), amount(worst, worst.limit));
}

} // namespace sparkout
