// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/xlsx_reader.h"
#include "ui/report/export_file.h"
#include "ui/text/language.h"

#include <QJsonDocument>
#include <QObject>
#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// Results on their way to other programs.
namespace sparkout::export_bench {

/// Few radii: another program reads every row.
inline Project smallProject(Operation operation) {
    Project project =
        operation == Operation::traverse ? fixtures::traverseProject() : fixtures::plungeProject(3);
    project.part->radii_per_section = 4;
    project.title = "=Вал <30h6>";
    project.author = "А. Иванов";
    return project;
}

inline QByteArray bytesOf(const OutcomePtr& outcome, const ExportChoice& choice) {
    return exportWork(outcome, choice)({});
}

inline std::vector<ResultPart> everyPart() {
    return {allResultParts.begin(), allResultParts.end()};
}

inline bool sameBits(std::optional<double> read, double value) {
    return read && std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(value + 0.0);
}

/// Rows of the languages that the window speaks.
inline void languageRows() {
    QTest::addColumn<QString>("language");
    QTest::newRow("Russian") << "ru";
    QTest::newRow("English") << "en";
}

/// A test in English with a folder of its own.
class ExportTest : public QObject {
protected:
    void begin() {
        QVERIFY(m_folder.isValid());
        m_english = std::make_unique<Language>();
        m_english->apply(QStringLiteral("en"));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Language> m_english;
};

inline void checkNoFormula(const XlsxReader& read) {
    for (int sheet = 0; sheet < read.names().size(); ++sheet) {
        QVERIFY(!QJsonDocument(read.sheet(sheet)).toJson().contains("\"f\""));
    }
}

} // namespace sparkout::export_bench
