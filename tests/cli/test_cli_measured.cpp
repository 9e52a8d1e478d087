// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `measured` as a user meets it: the real program on files with measured parts and traces.
#include "core/digits.h"
#include "core/project/measured.h"
#include "core/project/wheel.h"
#include "core/simulation/simulate.h"
#include "tests/cli/cli_bench.h"
#include "tests/core/measured/measured_cycles.h"
#include "tests/registry.h"
#include "words/measured_words.h"

#include <QFile>

#include <algorithm>
#include <cmath>

namespace test_cli_measured {

using namespace sparkout;
using namespace cli;
using namespace measured_cycles;

namespace {

/// A plunge that yields, and a batch of blanks of different stock.
json yielding() {
    json file = samples::sample("smallest-plunge");
    file["sections"] = 1;
    file["machine"]["compliance_mm_per_n"] = {5e-4};
    file["wheel"]["dullness"] = 0.01;
    file["part"]["stock_mm"] = 0.3;
    file["gauge"] = {{"rule", "mean"}};
    file["cycle"]["stages"] = {{{"radial_feed_mm_min", 2.0}, {"stock_mm", 0.22}},
                               {{"radial_feed_mm_min", 0.4}, {"stock_mm", 0.08}}};
    file["batch"] = {{"parts", 60}, {"factors", {{"stock_mm", {{"uniform", {0.25, 0.35}}}}}}};
    return file;
}

/// Diameters of parts as the batch would make them, so far from it [µm], as a table.
std::string table(const json& file, double shift_um) {
    const Project project = readProject(file.dump()).project.value();
    std::string text = "Деталь;Диаметр, мм\n";
    for (int i = 0; i < 12; ++i) {
        Project part = project;
        part.part->stock_mm = 0.252 + 0.008 * i;
        const SimulationResult result = simulateUnchecked(part);
        const double mean_mm = 2 * meanOfGround(result.sections[0].radii_mm) + shift_um / 1000;
        std::string number = std::to_string(mean_mm);
        std::replace(number.begin(), number.end(), '.', ',');
        text += std::to_string(i + 1) + ';' + number + '\n';
    }
    return text;
}

/// Size and power of a cycle with factors of γ and η, which begins so late in the recording, as a
/// table.
std::string traces(const json& file, double compliance, double dullness, double shift_s = 0) {
    json truth = file;
    truth["machine"]["compliance_mm_per_n"] = {5e-4 * compliance};
    truth["wheel"]["dullness"] = 0.01 * dullness;
    const Record cycle = record(readProject(truth.dump()).project.value());
    Recording how{.hertz = 20, .noise = 2e-4, .shift_s = shift_s, .seed = 3};
    Recording ofPower{.hertz = 20, .noise = 1e-2, .offset = 0.5, .shift_s = shift_s, .seed = 4};
    if (shift_s > 0) {
        how.from_s = ofPower.from_s = -1;
        how.to_s = ofPower.to_s = cycle.end_s.back() + 2;
    }
    const MeasuredTrace size = trace(TraceQuantity::gauge_size, cycle, how);
    const MeasuredTrace power = trace(TraceQuantity::wheel_power, cycle, ofPower);
    std::string text = "t [s],size [mm],P [kW]\n";
    for (std::size_t i = 0; i < size.values.size(); ++i) {
        text += std::to_string(size.time_s[i]) + ',' + std::to_string(size.values[i]) + ','
                + std::to_string(power.values[i]) + '\n';
    }
    return text;
}

/// Without the last column.
std::string sizesOf(const std::string& table) {
    std::string sizes;
    for (const std::string& line : split(table, '\n')) {
        sizes += line.substr(0, line.rfind(',')) + '\n';
    }
    return sizes;
}

/// With a lone size in its middle that is larger by so much.
std::string withSpike(std::string table, double more_mm) {
    const std::size_t line = table.find('\n', table.size() / 2) + 1;
    const std::size_t comma = table.find(',', line), second = table.find(',', comma + 1);
    const double size = std::stod(table.substr(comma + 1, second - comma - 1));
    return table.replace(comma + 1, second - comma - 1, std::to_string(size + more_mm));
}

QString trialPath(const char* name) {
    return QString::fromStdString(samples::sourcePath(std::string("tests/data/trials/") + name));
}

} // namespace

class TestCliMeasured : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void partsThatAgreeAndPartsThatDoNot() {
        json project = yielding();
        project["batch"]["bias_limit_um"] = 20; // of 12 parts
        const QString file = save("plunge.sparkout", project.dump());
        const QString good = save("good.csv", table(yielding(), 0));
        const QString shifted = save("shifted.csv", table(yielding(), 80));
        const ProcessOutcome agrees = run({"measured", file, "--data", good, "--json", "--check"});
        QVERIFY2(agrees.status == 0, agrees.text().c_str());
        const json row = json::parse(agrees.out).at("adequacy").at(0);
        QCOMPARE(row.at("quantity").get<std::string>(), std::string("diameter_deviation"));
        QCOMPARE(row.at("count").get<int>(), 12);
        QCOMPARE(row.at("verdict").get<std::string>(), std::string("adequate"));
        QVERIFY(row.at("predicted").at("low_um") < row.at("predicted").at("high_um"));
        QVERIFY(row.at("inside").at("count") > 9);
        const ProcessOutcome differs = run({"measured", file, "--data", shifted, "--check"});
        QVERIFY2(differs.status == 4, differs.text().c_str());
        QVERIFY(has(differs.out, "the mean differs from the predicted one"));
        QCOMPARE(run({"measured", file, "--data", shifted}).status, 0);
    }

