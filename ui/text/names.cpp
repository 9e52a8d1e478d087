// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/names.h"

#include "core/digits.h"
#include "core/project/member.h"
#include "core/quality/ranges.h"
#include "core/quality/verdict.h"
#include "core/units.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

/// The current locale without group separators, which another language reads as decimal ones.
QLocale numbers() {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

constexpr double roundOff = 1e-12; // rounding error of a difference, relative to its operands
constexpr double leastPlain = 1e-7, mostPlain = 1e15; // outside them a power of ten is used

QString withoutZeros(QString text) {
    while (text.contains(numbers().decimalPoint()) && !text.contains(u'·')
           && (text.endsWith(u'0') || !text.back().isDigit())) {
        text.chop(1);
    }
    return text;
}

} // namespace

QString Names::zone(Zone zone, int section) {
    switch (zone) {
    case Zone::rz1: return tr("RZ1", "entry reversal zone, short");
    case Zone::nz: return tr("NZ", "zone between reversals, short");
    case Zone::rz2: return tr("RZ2", "exit reversal zone, short");
    case Zone::section: break;
    }
    return tr("Section %1").arg(section + 1);
}

QString Names::zoneFull(Zone zone, int section) {
    switch (zone) {
    case Zone::rz1: return tr("Entry reversal zone RZ1");
    case Zone::nz: return tr("Zone between reversals NZ");
    case Zone::rz2: return tr("Exit reversal zone RZ2");
    case Zone::section: break;
    }
    return tr("Section %1").arg(section + 1);
}

QString Names::part(std::int64_t part) {
    return QString::number(part + 1);
}

QString Names::step(Step step) {
    return step == Step::none ? QString()
                              : tr("E%1", "step of a double stroke").arg(static_cast<int>(step));
}

QString Names::stepMeaning(Zone zone, Step step) {
    switch (strokeStep(zone, step)) {
    case StrokeStep::plungeIn: return tr("plunge-in");
    case StrokeStep::entryDwell: return tr("entry dwell");
    case StrokeStep::workingStroke: return tr("working stroke");
    case StrokeStep::exitPlungeIn: return tr("plunge-in at the exit");
    case StrokeStep::exitDwell: return tr("exit dwell");
    case StrokeStep::returnStroke: return tr("return stroke");
    case StrokeStep::dwellAfterReturn: return tr("dwell after return");
    case StrokeStep::none: break;
    }
    return {};
}

QString Names::moment(Operation operation, int stroke, int count, bool strokeDone) {
    if (stroke == 0) {
        return tr("Before the first touch");
    }
    const bool strokes = operation->travels;
    const QString text =
        strokeDone
            ? (strokes ? tr("After double stroke %1 of %2") : tr("After revolution %1 of %2"))
            : (strokes ? tr("Within double stroke %1 of %2") : tr("Within revolution %1 of %2"));
    return text.arg(stroke).arg(count);
}

QString Names::place(const Place& place, Operation operation) {
    QStringList parts{zone(place.zone, place.section)};
    if (place.step != Step::none) {
        parts << QStringLiteral("%1 (%2)").arg(stepMeaning(place.zone, place.step),
                                               step(place.step));
    }
    parts << tr("stage %1").arg(place.stage);
    parts << (operation->travels ? tr("double stroke %1").arg(place.cycleCount)
                                 : tr("revolution %1").arg(place.cycleCount));
    return parts.join(QStringLiteral(", "));
}

QString Names::moment(const Place& place, Operation operation) {
    QStringList parts;
    if (place.step != Step::none) {
        parts << stepMeaning(place.zone, place.step);
    }
    parts << tr("stage %1").arg(place.stage);
    parts << (operation->travels ? tr("double stroke %1", "short").arg(place.cycleCount)
                                 : tr("revolution %1").arg(place.cycleCount));
    return parts.join(QStringLiteral(", "));
}

