// SPDX-License-Identifier: GPL-3.0-or-later
// All parts of a batch as rows: what they hold, in which order, and when they end.
#include "core/batch/batch_run.h"
#include "core/batch/batch_statistics.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

#include <array>
#include <atomic>
#include <sstream>
#include <stop_token>
#include <thread>

namespace sparkout::test_batch_rows {

using fixtures::shaftBatch;
using fixtures::stiffBatch;
using fixtures::uniform;

/// With a point, whatever the locale.
double numberOf(const std::string& cell) {
    return QByteArray::fromStdString(cell).toDouble();
}

struct Rows {
    BatchResult result;
    PartColumns columns;
    std::string text;
    std::vector<std::vector<std::string>> cells; ///< without the head
};

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

Rows rowsOf(const Project& project, int threads, BatchOptions options = {}) {
    const ScenarioSource source(project);
    Rows rows;
    rows.columns = PartColumns::of(source);
    const PartTable table(rows.columns, {});
    rows.text = table.head(PartTable::keys(rows.columns));
    options.threads = threads;
    options.sink = [&](const PartRecord& record) {
        rows.text += table.line(record);
        return true;
    };
    rows.result = runBatchUnchecked(project, options);
    std::istringstream lines(rows.text);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        rows.cells.push_back(cellsOf(line));
    }
    return rows;
}

/// A batch of which some parts fail: half of them have a larger runout than allowed.
Project partlyBad(int parts) {
    Project project = shaftBatch(parts);
    const BatchResult result = runBatch(project);
    const auto characteristics = characteristicsOf(ScenarioSource(project).nominal());
    std::vector<double> largest;
    for (const PartRow& row : result.statistics.rows) {
        largest.push_back(0);
        for (std::size_t i = 0; i < characteristics.size(); ++i) {
            if (std::string(characteristics[i].name) == "radial_runout") {
                largest.back() = std::max(largest.back(), row.values[i]);
            }
        }
    }
    std::ranges::sort(largest);
    project.part->tolerance.radial_runout_um = largest[largest.size() / 2];
    return project;
}

class TestBatchRows : public QObject {
    Q_OBJECT

private slots:
    void rowsHoldTheStatisticsToTheBit() {
        const Rows rows = rowsOf(partlyBad(60), 2);
        const BatchStatistics& expected = rows.result.statistics;
        QCOMPARE(rows.cells.size(), std::size_t{60});
        QVERIFY(expected.bad > 0 && expected.bad < 60);
        const std::size_t factors = rows.columns.factors.size();
        for (std::size_t i = 0; i < rows.columns.characteristics.size(); ++i) {
            ValueStatistics again;
            for (std::size_t part = 0; part < rows.cells.size(); ++part) {
                const std::string& cell = rows.cells[part][4 + factors + i];
                if (!cell.empty()) {
                    again.add(numberOf(cell), static_cast<std::int64_t>(part),
                              rows.columns.characteristics[i], {}, 64);
                }
            }
            const ValueStatistics& of = expected.values[i];
            QCOMPARE(again.count, of.count);
            QVERIFY(again.powers == of.powers && again.least == of.least && again.most == of.most);
            QVERIFY(again.below == of.below && again.above == of.above);
            if (of.count > 1) {
                QCOMPARE(momentsOf(again).mean, momentsOf(of).mean);
                QCOMPARE(momentsOf(again).deviation, momentsOf(of).deviation);
            }
        }
        std::int64_t bad = 0;
        std::array<std::int64_t, constraintKinds> rejects{};
        for (const auto& cells : rows.cells) {
            bad += cells[2] == "false" ? 1 : 0;
            for (std::size_t i = 0; i < rows.columns.requirements.size(); ++i) {
                const std::size_t at = 4 + factors + rows.columns.characteristics.size() + i;
                rejects[static_cast<std::size_t>(rows.columns.requirements[i])] +=
                    cells[at] == "false" ? 1 : 0;
            }
        }
        QCOMPARE(bad, expected.bad);
        QVERIFY(rejects == expected.rejects);
    }

    void factorsAreThoseOfTheParts() {
        const Project project = shaftBatch(20);
        const ScenarioSource source(project);
        const Rows rows = rowsOf(project, 2);
        for (std::size_t part = 0; part < rows.cells.size(); ++part) {
            QCOMPARE(rows.cells[part][0], std::to_string(part));
            const auto values = source.values(static_cast<std::int64_t>(part));
            for (std::size_t f = 0; f < values.size(); ++f) {
                QCOMPARE(numberOf(rows.cells[part][4 + f]), values[f]);
            }
        }
    }

    void anyNumberOfThreadsGivesTheSameRows() {
        const Project project = shaftBatch(61);
        const std::string one = rowsOf(project, 1).text;
        QCOMPARE(rowsOf(project, 4).text, one);
        QCOMPARE(rowsOf(project, 7).text, one);
    }

    /// Parts in random order, and ended between rounds.
    void roundsGiveTheSameRowsToo() {
        BatchOptions options;
        options.meanWidth_um = 1e9;
        options.round = 16;
        const Rows one = rowsOf(shaftBatch(40), 1, options);
        QVERIFY(one.result.status == BatchStatus::narrowEnough);
        QCOMPARE(one.cells.size(), std::size_t{16});
        QCOMPARE(rowsOf(shaftBatch(40), 4, options).text, one.text);
    }

