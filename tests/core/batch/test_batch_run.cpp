// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_run.h"
#include "core/batch/batch_state.h"
#include "core/batch/batch_summary.h"
#include "core/batch/scenario_source.h"
#include "core/batch/sensitivity.h"
#include "core/build_id.h"
#include "core/file/project_file.h"
#include "core/project/given_factors.h"

#include "tests/check_line.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <stop_token>
#include <thread>

namespace sparkout::test_batch_run {

using fixtures::close;
using fixtures::shaftBatch;
using fixtures::uniform;
using nlohmann::json;

BatchResult runWith(const Project& project, int threads) {
    BatchOptions options;
    options.threads = threads;
    return runBatchUnchecked(project, options);
}

BatchResult runShard(const Project& project, int index, int shards) {
    BatchOptions options;
    options.threads = 1;
    options.range = shardRange(project.batch->parts, index, shards);
    return runBatchUnchecked(project, options);
}

JoinedBatch joined(const std::vector<BatchResult>& shards) {
    BatchJoiner joiner;
    for (const BatchResult& shard : shards) {
        joiner.add(shard);
    }
    return joiner.join();
}

class TestBatchRun : public QObject {
    Q_OBJECT

private slots:
    void anyNumberOfThreadsGivesTheSameBits() {
        const Project project = shaftBatch(61);
        const std::string one = writeBatchState(runWith(project, 1));
        QCOMPARE(writeBatchState(runWith(project, 2)), one);
        QCOMPARE(writeBatchState(runWith(project, 5)), one);
        checkLine("18", 3, 3, true,
                  QStringLiteral("numbers of threads (1, 2, 5) with the same bits of a batch"));
    }

    void partsInAnyOrderGiveTheSameBits() {
        const Project project = shaftBatch(40);
        const ScenarioSource source(project);
        const auto characteristics = characteristicsOf(source.nominal());
        BatchStatistics permutedOrder;
        PartOutcome outcome;
        for (std::int64_t i = 0; i < 40; ++i) {
            const std::int64_t part = i * 7 % 40;
            measure(simulateUnchecked(source.project(part)), characteristics, outcome);
            permutedOrder.add(outcome, part, characteristics, source.scores(source.values(part)));
        }
        permutedOrder.sort();
        QVERIFY(permutedOrder == runWith(project, 1).statistics);
    }

    void shardsJoinToTheWholeBitForBit() {
        const Project project = shaftBatch(50);
        const std::string whole = writeBatchState(runWith(project, 1));
        BatchJoiner shards;
        for (const int index : {3, 1, 2}) {
            const auto read = readBatchState(writeBatchState(runShard(project, index, 3)));
            QVERIFY(read.result.has_value());
            shards.add(*read.result);
        }
        const JoinedBatch joined = shards.join();
        QVERIFY(joined.fault == JoinFault::none);
        QCOMPARE(writeBatchState(joined.result), whole);
    }

    void shardsThatDoNotBelongTogetherAreRefused() {
        const Project project = shaftBatch(10);
        Project other = project;
        other.batch->seed = 2;
        const BatchResult first = runShard(project, 1, 2), second = runShard(project, 2, 2);
        QVERIFY(joined({}).fault == JoinFault::nothing);
        const JoinedBatch missing = joined({first});
        QVERIFY(missing.fault == JoinFault::incomplete);
        QVERIFY(missing.missing.size() == 1 && missing.missing[0].first == 5
                && missing.missing[0].end == 10);
        const JoinedBatch doubled = joined({second, first, second});
        QVERIFY(doubled.fault == JoinFault::overlap && doubled.doubled.size() == 1);
        QVERIFY(doubled.doubled[0].first == 0 && doubled.doubled[0].second == 2);
        QVERIFY(doubled.doubled[0].parts.first == 5 && doubled.doubled[0].parts.end == 10);
        const JoinedBatch foreign = joined({runShard(other, 2, 2), first, second});
        QVERIFY(foreign.fault == JoinFault::otherProject && foreign.model == 1);
        QCOMPARE(foreign.foreign, std::vector<std::size_t>{0});
        for (const bool byVersion : {true, false}) {
            BatchResult newer = second;
            (byVersion ? newer.engineVersion : newer.build) += "x";
            const JoinedBatch mixed = joined({first, newer});
            QVERIFY(mixed.fault == JoinFault::otherEngine);
            QCOMPARE(mixed.foreign, std::vector<std::size_t>{1});
        }
        QVERIFY(joined({second, first}).fault == JoinFault::none);
        BatchResult ended = first;
        ended.statistics.parts = 3;
        QCOMPARE(joined({ended, second}).stopped, std::vector<std::size_t>{0});
        QVERIFY(readBatchState("{}").fault == StateFault::otherFormat);
        QVERIFY(readBatchState("[1").fault == StateFault::otherFormat);
    }