QString Names::status(RunStatus status) {
    switch (status) {
    case RunStatus::completed: return tr("Completed");
    case RunStatus::cannotReachSize: return tr("Cannot reach size");
    case RunStatus::tooLong: return tr("Too long: the run was ended");
    case RunStatus::stopped: return tr("Stopped");
    case RunStatus::notSolved: return tr("The balance of forces was not solved");
    case RunStatus::groundAway: return tr("The part is ground away");
    case RunStatus::refused: return tr("The inputs are refused");
    }
    return {};
}

QString Names::constraint(ConstraintKind kind) {
    return requirementText(requirementOf(kind).label);
}

QString Names::constraintBrief(ConstraintKind kind) {
    return QCoreApplication::translate("RequirementBrief", requirementOf(kind).brief);
}

QString Names::inSentence(QString name) {
    const QString word = name.section(u' ', 0, 0);
    const bool isIndex = word == u"Ppk" || word == u"Cpk"; // of capability, a symbol
    if (name.size() > 1 && name[1].isLower() && word.size() > 2 && !isIndex) {
        name[0] = name[0].toLower();
    }
    return name;
}

QString Names::within(const QString& place) {
    return QLocale().language() == QLocale::Russian ? inSentence(place) : place;
}

QString Names::where(const ConstraintResult& constraint) {
    if (constraint.at || constraint.section >= 0) {
        return zone(constraint.zone, constraint.at ? constraint.at->section : constraint.section);
    }
    if (requirementOf(constraint.kind).scope == ConstraintScope::part) {
        return tr("whole part");
    }
    return constraint.stage > 0 ? tr("stage %1").arg(constraint.stage) : tr("cycle");
}

QString Names::amount(ConstraintKind kind, double value, bool withSign) {
    const int decimals = requirementOf(kind).digits.shown;
    if (decimals != RequirementDigits::significant) {
        const bool plus = decimals > 0 && value >= 0.5 * std::pow(10.0, -decimals); // no counts
        return (withSign && plus ? QStringLiteral("+") : QString()) + fixed(value, decimals);
    }
    const QString text = withoutZeros(significant(value)); // limits are round
    return (withSign && value > 0 ? QStringLiteral("+") : QString()) + text;
}

bool Names::isRange(ConstraintKind kind) {
    return requirementOf(kind).source == LimitSource::range;
}

QString Names::limit(const ConstraintResult& c) {
    const Requirement& row = requirementOf(c.kind);
    const QString text = amount(c.kind, c.limit, row.isDeviation);
    const bool marked =
        row.scope == ConstraintScope::setting && (row.source != LimitSource::input || row.isLeast);
    return marked ? (c.isLeast ? QStringLiteral("≥") : QStringLiteral("≤")) + text : text;
}

QString Names::margin(const ConstraintResult& c) {
    if (isRange(c.kind)) {
        const std::optional<double> ratio = ratioInRange(c);
        return ratio     ? withoutZeros(significant(*ratio, digitsOfRatio(*ratio))) + u'×'
               : c.holds ? tr("in range")
                         : tr("out of range");
    }
    switch (marginKnown(c)) {
    case MarginKnown::exactly: break;
    case MarginKnown::atMost: return QStringLiteral("≤ ") + amount(c.kind, c.margin, false);
    case MarginKnown::no: return QStringLiteral("–");
    }
    const double left = statedMargin(c);
    const bool none = std::abs(left) < roundOff * std::abs(c.limit);
    return amount(c.kind, none ? 0 : left, true);
}

QString Names::value(const ConstraintResult& c) {
    if (!c.isWhole) {
        return QStringLiteral("–");
    }
    if (c.mostValue) {
        return estimate(c.value, *c.mostValue);
    }
    const Requirement& row = requirementOf(c.kind);
    if (isLowerBound(c)) {
        return formAmount(c.value, false, row.digits.shown);
    }
    return row.isDeviation || row.digits.shown <= 0 ? amount(c.kind, c.value, row.isDeviation)
                                                    : amountFixed(c.value, row.digits.shown);
}

QString Names::estimate(double least, double most) {
    const int decimals = decimalsOf(least, 1);
    return fixed(least, decimals) + QStringLiteral("…") + fixed(most, decimals);
}

