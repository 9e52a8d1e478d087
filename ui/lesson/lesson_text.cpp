// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_text.h"

#include "core/lesson/text_markup.h"
#include "core/project/operation.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "words/lesson_words.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

#include <cmath>

namespace sparkout {

namespace {

constexpr int cycleTimeDigits = 3, marginDigits = 1;

bool speaksRussian() {
    return QLocale().language() == QLocale::Russian;
}

/// With at most this number of decimals, without trailing zeros.
QString withDecimals(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return printedNumber(std::round(value * scale) / scale);
}

/// Keeps a number on one line with its sign, tolerance and per cent sign.
QString bound(QString text) {
    return text.replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"))
        .replace(QStringLiteral(" ± "), QStringLiteral("\u00a0±\u00a0"));
}

QString failingNames(const GoalResult& result) {
    QStringList names;
    for (const ConstraintKind kind : result.failing) {
        names += Names::inSentence(Names::constraint(kind));
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

QString LessonText::of(const Bilingual& text) {
    return bound(harmlessText(QString::fromStdString(text.in(speaksRussian()))));
}

QString LessonText::tagged(const Bilingual& text) {
    const std::string& shown = text.in(speaksRussian());
    return isLaidOutSoon(shown)
               ? of(text)
               : harmlessText(QString::fromStdString(shown.substr(0, limits::lessonText.bytes)))
                     .toHtmlEscaped();
}

QString LessonText::markup(const Bilingual& text) {
    const QPalette palette = QGuiApplication::palette();
    return QStringLiteral("<style>p { margin-top: 4px; margin-bottom: 4px; } "
                          "p.formula { margin-left: 12px; background-color: %1; } "
                          "td, th { padding: 2px 8px 2px 0px; }</style>%2")
        .arg(palette.color(QPalette::AlternateBase).name(), tagged(text));
}

QString LessonText::place(const Project& project, std::size_t index) {
    const PlaceName name = placeName(project, index);
    return name.zone ? Names::zone(static_cast<Zone>(*name.zone))
                     : Names::zone(Zone::section, name.section.value_or(0));
}

QString LessonText::figure(const Figure& figure, const Project& project) {
    const QString name = QCoreApplication::translate("Figure", rowOf(figure.name).choice.label);
    QStringList where;
    if (figure.place.isGiven()) {
        where += Names::inSentence(place(project, figure.place.index()));
    }
    if (figure.stage) {
        where += tr("stage %1").arg(*figure.stage);
    }
    if (figure.count) {
        where += (project.operation->travels ? tr("double stroke %1") : tr("revolution %1"))
                     .arg(*figure.count);
    }
    if (figure.step != Step::none) {
        where += Names::step(figure.step);
    }
    return where.isEmpty() ? name : tr("%1: %2").arg(name, where.join(QStringLiteral(", ")));
}

QString LessonText::unit(const Figure& figure) {
    return unitText(rowOf(figure.name).unit);
}

QString LessonText::value(double value, const Figure& figure) {
    const QString number = withDecimals(value, rowOf(figure.name).digits);
    const QString of = unit(figure);
    return of.isEmpty() ? number : number + u'\u00a0' + of;
}

QString LessonText::at(const CurvePrediction& goal, double at, const Project& project) {
    return goal.along == CurveAlong::place ? place(project, static_cast<std::size_t>(at))
                                           : QString::number(static_cast<int>(at));
}

QString LessonText::along(const CurvePrediction& goal, const Project& project) {
    switch (goal.along) {
    case CurveAlong::count:
        return project.operation->travels ? tr("Double stroke") : tr("Revolution");
    case CurveAlong::stage: return tr("Stage");
    case CurveAlong::place: break;
    }
    return project.operation->travels ? tr("Zone") : tr("Section");
}

QString LessonText::asked(const Goal& goal, const Project& project) {
    switch (goal.kind()) {
    case GoalKind::requirements: {
        const bool all = goal.requirements->every_stock;
        return goal.requirements->least_margin_percent > 0
                   ? (all ? tr("To pass: every requirement is met for every stock, with a margin "
                               "of at least %1 %.")
                          : tr(
                              "To pass: every requirement is met, with a margin of at least %1 %."))
                         .arg(printedNumber(goal.requirements->least_margin_percent))
               : all ? tr("To pass: every requirement is met for every stock.")
                     : tr("To pass: every requirement is met.");
    }
    case GoalKind::time:
        if (!goal.time->below_min) {
            return {};
        }
        return (goal.time->requirements_hold
                    ? tr("To pass: cycle time at most %1 min, every requirement is met.")
                    : tr("To pass: cycle time at most %1 min."))
            .arg(withDecimals(*goal.time->below_min, cycleTimeDigits));
    case GoalKind::figure:
        return bound(tr("To pass: %1 = %2 ± %3.")
                         .arg(Names::inSentence(figure(goal.figure->figure, project)),
                              printedNumber(goal.figure->value),
                              printedNumber(goal.figure->tolerance)
                                  + (unit(goal.figure->figure).isEmpty()
                                         ? QString()
                                         : u'\u00a0' + unit(goal.figure->figure))));
    case GoalKind::prediction:
    case GoalKind::curve:
    case GoalKind::order:
    case GoalKind::choice:
    case GoalKind::text: break;
    }
    return {};
}

QString LessonText::numbers(const Goal& goal, const GoalResult& result) {
    QStringList parts;
    switch (goal.kind()) {
    case GoalKind::requirements:
        if (result.value) {
            parts += tr("minimum margin %1 %").arg(withDecimals(*result.value, marginDigits));
        }
        break;
    case GoalKind::time:
        if (result.value) {
            parts += tr("cycle time %1 min").arg(withDecimals(*result.value, cycleTimeDigits));
        }
        break;
    case GoalKind::figure:
        if (result.value) {
            parts += tr("it is %1").arg(value(*result.value, goal.figure->figure));
        }
        break;
    case GoalKind::prediction:
        if (result.value && result.asked) {
            parts += tr("prediction %1, result %2")
                         .arg(value(*result.asked, goal.prediction->figure),
                              value(*result.value, goal.prediction->figure));
        }
        if (result.value) {
            parts += tr("tolerance ± %1").arg(value(result.tolerance, goal.prediction->figure));
        }
        break;
    case GoalKind::curve:
        if (!result.curve.empty()) {
            parts += tr("within the tolerance at %1 % of the places, asked %2 %")
                         .arg(withDecimals(result.value.value_or(0), 0),
                              withDecimals(goal.curve->least_share_percent, 0));
        }
        break;
    case GoalKind::order:
    case GoalKind::choice:
    case GoalKind::text: break;
    }
    if (result.failingStocks_percent) {
        parts += tr("unfit for %1 % of stocks").arg(withDecimals(*result.failingStocks_percent, 0));
    }
    if (!result.failing.empty()) {
        parts += tr("not met: %1").arg(failingNames(result));
    }
    for (const std::string& path : result.forbidden) {
        parts += inputLocation(path);
    }
    for (const Issue& issue : result.issues) {
        if (issue.severity == Severity::error) {
            parts += issueText(issue);
            break;
        }
    }
    return parts.join(QStringLiteral("; "));
}

QString LessonText::found(const Goal& goal, const GoalResult& result) {
    QString finding = QCoreApplication::translate("Finding", findingText(result.finding));
    finding = finding.left(1).toUpper() + finding.mid(1);
    const QString more = numbers(goal, result);
    return more.isEmpty() ? tr("%1.").arg(finding) : tr("%1: %2.").arg(finding, more);
}

QString LessonText::points(double points) {
    return printedNumber(points);
}

QString LessonText::mark(LessonRun::Mark mark) {
    switch (mark) {
    case LessonRun::Mark::open: return tr("open");
    case LessonRun::Mark::checked: return tr("being checked");
    case LessonRun::Mark::passed: return tr("done");
    case LessonRun::Mark::failed: return tr("not passed");
    case LessonRun::Mark::teacher: return tr("handed in");
    }
    return {};
}

} // namespace sparkout
