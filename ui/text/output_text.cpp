// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/output_text.h"

#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

QString translated(const char* text) {
    return *text ? QCoreApplication::translate("Output", text) : QString();
}

QString withUnit(const QString& label, const OutputRow& row) {
    const QString unit = unitText(row.unitShown());
    return unit.isEmpty() ? label : QStringLiteral("%1, %2").arg(label, unit);
}

} // namespace

QString outputLabel(const OutputRow& row) {
    return translated(*row.brief ? row.brief : row.label);
}

QString outputName(const OutputRow& row, bool revolutions) {
    return withUnit(translated(row.labelOf(revolutions)), row);
}

QString outputBrief(const OutputRow& row, bool revolutions) {
    const QString brief = translated(row.brief);
    return brief.isEmpty()          ? outputName(row, revolutions)
           : brief.startsWith(u' ') ? brief // below a row with the unit
                                    : withUnit(brief, row);
}

QString outputHint(const OutputRow& row) {
    return translated(row.hint);
}

std::optional<double> outputNumber(const OutputRow& row, const OutputValue& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return *number * row.shownFactor;
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return static_cast<double>(*whole);
    }
    if (const auto* estimate = std::get_if<Estimate>(&value)) {
        return estimate->value * row.shownFactor;
    }
    if (const auto* share = std::get_if<Share>(&value)) {
        return share->value;
    }
    return {};
}

QString outputText(const OutputRow& row, const OutputValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return QString::number(*whole);
    }
    const std::optional<double> number = outputNumber(row, value);
    return number ? threeDigits(*number) : QString();
}

QString threeDigits(double value) {
    if (!(value > 0)) {
        return QStringLiteral("0");
    }
    const int zeros = value < 1 ? -static_cast<int>(std::floor(std::log10(value))) - 1 : 0;
    return Names::significant(value, std::max(1, 3 - zeros));
}

} // namespace sparkout
