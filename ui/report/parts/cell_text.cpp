// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/cell_text.h"

#include "core/quality/light.h"
#include "core/quality/roughness.h"
#include "ui/charts/verdict_table.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

namespace sparkout::report {

QString manyLines(QString text) {
    text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
    QString kept;
    for (const QChar c : text) {
        const bool line = c == u'\n' || c == QChar::LineSeparator || c == QChar::ParagraphSeparator;
        if (line) {
            kept += u'\n';
        } else if (c == u'\t' || c == u'\r') {
            kept += u' ';
        } else if (c >= u' ' && !c.isNonCharacter()) {
            kept += c;
        }
    }
    return kept;
}

QString oneLine(const std::string& text) {
    return manyLines(QString::fromStdString(text)).simplified();
}

QString cell(const QString& text) {
    return text.trimmed().isEmpty() ? QStringLiteral("–") : text;
}

QString withUnit(const QString& value, const char* unit) {
    return value + u'\u00a0' + unitText(unit);
}

QString requirementUnit(ConstraintKind kind) {
    const Requirement& row = requirementOf(kind);
    return cell(unitText(row.unitInFull ? row.unitInFull : row.unit));
}

RequirementCells::RequirementCells(const ConstraintResult& constraint) : m_constraint(constraint) {}

QString RequirementCells::value() const {
    return Names::value(m_constraint);
}

QString RequirementCells::margin() const {
    return m_constraint.mostValue ? cell({}) : Names::margin(m_constraint);
}

QString RequirementCells::verdict() const {
    return isOpen(m_constraint) ? tr("not calibrated") : lightName(m_constraint);
}

QString RequirementCells::roughnessHead(const Project& project) {
    return isRoughnessCalibrated(project) ? tr("Ra, µm") : tr("Ra, µm, not calibrated");
}

} // namespace sparkout::report