    void aFitSaysWhatItFinds() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const QString data = save("trace.csv", traces(yielding(), 1.2, 0.9));
        const ProcessOutcome outcome =
            run({"measured", file, "--data", data, "--fit",
                 "compliance,dullness,size_offset,idle_power", "--json"});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const json fit = json::parse(outcome.out).at("identification");
        QCOMPARE(fit.at("status").get<std::string>(), std::string("fitted"));
        QVERIFY(std::abs(fit.at("values")[0].at("value").get<double>() - 1.2) < 0.05);
        QVERIFY(std::abs(fit.at("values")[1].at("value").get<double>() - 0.9) < 0.05);
        QVERIFY(std::abs(fit.at("values")[3].at("value").get<double>() - 0.5) < 0.05);
        QCOMPARE(fit.at("residuals").size(), std::size_t{2});
        const ProcessOutcome text = run({"measured", file, "--data", data, "--fit", "alpha,beta"});
        QVERIFY2(has(text.out, "alpha: "), text.text().c_str());
    }

    /// What is known before holds a value where it is sure, outliers hardly count by a robust loss,
    /// and what was found is saved with what it was found on.
    void aFitTakesWhatIsKnownAndIsSaved() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const std::string table = traces(yielding(), 1.2, 0.9);
        const QString data = save("trace.csv", table);
        const QString found = m_folder.filePath(QStringLiteral("found.sparkout"));
        const QStringList fit{"measured", file, "--data", data, "--fit"};
        const ProcessOutcome known =
            run(fit + QStringList{"compliance=1~0.0001,dullness,size_offset,idle_power", "--json"});
        const json held = json::parse(known.out).at("identification");
        QVERIFY(std::abs(held.at("values")[0].at("value").get<double>() - 1) < 0.01);
        const QString parameters = QStringLiteral("compliance,dullness,size_offset,idle_power");
        const ProcessOutcome saved = run(fit + QStringList{parameters, "-o", found});
        QVERIFY2(saved.status == 0, saved.text().c_str());
        QFile written(found);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const ReadResult read = readProject(written.readAll().toStdString());
        QVERIFY(read.project && read.project->measured);
        QCOMPARE(read.project->measured->calibrations.size(), std::size_t{2});
        QCOMPARE(read.project->measured->calibrations.front().data, std::string("trace.csv"));
        QVERIFY(std::abs(read.project->wheel->dullness / 0.009 - 1) < 0.05);
        // A lone value that is a tenth of a millimetre off.
        const QStringList spike{
            "measured", file,       "--data", save("spike.csv", withSpike(table, 0.1)),
            "--fit",    parameters, "--json"};
        const json robust =
            json::parse(run(spike + QStringList{"--loss", "tukey"}).out).at("identification");
        QCOMPARE(robust.at("status").get<std::string>(), std::string("fitted"));
        QCOMPARE(robust.at("residuals")[0].at("outliers").get<int>(), 1);
        QVERIFY(std::abs(robust.at("values")[0].at("value").get<double>() - 1.2) < 0.05);
        for (const QStringList& wrong :
             {fit + QStringList{parameters, "-o", file},
              fit + QStringList{parameters, "--loss", "l1"},
              QStringList{"measured", file, "--loss", "huber"}, fit + QStringList{"alpha=1"},
              fit + QStringList{"alpha=1~0"}, fit + QStringList{"alpha=-1~0.1"}}) {
            QCOMPARE(run(wrong).status, 2);
        }
        // Without values to use nothing is saved.
        const QString none = m_folder.filePath(QStringLiteral("none.sparkout"));
        const ProcessOutcome untold = run(fit + QStringList{"alpha,beta,compliance", "-o", none});
        QVERIFY(!QFile::exists(none));
        QVERIFY2(has(untold.err, "not saved"), untold.text().c_str());
    }

    /// Recordings that were fitted wrongly once: revolutions traded against a shift of the time, a
    /// machine that yields much more, a power in watts read as kilowatts.
    void recordingsAreFittedOrRefused_data() {
        QTest::addColumn<QString>("project");
        QTest::addColumn<QString>("table");
        QTest::addColumn<double>("alpha"); // 0: it does not fit
        QTest::addColumn<double>("beta");
        QTest::addColumn<double>("within");
        const QString shaft = trialPath("shift_wrong.sparkout");
        const double any = 10;
        QTest::newRow("shift") << shaft << trialPath("shift_wrong.csv") << 1.57797821394345
                               << 1.4561277006434539 << any;
        QTest::newRow("no noise") << examplePath("plunge-shaft-two-stage")
                                  << trialPath("62_noise_free_beta1.5.csv") << 1.5 << 1.5 << 0.005;
        QTest::newRow("watts") << shaft << trialPath("14_power_W_nounit.csv") << 0.0 << 0.0 << any;
    }
    void recordingsAreFittedOrRefused() {
        QFETCH(QString, project);
        QFETCH(QString, table);
        QFETCH(double, alpha);
        QFETCH(double, beta);
        QFETCH(double, within);
        const bool fits = alpha > 0;
        const QString found = m_folder.filePath(QStringLiteral("recording.sparkout"));
        QFile::remove(found);
        const ProcessOutcome outcome =
            run({"measured", project, "--data", table, "--fit", "alpha,beta,size_offset,time_shift",
                 "--json", "-o", found});
        QVERIFY2(outcome.status == (fits ? 0 : 4), outcome.text().c_str());
        QCOMPARE(QFile::exists(found), fits);
        const json fit = json::parse(outcome.out).at("identification");
        QCOMPARE(fit.at("status").get<std::string>(),
                 std::string(fits ? "fitted" : "does_not_fit"));
        QCOMPARE(fit.at("residuals").back().at("in_doubt").get<bool>(), !fits);
        for (std::size_t i = 0; fits && i < 2; ++i) {
            const double truth = i == 0 ? alpha : beta;
            const json& value = fit.at("values")[i];
            const json& interval = value.at("interval_95");
            QVERIFY2(std::abs(value.at("value").get<double>() - truth) <= within,
                     value.dump().c_str());
            QVERIFY2(interval[0] <= truth && truth <= interval[1], value.dump().c_str());
        }
    }

    /// Left out, the beginning of the cycle goes into the other values.
    void aTimeLeftOutIsRefused() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const std::string late = sizesOf(traces(yielding(), 1.25, 0.7, 0.1));
        const QString found = m_folder.filePath(QStringLiteral("late.sparkout"));
        const QStringList fit{"measured", file, "--data", save("late.csv", late), "-o", found};
        const QString parameters = QStringLiteral("alpha,beta,size_offset");
        const ProcessOutcome without = run(fit + QStringList{"--fit", parameters, "--json"});
        QVERIFY2(without.status == 4, without.text().c_str());
        QVERIFY2(has(without.err, "not saved") && !QFile::exists(found), without.err.c_str());
        const json refused = json::parse(without.out).at("identification");
        QCOMPARE(refused.at("status").get<std::string>(), std::string("does_not_fit"));
        QVERIFY(refused.at("in_doubt").get<bool>());
        QCOMPARE(refused.at("values").size(), std::size_t{3});
        QCOMPARE(refused.at("out_of_step")[0].at("parameter").get<std::string>(),
                 std::string("time_shift"));
        const ProcessOutcome with = run(fit + QStringList{"--fit", parameters + ",time_shift"});
        QVERIFY2(with.status == 0 && QFile::exists(found), with.text().c_str());
    }

    /// A wheel five times as dull as the file says: it is found, named and not saved.
    void aValueOutsideItsUsualRangeIsRefused() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const QString found = m_folder.filePath(QStringLiteral("unusual.sparkout"));
        const QStringList fit{"measured", file,
                              "--data",   save("dull.csv", traces(yielding(), 1, 5.2)),
                              "--fit",    "dullness,size_offset,idle_power",
                              "-o",       found};
        const ProcessOutcome text = run(fit);
        QVERIFY2(text.status == 4, text.text().c_str());
        QVERIFY2(has(text.out, "does not fit: dullness: 5.") && has(text.out, "; usual: 0.25"),
                 text.out.c_str());
        QVERIFY2(has(text.err, "not saved") && !QFile::exists(found), text.err.c_str());
        const json values =
            json::parse(run(fit + QStringList{"--json"}).out).at("identification").at("values");
        QVERIFY(values[0].at("in_doubt").get<bool>() && !values[1].at("in_doubt").get<bool>());
        QCOMPARE(values[0].at("usual_range")[1].get<double>(), 4.0);
        QVERIFY(values[1].at("usual_range").is_null());
    }

    void aReadingOverRangeIsNamed() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const std::string table = withSpike(traces(yielding(), 1.2, 0.9), 9.5);
        const QStringList fit{"measured", file,
                              "--data",   save("spike.csv", table),
                              "--fit",    "compliance,dullness,size_offset,idle_power"};
        const ProcessOutcome text = run(fit);
        QVERIFY2(has(text.out, "over range: size at the gauge: "), text.text().c_str());
        const json residuals =
            json::parse(run(fit + QStringList{"--json"}).out).at("identification").at("residuals");
        QCOMPARE(residuals[0].at("over_range").get<int>(), 1);
        QCOMPARE(residuals[1].at("over_range").get<int>(), 0);
    }

    /// What the calibration predicts of a second recording is one line, whose words follow the
    /// JSON.
    void aRecordingThatWasNotUsedIsPredicted() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const QString first = save("first.csv", traces(yielding(), 1.2, 0.9, 0.1));
        const QString found = m_folder.filePath(QStringLiteral("calibrated.sparkout"));
        const ProcessOutcome saved =
            run({"measured", file, "--data", first, "--fit",
                 "compliance,dullness,size_offset,idle_power,time_shift", "-o", found});
        QVERIFY2(saved.status == 0, saved.text().c_str());
        const QString second = save("second.csv", sizesOf(traces(yielding(), 1.2, 0.9, 0.3)));
        const QStringList compared{"measured", found, "--data", second};
        const json rows = json::parse(run(compared + QStringList{"--json"}).out).at("hold_out");
        QCOMPARE(rows.size(), std::size_t{1});
        const json& row = rows[0];
        QCOMPARE(row.at("quantity").get<std::string>(), std::string("time"));
        const auto number = [&row](const char* key) { return fixed(row.at(key).get<double>(), 3); };
        const std::string said = "not used for the calibration, second.csv: "
                                 + std::string(wordsOf(HoldOutQuantity::time).text) + ": "
                                 + number("measured") + " s, predicted " + number("predicted");
        const bool agrees = row.at("agrees").get<bool>();
        const std::string verdict = agrees ? ": agrees\n" : ": does not agree\n";
        const ProcessOutcome checked = run(compared + QStringList{"--check"});
        QCOMPARE(checked.status, agrees ? 0 : 4);
        QVERIFY2(has(checked.out, said) && has(checked.out, verdict), checked.text().c_str());
    }

    void whatTheDataCannotTellIsNamed() {
        json file = yielding();
        const QString path = save("plunge.sparkout", file.dump());
        const QStringList command{"measured", path,
                                  "--data",   save("sizes.csv", sizesOf(traces(file, 1, 1))),
                                  "--fit",    "compliance,flow_stress,size_offset"};
        const ProcessOutcome outcome = run(command);
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QVERIFY2(has(outcome.out,
                     "determined only as a product: compliance, flow_stress; record the wheel's "
                     "power"),
                 outcome.out.c_str());
        QCOMPARE(run(command + QStringList{"--check"}).status, 4);
        const json fit = json::parse(run(command + QStringList{"--json"}).out).at("identification");
        QVERIFY(fit.at("cannot_tell")[0].at("parameters") == json({"compliance", "flow_stress"}));
        QVERIFY(fit.at("values").empty());
    }

    void theFileItselfMayHoldThem() {
        json file = yielding();
        file["measured"]["summaries"] = {{{"quantity", "diameter_deviation"},
                                          {"count", 50},
                                          {"mean_um", 900},
                                          {"half_width_um", 0.5}}};
        const ProcessOutcome outcome =
            run({"measured", save("held.sparkout", file.dump()), "--json", "--check"});
        QVERIFY2(outcome.status == 4, outcome.text().c_str());
        const json row = json::parse(outcome.out).at("adequacy").at(0);
        QVERIFY(row.at("summary").get<bool>());
        QVERIFY(row.at("verdict").get<std::string>().starts_with("biased"));
    }

    void refusals() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const ProcessOutcome nothing = run({"measured", file});
        QCOMPARE(nothing.status, 1);
        QVERIFY(has(nothing.err, "nothing is measured"));
        const QString wrong = save("wrong.csv", "Part;Diameter [mm]\n1;29,9\n2;abc\n");
        const ProcessOutcome fault = run({"measured", file, "--data", wrong});
        QCOMPARE(fault.status, 1);
        QVERIFY2(has(fault.err, "wrong.csv:3:2: "), fault.err.c_str());
        QCOMPARE(run({"measured", file, "--data", "/no/such/file.csv"}).status, 1);
        QVERIFY(isUsageError(run({"measured", file, "--fit", "alpha,gamma"})));
        QVERIFY(isUsageError(run({"measured", file, "--fit", "compliance:x"})));
        QVERIFY(isUsageError(run({"measured", file, "--fit"})));
        QVERIFY(isUsageError(run({"measured", file, "--csv"})));
        QVERIFY(isUsageError(run({"measured"})));
        const QString good = save("good.csv", table(yielding(), 0));
        QCOMPARE(run({"measured", file, "--data", good, "--fit", "alpha,alpha"}).status, 1);
    }
};

} // namespace test_cli_measured

SPARKOUT_TEST(test_cli_measured, TestCliMeasured)
#include "test_cli_measured.moc"
