// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `measured` as a user meets it: the real program on files with measured parts and traces.
#include "core/project/measured.h"
#include "core/project/wheel.h"
#include "core/simulation/simulate.h"
#include "tests/cli/cli_bench.h"
#include "tests/core/identification/measured_cycles.h"
#include "tests/registry.h"

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

/// Size and power of a cycle with factors of γ and η, as a table.
std::string traces(const json& file, double compliance, double dullness) {
    json truth = file;
    truth["machine"]["compliance_mm_per_n"] = {5e-4 * compliance};
    truth["wheel"]["dullness"] = 0.01 * dullness;
    const Record cycle = record(readProject(truth.dump()).project.value());
    const Recording how{.hertz = 20, .noise = 2e-4, .seed = 3};
    const Recording ofPower{.hertz = 20, .noise = 1e-2, .offset = 0.5, .seed = 4};
    const MeasuredTrace size = trace(TraceQuantity::gauge_size, cycle, how);
    const MeasuredTrace power = trace(TraceQuantity::wheel_power, cycle, ofPower);
    std::string text = "t [s],size [mm],P [kW]\n";
    for (std::size_t i = 0; i < size.values.size(); ++i) {
        text += std::to_string(size.time_s[i]) + ',' + std::to_string(size.values[i]) + ','
                + std::to_string(power.values[i]) + '\n';
    }
    return text;
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
        const Outcome agrees = run({"measured", file, "--data", good, "--json", "--check"});
        QVERIFY2(agrees.status == 0, agrees.text().c_str());
        const json row = json::parse(agrees.out).at("adequacy").at(0);
        QCOMPARE(row.at("quantity").get<std::string>(), std::string("diameter_deviation"));
        QCOMPARE(row.at("count").get<int>(), 12);
        QCOMPARE(row.at("verdict").get<std::string>(), std::string("adequate"));
        QVERIFY(row.at("predicted").at("low_um") < row.at("predicted").at("high_um"));
        QVERIFY(row.at("inside").at("count") > 9);
        const Outcome differs = run({"measured", file, "--data", shifted, "--check"});
        QVERIFY2(differs.status == 4, differs.text().c_str());
        QVERIFY(has(differs.out, "the mean differs from the predicted one"));
        QCOMPARE(run({"measured", file, "--data", shifted}).status, 0);
    }

    void aFitSaysWhatItFinds() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const QString data = save("trace.csv", traces(yielding(), 1.2, 0.9));
        const Outcome outcome = run({"measured", file, "--data", data, "--fit",
                                     "compliance,dullness,size_offset,idle_power", "--json"});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        const json fit = json::parse(outcome.out).at("identification");
        QCOMPARE(fit.at("status").get<std::string>(), std::string("fitted"));
        QVERIFY(std::abs(fit.at("values")[0].at("value").get<double>() - 1.2) < 0.05);
        QVERIFY(std::abs(fit.at("values")[1].at("value").get<double>() - 0.9) < 0.05);
        QVERIFY(std::abs(fit.at("values")[3].at("value").get<double>() - 0.5) < 0.05);
        QCOMPARE(fit.at("residuals").size(), std::size_t{2});
        const Outcome text = run({"measured", file, "--data", data, "--fit", "alpha,beta"});
        QVERIFY2(has(text.out, "alpha: "), text.text().c_str());
    }

    /// What is known before holds a value where it is sure, outliers hardly count by a robust loss,
    /// and what was found is saved with what it was found on.
    void aFitTakesWhatIsKnownAndIsSaved() {
        const QString file = save("plunge.sparkout", yielding().dump());
        std::string table = traces(yielding(), 1.2, 0.9);
        const QString data = save("trace.csv", table);
        const QString found = m_folder.filePath(QStringLiteral("found.sparkout"));
        const QStringList fit{"measured", file, "--data", data, "--fit"};
        const Outcome known =
            run(fit + QStringList{"compliance=1~0.0001,dullness,size_offset,idle_power", "--json"});
        const json held = json::parse(known.out).at("identification");
        QVERIFY(std::abs(held.at("values")[0].at("value").get<double>() - 1) < 0.01);
        const QString parameters = QStringLiteral("compliance,dullness,size_offset,idle_power");
        const Outcome saved = run(fit + QStringList{parameters, "-o", found});
        QVERIFY2(saved.status == 0, saved.text().c_str());
        QFile written(found);
        QVERIFY(written.open(QIODevice::ReadOnly));
        const ReadResult read = readProject(written.readAll().toStdString());
        QVERIFY(read.project && read.project->measured);
        QCOMPARE(read.project->measured->calibrations.size(), std::size_t{2});
        QCOMPARE(read.project->measured->calibrations.front().data, std::string("trace.csv"));
        QVERIFY(std::abs(read.project->wheel->dullness / 0.009 - 1) < 0.05);
        // A lone value that is a tenth of a millimetre off.
        std::size_t line = table.size() / 2;
        line = table.find('\n', line) + 1;
        const std::size_t comma = table.find(',', line), second = table.find(',', comma + 1);
        const double size = std::stod(table.substr(comma + 1, second - comma - 1));
        table.replace(comma + 1, second - comma - 1, std::to_string(size + 0.1));
        const QStringList spike{"measured", file,       "--data", save("spike.csv", table),
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
        const Outcome untold = run(fit + QStringList{"alpha,beta,compliance", "-o", none});
        QVERIFY(!QFile::exists(none));
        QVERIFY2(has(untold.err, "not saved"), untold.text().c_str());
    }

    void whatTheDataCannotTellIsNamed() {
        json file = yielding();
        const QString path = save("plunge.sparkout", file.dump());
        std::string sizes = "t [s],size [mm]\n";
        for (const std::string& line : split(traces(file, 1, 1), '\n')) {
            if (line.front() != 't') {
                sizes += line.substr(0, line.rfind(',')) + '\n';
            }
        }
        const QStringList command{"measured", path,
                                  "--data",   save("sizes.csv", sizes),
                                  "--fit",    "compliance,flow_stress,size_offset"};
        const Outcome outcome = run(command);
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QVERIFY2(has(outcome.out,
                     "told only as a product: compliance, flow_stress; record the wheel's "
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
        const Outcome outcome =
            run({"measured", save("held.sparkout", file.dump()), "--json", "--check"});
        QVERIFY2(outcome.status == 4, outcome.text().c_str());
        const json row = json::parse(outcome.out).at("adequacy").at(0);
        QVERIFY(row.at("summary").get<bool>());
        QVERIFY(row.at("verdict").get<std::string>().starts_with("biased"));
    }

    void refusals() {
        const QString file = save("plunge.sparkout", yielding().dump());
        const Outcome nothing = run({"measured", file});
        QCOMPARE(nothing.status, 1);
        QVERIFY(has(nothing.err, "nothing is measured"));
        const QString wrong = save("wrong.csv", "Part;Diameter [mm]\n1;29,9\n2;abc\n");
        const Outcome fault = run({"measured", file, "--data", wrong});
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
