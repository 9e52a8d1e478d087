// SPDX-License-Identifier: GPL-3.0-or-later
// The summary of a kept run: what it holds is the result, it goes through the file unchanged, and
// what comes out otherwise later is named.
#include "core/quality/run_summary.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_run_summary {

struct Ran {
    explicit Ran(const Project& project) : result(simulateUnchecked(project)) {
        const PartAccuracy accuracy = accuracyOf(result);
        constraints = evaluateConstraints(result, accuracy);
        summary = summarise(result, accuracy, constraints);
    }
    [[nodiscard]] KeptRun kept() const {
        return keptRun(result, summary, "Run 1", "2026-01-02T03:04:05Z");
    }
    [[nodiscard]] ReadSummary read() const { return *readSummary(kept().summary.text); }

    SimulationResult result;
    std::vector<ConstraintResult> constraints;
    RunSummary summary;
};

std::vector<Project> projects() {
    return {samples::project("smallest-traverse"), samples::project("smallest-plunge")};
}

std::vector<std::string> pathsOf(const std::vector<ChangedValue>& changes) {
    std::vector<std::string> paths;
    for (const ChangedValue& change : changes) {
        paths.push_back(change.path);
    }
    return paths;
}

class TestRunSummary : public QObject {
    Q_OBJECT

private slots:
    void itHoldsTheResultInTheUnitsOfItsKeys() {
        for (const Project& project : projects()) {
            const Ran ran(project);
            QCOMPARE(ran.summary.cycle_time_min * 60, ran.result.time_s);
            QCOMPARE(ran.summary.count, ran.result.cycleCount);
            QCOMPARE(ran.summary.counts_by_stage.size(), ran.result.countsByStage.size());
            QCOMPARE(ran.summary.peak_normal_force_n, ran.result.peakNormalForce_n);
            QCOMPARE(ran.summary.zones.size(), ran.result.sections.size());
            for (std::size_t i = 0; i < ran.summary.zones.size(); ++i) {
                const ZoneSummary& zone = ran.summary.zones[i];
                const std::vector<double>& radii_mm = ran.result.sections[i].radii_mm;
                QCOMPARE(zone.radii_um.size(), radii_mm.size());
                for (std::size_t k = 0; k < radii_mm.size(); ++k) {
                    QCOMPARE(project.part->diameter_mm / 2 + zone.radii_um[k] / 1000, radii_mm[k]);
                }
            }
            for (const RequirementSummary& requirement : ran.summary.requirements) {
                const auto kindOf = [&](const ConstraintResult& c) {
                    return requirementOf(c.kind).key == requirement.name;
                };
                QVERIFY(std::ranges::any_of(ran.constraints, kindOf));
                for (const ConstraintResult& c : ran.constraints) {
                    QVERIFY(!kindOf(c) || c.relativeMargin >= requirement.relative_margin);
                }
            }
        }
    }

    void itReadsBackAsItWasWritten() {
        for (const Project& project : projects()) {
            const Ran ran(project);
            const ReadSummary read = ran.read();
            QVERIFY(read.missing.empty());
            QVERIFY(changedSince(read, ran.summary).empty());
            QVERIFY(sameProject(readProject(ran.kept().inputs.text).project.value(), project));
        }
    }

    /// A thousandth more in any number, or one more in a count, is named by its path and nothing
    /// else is; a millionth of a micrometre is no difference.
    void everyValueThatChangesIsNamed() {
        const Ran ran(samples::project("smallest-traverse"));
        const ReadSummary kept = ran.read();
        RunSummary now = ran.summary;
        int changed = 0;
        for (const Leaf& leaf : leavesOf(tableOf<RunSummary>(), &now)) {
            if (leaf.field->kind != Kind::number && leaf.field->kind != Kind::integer) {
                continue;
            }
            void* const owner = const_cast<void*>(leaf.owner);
            const bool whole = leaf.field->kind == Kind::integer;
            const RunSummary before = now;
            if (whole) {
                leaf.field->as<int>(owner) += 1;
            } else {
                double& value = leaf.field->as<double>(owner);
                value += 1e-3 * std::max(1.0, std::abs(value));
            }
            QCOMPARE(changedSince(kept, now).size(), 1u);
            const ChangedValue change = changedSince(kept, now).front();
            QCOMPARE(std::string(change.kept.field->key), std::string(leaf.field->key));
            QVERIFY(change.path.starts_with("/requirements") || change.path == leaf.path);
            whole ? void(leaf.field->as<int>(owner) -= 1)
                  : void(leaf.field->as<double>(owner) =
                             leaf.field->as<double>(leavesAt(before, leaf.path)));
            ++changed;
        }
        QVERIFY(changed > 20);
        QVERIFY(changedSince(kept, now).empty());
        now.zones[1].radii_um[3] += 0.9 * sameRadius_um;
        QVERIFY(changedSince(kept, now).empty());
        now.zones[1].radii_um[3] += 0.9 * sameRadius_um;
        QCOMPARE(pathsOf(changedSince(kept, now)), (std::vector<std::string>{"/zones/1/radii_um"}));
    }

    void aRequirementGoesByItsNameWhateverStandsBeforeIt() {
        const Ran ran(samples::project("smallest-traverse"));
        const ReadSummary kept = ran.read();
        RunSummary now = ran.summary;
        QVERIFY(now.requirements.size() > 1);
        now.requirements.insert(now.requirements.begin(), {"new_one", "part", 1, 2, -1, -1, false});
        QVERIFY(changedSince(kept, now).empty());
        const std::string gone = now.requirements[1].name;
        now.requirements.erase(now.requirements.begin() + 1);
        const std::vector<ChangedValue> changes = changedSince(kept, now);
        QCOMPARE(changes.size(), 6u); // every value of it
        for (const ChangedValue& change : changes) {
            QVERIFY(change.path.starts_with("/requirements/" + gone + '/') && !change.now);
        }
    }

    void whatAnotherVersionWroteIsReadAsFarAsItIsKnown() {
        const Ran ran(samples::project("smallest-traverse"));
        auto json = nlohmann::json::parse(ran.kept().summary.text);
        json["later"] = {{"thing", 1}};
        json.erase("cylindricity_um");
        json["zones"][0].erase("roundness_um");
        const auto read = readSummary(json.dump());
        QVERIFY(read.has_value());
        QCOMPARE(read->missing,
                 (std::set<std::string>{"/cylindricity_um", "/zones/0/roundness_um"}));
        QVERIFY(changedSince(*read, ran.summary).empty());
        for (const char* text : {"", "[]", "{\"zones\": 3}", "{\"status\": \"dancing\"}", "7"}) {
            QVERIFY2(!readSummary(text), text);
        }
    }

private:
    static const void* leavesAt(const RunSummary& summary, const std::string& path) {
        for (const Leaf& leaf : leavesOf(tableOf<RunSummary>(), &summary)) {
            if (leaf.path == path) {
                return leaf.owner;
            }
        }
        return nullptr;
    }
};

} // namespace sparkout::test_run_summary

SPARKOUT_TEST(test_run_summary, TestRunSummary)
#include "test_run_summary.moc"
