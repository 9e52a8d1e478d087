// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a user meets it: the real program, its exit status and what it prints.
#include "core/project/safe_file.h"
#include "core/quality/constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"
#include "core/version.h"
#include "tests/cli/cli_process.h"
#include "tests/registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <cmath>
#include <iterator>
#include <map>
#include <random>

#include <sys/stat.h>
#include <unistd.h>

namespace test_cli {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

namespace {

const char* zoneName(Zone zone) {
    return zone == Zone::rz1 ? "rz1" : zone == Zone::nz ? "nz" : "rz2";
}

} // namespace

class TestCli : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        std::setlocale(LC_NUMERIC, "C"); // the application object took the environment's
        QVERIFY(m_folder.isValid());
        json slow = samples::sample("smallest-plunge");
        slow["cycle"]["stages"] = {{{"radial_feed_mm_min", 0.5}, {"stock_mm", 0.01}},
                                   {{"spark_out", "until_size"}, {"stock_mm", 0.14}}};
        m_stuck = save("stuck.sparkout", slow.dump());
        json strict = samples::sample("complete");
        strict["part"]["tolerance"]["radial_runout_um"] = 1e-6;
        m_strict = save("strict.sparkout", strict.dump());
    }

    // --- exit status and usage ------------------------------------------------------------------

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("empty") << QStringList{""};
        QTest::newRow("unknown command") << QStringList{"grind", "a"};
        QTest::newRow("no file") << QStringList{"simulate"};
        QTest::newRow("no file to validate") << QStringList{"validate"};
        QTest::newRow("no folder") << QStringList{"examples"};
        QTest::newRow("empty file name") << QStringList{"simulate", ""};
        QTest::newRow("two files") << QStringList{"simulate", "a", "b"};
        QTest::newRow("unknown option") << QStringList{"simulate", "a", "--jsom"};
        QTest::newRow("option of another command") << QStringList{"validate", "a", "--json"};
        QTest::newRow("no trace file") << QStringList{"simulate", "a", "--trace"};
        QTest::newRow("empty trace file") << QStringList{"simulate", "a", "--trace", ""};
        QTest::newRow("help of a command") << QStringList{"simulate", "--help"};
    }
    void usageErrors() {
        QFETCH(QStringList, arguments);
        const Outcome outcome = run(arguments);
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
    }

    void helpAndVersionSucceed() {
        const Outcome help = run({"--help"});
        QCOMPARE(help.status, 0);
        for (const char* word : {"simulate", "validate", "examples", "--trace", "Exit status"}) {
            QVERIFY2(help.out.find(word) != std::string::npos, word);
        }
        QCOMPARE(run({"--version"}).out, "sparkout-cli " + std::string(version) + "\n");
    }

    void validFilesPass_data() {
        QTest::addColumn<QString>("file");
        for (const std::string& name : samples::names()) {
            QTest::newRow(name.c_str()) << samplePath(name);
        }
    }
    void validFilesPass() {
        QFETCH(QString, file);
        const Outcome outcome = run({"validate", file});
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.out.empty());
        const Issues warnings = readProject(samples::readText(file.toStdString())).issues;
        QCOMPARE(lines(outcome.err), warnings.size());
    }

    void refusedFileNamesPathValueAndRange() {
        json file = samples::sample("smallest-plunge");
        file["wheel"]["width_mm"] = 2000;
        file["part"]["profile"] = "square";
        file["machine"].erase("work_speed_rpm");
        const QString path = save("three.sparkout", file.dump());
        for (const char* command : {"validate", "simulate"}) {
            const Outcome outcome = run({command, path});
            QCOMPARE(outcome.status, 1);
            QVERIFY(outcome.out.empty());
            QCOMPARE(lines(outcome.err), std::size_t{3});
            for (const char* expected :
                 {": /wheel/width_mm: 2000 mm is out of range; allowed: 0.5…1000 mm\n",
                  ": /part/profile: \"square\" is not one of the choices; allowed: \"ellipse\", "
                  "\"eccentric\", \"lobes\", \"measured\"\n",
                  ": /machine/work_speed_rpm: this value is required; allowed: 0.1…10000 "
                  "rev/min\n"}) {
                QVERIFY2(outcome.err.find(path.toStdString() + expected) != std::string::npos,
                         outcome.err.c_str());
            }
        }
    }

    void cannotReachSizeExits3() {
        const Outcome outcome = run({"simulate", m_stuck, "--json"});
        QCOMPARE(outcome.status, 3);
        QVERIFY(json::parse(outcome.out).at("status") == json("cannot_reach_size"));
        QVERIFY(outcome.err.find("cannot reach size") != std::string::npos);
    }

    void checkExits4WhenARequirementFails() {
        QCOMPARE(run({"simulate", m_strict, "--check"}).status, 4);
        QCOMPARE(run({"simulate", m_strict}).status, 0);
        json loose = samples::sample("complete");
        loose["part"]["lower_deviation_um"] = -200;
        loose["part"]["upper_deviation_um"] = 200;
        loose["part"]["tolerance"]["radial_runout_um"] = 900;
        QCOMPARE(run({"simulate", save("loose.sparkout", loose.dump()), "--check"}).status, 0);
    }

    void checkExits4ForEachRequirement_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("path");
        QTest::addColumn<double>("holds");
        QTest::addColumn<double>("fails");
        QStringList named;
        const auto row = [&named](const char* name, const char* path, double holds, double fails) {
            QTest::newRow(name) << name << path << holds << fails;
            named += name;
        };
        row("diameter_min", "/part/lower_deviation_um", -200, 100);
        row("diameter_max", "/part/upper_deviation_um", 200, -100);
        row("radial_runout", "/part/tolerance/radial_runout_um", 50, 1e-9);
        row("roundness", "/part/tolerance/roundness_um", 50, 1e-9);
        row("cylindricity", "/part/tolerance/cylindricity_um", 50, 1e-9);
        row("total_runout", "/part/tolerance/total_runout_um", 50, 1e-9);
        row("roughness", "/part/tolerance/roughness_ra_um", 50, 1e-6);
        row("burn", "/material/burn_rise_k", 3000, 50);
        row("self_sharpening", "/wheel/grains_per_mm2", 1000, 0.01);
        row("wheel_power", "/machine/wheel_drive_kw", 100, 0.001);
        row("work_power", "/machine/work_drive_kw", 100, 0.00001);
        row("range_radial_feed", "/machine/limits/radial_feed_mm/1", 0.02, 0.002);
        row("range_axial_feed", "/machine/limits/axial_feed_mm_min/1", 5000, 400);
        row("range_plunge_feed", "/machine/limits/plunge_feed_mm_min/1", 5, 0.1);
        row("range_work_speed", "/machine/limits/work_speed_rpm/1", 500, 100);
        row("gauge_commands", "/gauge/commands", 5, 1);
        for (int kind = 0; kind < constraintKinds; ++kind) {
            QVERIFY(named.contains(constraintName(static_cast<ConstraintKind>(kind))));
        }
    }
    /// The program's status on either side of a limit, as near to it as a double comes.
    void checkExits4ForEachRequirement() {
        QFETCH(QString, name);
        QFETCH(QString, path);
        QFETCH(double, holds);
        QFETCH(double, fails);
        QVERIFY(requirementHolds(path, holds));
        QVERIFY(!requirementHolds(path, fails));
        const bool whole = path == "/gauge/commands";
        for (double middle = (holds + fails) / 2;
             middle != holds && middle != fails && !(whole && holds - fails <= 1);
             middle = (holds + fails) / 2) {
            middle = whole ? std::floor(middle) : middle;
            (requirementHolds(path, middle) ? holds : fails) = middle;
        }
        for (const double limit : {holds, fails}) {
            const QString saved = save("one.sparkout", withOneRequirement(path, limit).dump());
            const Outcome outcome = run({"simulate", saved, "--check", "--json"});
            QCOMPARE(outcome.status, limit == holds ? 0 : 4);
            bool listed = false;
            const json answer = json::parse(outcome.out);
            for (const json& constraint : answer.at("constraints")) {
                const bool found = constraint.at("name") == name.toStdString();
                listed = listed || found;
                QVERIFY(constraint.at("ok") == (!found || limit == holds));
            }
            QVERIFY(listed);
        }
    }

    void unreadableFilesExit1_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("missing") << m_folder.filePath("no such file");
        QTest::newRow("no such folder") << m_folder.filePath("no/such/file");
        QTest::newRow("directory") << m_folder.path();
        QTest::newRow("device") << "/dev/null";
        QTest::newRow("endless device") << "/dev/zero";
        QTest::newRow("name too long") << m_folder.filePath(QString(300, 'x'));
        QTest::newRow("a dash") << "-";
        const QString fifo = m_folder.filePath("fifo");
        mkfifo(fifo.toUtf8(), 0600);
        QTest::newRow("FIFO") << fifo;
        if (geteuid() != 0) {
            const QString locked = save("locked.sparkout", "{}");
            chmod(locked.toUtf8(), 0);
            QTest::newRow("not permitted") << locked;
        }
    }
    void unreadableFilesExit1() {
        QFETCH(QString, file);
        for (const char* command : {"validate", "simulate"}) {
            const Outcome outcome = run({command, file});
            QCOMPARE(outcome.status, 1);
            QCOMPARE(lines(outcome.err), std::size_t{1});
            QVERIFY2(outcome.err.starts_with(file.toStdString() + ": "), outcome.err.c_str());
        }
    }

    void hostileFilesAreRefusedLineByLine_data() {
        QTest::addColumn<QString>("file");
        for (const auto& entry :
             std::filesystem::directory_iterator(samples::sourcePath("tests/data/hostile"))) {
            QTest::newRow(entry.path().filename().c_str()) << QString::fromStdString(entry.path());
        }
        QTest::newRow("10 MB of [") << save("nested.sparkout", std::string(10'000'000, '['));
        QTest::newRow("32 MB + 1")
            << save("large.sparkout", std::string(limits::fileBytes + 1, ' '));
    }
    void hostileFilesAreRefusedLineByLine() {
        QFETCH(QString, file);
        const Outcome outcome = run({"validate", file});
        const std::string content = samples::readText(file.toStdString());
        const bool accepted = file.contains("/accepted");
        QCOMPARE(outcome.status, accepted ? 0 : 1);
        const bool tooLarge = content.size() > limits::fileBytes;
        QCOMPARE(lines(outcome.err), tooLarge ? 1 : readProject(content).issues.size());
        for (const std::string& line : split(outcome.err, '\n')) {
            QVERIFY2(line.starts_with(file.toStdString() + ": "), line.c_str());
            QVERIFY2(std::none_of(line.begin(), line.end(),
                                  [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
                     line.c_str());
            QVERIFY2(line.find("\u202e") == std::string::npos, line.c_str());
        }
    }

    void aFloodOfFaultsIsCutAndSaysSo() {
        json file = samples::sample("smallest-plunge");
        for (int i = 0; i < 5000; ++i) {
            file["k" + std::to_string(i)] = i;
        }
        const Outcome outcome = run({"validate", save("flood.sparkout", file.dump())});
        QCOMPARE(outcome.status, 1);
        QCOMPARE(lines(outcome.err), limits::issues + 1);
        QVERIFY(outcome.err.ends_with("no further faults are listed\n"));
    }

    // --- simulate -------------------------------------------------------------------------------

    void jsonSaysWhatSimulateComputes_data() { runnableRows(); }
    void jsonSaysWhatSimulateComputes() {
        QFETCH(QString, file);
        const Outcome outcome = run({"simulate", file, "--json"});
        QCOMPARE(outcome.status, 0);
        const json answer = json::parse(outcome.out);
        const SimulationResult result = simulate(projectOf(file));
        const bool traverse = result.project.operation == Operation::traverse;
        QVERIFY(answer.at("status") == "completed");
        QVERIFY(answer.at("operation") == (traverse ? "traverse" : "plunge"));
        QCOMPARE(answer.at("cycle_time_min").get<double>(), result.time_s / 60);
        QVERIFY(answer.at(traverse ? "double_strokes" : "revolutions") == result.cycleCount);
        QVERIFY(answer.at(traverse ? "double_strokes_by_stage" : "revolutions_by_stage")
                == json(result.countsByStage));
        QVERIFY(!answer.contains(traverse ? "revolutions" : "double_strokes"));
        QVERIFY(!answer.contains(traverse ? "sections" : "zones"));
        QCOMPARE(answer.at("peak").at("normal_force_n").get<double>(), result.peakNormalForce_n);
        QCOMPARE(answer.at("peak").at("power_w").get<double>(), result.peakPower_w);
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            checkSection(traverse ? answer.at("zones").at(zoneName(result.sections[i].zone))
                                  : answer.at("sections").at(i),
                         result.sections[i], result.project.part.diameter_mm);
        }
        QCOMPARE(answer.at(traverse ? "zones" : "sections").size(), result.sections.size());
        checkForm(answer, result);
        checkConstraints(answer.at("constraints"), worstByKind(evaluateConstraints(result)));
        checkShop(answer.at("shop"), shopNumbers(result));
    }

    void textNamesTheRequirements() {
        json file = samples::sample("complete");
        file["title"] = "a\x1b[2Jb";
        const Outcome outcome = run({"simulate", save("title.sparkout", file.dump())});
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.out.starts_with("a\\u001B[2Jb\n"));
        for (const char* word :
             {"status", "machining time", "double strokes", "diameter_min", "diameter_max",
              "radial_runout", "rz1", "nz", "rz2", "cylindricity, µm", "total runout, µm", "taper",
              "roundness", "roughness", "burn", "nearest to burning", "wheel_power", "kW  holds",
              "gauge_commands"}) {
            QVERIFY2(outcome.out.find(word) != std::string::npos, word);
        }
    }

    void textListsTheShopsNumbersStageByStage() {
        const std::string out = run({"simulate", samplePath("complete")}).out;
        const ShopNumbers shop = shopNumbers(simulate(projectOf(samplePath("complete"))));
        const auto head = row(out, "shop's numbers");
        QCOMPARE(head.size(), 2 * shop.stages.size() + 1); // "stage 1 stage 2 … cycle"
        QCOMPARE(head.back(), std::string("cycle"));
        const auto energies = row(out, "  energy, J/mm³");
        QCOMPARE(energies.size(), shop.stages.size() + 1);
        for (std::size_t z = 0; z < shop.stages.size(); ++z) {
            const double shown = QByteArray::fromStdString(energies[z]).toDouble();
            QVERIFY(std::abs(shown / *shop.stages[z].energy_j_mm3 - 1) < 1e-3); // four digits
        }
        QVERIFY(!row(out, "  overlap B/s_ax").empty());
        QVERIFY(row(run({"simulate", samplePath("smallest-plunge")}).out, "  overlap").empty());
    }

    void textMarksWhatLiesOutsideItsBand() {
        json file = samples::sample("complete");
        QCOMPARE(run({"simulate", samplePath("complete")}).out.find("(<)"), std::string::npos);
        file["wheel"]["dullness"] = 0; // the shear alone: 5.6 J/mm³
        file["wheel"]["diameter_mm"] = 500;
        file["machine"]["work_speed_rpm"] = 150;
        file["machine"]["wheel_speed_m_s"] = 31.416; // 1200 rev/min, 8 : 1
        const std::string out = run({"simulate", save("sharp.sparkout", file.dump())}).out;
        QVERIFY(out.find("(<)5.600") != std::string::npos);
        QVERIFY(out.find("20…120 J/mm³") != std::string::npos);
        QVERIFY(out.find("8.000 wheel : work, near a whole number: WAVINESS") != std::string::npos);
    }

    void traceHoldsEveryVisit_data() { runnableRows(); }
    void traceHoldsEveryVisit() {
        QFETCH(QString, file);
        const QString trace = m_folder.filePath("trace.csv");
        QCOMPARE(run({"simulate", file, "--trace", trace}).status, 0);
        Trajectory trajectory;
        const SimulationResult result = simulate(projectOf(file), &trajectory);
        const auto rows = split(samples::readText(trace.toStdString()), '\n');
        const bool traverse = result.project.operation == Operation::traverse;
        const std::string columns =
            "programmed_mm,actual_mm,accumulated_mm,radius_um,normal_force_n";
        QCOMPARE(rows.at(0), (traverse ? "time_min,double_stroke,stage,zone,step,revolution,radius,"
                                       : "time_min,revolution,stage,section,radius,")
                                 + columns);
        QCOMPARE(static_cast<long long>(rows.size() - 1), result.visits);
        std::map<std::string, double> sums;
        std::map<std::string, double> accumulated;
        const std::size_t place = 3;
        const std::size_t radius = traverse ? 6 : 4;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const auto cells = split(rows[i], ',');
            QCOMPARE(cells.size(), radius + 6);
            const std::string key = cells[place] + ' ' + cells[radius];
            sums[key] += QByteArray::fromStdString(cells[radius + 2]).toDouble();
            accumulated[key] = QByteArray::fromStdString(cells[radius + 3]).toDouble();
        }
        for (const auto& [key, sum] : sums) {
            QVERIFY2(std::abs(sum - accumulated[key]) <= 1e-12, key.c_str());
        }
        QCOMPARE(sums.size(), result.sections.size() * static_cast<std::size_t>(trajectory.radii));
    }

    void traceThatCannotBeWrittenExits1() {
        for (const QString& trace :
             {m_folder.path(), m_folder.filePath("no/such/folder.csv"), QString("/dev/full")}) {
            const Outcome outcome =
                run({"simulate", samplePath("smallest-plunge"), "--trace", trace});
            QCOMPARE(outcome.status, 1);
            QVERIFY2(outcome.err.starts_with(trace.toStdString() + ": "), outcome.err.c_str());
        }
        if (geteuid() != 0) {
            const QString locked = save("read-only.csv", "old");
            chmod(locked.toUtf8(), 0444);
            QCOMPARE(run({"simulate", samplePath("smallest-plunge"), "--trace", locked}).status, 1);
            QCOMPARE(samples::readText(locked.toStdString()), std::string("old"));
        }
    }

    void traceOfMillionsOfRowsIsRefused() {
        json file = samples::sample("smallest-plunge");
        file["sections"] = 200;
        file["part"]["radii_per_section"] = 360;
        file["machine"]["compliance_mm_per_n"] = std::vector<double>(200, 2e-5);
        file["cycle"]["stages"][0]["radial_feed_mm_min"] = 0.1;
        const QString trace = m_folder.filePath("huge.csv");
        const Outcome outcome =
            run({"simulate", save("huge.sparkout", file.dump()), "--trace", trace});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.err.find("rows; allowed: at most") != std::string::npos,
                 outcome.err.c_str());
        QVERIFY(!std::filesystem::exists(trace.toStdString()));
    }

    // --- surroundings ---------------------------------------------------------------------------

    void outputThatIsNotTakenExits1() {
        QProcess full;
        full.setStandardOutputFile("/dev/full");
        full.start(SPARKOUT_CLI, {"simulate", samplePath("complete"), "--json"});
        const Outcome outcome = outcomeOf(full);
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.err.find("standard output cannot be written") != std::string::npos);
        // A closed pipe: the reader is gone before the program starts.
        const QString status = m_folder.filePath("status");
        QProcess shell;
        shell.start("/bin/sh",
                    {"-c", R"({ sleep 0.3; "$0" simulate "$1" --json; echo $? >"$2"; } | :)",
                     SPARKOUT_CLI, samplePath("complete"), status});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(samples::readText(status.toStdString()), std::string("1\n"));
    }

    void environmentChangesNothing_data() {
        QTest::addColumn<QStringList>("environment");
        QTest::newRow("ru_RU") << QStringList{"LC_ALL=ru_RU.UTF-8", "LANG=ru_RU.UTF-8"};
        QTest::newRow("de_DE") << QStringList{"LC_ALL=de_DE.UTF-8"};
        QTest::newRow("tr_TR") << QStringList{"LC_ALL=tr_TR.UTF-8"};
        QTest::newRow("ar_EG") << QStringList{"LC_ALL=ar_EG.UTF-8"};
        QTest::newRow("C") << QStringList{"LC_ALL=C"};
        QTest::newRow("next to nothing") << QStringList{"X=1"};
        QTest::newRow("no HOME, odd TZ")
            << QStringList{"HOME=/nonexistent", "TZ=Asia/Kathmandu", "TMPDIR=/nonexistent"};
    }
    void environmentChangesNothing() {
        QFETCH(QStringList, environment);
        const QString bad =
            QString::fromStdString(samples::sourcePath("tests/data/hostile/many-faults.sparkout"));
        const QString here = m_folder.filePath("here.csv");
        const QString there = m_folder.filePath("there.csv");
        for (QStringList arguments : {QStringList{"simulate", samplePath("complete"), "--json"},
                                      QStringList{"simulate", samplePath("internal-plunge")},
                                      QStringList{"validate", bad}}) {
            QCOMPARE(run(arguments, environment).text(), run(arguments).text());
        }
        run({"simulate", samplePath("smallest-plunge"), "--trace", here});
        run({"simulate", samplePath("smallest-plunge"), "--trace", there}, environment);
        QVERIFY(samples::readText(here.toStdString()) == samples::readText(there.toStdString()));
    }

    void examplesAreWrittenAndRun() {
        const QString folder = m_folder.filePath("examples");
        const Outcome outcome = run({"examples", folder});
        QCOMPARE(outcome.status, 0);
        std::size_t shipped = 0;
        for (const auto& entry :
             std::filesystem::directory_iterator(samples::sourcePath("resources/examples"))) {
            if (entry.path().extension() != ".sparkout") {
                continue;
            }
            ++shipped;
            const QString file = folder + '/' + QString::fromStdString(entry.path().filename());
            QCOMPARE(samples::readText(file.toStdString()), samples::readText(entry.path()));
            const Outcome valid = run({"validate", file});
            QVERIFY2(valid.status == 0, valid.err.c_str());
            const Outcome simulated = run({"simulate", file});
            QVERIFY2(simulated.status == 0, simulated.err.c_str());
        }
        QCOMPARE(lines(outcome.out), shipped);
        QVERIFY(shipped > 0);
        QCOMPARE(run({"examples", m_folder.filePath("no/such/folder")}).status, 1);
        QCOMPARE(run({"examples", samplePath("complete")}).status, 1);
    }

    void traceNeverReplacesAProject() {
        const std::string text = samples::readText(samplePath("smallest-plunge").toStdString());
        const QString project = save("kept.sparkout", text);
        const QString plain = save("kept.json", text);
        QVERIFY(QFile::link(plain, m_folder.filePath("link.csv")));
        for (const auto& [file, trace] : std::vector<std::pair<QString, QString>>{
                 {samplePath("complete"), project},
                 {plain, plain},
                 {plain, m_folder.filePath("link.csv")},
                 {samplePath("complete"), m_folder.filePath("new.sparkout")}}) {
            const Outcome outcome = run({"simulate", file, "--trace", trace});
            QCOMPARE(outcome.status, 2);
            QVERIFY2(outcome.err.find(trace.toStdString()) != std::string::npos,
                     outcome.err.c_str());
        }
        QCOMPARE(samples::readText(project.toStdString()), text);
        QCOMPARE(samples::readText(plain.toStdString()), text);
        QVERIFY(!QFile::exists(m_folder.filePath("new.sparkout")));
    }

    // --- reliability check 28 -------------------------------------------------------------------

    void randomArgumentsEndInADocumentedStatus() {
        std::map<QString, std::string> projects; // copies: whatever is done to them shows
        for (const char* name : {"smallest-plunge", "complete", "internal-plunge"}) {
            const std::string text = samples::readText(samplePath(name).toStdString());
            projects[save(QString("random-%1.sparkout").arg(name), text)] = text;
        }
        const auto copy = [this](const char* name) {
            return m_folder.filePath(QString("random-%1.sparkout").arg(name));
        };
        const QStringList words{
            "simulate",
            "simulate",
            "simulate",
            "validate",
            "validate",
            "examples",
            "batch",
            "batch-merge",
            "--json",
            "--json",
            "--csv",
            "--shard",
            "1/2",
            "--measured",
            "--scenarios",
            "corners",
            "--check",
            "--trace",
            "--help",
            "--version",
            "-",
            "--",
            "-o",
            "--parts",
            "",
            " ",
            ".",
            "..",
            "/dev/null",
            "Ж",
            "磨🛠",
            "\x01\x02",
            "%s%n",
            "-1",
            QString(5000, 'x'),
            "a b",
            "$(id)",
            copy("smallest-plunge"),
            copy("smallest-plunge"),
            copy("complete"),
            copy("internal-plunge"),
            m_stuck,
            m_strict,
            m_folder.path(),
            m_folder.filePath("out.csv"),
            QString::fromStdString(samples::sourcePath("tests/data/hostile/truncated.sparkout"))};
        std::mt19937 random(20250101);
        std::map<int, int> statuses;
        const int jobs = samples::sized(1000, 100, 10'000);
        for (int i = 0; i < jobs; ++i) {
            QStringList arguments;
            if (random() % 2 == 0) { // half of them begin well
                arguments << words[static_cast<qsizetype>(random() % 8)]
                          << words[words.size() - 1 - static_cast<qsizetype>(random() % 9)];
            }
            for (unsigned n = random() % 4; n > 0; --n) {
                arguments << words[static_cast<qsizetype>(random()
                                                          % static_cast<unsigned>(words.size()))];
            }
            QProcess process;
            process.setWorkingDirectory(m_folder.path());
            process.setStandardInputFile(QProcess::nullDevice());
            process.start(SPARKOUT_CLI, arguments);
            const Outcome outcome = outcomeOf(process);
            QVERIFY2(outcome.status >= 0 && outcome.status <= 4, qPrintable(arguments.join('|')));
            QVERIFY2(outcome.status == 0 || outcome.status == 4 || !outcome.err.empty(),
                     qPrintable(arguments.join('|')));
            QVERIFY2(outcome.status != 2 || outcome.out.empty(), qPrintable(arguments.join('|')));
            ++statuses[outcome.status];
        }
        for (const auto& [path, text] : projects) {
            QCOMPARE(samples::readText(path.toStdString()), text);
        }
        qInfo("CHECK 28 jobs %d: done %d, refused %d, usage %d, no size %d, fails %d PASS", jobs,
              statuses[0], statuses[1], statuses[2], statuses[3], statuses[4]);
    }

private:
    /// A project in which one requirement may fail, at the limit given.
    static json withOneRequirement(const QString& path, double limit) {
        json file = samples::sample("complete");
        file["part"]["lower_deviation_um"] = -200;
        file["part"]["upper_deviation_um"] = 200;
        file["part"]["target_diameter_mm"] = 30;
        file["part"]["tolerance"] = json::object();
        file["material"]["burn_rise_k"] = nullptr;
        file["machine"]["wheel_drive_kw"] = nullptr;
        const json limits = file["machine"]["limits"];
        file["machine"]["limits"] = json::object();
        if (path.startsWith("/machine/limits/")) {
            const std::string range = path.section('/', 3, 3).toStdString();
            file["machine"]["limits"][range] = limits.at(range);
        }
        if (path.startsWith("/wheel/")) {
            for (const auto& [key, value] :
                 {std::pair("grain_surface_energy_j_m2", 20.0),
                  std::pair("grain_modulus_gpa", 380.0), std::pair("bond_surface_energy_j_m2", 5.0),
                  std::pair("bond_modulus_gpa", 70.0)}) {
                file["wheel"][key] = value;
            }
        }
        json& place = file[json::json_pointer(path.toStdString())];
        if (path == "/gauge/commands") {
            place = static_cast<int>(limit);
        } else {
            place = limit;
        }
        return file;
    }

    static bool requirementHolds(const QString& path, double limit) {
        const Project project = readProject(withOneRequirement(path, limit).dump()).project.value();
        const std::vector<ConstraintResult> all = evaluateConstraints(simulate(project));
        return std::all_of(all.begin(), all.end(),
                           [](const ConstraintResult& constraint) { return constraint.holds; });
    }

    QString save(const QString& name, const std::string& content) const {
        const QString path = m_folder.filePath(name);
        std::ofstream(path.toStdString(), std::ios::binary) << content;
        return path;
    }

    static Project projectOf(const QString& file) {
        return readProject(samples::readText(file.toStdString())).project.value();
    }

    static void runnableRows() {
        QTest::addColumn<QString>("file");
        for (const char* name : {"complete", "smallest-plunge", "internal-plunge"}) {
            QTest::newRow(name) << samplePath(name);
        }
    }

    static void checkSection(const json& answer, const SectionResult& section, double diameter) {
        const json& deviation = answer.at("diameter_deviation_um");
        QCOMPARE(deviation.size(), std::size_t{2});
        QCOMPARE(deviation[0].get<double>(), section.diameterDeviationMin_mm * 1000);
        QCOMPARE(deviation[1].get<double>(), section.diameterDeviationMax_mm * 1000);
        QCOMPARE(answer.at("radial_runout_um").get<double>(), section.radialRunout_mm * 1000);
        QCOMPARE(answer.at("position_mm").get<double>(), section.position_mm);
        QCOMPARE(answer.at("compliance_mm_per_n").get<double>(), section.compliance_mm_per_n);
        QCOMPARE(answer.at("radii_um").size(), section.radii_mm.size());
        for (std::size_t k = 0; k < section.radii_mm.size(); ++k) {
            QCOMPARE(answer.at("radii_um")[k].get<double>(),
                     (section.radii_mm[k] - diameter / 2) * 1000);
        }
    }

    static void checkForm(const json& answer, const SimulationResult& result) {
        const PartAccuracy accuracy = accuracyOf(result);
        const json& part = answer.at("part");
        QCOMPARE(part.at("cylindricity_um").get<double>(), accuracy.minimumZone.deviation() * 1000);
        QCOMPARE(part.at("total_runout_um").get<double>(), accuracy.totalRunout_mm * 1000);
        QCOMPARE(part.at("taper_um").get<double>(), accuracy.profile.taper_mm * 1000);
        QCOMPARE(part.at("crown_um").get<double>(), accuracy.profile.crown_mm * 1000);
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            const bool traverse = result.project.operation == Operation::traverse;
            const json& section = traverse
                                      ? answer.at("zones").at(zoneName(result.sections[i].zone))
                                      : answer.at("sections").at(i);
            QCOMPARE(section.at("roundness_um").get<double>(),
                     accuracy.sections[i].minimumZone.deviation() * 1000);
            QCOMPARE(section.at("roundness_least_squares_um").get<double>(),
                     accuracy.sections[i].leastSquares.deviation() * 1000);
            QCOMPARE(section.at("roughness_ra_um").is_null(), !result.sections[i].lastCut);
        }
    }

    static void checkConstraints(const json& answer,
                                 const std::vector<ConstraintResult>& expected) {
        QCOMPARE(answer.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QVERIFY(answer[i].at("name") == constraintName(expected[i].kind));
            QCOMPARE(answer[i].at("limit").get<double>(), expected[i].limit);
            QCOMPARE(answer[i].at("value").get<double>(), expected[i].value);
            QCOMPARE(answer[i].at("margin").get<double>(), expected[i].margin);
            QCOMPARE(answer[i].at("relative_margin").get<double>(), expected[i].relativeMargin);
            QVERIFY(answer[i].at("ok") == expected[i].holds);
            QVERIFY(!answer[i].at("where").get<std::string>().empty());
        }
    }

    /// The words of the line that begins so, after that beginning; empty without such a line.
    static std::vector<std::string> row(const std::string& text, const std::string& beginning) {
        for (const std::string& line : split(text, '\n')) {
            if (line.starts_with(beginning)) {
                std::istringstream words(line.substr(beginning.size()));
                return {std::istream_iterator<std::string>(words), {}};
            }
        }
        return {};
    }

    static void checkShop(const json& answer, const ShopNumbers& expected) {
        QCOMPARE(answer.at("stages").size(), expected.stages.size());
        for (std::size_t z = 0; z < expected.stages.size(); ++z) {
            checkColumn(answer.at("stages")[z], expected.stages[z]);
        }
        checkColumn(answer.at("cycle"), expected.cycle);
        QCOMPARE(answer.at("wheel_speed_rpm").get<double>(), expected.wheelSpeed_rpm);
        QCOMPARE(answer.at("rotation_ratio").get<double>(), expected.rotationRatio);
        QVERIFY(answer.at("rotation_ratio_near_integer") == expected.ratioNearInteger());
    }

    static void checkColumn(const json& answer, const ShopColumn& expected) {
        const std::pair<const char*, double> numbers[] = {
            {"largest_depth_um", expected.depth_mm.value * 1000},
            {"removal_rate_mm3_mm_s", expected.removalRate_mm2_s},
            {"mean_removal_rate_mm3_mm_s", expected.meanRemovalRate_mm2_s},
            {"equivalent_chip_um", expected.equivalentChip_um},
            {"aggressiveness", expected.aggressiveness},
            {"removed_volume_mm3", expected.removedVolume_mm3},
            {"energy_j", expected.energy_j},
            {"grinding_time_min", expected.grindingTime_s / 60},
            {"peak_power_w", expected.power_w.value},
            {"mean_power_w", expected.meanPower_w},
            {"peak_normal_force_n", expected.normalForce_n.value}};
        for (const auto& [key, value] : numbers) {
            QCOMPARE(answer.at(key).get<double>(), value);
        }
        QVERIFY(answer.at("overlap_ratio")
                == (expected.overlap ? json(*expected.overlap) : json(nullptr)));
        QVERIFY(answer.at("specific_energy_j_mm3")
                == (expected.energy_j_mm3 ? json(*expected.energy_j_mm3) : json(nullptr)));
        QVERIFY(answer.at("specific_energy_plausible")
                == (expected.energy_j_mm3 ? json(expected.specificEnergyBand() == BandSide::inside)
                                          : json(nullptr)));
        for (const char* key :
             {"largest_depth_where", "peak_power_where", "peak_normal_force_where"}) {
            QCOMPARE(answer.at(key).is_null(), expected.depth_mm.value == 0);
        }
    }

    QTemporaryDir m_folder;
    QString m_stuck, m_strict;
};

} // namespace test_cli

SPARKOUT_TEST(test_cli, TestCli)
#include "test_cli.moc"
