// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/languages.h"
#include "tests/ui/support/report_reading.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/report/format/report_text.h"
#include "ui/report/passport.h"
#include "ui/session/document.h"
#include "ui/text/language.h"
#include "ui/window/dialogs/examples_dialog.h"

#include <QDate>
#include <QTest>

/// The accuracy passport of a project and its batch.
namespace sparkout::passport_bench {

using namespace reading;
using report::Format;

inline const QDate day(2026, 11, 22);

inline Project example(const char* name) {
    Document document;
    for (const QString& path : ExamplesDialog::paths()) {
        if (path.contains(QString::fromUtf8(name))) {
            (void)document.openCopy(ExamplesDialog::textOf(path));
        }
    }
    return document.project();
}

inline report::Subject subjectOf(const Project& project) {
    report::Subject subject;
    subject.outcome = fixtures::run(project);
    subject.file = QStringLiteral("/tmp/part.sparkout");
    subject.date = day;
    if (project.batch) {
        subject.batch = runWholeBatch(project, {});
        subject.worst = report::runWorstPart(*subject.batch);
    }
    return subject;
}

inline QByteArray made(const Project& project, Format format) {
    return bytesOf(report::passport(subjectOf(project)), format);
}

inline Project smallBatch() {
    Project project = fixtures::traverseProject();
    project.part->radii_per_section = 12;
    project.batch.emplace();
    project.batch->parts = 24;
    project.batch->factors.stock_mm.emplace().uniform = {0.14, 0.16};
    project.batch->factors.dullness.emplace().grows = {0.015, 0.03};
    return project;
}

} // namespace sparkout::passport_bench
