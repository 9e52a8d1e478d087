// SPDX-License-Identifier: GPL-3.0-or-later
// The engine against the second implementation, on random projects that cover every option.
// SPARKOUT_QUICK=1: every tenth project (sanitizers). SPARKOUT_LONG=1: 20,000 projects.
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/setting_constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"

#include "tests/check_line.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/random_project.h"
#include "tests/core/support/reference_simulation.h"
#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

namespace test_reference_agreement {

using namespace sparkout;
using nlohmann::json;

namespace {

constexpr int rowLength = 100;

int projects() {
    return qEnvironmentVariableIsSet("SPARKOUT_LONG") ? 20'000 : 1'000;
}
int stride() {
    return qEnvironmentVariableIsSet("SPARKOUT_QUICK") ? 10 : 1;
}

std::string statusName(RunStatus status) {
    switch (status) {
    case RunStatus::completed: return "completed";
    case RunStatus::cannotReachSize: return "cannot_reach_size";
    case RunStatus::tooLong: return "too_long";
    case RunStatus::notSolved: return "not_solved";
    case RunStatus::groundAway: return "ground_away";
    case RunStatus::stopped:
    case RunStatus::refused: break;
    }
    return "stopped";
}

/// What differs among the stages' sums. Depths of some tenths are rounded to 1e-16 mm or so; a pass
/// that finds no more than that removes it in one engine and not in the other, so each sum may
/// differ by what such passes come to.
QString stageDifference(const SimulationResult& engine, const reference::Result& second) {
    constexpr double depth = 1e-16; // [mm]
    const Project& project = engine.project;
    const ShopNumbers shop = shopNumbers(engine);
    const double turns_s = project.machine->work_speed_rpm / 60;
    const double rate = std::numbers::pi * project.part->diameter_mm * turns_s * depth; // [mm²/s]
    const double force = fixtures::Law(project).force(1, depth);                        // [N/mm]
    const double power = force * project.machine->wheel_speed_m_s; // P_z < P_y [W/mm]
    const double B = project.wheel->width_mm;
    if (shop.stages.size() != second.stages.size()) {
        return "number of stages";
    }
    for (std::size_t z = 0; z < second.stages.size(); ++z) {
        const ShopColumn& stage = shop.stages[z];
        const reference::StageSums& other = second.stages[z];
        const double l = other.ground_mm;
        const double meanRate = l > 0 ? other.volume_mm3 / l * turns_s : 0;
        const std::tuple<const char*, double, double, double> pairs[] = {
            {"volume", stage.removedVolume_mm3, other.volume_mm3, rate / turns_s * l},
            {"energy", stage.energy_j, other.energy_j, power / turns_s * l},
            {"grinding time", stage.grindingTime_s / 60, other.grinding_min, 0},
            {"largest depth", stage.depth_mm.value, other.largest_depth_mm, depth},
            {"normal force", stage.normalForce_n.value, other.peak_normal_force_n, force * B},
            {"power", stage.power_w.value, other.peak_power_w, power * B},
            {"mean removal rate", stage.meanRemovalRate_mm2_s, meanRate, rate}};
        for (const auto& [what, a, b, absolute] : pairs) {
            if (!fixtures::within(a, b, absolute + 1e-9 * b)) {
                return QString("stage %1 %2: engine %3, reference %4")
                    .arg(z + 1)
                    .arg(what)
                    .arg(a, 0, 'g', 17)
                    .arg(b, 0, 'g', 17);
            }
        }
    }
    return {};
}

/// What differs among the limits of practice.
QString practiceDifference(const SimulationResult& engine, const reference::Result& second) {
    ConstraintResults found;
    evaluateOverlap(ConstraintKind::overlap, {engine, {}}, found);
    evaluateOverlap(ConstraintKind::leastOverlap, {engine, {}}, found);
    evaluateOverlap(ConstraintKind::leastOverlapLast, {engine, {}}, found);
    std::ranges::stable_sort(found, {}, &ConstraintResult::stage);
    evaluateLeastSteps(ConstraintKind::leastSteps, {engine, {}}, found);
    if (found.size() != second.practice.size()) {
        return "number of limits of practice";
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        const ConstraintResult& a = found[i];
        const reference::Practice& b = second.practice[i];
        if (requirementOf(a.kind).key != b.name || a.stage != b.stage || a.holds != b.holds
            || a.limit != b.least || !fixtures::close(a.value, b.value, 1e-12)) {
            return QString("%1 of stage %2").arg(b.name.c_str()).arg(b.stage);
        }
    }
    return {};
}

/// What differs, in words; empty when nothing does.
QString difference(const SimulationResult& engine, const reference::Result& second,
                   double diameter_mm) {
    const auto differs = [](const char* what, double a, double b) {
        return QString("%1: engine %2, reference %3")
            .arg(what)
            .arg(a, 0, 'g', 17)
            .arg(b, 0, 'g', 17);
    };
    if (statusName(engine.status) != second.status) {
        return QString("status: engine %1, reference %2")
            .arg(statusName(engine.status).c_str(), second.status.c_str());
    }
    if (engine.cycleCount != second.passes) {
        return differs("count", engine.cycleCount, static_cast<double>(second.passes));
    }
    if (!std::equal(engine.countsByStage.begin(), engine.countsByStage.end(),
                    second.passes_by_stage.begin(), second.passes_by_stage.end())) {
        return "counts by stage";
    }
    // Times are sums of at most some 10,000 durations.
    if (!fixtures::close(engine.time_s / 60, second.time_min, 1e-12)) {
        return differs("time", engine.time_s / 60, second.time_min);
    }
    if (!fixtures::close(engine.peakNormalForce_n, second.peak_normal_force_n, 1e-9)) {
        return differs("peak force", engine.peakNormalForce_n, second.peak_normal_force_n);
    }
    if (!fixtures::close(engine.peakPower_w, second.peak_power_w, 1e-9)) {
        return differs("peak power", engine.peakPower_w, second.peak_power_w);
    }
    if (const QString stage = stageDifference(engine, second); !stage.isEmpty()) {
        return stage;
    }
    if (const QString practice = practiceDifference(engine, second); !practice.isEmpty()) {
        return practice;
    }
    if (engine.sections.size() != second.places.size()) {
        return "number of sections";
    }
    constexpr double um = 1e-6; // the agreement the vectors' page asks for
    for (std::size_t i = 0; i < second.places.size(); ++i) {
        const SectionResult& section = engine.sections[i];
        const reference::Place& place = second.places[i];
        const std::pair<double, double> lengths[] = {
            {section.diameterDeviationMin_mm, place.diameter_deviation_min_um},
            {section.diameterDeviationMax_mm, place.diameter_deviation_max_um},
            {section.radialRunout_mm, place.radial_runout_um}};
        for (const auto& [mm, expected] : lengths) {
            if (!fixtures::within(mm * 1000, expected, um)) {
                return differs("deviation or runout", mm * 1000, expected);
            }
        }
        if (section.radii_mm.size() != place.radii_um.size()) {
            return "number of radii";
        }
        for (std::size_t k = 0; k < place.radii_um.size(); ++k) {
            const double radius = (section.radii_mm[k] - diameter_mm / 2) * 1000;
            if (std::isnan(radius) && std::isnan(place.radii_um[k])) {
                continue; // both see a gap
            }
            if (!fixtures::within(radius, static_cast<double>(place.radii_um[k]), um)) {
                return QString("section %1 radius %2, ").arg(i).arg(k)
                       + differs("µm", radius, static_cast<double>(place.radii_um[k]));
            }
        }
    }
    return {};
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

} // namespace

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
        const char* const options[] = {"traverse, external",
                                       "traverse, internal",
                                       "odd number of sections in a zone",
                                       "even number of sections in a zone",
                                       "traverse, interrupted",
                                       "plunge, interrupted",
                                       "gauge spans the gaps",
                                       "gauge drops into the gaps",
                                       "wall at the entry",
                                       "wall at the exit",
                                       "turns before the wall",
                                       "turns at the wall",
                                       "plunge, external",
                                       "plunge, internal",
                                       "external, profile ellipse",
                                       "external, profile eccentric",
                                       "external, profile lobes",
                                       "external, profile measured",
                                       "internal, profile ellipse",
                                       "internal, profile eccentric",
                                       "internal, profile lobes",
                                       "internal, profile measured",
                                       "external, rule min",
                                       "external, rule mean",
                                       "external, rule max",
                                       "internal, rule min",
                                       "internal, rule mean",
                                       "internal, rule max",
                                       "traverse, control gauge",
                                       "traverse, control position",
                                       "plunge, control gauge",
                                       "plunge, control position",
                                       "target given",
                                       "target by the field",
                                       "sharp wheel",
                                       "dull wheel",
                                       "round blank",
                                       "blank with runout",
                                       "machine runout",
                                       "no machine runout",
                                       "reversal infeed, entry",
                                       "reversal infeed, exit",
                                       "reversal infeed, both",
                                       "continuous infeed, entry",
                                       "continuous infeed, exit",
                                       "continuous infeed, both",
                                       "continuous infeed, control gauge",
                                       "continuous infeed, control position",
                                       "continuous beside reversal infeed",
                                       "continuous infeed alone",
                                       "free gauge, own compliance",
                                       "free gauge, interpolated",
                                       "gauge in a section",
                                       "gauge in the middle",
                                       "1 stages",
                                       "2 stages",
                                       "3 stages",
                                       "4 stages",
                                       "5 stages",
                                       "stocks that do not sum up",
                                       "stocks that sum up",
                                       "traverse, no spark-out",
                                       "traverse, spark-out until size",
                                       "traverse, spark-out by count",
                                       "plunge, no spark-out",
                                       "plunge, spark-out until size",
                                       "plunge, spark-out by count",
                                       "no delay",
                                       "gauge delay",
                                       "feed change delay",
                                       "both delays",
                                       "traverse, least_overlap",
                                       "traverse, least_overlap_last",
                                       "traverse, least_steps",
                                       "plunge, least_steps"};
        for (const char* const option : options) {
            QVERIFY2(counts[option] >= 10,
                     qPrintable(QString("%1: %2").arg(option).arg(counts[option])));
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
                difference(engine, second, project["part"]["diameter_mm"].get<double>());
            QVERIFY2(found.isEmpty(), qPrintable(QString("seed %1, %2").arg(seed).arg(found)));
            ++m_statuses[second.status];
            const auto& counts = second.passes_by_stage;
            m_skippedStages += std::find(counts.begin(), counts.end(), 0) != counts.end();
        }
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

} // namespace test_reference_agreement

SPARKOUT_TEST(test_reference_agreement, TestReferenceAgreement)
#include "test_reference_agreement.moc"
