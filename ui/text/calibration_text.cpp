// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/calibration_text.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/member.h"
#include "core/quality/requirement.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QDate>
#include <QStringList>

namespace sparkout {

namespace {

QString dataOf(const Calibration& calibration) {
    return printableText(QString::fromStdString(calibration.data));
}

} // namespace

QString CalibrationText::brief(const Calibration& calibration) {
    return tr("calibrated on %1 (n = %2)").arg(dataOf(calibration)).arg(calibration.count);
}

QString CalibrationText::changed(const Calibration& calibration) {
    return tr("no longer the value calibrated on %1 (n = %2)")
        .arg(dataOf(calibration))
        .arg(calibration.count);
}

QString CalibrationText::state(const Project& project, const Calibration& calibration) {
    return hasCalibratedValue(project, calibration) ? brief(calibration) : changed(calibration);
}

QString CalibrationText::details(const Project& project, const Calibration& calibration) {
    const QString unitOfInput = unit(project, calibration);
    const auto withUnit = [&](const QString& text) {
        return unitOfInput.isEmpty() ? text : text + QChar(0xa0) + unitOfInput;
    };
    QStringList lines{state(project, calibration),
                      tr("Value found: %1").arg(withUnit(number(calibration.value)))};
    if (const QString range = interval(calibration); !range.isEmpty()) {
        lines << tr("95 % interval: %1").arg(withUnit(range));
    }
    if (const QString day = date(calibration); !day.isEmpty()) {
        lines << tr("Date: %1").arg(day);
    }
    return lines.join(u'\n');
}

QString CalibrationText::number(double value) {
    constexpr int digits = 4;
    return printedNumber(value, digits);
}

QString CalibrationText::interval(const Calibration& calibration) {
    return calibration.low && calibration.high
               ? number(*calibration.low) + u'…' + number(*calibration.high)
               : QString();
}

QString CalibrationText::unit(const Project& project, const Calibration& calibration) {
    const Field* const field = nearestField(project, calibration.input);
    return field ? unitText(field->unit) : QString();
}

QString CalibrationText::date(const Calibration& calibration) {
    const QString written = QString::fromStdString(calibration.date);
    const QDate day = QDate::fromString(written.left(10), Qt::ISODate);
    return day.isValid() ? dateText(day) : printableText(written);
}

QString EstimateNames::inputs(const Project& project, ConstraintKind kind) {
    QStringList names;
    for (const Field* field : estimatesBehind(project, kind)) {
        if (!isCalibrated(project, *field)) {
            names += inputText(field->label).toLower();
        }
    }
    return names.join(u", ");
}

QString EstimateNames::behind(const Project& project, ConstraintKind kind) {
    const QString names = inputs(project, kind);
    return names.isEmpty() ? QString() : tr("Based on estimates, to be calibrated: %1.").arg(names);
}

} // namespace sparkout
