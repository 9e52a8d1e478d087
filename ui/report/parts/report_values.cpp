// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/report_values.h"

#include "core/project/iso286.h"
#include "core/project/member.h"
#include "core/units.h"
#include "core/version.h"
#include "ui/text/example_texts.h"
#include "ui/text/number_text.h"
#include "ui/text/size_field.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QLocale>

#include <cmath>

namespace sparkout::report {

namespace {
constexpr double nanometres = 1e3; ///< in a micrometre
}

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

QString plainNumber(double value) {
    return showNumber(value, QLocale()).replace(u'-', QChar(0x2212));
}

QString withUnit(const QString& value, const char* unit) {
    return value + u'\u00a0' + unitText(unit);
}

QString requirementUnit(ConstraintKind kind) {
    const Requirement& row = requirementOf(kind);
    return cell(unitText(row.unitInFull ? row.unitInFull : row.unit));
}

QString drawnSize(const Part& part) {
    QString field = fieldOf(part);
    for (const QString& word : oneLine(part.name).split(u' ', Qt::SkipEmptyParts)) {
        const auto size = parseSizeDesignation(word.toStdString());
        if (field.isEmpty() && size && size->nominal_mm == part.diameter_mm
            && size->isHole() == (part.surface == Surface::internal)) {
            field = plainNumber(size->nominal_mm) + QString::fromStdString(size->letters)
                    + QString::number(size->grade);
        }
    }
    const auto limit = [](double value_um) {
        return (value_um > 0 ? QStringLiteral("+") : QString())
               + plainNumber(std::round(value_um * nanometres) / nanometres / units::umPerMm);
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
    return u'⌀' + (field.isEmpty() ? plainNumber(part.diameter_mm) + u' ' : field) + u'(' + limits
           + u')';
}

std::pair<QString, QString> inputFact(const Project& project, const char* path) {
    const ConstMember member = findMember(project, path);
    const Field& field = *member.field;
    QString name = inputText(field.label);
    if (*field.symbol) {
        name += QStringLiteral(" ") + QString::fromUtf8(field.symbol).remove(u'_');
    }
    if (field.kind == sparkout::Kind::text) {
        return {name, cell(oneLine(field.as<std::string>(member.owner)))};
    }
    const std::optional<double> value = numberIn(field, member.owner);
    return {name, !value        ? cell({})
                  : *field.unit ? withUnit(plainNumber(*value), field.unit)
                                : plainNumber(*value)};
}

Report begunReport(const QString& title, const Project& project, const QString& file,
                   const QDate& date) {
    Report report;
    report.title = title;
    QStringList subject{manyLines(exampleTitle(project.title)).simplified(),
                        oneLine(project.part.name)};
    subject.removeAll(QString());
    subject.removeDuplicates();
    report.subject = subject.join(QStringLiteral(" · "));
    report.author = oneLine(project.author);
    report.file = manyLines(QFileInfo(file).fileName()).simplified();
    report.program = QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version));
    report.language = QLocale().bcp47Name().section(u'-', 0, 0);
    report.date = date;
    return report;
}

} // namespace sparkout::report