    /// Each number of a shard replaced by one that no batch writes: it is refused, or what is read
    /// can be joined and summed up.
    void hostileShardsDoNoHarm() {
        const json good = json::parse(writeBatchState(runShard(shaftBatch(12), 1, 2)));
        const std::vector<json> wrong{-1,         1'000'000,     INT64_MAX,     INT64_MIN,
                                      UINT64_MAX, 1e300,         0.5,           "x",
                                      nullptr,    json::array(), json::object()};
        std::size_t refused = 0, tried = 0;
        const json places = good.flatten();
        for (const auto& [path, value] : places.items()) {
            if (path.starts_with("/project")) {
                continue; // the reader of projects has tests of its own
            }
            json state = good;
            state[json::json_pointer(path)] = wrong[tried++ % wrong.size()];
            const auto read = readBatchState(*sealBatchState(state.dump()));
            QVERIFY(read.fault != StateFault::changed);
            refused += read ? 0 : 1;
            if (read) {
                const BatchSummary summary = summarise(*read.result);
                QVERIFY(summary.parts <= 6);
                QVERIFY(joined({*read.result}).fault != JoinFault::none);
            }
        }
        QVERIFY(tried > 300 && refused > tried / 2);
    }

    /// Whatever walks a state by recursion would need a stack as deep as its text.
    void aStateOfAnyDepthIsRefused() {
        constexpr std::size_t levels = 200'000;
        const std::string deep = std::string(levels, '[') + std::string(levels, ']');
        const json good = json::parse(writeBatchState(runShard(shaftBatch(12), 1, 2)));
        std::string state = good.dump();
        const json brackets = {{"a[[{\\\"[", "]]"}};
        state = brackets.dump().substr(0, brackets.dump().size() - 1) + ",\"deep\":" + deep + ","
                + state.substr(1);
        QVERIFY(json::accept(state));
        QVERIFY(readBatchState(state).fault == StateFault::tooDeep);
        QVERIFY(readBatchState(deep).fault == StateFault::tooDeep);
        QVERIFY(!sealBatchState(state) && !sealBatchState(deep) && !sealBatchState("[1"));
        // As deep as a project may be is read, brackets of texts not counted.
        json known = good;
        known["project"]["title"] = std::string(limits::depth + 1, '[');
        QVERIFY(readBatchState(known.dump()).fault == StateFault::changed);
        for (const std::size_t more : {0, 1}) {
            json edge = good;
            edge["deep"] = json::parse(std::string(limits::depth - 1 + more, '[')
                                       + std::string(limits::depth - 1 + more, ']'));
            QVERIFY(readBatchState(edge.dump()).fault
                    == (more == 0 ? StateFault::changed : StateFault::tooDeep));
        }
    }

