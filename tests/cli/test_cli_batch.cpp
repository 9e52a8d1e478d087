// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `batch` and `batch-merge` as a user meets them: the real program, its exit status, what it
// prints.
#include "core/batch/batch_summary.h"
#include "core/batch/sensitivity.h"
#include "tests/cli/cli_bench.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>

namespace test_cli_batch {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

/// A batch that is still running, with its progress on stderr.
class RunningBatch {
public:
    explicit RunningBatch(const QString& file, const QStringList& more = {}) {
        m_process.start(SPARKOUT_CLI, QStringList{"batch", file, "--parts", "1000000", "--threads",
                                                  "2", "--json", "--progress"}
                                          + more);
    }
    /// Waits until some parts are done; false: it takes too long.
    bool hasDoneSome() {
        while (m_process.waitForReadyRead(-1) || m_process.state() == QProcess::Running) {
            m_progress += m_process.readAllStandardError().toStdString();
            const auto told = split(m_progress, '\n');
            if (!told.empty() && std::stoll(told.back()) > 0) {
                return true;
            }
        }
        return false;
    }
    ProcessOutcome endBy(int signal) {
        endBySignal(m_process, signal);
        return outcomeOf(m_process);
    }
    void readProgress() { m_process.setReadChannel(QProcess::StandardError); }

private:
    QProcess m_process;
    std::string m_progress;
};

class TestCliBatch : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        m_file = samplePath("complete");
        QVERIFY(projectOf(m_file).batch.has_value());
    }

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const char* name, const QStringList& options) {
            QTest::newRow(name) << QStringList{"batch", "a"} + options;
        };
        QTest::newRow("no file") << QStringList{"batch"};
        QTest::newRow("no shard") << QStringList{"batch-merge"};
        QTest::newRow("parts to merge") << QStringList{"batch-merge", "a", "--parts", "3"};
        QTest::newRow("shard of a simulation") << QStringList{"simulate", "a", "--shard", "1/2"};
        row("two files", {"b"});
        row("no parts", {"--parts"});
        row("negative seed", {"--seed", "-1"});
        row("no threads", {"--threads", "0"});
        row("shard 0", {"--shard", "0/2"});
        row("shard beyond", {"--shard", "3/2"});
        row("shard without slash", {"--shard", "3"});
        row("shard of a word", {"--shard", "1/x"});
        row("shard overflow", {"--shard", "1/99999999999999999999"});
        row("width 0", {"--until-width", "0"});
        row("empty table", {"--measured", ""});
        row("rows without a file", {"--rows"});
        row("rows into a project", {"--rows", "b.sparkout"});
        row("force of nothing", {"--force"});
        row("a shard as CSV", {"--shard", "1/2", "--csv"});
        row("a shard that is checked", {"--shard", "1/2", "--check"});
        row("a shard until narrow", {"--shard", "1/2", "--until-width", "1"});
    }
    void usageErrors() {
        QFETCH(QStringList, arguments);
        const ProcessOutcome outcome = run(arguments);
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
    }

    void helpTellsEveryOption() {
        const std::string help = run({"--help"}).out;
        for (const char* word : {"batch-merge", "--parts", "--seed", "--scenarios", "--measured",
                                 "--until-width", "--sensitivity", "--threads", "--rows", "--shard",
                                 "--csv", "--progress", "Ctrl+C", "130"}) {
            QVERIFY2(has(help, word), word);
        }
        const std::string script =
            samples::readText(samples::sourcePath("resources/help/batch.sbatch"));
        QVERIFY(has(script, "--shard"));
        QVERIFY(has(script, "batch-merge"));
    }

    void jsonSaysWhatTheEngineComputes() {
        const json answer = json::parse(run({"batch", m_file, "--json"}).out);
        const BatchResult result = runBatch(projectOf(m_file));
        const BatchSummary summary = summarise(result);
        QVERIFY(answer.at("status") == "completed");
        QVERIFY(answer.at("parts") == 50 && answer.at("batch_parts") == 50);
        QVERIFY(answer.at("not_good").at("count") == summary.bad.count);
        QVERIFY(answer.at("batch").at("seed") == 1);
        QVERIFY(answer.at("batch").at("factors")
                == samples::sample("complete").at("batch").at("factors"));
        const json& all = answer.at("characteristics");
        QCOMPARE(all.size(), summary.characteristics.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            checkCharacteristic(all[i], summary.characteristics[i]);
        }
    }

    void theWorstPartIsAProjectThatSimulateRuns() {
        const json worst = json::parse(run({"batch", m_file, "--json"}).out).at("worst");
        const QString file = save("worst.sparkout", worst.at("project").dump());
        const json again = json::parse(run({"simulate", file, "--json"}).out);
        double least = 1e9;
        for (const json& constraint : again.at("constraints")) {
            const std::string name = constraint.at("name");
            if (!name.starts_with("range_") && name != "gauge_commands") {
                least = std::min(least, constraint.at("relative_margin").get<double>());
            }
        }
        const BatchResult result = runBatch(projectOf(m_file));
        QCOMPARE(least, result.statistics.worst.value);
        QVERIFY(worst.at("part") == result.statistics.worst.part);
        QVERIFY(worst.at("factors").size() == 3);
    }

    void everyRowOfTheCsvHasEveryColumn() {
        for (const char* scenarios : {"random", "corners"}) {
            const std::string csv = run({"batch", m_file, "--csv", "--scenarios", scenarios}).out;
            const auto rows = split(csv, '\n');
            QCOMPARE(rows.size(), characteristicsOf(projectOf(m_file)).size() + 1);
            for (const std::string& row : rows) {
                QCOMPARE(std::count(row.begin(), row.end(), ','),
                         std::count(rows[0].begin(), rows[0].end(), ','));
            }
        }
    }

    void allPartsAreWrittenAsRows() {
        const QString one = m_folder.filePath("one.csv"), four = m_folder.filePath("four.csv");
        QCOMPARE(run({"batch", m_file, "--rows", one, "--threads", "1"}).status, 0);
        const ProcessOutcome outcome =
            run({"batch", m_file, "--rows", four, "--threads", "4", "--json"});
        QCOMPARE(outcome.status, 0);
        const std::string text = samples::readText(one.toStdString());
        QCOMPARE(samples::readText(four.toStdString()), text);
        const auto rows = split(text, '\n');
        QCOMPARE(rows.size(), std::size_t{51});
        QVERIFY(rows[0].starts_with("part,status,good,least_relative_margin,stock_mm,"));
        QVERIFY(rows[1].starts_with("0,completed,true,"));
        // What the summary says of the worst part is in its row.
        const json worst = json::parse(outcome.out).at("worst");
        const auto cells = split(rows[1 + worst.at("part").get<std::size_t>()], ',');
        QCOMPARE(QByteArray::fromStdString(cells[4]).toDouble(),
                 worst.at("factors").at("stock_mm").get<double>());
        QCOMPARE(QDir(m_folder.path()).entryList({".sparkout-*"}, QDir::Hidden | QDir::Files),
                 QStringList());
    }

    void rowsOfShardsAreThoseOfTheWhole() {
        const auto rowsOf = [this](const QStringList& which, const char* name) {
            const QString file = m_folder.filePath(name);
            run(QStringList{"batch", m_file, "--rows", file} + which);
            return samples::readText(file.toStdString());
        };
        const std::string whole = rowsOf({}, "whole.csv"),
                          first = rowsOf({"--shard", "1/2"}, "first.csv"),
                          second = rowsOf({"--shard", "2/2"}, "second.csv");
        QCOMPARE(first + second.substr(second.find('\n') + 1), whole);
    }

    void aFileThatIsThereIsNotReplacedUnasked() {
        const QString file = save("kept.csv", "mine");
        const ProcessOutcome outcome = run({"batch", m_file, "--rows", file});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.out.empty());
        QVERIFY2(has(outcome.err, "kept.csv: exists; --force replaces it\n"), outcome.err.c_str());
        QCOMPARE(samples::readText(file.toStdString()), std::string("mine"));
        QCOMPARE(run({"batch", m_file, "--rows", file, "--force"}).status, 0);
        QVERIFY(samples::readText(file.toStdString()).starts_with("part,"));
        const ProcessOutcome project = run({"batch", m_file, "--rows", m_file, "--force"});
        QVERIFY2(isUsageError(project), project.text().c_str());
        const QString blanks = save("blanks2.csv", "stock_mm\n0.141\n");
        QVERIFY(isUsageError(
            run({"batch", m_file, "--measured", blanks, "--rows", blanks, "--force"})));
        const ProcessOutcome nowhere =
            run({"batch", m_file, "--rows", m_folder.filePath("no folder/a.csv")});
        QCOMPARE(nowhere.status, 1);
        QVERIFY(nowhere.out.empty());
    }

    void rowsThatAreStoppedLeaveNoFile() {
        const QString file = m_folder.filePath("stopped.csv");
        RunningBatch batch(m_file, {"--rows", file});
        batch.readProgress();
        QVERIFY(batch.hasDoneSome());
        QCOMPARE(batch.endBy(SIGINT).status, 130);
        QVERIFY(!QFile::exists(file));
        QCOMPARE(QDir(m_folder.path()).entryList({".sparkout-*"}, QDir::Hidden | QDir::Files),
                 QStringList());
    }

    void textNamesTheFigures() {
        const ProcessOutcome outcome = run({"batch", m_file, "--sensitivity", "8"});
        QCOMPARE(outcome.status, 0);
        for (const char* word :
             {"50 of 50 parts, completed", "verdict ", "rejected", "worst part", "stock_mm",
              "rz1 diameter, µm", "Ppk", "normality (Shapiro-Wilk) p", "rank regression",
              "Sobol indices, first and total"}) {
            QVERIFY2(has(outcome.out, word), word);
        }
        const json told = json::parse(run({"batch", m_file, "--json"}).out);
        const int worst = told.at("worst").at("part").get<int>(); // an index
        QVERIFY(has(outcome.out, "worst part " + std::to_string(worst + 1) + ": "));
        static const QRegularExpression allDigits(QStringLiteral("\\d\\.\\d{8}"));
        QVERIFY(!QString::fromStdString(outcome.out).contains(allDigits));
    }

    void mergedShardsPrintWhatOneRunPrints() {
        const QStringList shards{shard(2, 3), shard(3, 3), shard(1, 3)};
        for (const char* output : {"--json", "--csv"}) {
            const ProcessOutcome merged =
                run(QStringList{"batch-merge"} + shards + QStringList{output});
            QCOMPARE(merged.status, 0);
            QCOMPARE(merged.out, run({"batch", m_file, output}).out);
        }
    }

    void whatCannotBeMergedIsRefused() {
        const QString first = shard(1, 2), second = shard(2, 2);
        const auto refuses = [](const QStringList& files, const char* why) {
            const ProcessOutcome outcome = run(QStringList{"batch-merge"} + files);
            return outcome.status == 1 && outcome.out.empty() && has(outcome.err, why);
        };
        const QString copy = save("copy.json", samples::readText(first.toStdString()));
        QVERIFY(refuses({first}, "parts 26…50 of 50 are in no shard"));
        QVERIFY(refuses({first, second, copy}, "copy.json: holds parts 1…25, as does "));
        QVERIFY(refuses({first, second, copy}, first.toUtf8()));
        QVERIFY(refuses({first, m_file}, "not a shard of a batch"));
        std::string changed = samples::readText(second.toStdString());
        const std::size_t least = changed.find("\"least\":[") + 10;
        changed[least + 3] = changed[least + 3] == '1' ? '2' : '1';
        QVERIFY(refuses({first, save("changed.json", changed)},
                        "changed.json: changed since it was written"));
        QVERIFY(refuses({first, m_folder.filePath("none")}, "none: "));
        const QString other =
            save("other.json", run({"batch", m_file, "--shard", "2/2", "--seed", "9"}).out);
        QVERIFY(refuses({first, other}, "other.json: of another batch (project "));
        QVERIFY(refuses({other, first, second}, "other.json: of another batch (project "));
        QCOMPARE(run({"batch-merge", second, first}).status, 0);
    }

    /// The script of a cluster, run as Slurm runs it: a shard a job of the array, then the merge.
    void theClusterScriptTakesTheNumberOfShardsFromTheArray() {
        const QTemporaryDir folder;
        QVERIFY(QFile::copy(m_file, folder.filePath("shaft.sparkout")));
        QVERIFY(QFile::link(SPARKOUT_CLI, folder.filePath("sparkout-cli")));
        const auto job = [&](const QStringList& given) {
            QProcess process;
            process.setWorkingDirectory(folder.path());
            process.setEnvironment(
                QStringList{"PATH=" + folder.path() + ":/usr/bin:/bin", "PARTS=20"} + given);
            process.start("bash", {QString::fromStdString(
                                      samples::sourcePath("resources/help/batch.sbatch"))});
            return outcomeOf(process);
        };
        const auto array = [](int task, int last, int first = 1) {
            return QStringList{"SLURM_ARRAY_TASK_ID=" + QString::number(task),
                               "SLURM_ARRAY_TASK_MIN=" + QString::number(first),
                               "SLURM_ARRAY_TASK_MAX=" + QString::number(last),
                               "SLURM_ARRAY_TASK_COUNT=" + QString::number(last - first + 1)};
        };
        const auto written = [&] { return QDir(folder.path()).entryList({"*.json*"}); };
        QCOMPARE(job(array(0, 2, 0)).status, 2); // counts from 0
        QVERIFY(written().isEmpty());
        for (const int task : {1, 3}) {
            const ProcessOutcome outcome = job(array(task, 3));
            QVERIFY2(outcome.status == 0, outcome.text().c_str());
        }
        const ProcessOutcome failed = job({"MERGE=1"});
        QCOMPARE(failed.status, 1);
        QVERIFY2(has(failed.err, "parts 7…13 of 20 are in no shard"), failed.err.c_str());
        QCOMPARE(written(), (QStringList{"shard-1-of-3.json", "shard-3-of-3.json"}));
        QCOMPARE(job(array(2, 2, 2) + QStringList{"SHARDS=3"}).status, 0); // the one that failed
        QCOMPARE(job({"MERGE=1"}).status, 0);
        QCOMPARE(samples::readText(folder.filePath("batch.json").toStdString()),
                 run({"batch", m_file, "--parts", "20", "--json"}).out);
        QVERIFY(!written().contains("batch.json.part"));
    }

    void optionsTakeThePlaceOfTheFile() {
        const json few = json::parse(run({"batch", m_file, "--json", "--parts", "20"}).out);
        QVERIFY(few.at("parts") == 20);
        const json corners =
            json::parse(run({"batch", m_file, "--json", "--scenarios", "corners"}).out);
        QVERIFY(corners.at("parts") == 8 && corners.at("is_sample") == false);
        QVERIFY(run({"batch", m_file, "--seed", "2"}).out != run({"batch", m_file}).out);
    }

    void anIntervalThatIsNarrowEnoughEndsIt() {
        const json answer = json::parse(
            run({"batch", m_file, "--json", "--parts", "5000", "--until-width", "100"}).out);
        QVERIFY(answer.at("status") == "narrow_enough");
        QVERIFY(answer.at("parts") == 1024 && answer.at("batch_parts") == 5000);
        for (const json& one : answer.at("characteristics")) {
            if (one.at("unit") == "µm") {
                const json& interval = one.at("mean_interval_95");
                QVERIFY(interval[1].get<double>() - interval[0].get<double>() <= 100);
            }
        }
    }

    void sobolIndicesAreThoseOfTheEngine() {
        const json answer =
            json::parse(run({"batch", m_file, "--json", "--sensitivity", "16"}).out);
        const auto indices = sobolIndices(projectOf(m_file), 16);
        QVERIFY(answer.at("sobol_simulations") == 16 * 5);
        const json& time = answer.at("characteristics").back().at("sobol_indices");
        QCOMPARE(time.at("stock_mm").at("first").get<double>(),
                 indices->byCharacteristic.back().front().first);
        json file = samples::sample("complete");
        file["batch"]["factors"].erase("dullness");
        file["batch"]["correlation"] = {{1, 0.5}, {0.5, 1}};
        const QString correlated = save("correlated.sparkout", file.dump());
        const ProcessOutcome outcome = run({"batch", correlated, "--sensitivity", "16"});
        QCOMPARE(outcome.status, 1);
        QVERIFY(has(outcome.err, "not correlated"));
        QCOMPARE(run({"batch", correlated}).status, 0);
    }

    void measuredBlanksTakeThePlaceOfALaw() {
        const QString table = save("blanks.csv", "no;stock_mm\n1;0,141\n2;0,147\n");
        const ProcessOutcome outcome = run({"batch", m_file, "--json", "--measured", table});
        QCOMPARE(outcome.status, 0);
        QVERIFY(has(outcome.err, "2 values of stock_mm"));
        const json worst = json::parse(outcome.out).at("worst");
        const double stock = worst.at("factors").at("stock_mm");
        QVERIFY(stock == 0.141 || stock == 0.147);
        const QString words = save("words.csv", "stock_mm\n0.15\nwide\x1b[2J\n");
        const ProcessOutcome refused = run({"batch", m_file, "--measured", words});
        QCOMPARE(refused.status, 1);
        QVERIFY(refused.out.empty());
        QVERIFY2(has(refused.err, "line 3: not understood: \"wide\\u001b[2J\""),
                 refused.err.c_str());
        QCOMPARE(run({"batch", m_file, "--measured", m_folder.filePath("none")}).status, 1);
    }

    void checkExits4WhenAPartFails() {
        json file = samples::sample("complete");
        QCOMPARE(run({"batch", save("c.sparkout", file.dump())}).status, 0);
        file["part"]["tolerance"]["radial_runout_um"] = 1e-6;
        const QString strict = save("strict.sparkout", file.dump());
        const ProcessOutcome outcome = run({"batch", strict, "--check", "--json"});
        QCOMPARE(outcome.status, 4);
        QVERIFY(json::parse(outcome.out).at("not_good").at("count") == 50);
        QCOMPARE(run({"batch", strict}).status, 0);
    }

    void aBatchThatCannotBeRunIsRefusedAndTheCycleIsNot() {
        json file = samples::sample("complete");
        file["batch"]["factors"]["stock_mm"] = {{"uniform", {0.15, 0.13}}};
        const QString path = save("reversed.sparkout", file.dump());
        const ProcessOutcome outcome = run({"batch", path});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.out.empty());
        QVERIFY(has(outcome.err,
                    "/batch/factors/stock_mm/uniform/1: 0.13 is out of range; allowed: "
                    "≥ 0.15\n"));
        QCOMPARE(run({"simulate", path}).status, 0);
        const ProcessOutcome validated = run({"validate", path});
        QCOMPARE(validated.status, 1);
        for (const ProcessOutcome& each : {outcome, validated}) { // an error, once
            QVERIFY(std::ranges::count(each.err, '\n') == 1);
            QVERIFY2(!has(each.err, "warning"), each.err.c_str());
        }
        file["batch"]["factors"]["stock_mm"] = json::object();
        const ProcessOutcome lawless = run({"validate", save("lawless.sparkout", file.dump())});
        QVERIFY2(has(lawless.err, "/batch/factors/stock_mm: no law given; expected one of "
                                  "uniform | normal | "),
                 lawless.err.c_str());
        const ProcessOutcome none = run({"batch", samplePath("smallest-plunge")});
        QCOMPARE(none.status, 1);
        QVERIFY(has(none.err, ": /batch: "));
    }

    void aSignalEndsItAndKeepsWhatWasDone_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl+C") << SIGINT;
        QTest::newRow("the end of a job") << SIGTERM;
    }
    void aSignalEndsItAndKeepsWhatWasDone() {
        QFETCH(int, signal);
        RunningBatch batch(m_file);
        batch.readProgress();
        QVERIFY(batch.hasDoneSome());
        RunningTimer timer;
        const ProcessOutcome outcome = batch.endBy(signal);
        QVERIFY(timer.elapsed() < 5000); // the quickness itself is the engine's test
        QCOMPARE(outcome.status, 128 + signal);
        const json answer = json::parse(outcome.out);
        QVERIFY(answer.at("status") == "stopped");
        QVERIFY(answer.at("parts") > 0 && answer.at("parts") < 1'000'000);
        QVERIFY(answer.at("characteristics").at(0).at("count") == answer.at("parts"));
    }

