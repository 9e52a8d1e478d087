// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_values.h"

#include "core/version.h"
#include "ui/session/example_texts.h"
#include "ui/session/member.h"
#include "ui/session/number_text.h"
#include "ui/session/texts.h"

#include <QFileInfo>
#include <QLocale>

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

QString plainNumber(double value) {
    return showNumber(value, QLocale()).replace(u'-', QChar(0x2212));
}

QString withUnit(const QString& value, const char* unit) {
    return value + u'\u00a0' + unitText(unit);
}

QString drawnDeviation(double value_um) {
    return (value_um > 0 ? QStringLiteral("+") : QString()) + plainNumber(value_um);
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