    void aShardThatContradictsItselfIsRefused_data() {
        addColumns<QByteArray, double>("path", "value");
        const auto row = [](const char* path, double value) {
            QTest::addRow("%s = %g", path, value) << QByteArray(path) << value;
        };
        row("/first", -1);
        row("/end", 13);
        row("/end", 5);
        row("/batch_parts", 24);
        row("/statistics/parts", 7);
        row("/statistics/failed", 1);
        row("/statistics/bad", -1);
        row("/statistics/rejects/0", -1);
        row("/statistics/rejects/15", 7);
        row("/statistics/worst/1", 6);
        row("/statistics/values/0/count", 7);
        row("/statistics/values/0/below", 7);
        row("/statistics/values/0/bins/0/1", 1000);
        row("/statistics/values/0/bins/0/0", 4e12);
        row("/statistics/values/0/bins/0/2", 1e6);
        row("/statistics/values/0/bins/1/0", -4e12);
        row("/statistics/values/0/bin_level", 42);
        row("/statistics/values/0/score_products/0", 1e15);
        row("/statistics/values/0/powers/0/0", -1);
        row("/statistics/values/0/powers/0/13", 1e15);
        row("/statistics/values/0/least/0", 1000);
        row("/statistics/values/0/most/0", 1e10);
        row("/statistics/values/0/powers/0/9", 1);
        row("/statistics/values/0/powers/1/12", 1);
        row("/statistics/worst/0", 1e300);
        row("/statistics/rows/0/1/0", 1e308);
        row("/statistics/rows/0/1/0", -1e6);
        row("/statistics/rows/0/1/0", 5e-324);
        row("/statistics/rows/0/0", 3);
        row("/statistics/rows/0/0", 8);
    }
    void aShardThatContradictsItselfIsRefused() {
        QFETCH(QByteArray, path);
        QFETCH(double, value);
        json state = json::parse(writeBatchState(runShard(shaftBatch(12), 1, 2)));
        QVERIFY(readBatchState(*sealBatchState(state.dump())).result.has_value());
        state[json::json_pointer(path.toStdString())] =
            std::abs(value) < 1e16 && value == std::round(value)
                ? json(static_cast<std::int64_t>(value))
                : json(value);
        const ReadBatchState read = readBatchState(*sealBatchState(state.dump()));
        QVERIFY(read.fault == StateFault::impossible);
        QVERIFY(read.issue && !read.issue->path.empty());
    }

    void whatNoBatchGivesIsNamedWithItsRange() {
        json state = json::parse(writeBatchState(runShard(shaftBatch(12), 1, 2)));
        const double least = state["statistics"]["values"][0]["least"][0];
        state["statistics"]["rows"][2][1][0] = 1e308;
        const ReadBatchState read = readBatchState(*sealBatchState(state.dump()));
        QVERIFY(read.issue);
        QCOMPARE(read.issue->path, std::string("/statistics/rows/2/1/0"));
        QVERIFY(read.issue->code == IssueCode::outOfRange);
        QCOMPARE(std::get<Amount>(read.issue->value).number, 1e308);
        QCOMPARE(std::get<Bounds>(read.issue->limit).range.low, least);
    }

    /// Numbers that are as possible as the right ones: only the checksum tells.
    void aShardThatWasChangedIsRefused() {
        const std::string text = writeBatchState(runShard(shaftBatch(12), 1, 2));
        const nlohmann::ordered_json good = nlohmann::ordered_json::parse(text);
        QVERIFY(readBatchState(good.dump(2)).result.has_value()); // set out otherwise, the same
        for (const char* path :
             {"/statistics/values/0/least/0", "/statistics/values/0/powers/0/5",
              "/statistics/values/0/score_products/0", "/statistics/bad", "/end", "/build",
              "/project_digest", "/project/part/stock_mm", "/project/title", "/checksum"}) {
            nlohmann::ordered_json state = good;
            auto& number = state.at(nlohmann::ordered_json::json_pointer(path));
            if (number.is_string()) {
                number = number.get<std::string>() + "0";
            } else if (number.is_number_float()) {
                number = std::nextafter(number.get<double>(), 1e9);
            } else {
                number = number.get<std::int64_t>() + 1;
            }
            QVERIFY2(readBatchState(state.dump()).fault == StateFault::changed, path);
        }
        nlohmann::ordered_json bare = good;
        bare.erase("checksum");
        QVERIFY(readBatchState(bare.dump()).fault == StateFault::changed);
        bare["version"] = 1;
        QVERIFY(readBatchState(bare.dump()).fault == StateFault::otherVersion);
        nlohmann::ordered_json mixed = good;
        mixed["project_digest"] = "0123456789abcdef";
        QVERIFY(readBatchState(*sealBatchState(mixed.dump())).fault == StateFault::impossible);
    }

