// SPDX-License-Identifier: GPL-3.0-or-later
// Measured parts and traces in a project: shared by its copies, read and written as any input.
#include "core/project/measured.h"

#include "core/file/project_file.h"
#include "core/project/member.h"
#include "core/project/number_input.h"
#include "core/project/validate.h"
#include "core/quality/run_summary.h"
#include "core/study/outcome.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <numeric>

namespace sparkout::test_measured {

using nlohmann::json;

Project everything() {
    return samples::project("everything");
}

json withMeasured(const json& measured) {
    json file = samples::sample("smallest-plunge");
    file["measured"] = measured;
    return file;
}

MeasuredTrace longTrace() {
    std::vector<double> times(limits::traceSamples);
    std::iota(times.begin(), times.end(), 0.0);
    MeasuredTrace trace;
    trace.values = Samples(times);
    trace.time_s = Samples(std::move(times));
    return trace;
}

class TestMeasured : public QObject {
    Q_OBJECT

private slots:
    /// What undo keeps: one section for all the states in which it was the same.
    void copiesShareItUntilOneIsWrittenTo() {
        const Project a = everything();
        Project b = a;
        QVERIFY(a.measured.isSharedWith(b.measured));
        QCOMPARE(&*a.measured, &*std::as_const(b).measured);
        b.measured->parts.front().place = 2;
        QVERIFY(!a.measured.isSharedWith(b.measured));
        QCOMPARE(a.measured->parts.front().place, 1);
        // The traces stay one even then.
        QCOMPARE(a.measured->traces.front().values.values().data(),
                 std::as_const(b).measured->traces.front().values.values().data());
        const void* const own = &*std::as_const(b).measured;
        b.measured->parts.clear();
        QCOMPARE(static_cast<const void*>(&*std::as_const(b).measured), own);
    }

    void readingDoesNotPartIt() {
        const Project a = everything();
        const Project b = a;
        QVERIFY(findMember(b, "/measured/parts/0/part"));
        QVERIFY(firstDifference(a, b).empty());
        QVERIFY(!hasErrors(validate(b)));
        QVERIFY(!writeProject(b).empty() && sameProject(a, b));
        QVERIFY(!numberInput(b, "/measured/parts/0/roundness_um")); // no input of a cycle
        QVERIFY(a.measured.isSharedWith(b.measured));
    }

    void aChangeOfItIsADifference() {
        const Project a = everything();
        Project b = a;
        b.measured->traces.front().values = Samples({2, 2.1, 4.5, 4.6});
        QCOMPARE(firstDifference(a, b), std::string("/measured/traces/0/values"));
        QVERIFY(!sameProject(a, b));
        b.measured->traces.front().values = a.measured->traces.front().values;
        QVERIFY(sameProject(a, b));
        b.measured.reset();
        QCOMPARE(firstDifference(a, b), std::string("/measured"));
    }

    void aFullTraceIsRead() {
        Project project = samples::project("smallest-plunge");
        project.measured.emplace().traces.assign(limits::traces, longTrace());
        const ReadResult read = readProject(writeProject(project));
        QVERIFY2(read.project, samples::listed(read.issues).c_str());
        QVERIFY(sameProject(*read.project, project));
        QVERIFY(read.project->measured->traces.back().values == longTrace().values);
    }

    void manyPartsAreRead() {
        Project project = samples::project("smallest-plunge");
        project.measured.emplace().parts.resize(limits::measuredParts);
        QVERIFY(readProject(writeProject(project)).project);
        project.measured->parts.emplace_back();
        QVERIFY(samples::holds(readProject(writeProject(project)).issues, IssueCode::wrongCount,
                               "/measured/parts"));
    }