QString Names::uncutStrips(const Project& project) {
    const std::vector<OverlapCheck> all = checkOverlaps(project);
    const auto least = std::ranges::min_element(all, {}, &OverlapCheck::overlap);
    return least == all.end() || !leavesStrips(least->overlap)
               ? QString()
               : tr("Strips stay uncut (overlap B/s %1, below 1): this is not the whole surface, "
                    "and its size, form and roughness are those of the cut part alone.")
                     .arg(significant(least->overlap));
}

QString Names::ofMachine(const QString& quantity, bool isKnown) {
    return isKnown ? quantity : tr("%1, machine not known", "the form it prints").arg(quantity);
}

QString Names::formAmount(double value, bool isKnown, int decimals) {
    return isKnown ? amountFixed(value, decimals)
           : value < 0.5 * std::pow(10.0, -decimals)
               ? QStringLiteral("–")
               : QStringLiteral("≥ ") + fixed(value, decimals);
}

QString Names::ofWheel(const QString& quantity, bool isKnown) {
    return isKnown ? quantity : tr("%1, waves not known", "that the wheel prints").arg(quantity);
}

QString Names::issue(const Issue& issue) {
    const QString text = issueText(issue);
    return issue.path.empty() ? text : inputLocation(issue.path) + QStringLiteral(": ") + text;
}

QString Names::refusal(const Issues& issues, int most) {
    QStringList lines;
    int left = 0;
    for (const Issue& i : issues) {
        if (i.severity != Severity::error) {
            continue;
        }
        if (lines.size() < most) {
            lines << issue(i);
        } else {
            ++left;
        }
    }
    if (left > 0) {
        lines << tr("and %1 more").arg(left);
    }
    return lines.join(QLatin1Char('\n'));
}

bool Names::incomplete(const Issues& issues) {
    return hasErrors(issues) && std::ranges::all_of(issues, [](const Issue& issue) {
               return issue.severity != Severity::error || issue.code == IssueCode::missingKey;
           });
}

QString Names::missingLinks(const Issues& issues) {
    QStringList links;
    for (const Issue& issue : issues) {
        if (issue.code == IssueCode::missingKey) {
            const Field* field = nearestField(Project{}, issue.path);
            const QString name = field ? inputText(field->label) : locationText(issue.path);
            links << QStringLiteral("<a href=\"%1\">%2</a>")
                         .arg(QString::fromStdString(issue.path), name.toHtmlEscaped());
        }
    }
    return links.join(QStringLiteral(", "));
}

QString Names::fixed(double value, int decimals) {
    const double least = 0.5 * std::pow(10.0, -decimals);
    return numbers()
        .toString(std::abs(value) < least ? 0.0 : value, 'f', decimals)
        .replace(u'-', u'−');
}

QString Names::amountFixed(double value, int decimals) {
    constexpr double rounding = 1e-9; // a difference this small is rounding
    const double last = std::pow(10.0, -decimals);
    return value > rounding && value < 0.5 * last
               ? QStringLiteral("<\u00a0") + fixed(last, decimals)
               : fixed(value, decimals);
}

QString Names::micrometres(double value_um) {
    return fixed(value_um, 2);
}

QString Names::signedMicrometres(double value_um) {
    return (value_um >= 0.005 ? QStringLiteral("+") : QString()) + micrometres(value_um);
}

QString Names::millimetres(double value_mm) {
    return fixed(value_mm, 4);
}

QString Names::significant(double value, int digits) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const double size = std::abs(value);
    const bool plain = size == 0 || (size >= leastPlain && size < mostPlain);
    return plain ? fixed(value, decimalsOf(value, digits)) : printedNumber(value, digits);
}

QString Names::timeOfMinutes(double time_min, int digits) {
    return time(time_min * units::secondsPerMinute, digits);
}

QString Names::time(double time_s, int digits) {
    return std::abs(time_s) < shortTime_s
               ? tr("%1 s", "time of a cycle").arg(significant(time_s, digits))
               : tr("%1 min", "time of a cycle")
                     .arg(significant(time_s / units::secondsPerMinute, digits));
}

} // namespace sparkout