private:
    [[nodiscard]] QString shard(int index, int shards) const {
        const QString which = QString::number(index) + "/" + QString::number(shards);
        return save(QString::number(index) + "of" + QString::number(shards) + ".json",
                    run({"batch", m_file, "--shard", which}).out);
    }

    static void checkCharacteristic(const json& answer, const CharacteristicSummary& expected) {
        QVERIFY(answer.at("name") == expected.characteristic.name);
        QVERIFY(answer.at("unit") == expected.characteristic.unit);
        QVERIFY(answer.at("count") == expected.count);
        if (expected.count == 0) {
            return;
        }
        QCOMPARE(answer.at("min").get<double>(), expected.least.value);
        QCOMPARE(answer.at("max").get<double>(), expected.most.value);
        QCOMPARE(answer.at("mean").get<double>(), expected.moments.mean);
        QCOMPARE(answer.at("standard_deviation").get<double>(), expected.moments.deviation);
        QCOMPARE(answer.at("mean_interval_95")[0].get<double>(), expected.mean95->low);
        QVERIFY(answer.at("cp").is_null() && answer.at("cpk").is_null()); // the dullness drifts
        QCOMPARE(answer.at("pp").is_null(), !expected.pp);
        QCOMPARE(answer.at("ppk").is_null(), !expected.ppk);
        QCOMPARE(answer.at("expected_outside").is_null(), !expected.expectedOutside);
        if (expected.ppk) {
            QCOMPARE(answer.at("ppk").at("value").get<double>(), expected.ppk->value);
            QCOMPARE(answer.at("ppk").at("interval_95")[0].get<double>(),
                     expected.ppk->interval.low);
        }
        QCOMPARE(answer.at("normality_probability").is_null(), !expected.normality);
        if (expected.normality) {
            QCOMPARE(answer.at("normality_probability").get<double>(),
                     expected.normality->probability);
            QVERIFY(answer.at("normality_test") == "shapiro_wilk");
        }
        const Characteristic& of = expected.characteristic;
        if (of.low || of.high) {
            QVERIFY(answer.at("outside").at("count") == expected.outside.count);
        } else {
            QVERIFY(answer.at("outside").is_null());
        }
        QCOMPARE(answer.at("percentiles").size(), expected.percentiles.size());
        QCOMPARE(answer.at("histogram").size(), expected.histogram.size());
    }

    QString m_file;
};

} // namespace test_cli_batch

SPARKOUT_TEST(test_cli_batch, TestCliBatch)
#include "test_cli_batch.moc"
