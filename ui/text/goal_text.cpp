// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/goal_text.h"

#include "core/project/operation.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

namespace sparkout {

QString GoalText::quantity(const Figure& figure, const Project& project) {
    return QString::fromStdString(GoalText().GoalWording::quantity(figure, project));
}

QString GoalText::quantityAndUnit(const Figure& figure, const Project& project) {
    const QString of = unit(figure);
    return of.isEmpty() ? quantity(figure, project)
                        : quantity(figure, project) + QStringLiteral(", ") + of;
}

QString GoalText::unit(const Figure& figure) {
    const char* const unit = rowOf(figure.name).unit;
    return *unit ? unitText(unit) : QString();
}

QString GoalText::number(const Figure& figure, double value) {
    return Names::fixed(value, rowOf(figure.name).digits);
}

QString GoalText::value(const Figure& figure, double value) {
    return QString::fromStdString(GoalText().GoalWording::value(figure, value));
}

QString GoalText::place(const Project& project, std::size_t index) {
    return project.operation->travels ? Names::zone(static_cast<Zone>(index))
                                      : Names::zone(Zone::section, static_cast<int>(index));
}

QString GoalText::order(const Project& project, const std::vector<std::size_t>& places) {
    return QString::fromStdString(GoalText().GoalWording::order(project, places));
}

QString GoalText::along(const CurvePrediction& goal, const Project& project) {
    switch (goal.along) {
    case CurveAlong::count:
        return project.operation->travels ? tr("Double stroke") : tr("Revolution");
    case CurveAlong::stage: return tr("Stage");
    case CurveAlong::place: break;
    }
    return project.operation->travels ? tr("Zone") : tr("Section");
}

QString GoalText::alongAt(const CurvePrediction& goal, double at, const Project& project) {
    return goal.along == CurveAlong::place ? place(project, static_cast<std::size_t>(at))
                                           : printedNumber(at);
}

QString GoalText::finding(Finding finding) {
    return QCoreApplication::translate("Finding", findingText(finding));
}

QString GoalText::asked(const Goal& goal, const Project& project) {
    return unbroken(QString::fromStdString(GoalText().GoalWording::asked(goal, project)));
}

QString GoalText::found(const Goal& goal, const GoalResult& result, const Project& project,
                        bool showsAnswer) {
    QString text = unbroken(
        QString::fromStdString(GoalText().GoalWording::found(goal, result, project, showsAnswer)));
    text[0] = text[0].toUpper();
    return text.endsWith(u'.') ? text : text + u'.';
}

std::string GoalText::translated(const char* context, const char* text) const {
    return QCoreApplication::translate(context, text).toStdString();
}

std::string GoalText::number(double value) const {
    return printedNumber(value).toStdString();
}

std::string GoalText::fixed(double value, int decimals) const {
    return Names::fixed(value, decimals).toStdString();
}

std::string GoalText::withUnit(const std::string& number, const char* unit) const {
    return *unit ? number + "\u00a0" + unitText(unit).toStdString() : number;
}

std::string GoalText::inSentence(const std::string& name) const {
    return Names::inSentence(QString::fromStdString(name)).toStdString();
}

std::string GoalText::zoneOrSection(const Project& project, std::size_t index) const {
    return Names::within(place(project, index)).toStdString();
}

std::string GoalText::step(Step step) const {
    return Names::step(step).toStdString();
}

std::string GoalText::input(const std::string& path) const {
    return inputLocation(path).toStdString();
}

std::string GoalText::fault(const Issue& issue) const {
    return issueText(issue).toStdString();
}

} // namespace sparkout
