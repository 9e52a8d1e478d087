// SPDX-License-Identifier: GPL-3.0-or-later
// What is written is read again, to the last bit and byte.
#include "tests/check_line.h"
#include "tests/core/project/project_places.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

namespace sparkout::test_project_file {

using namespace project_places;

class TestProjectFile : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(1000); }

    // --- round trip (reliability check 4) -------------------------------------------------------

    void samplesReadWithoutErrorAndRoundTrip_data() { sampleRows(); }

    void samplesReadWithoutErrorAndRoundTrip() {
        QFETCH(QString, name);
        const ReadResult read = readProject(samples::text(name.toStdString()));
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        const std::string fault = roundTripFault(*read.project);
        QVERIFY2(fault.empty(), fault.c_str());
    }

    void completeExampleKeepsEveryValue() {
        const json given = samples::sample("complete").flatten();
        const json written = json::parse(writeProject(samples::project("complete"))).flatten();
        for (const auto& [path, value] : given.items()) {
            if (!value.is_null()) {
                QVERIFY2(written.value(path, json()) == value, path.c_str());
            }
        }
    }

    void everythingGivesEveryKeyOfTheTables() {
        Project project = samples::project("everything");
        std::set<std::string> given;
        for (const samples::Spot& spot : samples::spots(project)) {
            given.insert(spot.place);
        }
        for (const samples::Place& place : samples::places()) {
            QVERIFY2(given.count(place.path), place.path.c_str());
        }
    }

    void everyLeafRoundTripsAwayFromItsDefault() {
        Coverage coverage;
        const auto lastSeed = static_cast<std::uint64_t>(samples::sized(4, 0, 4));
        const auto step = static_cast<std::size_t>(samples::sized(1, 6, 1));
        for (const std::string& name : samples::names()) {
            Project project = samples::project(name);
            coverage.add(project);
            const std::size_t count = samples::spots(project).size();
            for (std::size_t i = 0; i < count; i += step) {
                for (std::uint64_t seed = 0; seed < 12; ++seed) {
                    Project changed = samples::project(name);
                    Mutator mutator(fromSeed(seed + 977 * i));
                    if (mutator.mutateOne(changed, samples::spots(changed)[i])) {
                        coverage.add(changed);
                        const std::string fault = roundTripFault(changed);
                        QVERIFY2(fault.empty(), fault.c_str());
                        if (seed > lastSeed) {
                            break;
                        }
                    }
                }
            }
        }
        const std::string missing = coverage.missing();
        const auto missed = std::ranges::count(missing, '\n');
        const auto leaves = coverage.leaves();
        checkLine("04", 100.0 * double(leaves - missed) / double(leaves), 100,
                  step > 1 || missed == 0,
                  QStringLiteral("% of the %1 leaves and their forms away from the default, saved, "
                                 "opened and saved: the same bytes")
                      .arg(leaves));
        if (step == 1) {
            QCOMPARE(missing, std::string());
        }
    }

    void randomProjectsRoundTripByteForByte() {
        Coverage coverage;
        int projects = 0;
        QVERIFY(rc::check("write, read, write", [&] {
            ++projects;
            Project project = samples::project(*rc::gen::elementOf(samples::names()));
            Mutator mutator(fromSeed(*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())));
            mutator.mutate(project, 60);
            coverage.add(project);
            const std::string fault = roundTripFault(project);
            if (!fault.empty()) {
                RC_FAIL(fault);
            }
        }));
        checkLine("04", projects, asked(1000, projects), projects >= asked(1000, projects),
                  QStringLiteral("random valid projects saved, opened and saved: the same bytes"));
        if (!std::getenv("SPARKOUT_QUICK")) {
            QCOMPARE(coverage.missing(), std::string());
        }
    }

    void texts_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("cyrillic") << QByteArray("Вал 30h6, круг 25А F60 L 6 V");
        QTest::newRow("four bytes") << QByteArray("𝛾 = 🛠 𠜎");
        QTest::newRow("quotes and slashes") << QByteArray(R"("\/ {value} {limit} %1 </b>)");
        QTest::newRow("control characters") << QByteArray("a\0b\x01\x1f\x7f\n\r\t", 9);
        QTest::newRow("direction marks") << QByteArray("\u202egnp.exe\u2066 \u2028");
        QTest::newRow("64 KB") << QByteArray(65536, 'x');
    }

    void texts() {
        QFETCH(QByteArray, text);
        Project project = samples::project("smallest-traverse");
        project.title = text.toStdString();
        project.runs = {{text.toStdString(),
                         "",
                         "",
                         {samples::text("smallest-plunge")},
                         {json{{text.left(60).toStdString(), text.toStdString()}}.dump()}}};
        const std::string fault = roundTripFault(project);
        QVERIFY2(fault.empty(), fault.substr(0, 500).c_str());
    }

    void numbers_data() {
        addColumns<QByteArray, double, QByteArray>("written", "value", "again");
        QTest::newRow("shortest") << QByteArray("0.1") << 0.1 << QByteArray("0.1");
        QTest::newRow("sum") << QByteArray("0.30000000000000004") << 0.1 + 0.2
                             << QByteArray("0.30000000000000004");
        QTest::newRow("too many digits")
            << QByteArray("0.1000000000000000055511") << 0.1 << QByteArray("0.1");
        QTest::newRow("tiny") << QByteArray("1e-300") << 1e-300 << QByteArray("1e-300");
        QTest::newRow("denormal") << QByteArray("5e-324") << 5e-324 << QByteArray("5e-324");
        QTest::newRow("below everything") << QByteArray("1e-400") << 0.0 << QByteArray("0");
        QTest::newRow("minus zero") << QByteArray("-0") << 0.0 << QByteArray("0");
        QTest::newRow("minus zero, float") << QByteArray("-0.0") << 0.0 << QByteArray("0");
        QTest::newRow("whole float") << QByteArray("36.0") << 36.0 << QByteArray("36");
        QTest::newRow("exponent") << QByteArray("1e3") << 1000.0 << QByteArray("1000");
        QTest::newRow("capital exponent") << QByteArray("1.5E+1") << 15.0 << QByteArray("15");
    }

    void numbers() {
        QFETCH(QByteArray, written);
        QFETCH(double, value);
        QFETCH(QByteArray, again);
        std::string text = samples::text("smallest-traverse");
        const std::string key = "\"dwell_exit_s\": ";
        const std::size_t at = text.find(key + "0");
        QVERIFY(at != std::string::npos);
        text.replace(at + key.size(), 1, written.toStdString());
        const ReadResult read = readProject(text);
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        QCOMPARE(read.project->machine->dwell_exit_s, value);
        QVERIFY(!std::signbit(read.project->machine->dwell_exit_s));
        const std::string out = writeProject(*read.project);
        QVERIFY(out.find(key + again.toStdString() + ",") != std::string::npos);
        const std::string fault = roundTripFault(*read.project);
        QVERIFY2(fault.empty(), fault.c_str());
    }

    void wholeNumbersMayBeWrittenAsNumbers() {
        for (const char* written : {"36", "36.0", "3.6e1", "360e-1"}) {
            json file = samples::sample("smallest-traverse");
            file["part"]["radii_per_section"] = json::parse(written);
            const ReadResult read = readProject(file.dump());
            QCOMPARE(read.project.value().part->radii_per_section, 36);
        }
    }

    void minusZeroInMemoryIsWrittenAsZero() {
        Project project = samples::project("smallest-traverse");
        project.machine->dwell_exit_s = -0.0;
        project.runs = {{"", "", "", {samples::text("smallest-plunge")}, {R"({"x": -0.0})"}}};
        QCOMPARE(roundTripFault(project), std::string());
    }

    void keptRunKeepsItsValuesAndCanonicalOrder() {
        json file = samples::sample("everything");
        file["runs"][0]["summary"] = json::parse(
            R"({"b": [1, 2.5, "x", null, {"deep": true}], "a": 9007199254740993, "c": 1e22})");
        const ReadResult read = readProject(file.dump());
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        const json written = json::parse(writeProject(*read.project));
        QVERIFY(written["runs"][0]["summary"] == file["runs"][0]["summary"]);
        QVERIFY(written["runs"][0]["inputs"] == file["runs"][0]["inputs"]);
        Project unordered = *read.project;
        unordered.runs[0].summary.text = R"({"z": 1, "a": {"y": 2, "b": 3}})";
        QCOMPARE(roundTripFault(unordered), std::string());
    }
};

} // namespace sparkout::test_project_file

SPARKOUT_TEST(test_project_file, TestProjectFile)
#include "test_project_file.moc"
