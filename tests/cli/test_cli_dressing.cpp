// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `dressing` as a user meets it: what it prints is what the engine finds, and its exit status.
#include "core/project/optimisation.h"
#include "core/quality/requirement.h"
#include "core/setup/dressing_interval.h"
#include "core/setup/setup_file.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <string>

namespace test_cli_dressing {

using namespace sparkout;
using namespace cli;

namespace {

/// The spindle of five surfaces, whose wheel dulls fast, with rates.
json dullingSpindle() {
    json file = json::parse(
        samples::readText(samples::sourcePath("resources/examples/setups/spindle.sparkout")));
    file["wear"]["dulling_per_mm2"] = 2e-5;
    file["surfaces"][0]["optimisation"]["cost"] = {
        {"machine_per_h", 1800}, {"handling_s", 20}, {"dressing_s", 120}, {"dressing_cost", 35}};
    return file;
}

} // namespace

class TestCliDressing : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void jsonStatesWhatTheEngineFinds() {
        const std::string text = dullingSpindle().dump();
        const auto setup = readSetup(text).setup;
        QVERIFY(setup.has_value());
        const DressingInterval interval = dressingInterval(*setup);
        QVERIFY(interval.parts > 1 && interval.end && interval.end->worst);
        const json answer =
            answerTo({"dressing", save(QStringLiteral("dull.sparkout"), text), "--json"});
        QCOMPARE(answer.at("parts").get<std::int64_t>(), interval.parts);
        QCOMPARE(answer.at("endless").get<bool>(), false);
        QCOMPARE(answer.at("at_least").get<bool>(), false);
        const json& end = answer.at("ends_by");
        QCOMPARE(end.at("part").get<std::int64_t>(), interval.parts + 1);
        QCOMPARE(end.at("surface").get<std::string>(), setup->surfaces[interval.end->surface].name);
        QCOMPARE(end.at("requirement").get<std::string>(),
                 std::string(requirementOf(interval.end->worst->kind).key));
        QVERIFY(end.at("scenario").is_null());
        const Cost& cost = *setup->surfaces[0].project.optimisation->cost;
        QCOMPARE(answer.at("cheapest").at("cost").get<double>(),
                 cheapestInterval(interval, cost)->value);
        QCOMPARE(answer.at("quickest").at("parts").get<std::int64_t>(),
                 quickestInterval(interval, cost.dressing_s)->parts);
    }

    void textSaysWhatEndsItAndWhatIsBest() {
        json file = dullingSpindle();
        const QString path = save(QStringLiteral("dull.sparkout"), file.dump());
        ProcessOutcome outcome = run({"dressing", path, "--check"});
        QCOMPARE(outcome.status, 0);
        for (const char* line : {"parts to a dressing  ", "ends by              part ",
                                 "quickest after       ", "cheapest after       "}) {
            QVERIFY2(QByteArray::fromStdString(outcome.out).contains(line), line);
        }
        file["surfaces"][0]["optimisation"].erase("cost");
        outcome = run({"dressing", save(QStringLiteral("free.sparkout"), file.dump())});
        QVERIFY(!QByteArray::fromStdString(outcome.out).contains("cheapest"));
    }

    /// The first by the metal that the wheel removed, as an independent program found (72 by
    /// π·d·L·Π); the second by the size under position control, which follows the worn radius.
    void partsToADressingOfTwoTrials() {
        const auto answer = [](const std::string& name) {
            return answerTo(
                {"dressing",
                 QString::fromStdString(samples::sourcePath("tests/data/trials/" + name)),
                 "--json"});
        };
        const json volume = answer("dressing-volume.sparkout");
        QCOMPARE(volume.at("parts").get<int>(), 60);
        QCOMPARE(volume.at("ends_by").at("requirement").get<std::string>(), "wheel_power");
        const json wear = answer("position-wear.sparkout");
        QCOMPARE(wear.at("parts").get<int>(), 10);
        QCOMPARE(wear.at("ends_by").at("requirement").get<std::string>(), "diameter_max");
    }

    void theBatchOfASurfaceNeverGivesMoreParts() {
        json file = dullingSpindle();
        file["surfaces"][0]["batch"] = {{"parts", 8},
                                        {"factors", {{"stock_mm", {{"uniform", {0.19, 0.21}}}}}}};
        const QString path = save(QStringLiteral("batch.sparkout"), file.dump());
        const auto partsOf = [&](const QStringList& arguments) {
            const ProcessOutcome outcome = run(arguments);
            return outcome.status == 0 ? json::parse(outcome.out).at("parts").get<int>() : -1;
        };
        const int alone = partsOf({"dressing", path, "--json"});
        const int batch = partsOf({"dressing", path, "--scenarios", "corners", "--json"});
        QVERIFY(batch >= 0 && batch <= alone);
    }

    void whatIsRefused() {
        json file = dullingSpindle();
        file.erase("wear");
        ProcessOutcome outcome =
            run({"dressing", save(QStringLiteral("sharp.sparkout"), file.dump())});
        QCOMPARE(outcome.status, 1);
        QVERIFY(QByteArray::fromStdString(outcome.err).contains("/wear: not given"));
        QCOMPARE(run({"dressing", QStringLiteral("absent.sparkout")}).status, 1);
        outcome = run({"dressing", QStringLiteral("x"), "--scenarios", "all"});
        QCOMPARE(outcome.status, 2);
    }
};

} // namespace test_cli_dressing

SPARKOUT_TEST(test_cli_dressing, TestCliDressing)
#include "test_cli_dressing.moc"