    void shardsHoldEveryPartOnce() {
        for (const int shards : {1, 2, 3, 7, 50, 51, 1000}) {
            std::int64_t next = 0;
            for (int index = 1; index <= shards; ++index) {
                const PartRange range = shardRange(50, index, shards);
                QCOMPARE(range.first, next);
                QVERIFY(range.end >= range.first && range.end - range.first <= 50 / shards + 1);
                next = range.end;
            }
            QCOMPARE(next, std::int64_t{50});
        }
        const PartRange last = shardRange(1'000'000, INT32_MAX, INT32_MAX);
        QVERIFY(last.end == 1'000'000 && last.first >= 999'999);
    }

    void theWorstPartRunsAgainFromItsInputs() {
        const Project project = shaftBatch(30);
        const BatchResult result = runWith(project, 2);
        const BatchSummary summary = summarise(result);
        const ScenarioSource source(project);
        const SimulationResult again = simulateUnchecked(source.project(summary.worstPart));
        PartOutcome outcome;
        measure(again, characteristicsOf(source.nominal()), outcome);
        QCOMPARE(outcome.margin, result.statistics.worst.value);
        for (std::int64_t part = 0; part < 30; ++part) {
            measure(simulateUnchecked(source.project(part)), characteristicsOf(source.nominal()),
                    outcome);
            QVERIFY(outcome.margin >= result.statistics.worst.value);
        }
    }

    // A system that does not yield cuts what it is fed: P_z·V_k is then proportional to σ_i
    // [MODEL-2], and every quantile of the power is that of the flow stress times a constant.
    void withoutComplianceQuantilesOfThePowerScaleWithTheFlowStress() {
        Project project = fixtures::stiffBatch(99);
        project.batch->factors.flow_stress_mpa = uniform(1800, 2200);
        const double unit = simulateUnchecked(project).peakPower_w / 1000 / 2000; // kW per MPa
        const ScenarioSource source(project);
        std::vector<double> stresses;
        for (std::int64_t part = 0; part < 99; ++part) {
            stresses.push_back(source.values(part)[0]);
        }
        std::sort(stresses.begin(), stresses.end());
        bool found = false;
        const BatchSummary summary = summarise(runWith(project, 2));
        QVERIFY(summary.exactPercentiles);
        for (const CharacteristicSummary& row : summary.characteristics) {
            if (std::string(row.characteristic.name) != "wheel_power") {
                continue;
            }
            found = true;
            for (const Percentile& percentile : row.percentiles) {
                const double rank = std::max(1.0, std::ceil(percentile.order * 99));
                const double expected = unit * stresses[static_cast<std::size_t>(rank) - 1];
                QVERIFY(close(percentile.value, expected, 1e-9));
            }
            QVERIFY(close(row.least.value, unit * stresses.front(), 1e-9));
            QVERIFY(close(row.most.value, unit * stresses.back(), 1e-9));
        }
        QVERIFY(found);
    }

    void everyPartIsCountedOnce() {
        const BatchResult result = runWith(shaftBatch(50), 2);
        QCOMPARE(result.statistics.parts, std::int64_t{50});
        const BatchSummary summary = summarise(result);
        for (const CharacteristicSummary& row : summary.characteristics) {
            std::int64_t bars = 0;
            for (const HistogramBar& bar : row.histogram) {
                bars += bar.count;
            }
            QCOMPARE(bars, row.count);
            QCOMPARE(row.count + result.statistics.failed, std::int64_t{50});
        }
    }

    // Counted again from the parts one by one, over shards; a part counts at each of its causes.
    void causesAreCountedAtEveryPartThatFailsThem() {
        Project project = shaftBatch(60);
        project.part->tolerance.roundness_um = 1e-6;
        project.part->tolerance.radial_runout_um = 1e-6;
        project.material->burn_rise_k = 500;
        const ScenarioSource source(project);
        std::map<ConstraintKind, std::int64_t> counted;
        std::int64_t failed = 0, several = 0;
        for (std::int64_t part = 0; part < 60; ++part) {
            const SimulationResult result = simulateUnchecked(source.project(part));
            failed += result.status == RunStatus::completed ? 0 : 1;
            std::set<ConstraintKind> kinds;
            for (const ConstraintResult& c : evaluateConstraints(result)) {
                if (result.status == RunStatus::completed && !c.holds) {
                    kinds.insert(c.kind);
                }
            }
            several += kinds.size() > 1 ? 1 : 0;
            for (const ConstraintKind kind : kinds) {
                ++counted[kind];
            }
        }
        QVERIFY(several > 0 && counted.size() >= 2);
        const JoinedBatch whole =
            joined({runShard(project, 1, 3), runShard(project, 2, 3), runShard(project, 3, 3)});
        QVERIFY(whole.fault == JoinFault::none);
        const std::vector<RejectCause> causes = summarise(whole.result).causes;
        QCOMPARE(causes.size(), counted.size() + (failed > 0 ? 1 : 0));
        for (std::size_t i = 0; i < causes.size(); ++i) {
            QCOMPARE(causes[i].count, causes[i].kind ? counted[*causes[i].kind] : failed);
            QVERIFY(i == 0 || causes[i].count <= causes[i - 1].count);
        }
    }

    void everyRequirementOfThePassesIsAQuantity() {
        Project project = shaftBatch(8);
        project.material->burn_rise_k = 700;
        project.part->tolerance = {4, 6, 5, 8, 0.8, {}};
        project.machine->wheel_drive_kw = 4;
        project.machine->work_drive_kw = 1;
        const BatchResult result = runWith(project, 1);
        const ScenarioSource source(project);
        const auto characteristics = characteristicsOf(source.nominal());
        for (const ConstraintResult& c : evaluateConstraints(
                 simulateUnchecked(source.project(result.statistics.rows[3].part)))) {
            bool listed = requirementOf(c.kind).scope == ConstraintScope::setting;
            for (std::size_t i = 0; i < characteristics.size(); ++i) {
                if (std::string(characteristics[i].name) != requirementOf(c.kind).key) {
                    continue;
                }
                listed = true;
                if (c.kind == ConstraintKind::burn) { // in per cent of the part's own limit
                    QCOMPARE(characteristics[i].high.value(), 100.0);
                    QVERIFY(
                        close(result.statistics.rows[3].values[i], 100 * c.value / c.limit, 1e-9));
                }
            }
            QVERIFY2(listed, requirementOf(c.kind).key);
        }
    }

    void whatCannotBeRunIsRefusedAndSaysWhy() {
        Project noBatch = shaftBatch(5), noPart = shaftBatch(5), noProject = shaftBatch(5);
        noBatch.batch.reset();
        noPart.batch->parts = 0;
        noProject.cycle->stages.clear();
        for (const Project& project : {noBatch, noPart, noProject, Project{}}) {
            const BatchResult result = runBatch(project);
            QVERIFY(result.status == BatchStatus::refused);
            QVERIFY(!result.issues.empty() && result.issues == checkBatch(project));
            QCOMPARE(result.statistics.parts, std::int64_t{0});
        }
        QVERIFY(!sobolIndices(noBatch, 4) && !sobolIndices(shaftBatch(5), 0));
        const BatchResult result = runBatch(shaftBatch(5));
        QVERIFY(result.status == BatchStatus::completed && result.issues.empty());
    }

    void aRangeBeyondTheBatchIsCutToIt() {
        BatchOptions options;
        options.range = PartRange{-3, 90};
        options.meanWidth_um = 1e-9;
        options.round = 0;
        const BatchResult result = runBatch(shaftBatch(5), options);
        QCOMPARE(result.statistics.parts, std::int64_t{5});
        QVERIFY(result.range.first == 0 && result.range.end == 5);
        options.range = PartRange{4, 2};
        QCOMPARE(runBatch(shaftBatch(5), options).statistics.parts, std::int64_t{0});
    }

    void aStopBeforeTheFirstPartLeavesNone() {
        const StoppedSource stop;
        BatchOptions options;
        options.stop = stop.get_token();
        const BatchResult result = runBatch(shaftBatch(50), options);
        QVERIFY(result.status == BatchStatus::stopped);
        QCOMPARE(result.statistics.parts, std::int64_t{0});
        QCOMPARE(summarise(result).parts, std::int64_t{0});
        const auto read = readBatchState(writeBatchState(result));
        QVERIFY(read && read.result->status == BatchStatus::stopped);
    }

    /// Every bin and row filled, with as many factors and, in a long run, sections as a project may
    /// have.
    void theLargestShardIsReadBack() {
        Project project = fixtures::stiffBatch(1'000'000);
        project.sections = samples::sized(20, 4, 200);
        project.part->tolerance.roundness_um = project.part->tolerance.cylindricity_um = 10;
        project.notes = std::string(limits::stringBytes, 'x');
        const auto sections = static_cast<std::size_t>(project.sections);
        project.machine->compliance_mm_per_n = std::vector<double>(sections, 1e-6);
        auto& stocks = project.batch->zone_stock_mm.emplace(sections, std::vector<double>{0, 0});
        auto& runouts = project.batch->zone_runout_mm.emplace(sections, std::vector<double>{0, 0});
        for (std::size_t i = 0; i < limits::factors; ++i) {
            (i % 2 ? stocks : runouts)[i / 2 % sections] = {0.001, 0.002};
        }
        BatchResult result;
        result.project = project;
        result.build = buildId();
        result.batchParts = result.range.end = project.batch->parts;
        const ScenarioSource source(project);
        const auto characteristics = characteristicsOf(source.nominal());
        PartOutcome outcome;
        measure(simulateUnchecked(source.project(0)), characteristics, outcome);
        const std::vector<double> usual = outcome.values;
        std::mt19937_64 draw(1);
        const std::int64_t parts = 4 * BatchStatistics::keptRows;
        for (std::int64_t part = 0; part < parts; ++part) {
            RankScores scores{};
            for (std::size_t f = 0; f < source.factors().size(); ++f) {
                scores[f] = static_cast<std::int32_t>(draw() >> 45) - (1 << 18);
            }
            for (std::size_t i = 0; i < usual.size(); ++i) {
                outcome.values[i] = usual[i] + std::ldexp(static_cast<double>(draw()), -64);
            }
            result.statistics.add(outcome, part, characteristics, scores);
        }
        result.statistics.sort();
        const std::string text = writeBatchState(result);
        qInfo("a shard of %zu characteristics and %zu factors: %zu MB", characteristics.size(),
              source.factors().size(), text.size() >> 20);
        QVERIFY(text.size() <= limits::shardBytes);
        const ReadBatchState read = readBatchState(text);
        QVERIFY2(read, read.issue ? read.issue->path.c_str() : "");
        QVERIFY(read.result->statistics == result.statistics);
    }

    // Other programs may hold the processor up: of five stops the quickest counts.
    void aStopMidwayEndsWithin100MsAndKeepsWhatWasDone() {
        const Project project = shaftBatch(1'000'000);
        auto quickest = std::chrono::steady_clock::duration::max();
        for (int i = 0; i < 5 && quickest > std::chrono::milliseconds(100); ++i) {
            std::stop_source stop;
            std::atomic<std::int64_t> done = 0;
            BatchOptions options;
            options.threads = 2;
            options.stop = stop.get_token();
            options.done = &done;
            BatchResult result;
            std::jthread batch([&] { result = runBatch(project, options); });
            while (done < 100) {
                std::this_thread::yield();
            }
            const auto asked = std::chrono::steady_clock::now();
            stop.request_stop();
            batch.join();
            quickest = std::min(quickest, std::chrono::steady_clock::now() - asked);
            QVERIFY(result.status == BatchStatus::stopped);
            QVERIFY(result.statistics.parts >= 100 && result.statistics.parts < 1'000'000);
            QCOMPARE(result.statistics.parts, done.load());
            checkRows(result);
        }
        QVERIFY(quickest <= std::chrono::milliseconds(100));
    }

    void itEndsWhenTheIntervalIsNarrowAtTheSamePartForAnyThreads() {
        const Project project = shaftBatch(200);
        BatchOptions options;
        options.round = 20;
        options.meanWidth_um = 1e6;
        options.threads = 1;
        const BatchResult one = runBatch(project, options);
        QVERIFY(one.status == BatchStatus::narrowEnough);
        QCOMPARE(one.statistics.parts, std::int64_t{20});
        options.threads = 3;
        QCOMPARE(writeBatchState(runBatch(project, options)), writeBatchState(one));
        options.meanWidth_um = 0;
        QVERIFY(runBatch(project, options).status == BatchStatus::completed);
    }

    // Beyond 4096 parts percentiles come from bins: what is kept does not grow with the parts, and
    // a percentile is off by no more than a bin.
    void ofManyPartsLittleIsKeptAndPercentilesAreExactToABin() {
        Project project = fixtures::stiffBatch(9000);
        project.batch->scenarios = Scenarios::random;
        project.batch->factors.flow_stress_mpa = uniform(1800, 2200);
        const BatchResult result = runWith(project, 2);
        QCOMPARE(result.statistics.rows.size(), std::size_t{BatchStatistics::keptRows});
        const BatchSummary summary = summarise(result);
        QVERIFY(!summary.exactPercentiles);
        const double unit = simulateUnchecked(project).peakPower_w / 1000 / 2000; // kW per MPa
        const ScenarioSource source(project);
        std::vector<double> powers;
        for (std::int64_t part = 0; part < 9000; ++part) {
            powers.push_back(unit * source.values(part)[0]);
        }
        std::sort(powers.begin(), powers.end());
        for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
            const CharacteristicSummary& row = summary.characteristics[i];
            if (std::string(row.characteristic.name) != "wheel_power") {
                continue;
            }
            const ValueBins& bins = result.statistics.values[i].bins;
            const double bin = bins.width(row.characteristic.resolution);
            QVERIFY(bins.bins().size() <= 4096 && bin < (powers.back() - powers[0]) / 2000);
            for (const Percentile& percentile : row.percentiles) {
                const auto rank =
                    static_cast<std::size_t>(std::ceil(percentile.order * 9000 - 1e-9));
                QVERIFY(std::abs(percentile.value - powers[rank - 1]) <= bin);
                const auto bounds = quantileRanks(9000, percentile.order, confidence95);
                QCOMPARE(percentile.interval.has_value(), bounds.has_value());
                if (bounds) { // holds the interval of the values themselves, and is little wider
                    const double low = powers[static_cast<std::size_t>(bounds->low) - 1];
                    const double high = powers[static_cast<std::size_t>(bounds->high) - 1];
                    QVERIFY(percentile.interval->low <= low
                            && low - percentile.interval->low <= bin);
                    QVERIFY(percentile.interval->high >= high
                            && percentile.interval->high - high <= bin);
                    QVERIFY(percentile.interval->low < percentile.interval->high);
                }
            }
            return;
        }
        QVERIFY2(false, "there is a power");
    }

