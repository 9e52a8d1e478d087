// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/goal_words.h"

#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "words/lesson_words.h"

#include <QStringList>

namespace sparkout::report {

namespace {

/// "mm/N" and other units of figures besides those of inputs.
QString figureUnit(const sparkout::Figure& figure) {
    const char* const unit = rowOf(figure.name).unit;
    return *unit ? unitText(unit) : QString();
}

QString countOf(const Project& project, int count) {
    return (project.operation->travels
                ? QCoreApplication::translate("GoalWords", "double stroke %1")
                : QCoreApplication::translate("GoalWords", "revolution %1"))
        .arg(count);
}

} // namespace

QString GoalWords::place(const Project& project, std::size_t index) {
    return project.operation->travels ? Names::zone(static_cast<Zone>(index))
                                      : Names::zone(Zone::section, static_cast<int>(index));
}

QString GoalWords::quantity(const sparkout::Figure& figure, const Project& project) {
    QStringList parts{QCoreApplication::translate("Figure", rowOf(figure.name).choice.label)};
    if (figure.place.isGiven()) {
        parts << Names::within(place(project, figure.place.index()));
    }
    if (figure.stage) {
        parts << tr("stage %1").arg(*figure.stage);
    }
    if (figure.count) {
        parts << countOf(project, *figure.count);
    }
    if (figure.step != Step::none) {
        parts << Names::step(figure.step);
    }
    return parts.join(QStringLiteral(", "));
}

QString GoalWords::unit(const sparkout::Figure& figure) {
    const QString unit = figureUnit(figure);
    return unit.isEmpty() ? QStringLiteral("–") : unit;
}

QString GoalWords::withUnit(const QString& quantity, const sparkout::Figure& figure) {
    const QString unit = figureUnit(figure);
    return unit.isEmpty() ? quantity : quantity + QStringLiteral(", ") + unit;
}

QString GoalWords::number(const sparkout::Figure& figure, double value) {
    return Names::fixed(value, rowOf(figure.name).digits);
}

QString GoalWords::amount(const sparkout::Figure& figure, double value) {
    const QString unit = figureUnit(figure);
    const QString number = printedNumber(value);
    return unit.isEmpty() ? number : number + QChar::Nbsp + unit;
}

QString GoalWords::order(const Project& project, const std::vector<std::size_t>& places) {
    QStringList names;
    for (const std::size_t index : places) {
        names << place(project, index);
    }
    return names.join(QStringLiteral(" > "));
}

QString GoalWords::along(const CurvePrediction& goal, const Project& project) {
    switch (goal.along) {
    case CurveAlong::count:
        return project.operation->travels ? tr("Double stroke") : tr("Revolution");
    case CurveAlong::stage: return tr("Stage");
    case CurveAlong::place: return tr("Zone or section");
    }
    return {};
}

QString GoalWords::alongAt(const CurvePrediction& goal, double at, const Project& project) {
    return goal.along == CurveAlong::place ? place(project, static_cast<std::size_t>(at))
                                           : printedNumber(at);
}

QString GoalWords::finding(Finding finding) {
    return QCoreApplication::translate("Finding", findingText(finding));
}

QString GoalWords::asked(const Goal& goal, const Project& project) {
    const auto amountOf = [](const sparkout::Figure& figure, double value) {
        return amount(figure, value);
    };
    switch (goal.kind()) {
    case GoalKind::requirements: {
        const QString holds = goal.requirements->every_stock
                                  ? tr("Every requirement must be met for every stock")
                                  : tr("Every requirement must be met");
        return goal.requirements->least_margin_percent > 0
                   ? tr("%1, with a margin of at least %2 %.")
                         .arg(holds, printedNumber(goal.requirements->least_margin_percent))
                   : holds + u'.';
    }
    case GoalKind::time: {
        const QString time = goal.time->below_min ? tr("The cycle must take at most %1 min.")
                                                        .arg(printedNumber(*goal.time->below_min))
                             : goal.time->within_percent_of_best
                                 ? tr("The cycle must take at most %1 % more than the best one.")
                                       .arg(printedNumber(*goal.time->within_percent_of_best))
                                 : tr("The cycle must be quick.");
        return goal.time->requirements_hold
                   ? time + u' ' + tr("Every requirement must be met") + u'.'
                   : time;
    }
    case GoalKind::figure:
        return tr("To be reached: %1 of %2 ± %3.")
            .arg(Names::inSentence(quantity(goal.figure->figure, project)),
                 printedNumber(goal.figure->value),
                 amountOf(goal.figure->figure, goal.figure->tolerance));
    case GoalKind::prediction:
        return tr("To be predicted before the run: %1.")
            .arg(Names::inSentence(
                withUnit(quantity(goal.prediction->figure, project), goal.prediction->figure)));
    case GoalKind::curve:
        return tr("To be drawn before the run: %1.")
            .arg(Names::inSentence(
                withUnit(quantity(goal.curve->figure, project), goal.curve->figure)));
    case GoalKind::order:
        return tr("To be predicted before the run: the order by %1, the largest first.")
            .arg(Names::inSentence(quantity(goal.order->figure, project)));
    case GoalKind::choice: return tr("One or several answers are right.");
    case GoalKind::text: return tr("The answer is in words; the teacher reads it.");
    }
    return {};
}

} // namespace sparkout::report