    void faults_data() {
        addColumns<QByteArray, int, QByteArray, bool>("measured", "code", "path", "refused");
        const auto row = [](const char* name, const char* measured, IssueCode code,
                            const char* path, bool refused) {
            addRow(name, QByteArray(measured), static_cast<int>(code), QByteArray(path), refused);
        };
        row("unknown key", R"({"part": []})", IssueCode::unknownKey, "/measured/part", true);
        row("unknown quantity",
            R"({"traces": [{"quantity": "noise", "time_s": [], "values": []}]})",
            IssueCode::notOneOf, "/measured/traces/0/quantity", true);
        row("no part", R"({"parts": [{"place": 0}]})", IssueCode::missingKey,
            "/measured/parts/0/part", true);
        row("no such section", R"({"parts": [{"part": "1", "place": 4}]})", IssueCode::outOfRange,
            "/measured/parts/0/place", false);
        row("a negative roundness", R"({"parts": [{"part": "1", "roundness_um": -1}]})",
            IssueCode::outOfRange, "/measured/parts/0/roundness_um", true);
        row("fewer values than times",
            R"({"traces": [{"quantity": "gauge_size", "time_s": [0, 1], "values": [0]}]})",
            IssueCode::wrongCount, "/measured/traces/0/values", true);
        row("time goes back",
            R"({"traces": [{"quantity": "gauge_size", "time_s": [0, 2, 1], "values": [0, 0, 0]}]})",
            IssueCode::outOfRange, "/measured/traces/0/time_s/2", true);
        row("a range turned round",
            R"({"summaries": [{"quantity": "roundness", "count": 3, "mean_um": 1, "least_um": 2,
                "greatest_um": 1}]})",
            IssueCode::outOfRange, "/measured/summaries/0/greatest_um", true);
        row("one part is no statistics",
            R"({"summaries": [{"quantity": "roundness", "count": 1, "mean_um": 1}]})",
            IssueCode::outOfRange, "/measured/summaries/0/count", true);
    }
    void faults() {
        QFETCH(QByteArray, measured);
        QFETCH(int, code);
        QFETCH(QByteArray, path);
        QFETCH(bool, refused);
        const ReadResult read =
            readProject(withMeasured(json::parse(measured.toStdString())).dump());
        QVERIFY2(samples::holds(read.issues, static_cast<IssueCode>(code), path.toStdString()),
                 samples::listed(read.issues).c_str());
        QCOMPARE(read.project.has_value(), !refused);
    }

    void aTraceOfTooManySamplesIsRefused() {
        json trace = {{"quantity", "gauge_size"}};
        trace["time_s"] = std::vector<int>(limits::traceSamples + 1, 0);
        trace["values"] = trace["time_s"];
        const Issues issues = samples::faults(withMeasured({{"traces", {trace}}}));
        QVERIFY(samples::holds(issues, IssueCode::wrongCount, "/measured/traces/0/time_s"));
    }

    /// In a file of several surfaces each has its own.
    void itBelongsToASurface() {
        json first = samples::sample("smallest-plunge");
        first["measured"] = {{"parts", {{{"part", "7"}}}}};
        const json file = setup_samples::setupOf({first, samples::sample("smallest-plunge")});
        QVERIFY(file["surfaces"][0].contains("measured"));
        const ReadSetup read = readSetup(file.dump());
        QVERIFY2(read.setup, samples::listed(read.issues).c_str());
        QCOMPARE(read.setup->surfaces[0].project.measured->parts.front().part, std::string("7"));
        QVERIFY(!read.setup->surfaces[1].project.measured);
        const ReadSetup again = readSetup(writeSetup(*read.setup));
        QVERIFY(again.setup && again.setup->surfaces[0].project.measured);
    }

    /// A kept run is a record of what was run; what was measured since stays with the project.
    void aKeptRunHasNone() {
        Project project = samples::project("smallest-plunge");
        project.measured.emplace().parts.emplace_back();
        const OutcomePtr outcome = evaluate(project, {});
        QVERIFY(outcome && outcome->ran());
        const RunSummary summary =
            summarise(outcome->result, outcome->accuracy, outcome->constraints);
        const KeptRun run = keptRun(outcome->result, summary, "first", "2026-01-01T00:00:00Z");
        QVERIFY(run.inputs.text.find("measured") == std::string::npos);
        QVERIFY(readProject(run.inputs.text).project);
    }
};

} // namespace sparkout::test_measured

SPARKOUT_TEST(test_measured, TestMeasured)
#include "test_measured.moc"
