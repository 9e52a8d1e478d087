// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Trials as a user meets them: the form as a roundness machine states it, the choice of a trial and
// the stiffness of the units, by the real program.
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <cmath>
#include <numbers>

namespace test_cli_trials {

using namespace sparkout;
using namespace cli;

json plunge() {
    json file = samples::sample("smallest-plunge");
    file["machine"]["compliance_mm_per_n"] = {5e-4, 6e-4, 6e-4, 5e-4};
    file["wheel"]["dullness"] = 0.01;
    return file;
}

json onCentres() {
    json file = samples::sample("stiffness-traverse");
    file["part"]["shaft"].erase("steady_rests");
    return file;
}

/// Deflections of a rigid shaft's ends: at x of L by the springs alone, its bending left out.
std::string rigidReadings(double length_mm, double head, double tail) {
    std::string text = "x, mm;P, N;y, µm\n";
    for (const double u : {0.1, 0.5, 0.9}) {
        const double y = 200 * ((1 - u) * (1 - u) / head + u * u / tail);
        text += std::to_string(u * length_mm) + ";200;" + std::to_string(y) + '\n';
    }
    return text;
}

class TestCliTrials : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void roundnessAboutFourCirclesAfterThreeFilters() {
        const QString file = save("plunge.sparkout", plunge().dump());
        std::string profile = "φ;R, мм\n";
        for (int k = 0; k < 360; ++k) {
            const double r = 15 + 0.005 * std::cos(2 * std::numbers::pi * k / 120);
            profile += std::to_string(k) + ';' + std::to_string(r) + '\n';
        }
        const ProcessOutcome outcome = run(
            {"measured", file, "--roundness", "--profile", save("profile.csv", profile), "--json"});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const json all = json::parse(outcome.out);
        QCOMPARE(all.at("roundness").size(), std::size_t{4});
        for (const json& section : all.at("roundness")) {
            const json& readings = section.at("readings");
            QCOMPARE(readings.size(), std::size_t{4});
            QVERIFY(readings[0].at("filter_upr").is_null());
            QCOMPARE(readings[1].at("filter_upr").get<int>(), 15);
            QVERIFY(readings[1].at("mzc_um") <= readings[1].at("mcc_um"));
        }
        const json& recorded = all.at("recorded");
        QCOMPARE(recorded.at("points").get<int>(), 360);
        // Three lobes of 5 µm pass 15 UPR by 2^(−1/25).
        const double mzc = recorded.at("readings")[1].at("mzc_um").get<double>();
        QVERIFY(std::abs(mzc - 10 * std::pow(2, -1.0 / 25)) < 0.01);
        const ProcessOutcome text = run({"measured", file, "--roundness"});
        QVERIFY2(has(text.out, "Gaussian filter 50 UPR: MZC "), text.text().c_str());
    }

    void theBestTrialComesFirst() {
        const QString file = save("plunge.sparkout", plunge().dump());
        const ProcessOutcome outcome = run({"measured", file, "--trial", "alpha,beta", "--json"});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const json trials = json::parse(outcome.out).at("trials");
        QCOMPARE(trials.size(), std::size_t{24});
        QCOMPARE(trials[0].at("record").get<std::string>(), std::string("size_and_power"));
        QCOMPARE(trials[0].at("spark_out").get<std::string>(), std::string("until_settled"));
        QCOMPARE(trials[0].at("expected").size(), std::size_t{2});
        QVERIFY(trials[0].at("radial_feed_mm_min").get<double>() > 0);
        const ProcessOutcome text = run({"measured", file, "--trial", "chip_power"});
        QVERIFY2(has(text.out, "chip_power: undetermined"), text.text().c_str());
        QVERIFY(isUsageError(run({"measured", file, "--trial", "gamma"})));
        QCOMPARE(run({"measured", file, "--trial", "alpha,alpha"}).status, 1);
    }

    void stiffnessFromATable() {
        json file = onCentres();
        file["part"]["shaft"]["youngs_modulus_gpa"] = 1000; // hardly bends
        const QString path = save("shaft.sparkout", file.dump());
        double length = 0;
        for (const json& segment : file["part"]["shaft"]["segments"]) {
            length += segment.at("length_mm").get<double>();
        }
        const QString table = save("trial.csv", rigidReadings(length, 30, 20));
        const ProcessOutcome outcome = run({"measured", path, "--stiffness", table, "--json"});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const json found = json::parse(outcome.out);
        QCOMPARE(found.at("stiffness")[0].at("unit").get<std::string>(), std::string("headstock"));
        QVERIFY(std::abs(found.at("stiffness")[0].at("n_um").get<double>() - 30) < 1.5);
        QVERIFY(std::abs(found.at("stiffness")[1].at("n_um").get<double>() - 20) < 1.5);
        QCOMPARE(found.at("compliance").size(), std::size_t{3});
        const ProcessOutcome system =
            run({"measured", path, "--stiffness", table, "--indicator", "system"});
        QVERIFY(system.status == 0 || has(system.err, "stiffer than rigid"));
        const ProcessOutcome sheet = run({"measured", path, "--stiffness-sheet"});
        QVERIFY2(has(sheet.out, "Set an indicator"), sheet.text().c_str());
    }

    void refusals() {
        const QString file = save("plunge.sparkout", plunge().dump());
        const QString bad = save("bad.csv", "0;15\n90;abc\n");
        const ProcessOutcome profile = run({"measured", file, "--profile", bad});
        QCOMPARE(profile.status, 1);
        QVERIFY2(has(profile.err, "bad.csv:2:2: "), profile.err.c_str());
        const ProcessOutcome stiffness = run({"measured", file, "--stiffness", bad});
        QCOMPARE(stiffness.status, 1);
        QVERIFY(isUsageError(run({"measured", file, "--roundness", "--trial", "alpha"})));
        QVERIFY(isUsageError(run({"measured", file, "--indicator", "part"})));
        QVERIFY(isUsageError(run({"measured", file, "--stiffness", bad, "--indicator", "x"})));
    }
};

} // namespace test_cli_trials

SPARKOUT_TEST(test_cli_trials, TestCliTrials)
#include "test_cli_trials.moc"