    /// Capability is of sizes and forms; of all parts, so that a drift is in its s.
    void capabilityIsOfSizesAndFormsAlone() {
        Project project = shaftBatch(40);
        project.machine->wheel_drive_kw = 7.5;
        project.part->tolerance.roughness_ra_um = 1.6;
        QVERIFY(!summarise(runWith(project, 2)).drifts);
        project.batch->factors.dullness = Factor{};
        project.batch->factors.dullness->grows = {0.015, 0.03};
        const BatchSummary summary = summarise(runWith(project, 2));
        QVERIFY(summary.drifts);
        int capable = 0, others = 0;
        for (const CharacteristicSummary& row : summary.characteristics) {
            const std::string name = row.characteristic.name;
            if (name == "roughness" || name == "wheel_power" || name == "time") {
                ++others;
                QVERIFY2(!row.pp && !row.ppk && !row.expectedOutside, name.c_str());
                QVERIFY2(row.moments.deviation > 0 && row.normality, name.c_str());
            } else if (name == "diameter") {
                ++capable;
                QVERIFY(row.ppk->value > 0 && row.ppk->value <= 99);
                const double s = row.moments.deviation, mean = row.moments.mean;
                const double low = *row.characteristic.low, high = *row.characteristic.high;
                QVERIFY(close(row.ppk->value, std::min(high - mean, mean - low) / (3 * s), 1e-12));
                QVERIFY(close(*row.expectedOutside,
                              normalShare((low - mean) / s) + 1 - normalShare((high - mean) / s),
                              1e-9)
                        || *row.expectedOutside < 1e-9);
            }
            QVERIFY2(!row.ppk || row.ppk->value <= 99, name.c_str());
        }
        QVERIFY(capable == 3 && others == 5);
    }

