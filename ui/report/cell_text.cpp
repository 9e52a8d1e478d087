// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/cell_text.h"

#include "core/project/iso286.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/quality/roughness.h"
#include "core/quality/verdict.h"
#include "core/units.h"
#include "ui/results/verdict_table.h"
#include "ui/text/designation_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QStringList>

#include <cmath>
#include <cstddef>

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

namespace {

constexpr double nanometres = 1e3; ///< per micrometre
}

QString drawnSize(const Part& part) {
    QString field = fieldOf(part);
    for (const QString& word : oneLine(part.name).split(u' ', Qt::SkipEmptyParts)) {
        const auto size = parseSizeDesignation(word.toStdString());
        if (field.isEmpty() && size && size->nominal_mm == part.diameter_mm
            && size->isHole() == (part.surface == Surface::internal)) {
            field = printedNumber(size->nominal_mm) + QString::fromStdString(size->letters)
                    + QString::number(size->grade);
        }
    }
    const auto limit = [](double value_um) {
        return (value_um > 0 ? QStringLiteral("+") : QString())
               + printedNumber(std::round(value_um * nanometres) / nanometres / units::umPerMm);
    };
    const double upper = part.upper_deviation_um, lower = part.lower_deviation_um;
    QString limits;
    if (upper == -lower) {
        limits = upper == 0 ? QStringLiteral("0") : u'±' + limit(upper).remove(u'+');
    } else if (upper == 0 || lower == 0) {
        limits = limit(upper == 0 ? lower : upper);
    } else {
        limits = limit(upper) + QStringLiteral("; ") + limit(lower);
    }
    return u'⌀' + (field.isEmpty() ? printedNumber(part.diameter_mm) + u' ' : field) + u'(' + limits
           + u')';
}

std::pair<QString, QString> inputFact(const Project& project, const char* path) {
    const ConstMember member = findMember(project, path);
    const Field& field = *member.field;
    QString name = inputText(field.label);
    if (*field.symbol) {
        name += QStringLiteral(" ") + symbolOf(field, *project.part).remove(u'_');
    }
    if (field.kind == sparkout::Kind::text) {
        return {name, cell(oneLine(field.as<std::string>(member.owner)))};
    }
    if (field.kind == sparkout::Kind::choice) {
        const auto chosen = static_cast<std::size_t>(field.getChoice(member.owner));
        return {name, choiceText(field.choices[chosen].label)};
    }
    const std::optional<double> value = ShownScale::of(field).shown(numberIn(field, member.owner));
    if (!value) {
        return {name, cell({})};
    }
    constexpr int digits = 6; // wear by the earlier surfaces gives all digits of a double
    const QString printed = printedNumber(*value, digits);
    return {name, *field.unit ? withUnit(printed, field.unit) : printed};
}

} // namespace sparkout::report