    /// While the first part is missing those that come after it are held, and no more than 1024.
    void aSlowPartHoldsTheOthersBack() {
        std::vector<std::int64_t> told;
        const PartSink sink = [&told](const PartRecord& record) {
            told.push_back(record.part);
            return true;
        };
        PartQueue queue(sink, 0, {});
        std::atomic<std::int64_t> held = 0;
        std::jthread ahead([&] {
            for (std::int64_t place = 1; place <= 3000; ++place) {
                queue.put(place, {place, {}, {}});
                ++held;
            }
        });
        QTRY_COMPARE(held.load(), std::int64_t{1023});
        QTest::qWait(50);
        QCOMPARE(held.load(), std::int64_t{1023});
        QVERIFY(queue.put(0, {0, {}, {}}));
        ahead.join();
        QCOMPARE(told.size(), std::size_t{3001});
        QVERIFY(std::ranges::is_sorted(told));
    }

    void aStopFreesWhoWaits() {
        const PartSink sink = [](const PartRecord&) { return true; };
        std::stop_source stop;
        PartQueue queue(sink, 0, stop.get_token());
        std::atomic<bool> freed = false;
        std::jthread waits([&] { freed = !queue.put(5000, {5000, {}, {}}); });
        QTest::qWait(20);
        QVERIFY(!freed);
        stop.request_stop();
        QTRY_VERIFY(freed);
    }

    void aSinkThatWantsNoMoreEndsIt() {
        std::int64_t taken = 0;
        BatchOptions options;
        options.threads = 2;
        options.sink = [&](const PartRecord&) { return ++taken < 10; };
        const BatchResult result = runBatch(shaftBatch(500), options);
        QCOMPARE(taken, std::int64_t{10});
        QVERIFY(result.status == BatchStatus::stopped);
        QVERIFY(result.statistics.parts < 500);
    }

    void aPartThatDoesNotReachSizeHasNoNumbers() {
        PartRecord record;
        record.part = 7;
        record.factors = {0.25};
        const PartColumns columns = PartColumns::of(ScenarioSource(stiffBatchWithRunout()));
        const std::string line = PartTable(columns, {}).line(record);
        const auto cells = cellsOf(line.substr(0, line.size() - 1));
        QCOMPARE(cells.size(), PartTable::keys(columns).size());
        QCOMPARE(cells[1], std::string("cannot_reach_size"));
        QCOMPARE(cells[2], std::string("false"));
        QCOMPARE(cells[4], std::string("0.25"));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            QVERIFY2(i < 3 || i == 4 || cells[i].empty(), std::to_string(i).c_str());
        }
    }

    void whereStripsStayUncutTheSurfaceHasNoNumbers() {
        Project project = shaftBatch(4);
        for (Stage& stage : project.cycle->stages) {
            if (stage.axial_feed_mm_min) {
                *stage.axial_feed_mm_min *= 100;
            }
        }
        const Rows rows = rowsOf(project, 1);
        QCOMPARE(rows.cells.size(), std::size_t{4});
        const auto keys = PartTable::keys(rows.columns);
        for (const auto& cells : rows.cells) {
            QCOMPARE(cells[1], std::string("strips_uncut"));
            for (std::size_t i = 0; i < keys.size(); ++i) {
                const bool ofSurface = keys[i].find(" [µm]") != std::string::npos;
                const bool isTime = keys[i] == "time part [s]";
                QVERIFY2(!ofSurface || cells[i].empty(), keys[i].c_str());
                QVERIFY2(!isTime || !cells[i].empty(), keys[i].c_str());
            }
            int failed = 0;
            for (const ConstraintKind kind : rows.columns.requirements) {
                const auto at =
                    std::ranges::find(keys, std::string(requirementOf(kind).key) + " holds");
                QVERIFY(at != keys.end());
                const std::string& cell = cells[static_cast<std::size_t>(at - keys.begin())];
                if (requirementOf(kind).isOfSurface() || kind == ConstraintKind::overlap) {
                    QVERIFY2(cell != "true", at->c_str()); // empty: not required of this part
                    failed += cell == "false" ? 1 : 0;
                }
            }
            QVERIFY(failed > 2);
            QCOMPARE(cells[3], std::string());
        }
    }

    void aDialectSaysHowNumbersAreWritten() {
        PartTable::Dialect dialect;
        dialect.table.delimiter = ';';
        dialect.table.decimal = ',';
        dialect.begin = "\xEF\xBB\xBF";
        dialect.lineEnd = "\r\n";
        const PartColumns columns = PartColumns::of(ScenarioSource(stiffBatchWithRunout()));
        const PartTable table(columns, dialect);
        QCOMPARE(table.head({"a;b", "say \"c\""}),
                 std::string("\xEF\xBB\xBF\"a;b\";\"say \"\"c\"\"\"\r\n"));
        PartRecord record;
        record.factors = {0.25};
        QVERIFY(table.line(record).starts_with("0;cannot_reach_size;false;;0,25;"));
        QVERIFY(table.line(record).ends_with(";\r\n"));
    }

private:
    static Project stiffBatchWithRunout() {
        Project project = stiffBatch(3);
        project.batch->factors.initial_runout_mm = uniform(0.001, 0.002);
        return project;
    }
};

} // namespace sparkout::test_batch_rows

SPARKOUT_TEST(test_batch_rows, TestBatchRows)
#include "test_batch_rows.moc"