    // The power of a moment test at 50 values was none: 0.17 of a shape that is plainly not normal.
    void theShippedBatchIsNotNormal() {
        Project project = *readProject(samples::readText(samples::sourcePath(
                                           "resources/examples/shaft-30h6-factory.sparkout")))
                               .project;
        project.batch->zone_stock_mm.reset(); // what scatters in the zones alone smooths it
        project.batch->zone_runout_mm.reset();
        project.batch->zone_compliance.reset();
        int diameters = 0;
        for (const CharacteristicSummary& row : summarise(runWith(project, 2)).characteristics) {
            if (std::string(row.characteristic.name) == "diameter") {
                ++diameters;
                QVERIFY(row.normality->test == NormalityTest::shapiroWilk);
                QVERIFY(fixtures::within(row.normality->probability, 0.006, 0.001));
            }
        }
        QCOMPARE(diameters, 3);
    }

    void whatDoesNotScatterHasNoCapability() {
        Project project = fixtures::stiffBatch(40); // the diameter is the same but for rounding
        project.batch->factors.flow_stress_mpa = uniform(1800, 2200);
        project.batch->factors.dullness = uniform(0.02, 0.02);
        int diameters = 0;
        for (const CharacteristicSummary& row : summarise(runWith(project, 2)).characteristics) {
            if (std::string(row.characteristic.name) == "diameter") {
                ++diameters;
                QVERIFY(!row.pp && !row.ppk && !row.normality);
                QVERIFY(row.mean95.has_value() && row.count == 40);
            }
            const bool scatters = std::string(row.characteristic.name) == "wheel_power";
            QCOMPARE(row.normality.has_value(), scatters);
            QVERIFY(!row.ppk && !row.expectedOutside); // the power is no size of the part
        }
        QCOMPARE(diameters, 1);
    }

