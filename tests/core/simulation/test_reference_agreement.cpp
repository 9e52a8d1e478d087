// SPDX-License-Identifier: GPL-3.0-or-later
// The engine against the second implementation, on random projects that cover every option.
// SPARKOUT_QUICK=1: every tenth project (sanitizers). SPARKOUT_LONG=1: 6,000 projects.
#include "core/simulation/simulate.h"

#include "tests/check_line.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/random_project.h"
#include "tests/core/support/reference_difference.h"
#include "tests/registry.h"

#include <map>
#include <set>

namespace sparkout::test_reference_agreement {

using nlohmann::json;

constexpr int rowLength = 100;

int projects() {
    return qEnvironmentVariableIsSet("SPARKOUT_LONG") ? 6'000 : 1'000;
}
int stride() {
    return qEnvironmentVariableIsSet("SPARKOUT_QUICK") ? 10 : 1;
}

/// The features of a project, as words to count.
std::set<std::string> features(const json& p) {
    std::set<std::string> found;
    const std::string operation = p["operation"];
    const json& part = p["part"];
    const json gauge = p.value("gauge", json::object());
    const std::string surface = part.value("surface", "external");
    found.insert(operation);
    found.insert(operation + ", " + surface);
    found.insert(surface + ", profile " + part.value("profile", "ellipse"));
    found.insert(surface + ", rule " + gauge.value("rule", "min"));
    found.insert(operation + ", control " + gauge.value("control", "gauge"));
    found.insert(part.contains("target_diameter_mm") ? "target given" : "target by the field");
    found.insert(p["wheel"]["dullness"] == 0 ? "sharp wheel" : "dull wheel");
    found.insert(part["initial_runout_mm"] == 0 ? "round blank" : "blank with runout");
    found.insert(p["machine"].contains("geometric_runout_um") ? "machine runout"
                                                              : "no machine runout");
    if (operation == "plunge" && part.contains("gaps")) {
        found.insert("plunge, interrupted");
        found.insert(gauge.value("spans_gaps", true) ? "gauge spans the gaps"
                                                     : "gauge drops into the gaps");
    }
    if (operation == "plunge") {
        found.insert(gauge.contains("compliance_mm_per_n") ? "free gauge, own compliance"
                     : gauge.contains("position_mm")       ? "free gauge, interpolated"
                     : gauge.contains("section")           ? "gauge in a section"
                                                           : "gauge in the middle");
    }
    if (operation == "traverse") {
        const json& machine = p["machine"];
        const std::string infeed = machine.value("reversal_infeed", "entry");
        found.insert("reversal infeed, " + infeed);
        if (p.contains("zone_sections")) {
            found.insert(p["zone_sections"].get<int>() % 2 ? "odd number of sections in a zone"
                                                           : "even number of sections in a zone");
        }
        if (part.contains("gaps")) {
            found.insert("traverse, interrupted");
        }
        if (part.value("blind_bore", false)) {
            const bool entry = machine["entry_side"] == "headstock";
            found.insert(entry ? "wall at the entry" : "wall at the exit");
            const double overrun = machine[entry ? "overrun_entry_mm" : "overrun_exit_mm"];
            found.insert(overrun < 0 ? "turns before the wall" : "turns at the wall");
        }
        for (const json& stage : p["cycle"]["stages"]) {
            if (stage.value("continuous_feed_mm_min", 0.0) > 0) {
                found.insert("continuous infeed, " + infeed);
                found.insert("continuous infeed, control " + gauge.value("control", "gauge"));
                found.insert(stage["radial_feed_mm"] > 0 ? "continuous beside reversal infeed"
                                                         : "continuous infeed alone");
            }
        }
    }
    const json& machine = p["machine"];
    const bool late = gauge.contains("delay_s"),
               changesLate = machine.contains("feed_change_delay_s");
    found.insert(late && changesLate ? "both delays"
                 : late              ? "gauge delay"
                 : changesLate       ? "feed change delay"
                                     : "no delay");
    for (const char* key : {"least_overlap", "least_overlap_last", "least_steps"}) {
        if (p.contains(key)) {
            found.insert(operation + ", " + key);
        }
    }
    const json& stages = p["cycle"]["stages"];
    found.insert(std::to_string(stages.size()) + " stages");
    double stock = 0;
    for (const json& stage : stages) {
        stock += stage.value("stock_mm", 0.0);
    }
    found.insert(std::abs(stock - part["stock_mm"].get<double>()) > 1e-9
                     ? "stocks that do not sum up"
                     : "stocks that sum up");
    const json last = stages.back().value("spark_out", json());
    found.insert(operation
                 + (last.is_null()     ? ", no spark-out"
                    : last.is_string() ? ", spark-out until size"
                                       : ", spark-out by count"));
    return found;
}

class TestReferenceAgreement : public QObject {
    Q_OBJECT

private slots:
    // Only the projects are made here, so this checks all of them even in a quick run.
    void projectsCoverEveryOption() {
        std::map<std::string, int> counts;
        for (int seed = 1; seed <= 1'000; ++seed) {
            for (const std::string& feature : features(randomProject(std::uint64_t(seed)))) {
                ++counts[feature];
            }
        }
        for (const std::string& option : samples::listOf(
                 "traverse, external|traverse, internal|odd number of sections in a zone|"
                 "even number of sections in a zone|traverse, interrupted|plunge, interrupted|"
                 "gauge spans the gaps|gauge drops into the gaps|wall at the entry|"
                 "wall at the exit|turns before the wall|turns at the wall|plunge, external|"
                 "plunge, internal|external, profile ellipse|external, profile eccentric|"
                 "external, profile lobes|external, profile measured|internal, profile ellipse|"
                 "internal, profile eccentric|internal, profile lobes|"
                 "internal, profile measured|external, rule min|external, rule mean|"
                 "external, rule max|internal, rule min|internal, rule mean|internal, rule max|"
                 "traverse, control gauge|traverse, control position|plunge, control gauge|"
                 "plunge, control position|target given|target by the field|sharp wheel|"
                 "dull wheel|round blank|blank with runout|machine runout|no machine runout|"
                 "reversal infeed, entry|reversal infeed, exit|reversal infeed, both|"
                 "continuous infeed, entry|continuous infeed, exit|continuous infeed, both|"
                 "continuous infeed, control gauge|continuous infeed, control position|"
                 "continuous beside reversal infeed|continuous infeed alone|"
                 "free gauge, own compliance|free gauge, interpolated|gauge in a section|"
                 "gauge in the middle|1 stages|2 stages|3 stages|4 stages|5 stages|"
                 "stocks that do not sum up|stocks that sum up|traverse, no spark-out|"
                 "traverse, spark-out until size|traverse, spark-out by count|"
                 "plunge, no spark-out|plunge, spark-out until size|plunge, spark-out by count|"
                 "no delay|gauge delay|feed change delay|both delays|traverse, least_overlap|"
                 "traverse, least_overlap_last|traverse, least_steps|plunge, least_steps")) {
            QVERIFY2(counts[option] >= 10,
                     qPrintable(QString("%1: %2").arg(option.c_str()).arg(counts[option])));
        }
    }

