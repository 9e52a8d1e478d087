// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/judgement_text.h"

#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <cmath>

namespace sparkout {

QString JudgementText::headline(const Judgement& judgement) {
    return QString::fromStdString(JudgementText().JudgementWording::headline(judgement));
}

QString JudgementText::exceptions(const std::vector<Undecided>& undecided) {
    return QString::fromStdString(JudgementText().JudgementWording::exceptions(undecided));
}

QString JudgementText::stocks(const Judgement& judgement, bool areComing) {
    return QString::fromStdString(JudgementText().JudgementWording::stocks(judgement, areComing));
}

QString JudgementText::batch(const Judgement& judgement, bool isComing) {
    return QString::fromStdString(JudgementText().JudgementWording::batch(judgement, isComing));
}

QStringList JudgementText::lines(const Judgement& judgement) {
    QStringList lines{stocks(judgement)};
    if (judgement.batch) {
        lines << batch(judgement);
    }
    return lines + JudgementText::lines(judgement.notDecided);
}

QStringList JudgementText::lines(const std::vector<Undecided>& notDecided) {
    QStringList lines;
    for (const Undecided& each : notDecided) {
        lines << QString::fromStdString(JudgementText().notDecided(each));
    }
    return lines;
}

std::string JudgementText::translated(const char* text) const {
    return QCoreApplication::translate("Judgement", text).toStdString();
}

std::string JudgementText::number(double value, int decimals) const {
    return Names::fixed(value, decimals).toStdString();
}

std::string JudgementText::requirement(ConstraintKind kind) const {
    return Names::inSentence(Names::constraint(kind)).toStdString();
}

std::string JudgementText::where(const ConstraintResult& constraint) const {
    return Names::within(Names::where(constraint)).toStdString();
}

std::string JudgementText::ofRequirement(const char* text) const {
    return requirementText(text).toStdString();
}

std::string JudgementText::amount(const ConstraintResult& constraint) const {
    return Names::amount(constraint.kind, std::abs(constraint.margin), false).toStdString();
}

std::string JudgementText::value(const ConstraintResult& constraint) const {
    return Names::value(constraint).toStdString();
}

std::string JudgementText::unit(const char* unit) const {
    return unitText(unit).toStdString();
}

} // namespace sparkout