    // C_p and C_pk by their definitions, from the values themselves.
    void capabilityIsThatOfTheDefinition() {
        const BatchResult result = runWith(shaftBatch(60), 2);
        const CharacteristicSummary row = summarise(result).characteristics.front();
        QCOMPARE(std::string(row.characteristic.name), std::string("diameter"));
        double mean = 0, squares = 0;
        for (const PartRow& part : result.statistics.rows) {
            mean += part.values[0] / 60;
        }
        for (const PartRow& part : result.statistics.rows) {
            squares += std::pow(part.values[0] - mean, 2);
        }
        const double s = std::sqrt(squares / 59);
        QVERIFY(row.pp && row.ppk);
        QVERIFY(close(row.pp->value, (0 - -16) / (6 * s), 1e-9));
        QVERIFY(close(row.ppk->value, std::min(0 - mean, mean - -16) / (3 * s), 1e-9));
    }

    // Dullness grows from the first part to the last: of 20 parts out of 400, taken at random, the
    // mean place lies within five of its standard deviations, 400/√(12·20), of the middle.
    void aBatchThatEndsEarlyMeetsALawAllAlongIt() {
        Project project = shaftBatch(400);
        project.batch->factors.dullness = Factor{};
        project.batch->factors.dullness->grows = {0.015, 0.03};
        BatchOptions options;
        options.round = 20;
        options.meanWidth_um = 1e6;
        const BatchResult result = runBatch(project, options);
        QCOMPARE(result.statistics.rows.size(), std::size_t{20});
        double mean = 0;
        for (std::size_t i = 0; i < 20; ++i) {
            mean += static_cast<double>(result.statistics.rows[i].part) / 20;
            QVERIFY(i == 0 || result.statistics.rows[i].part > result.statistics.rows[i - 1].part);
        }
        QVERIFY(std::abs(mean - 200) < 5 * 400 / std::sqrt(12.0 * 20));
        checkRows(result);
        project.batch->scenarios = Scenarios::corners;
        options.round = 2;
        QCOMPARE(runBatch(project, options).statistics.parts, std::int64_t{8});
    }

    void cornersTellExtremesAndNoIntervals() {
        Project project = shaftBatch(50);
        project.batch->scenarios = Scenarios::corners;
        const BatchSummary summary = summarise(runWith(project, 2));
        QCOMPARE(summary.parts, std::int64_t{8});
        QVERIFY(!summary.isSample && !summary.bad.interval);
        for (const CharacteristicSummary& row : summary.characteristics) {
            QVERIFY(!row.mean95 && !row.pp && !row.ppk);
        }
    }

private:
    /// What is kept of some of the parts is what each of them gives alone.
    static void checkRows(const BatchResult& result) {
        const ScenarioSource source(result.project);
        const auto characteristics = characteristicsOf(source.nominal());
        QVERIFY(!result.statistics.rows.empty());
        for (std::size_t i = 0; i < result.statistics.rows.size(); i += 37) {
            const PartRow& row = result.statistics.rows[i];
            PartOutcome outcome;
            measure(simulateUnchecked(source.project(row.part)), characteristics, outcome);
            QVERIFY(row.values == outcome.values);
        }
    }
};

} // namespace sparkout::test_batch_run

SPARKOUT_TEST(test_batch_run, TestBatchRun)
#include "test_batch_run.moc"