    void engineAgreesWithTheSecondImplementation_data() {
        QTest::addColumn<int>("first");
        for (int first = 1; first <= projects(); first += rowLength) {
            QTest::addRow("seeds %d to %d", first, first + rowLength - 1) << first;
        }
    }
    void engineAgreesWithTheSecondImplementation() {
        QFETCH(int, first);
        for (int seed = first; seed < first + rowLength; seed += stride()) {
            const json project = randomProject(std::uint64_t(seed));
            const SimulationResult engine = simulateUnchecked(fixtures::read(project));
            const reference::Result second = reference::simulate(project);
            const QString found =
                reference::difference(engine, second, project["part"]["diameter_mm"].get<double>());
            QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1, %2").arg(seed).arg(found)));
            ++m_statuses[second.status];
            const auto& counts = second.passes_by_stage;
            m_skippedStages += std::find(counts.begin(), counts.end(), 0) != counts.end();
        }
    }

    // With a threshold of the force, in cycles that cut, touch and leave radii alone.
    void engineAgreesWhereTheForceHasAThreshold() {
        const int last = qEnvironmentVariableIsSet("SPARKOUT_LONG") ? 2'000 : 300;
        int completed = 0, touching = 0;
        for (int seed = 1; seed <= last; seed += stride()) {
            const auto number = static_cast<std::uint64_t>(seed);
            const json project = withThreshold(randomProject(number), number);
            Trajectory trajectory;
            const SimulationResult engine = simulateUnchecked(fixtures::read(project), &trajectory);
            const reference::Result second = reference::simulate(project);
            const QString found =
                reference::difference(engine, second, project["part"]["diameter_mm"].get<double>());
            QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1, %2").arg(seed).arg(found)));
            completed += second.status == "completed";
            touching += std::ranges::any_of(trajectory.visits, [](const Visit& visit) {
                return visit.actual_mm == 0 && visit.normalForce_n > 0;
            });
        }
        const int compared = last / stride();
        QVERIFY2(completed >= compared / 2, qPrintable(QString::number(completed)));
        QVERIFY2(touching >= compared / 2, qPrintable(QString::number(touching)));
    }

