// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/verdict/remedy_text.h"

#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>

namespace sparkout {

std::string RemedyText::translated(const char* text) const {
    return QCoreApplication::translate("Remedy", text).toStdString();
}

std::string RemedyText::number(double value) const {
    return printedNumber(value).toStdString();
}

std::string RemedyText::unit(const char* unit) const {
    return unitText(unit).toStdString();
}

std::string RemedyText::input(const char* label, const char* symbol) const {
    return QStringLiteral("%1 %2").arg(inputText(label), QString::fromUtf8(symbol)).toStdString();
}

std::string RemedyText::requirement(ConstraintKind kind) const {
    return Names::constraint(kind).toStdString();
}

} // namespace sparkout
