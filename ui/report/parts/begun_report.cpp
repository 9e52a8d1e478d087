// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/begun_report.h"

#include "core/format/project_file.h"
#include "core/project/part.h"
#include "core/version.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/example_texts.h"

#include <QFileInfo>
#include <QLocale>

namespace sparkout::report {

Report begunReport(const QString& title, const Project& project, const QString& file,
                   const QDate& date) {
    Report report;
    report.title = title;
    QStringList subject{manyLines(exampleTitle(project.title)).simplified(),
                        manyLines(exampleTitle(project.part->name)).simplified()};
    subject.removeAll(QString());
    subject.removeDuplicates();
    report.subject = subject.join(QStringLiteral(" · "));
    report.author = oneLine(project.author);
    report.file = manyLines(QFileInfo(file).fileName()).simplified();
    report.program = QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version));
    report.language = QLocale().bcp47Name().section(u'-', 0, 0);
    report.date = date;
    Project inputs = project; // kept runs are not inputs of this paper
    inputs.runs = {};
    report.inputs = QByteArray::fromStdString(writeProject(inputs));
    return report;
}

} // namespace sparkout::report