    // With a wheel out of true, by an amplitude, an unbalance or a grade, at a varied speed too.
    void engineAgreesWhereTheWheelRunsOutOfTrue() {
        const int last = qEnvironmentVariableIsSet("SPARKOUT_LONG") ? 2'000 : 300;
        int completed = 0, changed = 0;
        for (int seed = 1; seed <= last; seed += stride()) {
            const auto number = static_cast<std::uint64_t>(seed);
            const json plain = randomProject(number), project = withWheelRunout(plain, number);
            const SimulationResult engine = simulateUnchecked(fixtures::read(project));
            const reference::Result second = reference::simulate(project);
            const QString found =
                reference::difference(engine, second, project["part"]["diameter_mm"].get<double>());
            QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1, %2").arg(seed).arg(found)));
            completed += second.status == "completed";
            changed += engine.sections[0].radii_mm
                       != simulateUnchecked(fixtures::read(plain)).sections[0].radii_mm;
        }
        const int compared = last / stride();
        QVERIFY2(completed >= compared / 2, qPrintable(QString::number(completed)));
        QVERIFY2(changed >= compared * 9 / 10, qPrintable(QString::number(changed)));
    }

    // What comes out must vary too: cycles that reach size and that do not, stages that are over
    // before they begin.
    void outcomesOfEveryKindWereCompared() {
        if (m_statuses.empty()) {
            QSKIP("nothing was compared in this run");
        }
        const int compared = projects() / stride();
        checkLine(
            "15", compared, asked(1000, compared), !QTest::currentTestFailed(),
            QStringLiteral("random projects on which the engine and the second implementation "
                           "agree, %1 of them to size")
                .arg(m_statuses["completed"]));
        const int least = projects() / stride() / 100;
        QVERIFY2(m_statuses["completed"] >= least,
                 qPrintable(QString::number(m_statuses["completed"])));
        QVERIFY2(m_statuses["cannot_reach_size"] >= least,
                 qPrintable(QString::number(m_statuses["cannot_reach_size"])));
        QVERIFY2(m_skippedStages >= least, qPrintable(QString::number(m_skippedStages)));
    }

private:
    std::map<std::string, int> m_statuses;
    int m_skippedStages = 0; ///< cycles in which several stages ended at one reading
};

} // namespace sparkout::test_reference_agreement

SPARKOUT_TEST(test_reference_agreement, TestReferenceAgreement)
#include "test_reference_agreement.moc"
