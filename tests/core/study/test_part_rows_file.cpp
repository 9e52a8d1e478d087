// SPDX-License-Identifier: GPL-3.0-or-later
// The file of all parts of a batch: what it holds, and that there is none unless it is whole.
#include "core/study/whole_batch.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <QTemporaryDir>

namespace sparkout::test_part_rows_file {

using Existing = SafeFileWriter::Existing;

constexpr int parts = 7;

std::string writtenBy(const PartTable& table, const std::vector<std::string>& head,
                      const Project& project) {
    std::string text = table.head(head);
    BatchOptions options;
    options.sink = [&](const PartRecord& record) {
        text += table.line(record);
        return true;
    };
    (void)runBatch(project, options);
    return text;
}

class TestPartRowsFile : public QObject {
    Q_OBJECT

private slots:
    void init() {
        QVERIFY(m_folder.isValid());
        m_path = std::filesystem::path(m_folder.path().toStdString()) / "parts.csv";
        std::filesystem::remove(m_path);
    }

    void itHoldsARowForEveryPart() {
        const Project project = fixtures::shaftBatch(parts);
        std::vector<double> shares;
        PartRowsFile file(m_path, Existing::refused, {});
        QVERIFY(file.runBatch(project, {}, [&](double share) {
            shares.push_back(share);
            return true;
        }));
        QVERIFY(!file.error());
        const PartColumns columns = PartColumns::of(ScenarioSource(project));
        QCOMPARE(samples::readText(m_path),
                 writtenBy(PartTable(columns, {}), PartTable::keys(columns), project));
        QCOMPARE(shares.size(), std::size_t{parts});
        QVERIFY(std::ranges::is_sorted(shares));
        QCOMPARE(shares.back(), 1.0);
    }

    void aFormSaysHowItIsWritten() {
        const Project project = fixtures::shaftBatch(parts);
        PartRowsFile::Form form;
        form.dialect.table.delimiter = ';';
        form.dialect.table.decimal = ',';
        form.head = [](const PartColumns& columns) {
            return std::vector<std::string>(PartTable::keys(columns).size(), "column");
        };
        PartRowsFile file(m_path, Existing::refused, form);
        QVERIFY(file.runBatch(project, {}, [](double) { return true; }));
        const PartColumns columns = PartColumns::of(ScenarioSource(project));
        const std::string text = samples::readText(m_path);
        QCOMPARE(text, writtenBy(PartTable(columns, form.dialect), form.head(columns), project));
        QVERIFY(text.starts_with("column;column;"));
    }

    void stoppedThereIsNone() {
        const Project project = fixtures::shaftBatch(parts);
        int done = 0;
        PartRowsFile file(m_path, Existing::refused, {});
        QVERIFY(!file.runBatch(project, {}, [&](double) { return ++done < 3; }));
        QCOMPARE(done, 3);
        QVERIFY(!file.error()); // nothing went wrong
        QVERIFY(!std::filesystem::exists(m_path));
        const StoppedSource stop;
        BatchOptions options;
        options.stop = stop.get_token();
        PartRowsFile other(m_path, Existing::refused, {});
        QVERIFY(!other.runBatch(project, options, [](double) { return true; }));
        QVERIFY(!std::filesystem::exists(m_path));
    }

    void whatCannotBeWrittenIsSaid() {
        const auto nowhere = m_path.parent_path() / "none" / "parts.csv";
        PartRowsFile file(nowhere, Existing::refused, {});
        QVERIFY(!file.runBatch(fixtures::shaftBatch(parts), {}, [](double) { return true; }));
        QVERIFY(file.error().has_value());
    }

    void aRefusedBatchLeavesNoFile() {
        Project project = fixtures::shaftBatch(parts);
        project.batch->parts = 0;
        PartRowsFile file(m_path, Existing::refused, {});
        QVERIFY(!file.runBatch(project, {}, [](double) { return true; }));
        QVERIFY(!std::filesystem::exists(m_path));
    }

private:
    QTemporaryDir m_folder;
    std::filesystem::path m_path;
};

} // namespace sparkout::test_part_rows_file

SPARKOUT_TEST(test_part_rows_file, TestPartRowsFile)
#include "test_part_rows_file.moc"
