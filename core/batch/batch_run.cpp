// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_run.h"

#include "core/batch/worker_pool.h"
#include "core/build_id.h"
#include "core/project/batch.h"
#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "core/version.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

namespace sparkout {

bool PartQueue::put(std::int64_t place, PartRecord record) {
    constexpr std::int64_t most = 1024; // parts ahead of the slowest
    std::unique_lock lock(m_mutex);
    m_moved.wait(lock, m_stop, [&] { return m_over || place - m_next < most; });
    if (m_over || m_stop.stop_requested()) {
        return false;
    }
    m_waiting.emplace(place, std::move(record));
    bool moved = false;
    for (auto next = m_waiting.find(m_next); next != m_waiting.end();
         next = m_waiting.find(++m_next)) {
        m_over = m_over || !m_sink(next->second);
        m_waiting.erase(next);
        moved = true;
    }
    if (moved) {
        m_moved.notify_all();
    }
    return !m_over;
}

namespace {

Issues errorsOf(Issues issues) {
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    return issues;
}

/// Every corner must be a project that can be run; returns the faults of the first that is not. For
/// the zones' own values the two ends of all together suffice: each value increases its zone's
/// stock, runout or compliance, so any value that is too small or too large is so at one of these
/// ends.
Issues faultsOfExtremes(Project project) {
    project.batch->scenarios = Scenarios::corners;
    const ScenarioSource corners(std::move(project));
    const std::size_t all = corneredCount(corners.factors());
    const auto ofPart =
        static_cast<std::size_t>(std::ranges::count_if(corners.factors(), [](const GivenFactor& f) {
            return f.place < 0 && !isOfReading(f.kind);
        }));
    const std::int64_t zones = ((std::int64_t{1} << all) - 1) >> ofPart << ofPart;
    for (std::int64_t part = 0; part < std::int64_t{1} << ofPart; ++part) {
        for (const std::int64_t corner : {part, part | zones}) {
            Issues issues = errorsOf(validate(corners.project(corner)));
            if (!issues.empty()) {
                return issues;
            }
        }
    }
    return {};
}

class BatchPool {
public:
    BatchPool(const ScenarioSource& source, const BatchOptions& options)
        : m_source(source)
        , m_options(options)
        , m_characteristics(characteristicsOf(source.nominal())) {}

    BatchStatistics run(PartRange range) {
        const std::size_t workers = workerCount(m_options.threads);
        std::vector<BatchStatistics> found(workers);
        PartQueue queue(m_options.sink, range.first, m_options.stop);
        forEachIndex(
            workers, range.first, range.end, m_options.stop,
            [&](std::size_t worker, std::int64_t at) { return runPart(at, found[worker], queue); });
        for (std::size_t i = 1; i < found.size(); ++i) {
            found.front().add(found[i]);
        }
        return std::move(found.front());
    }

    [[nodiscard]] const std::vector<Characteristic>& characteristics() const {
        return m_characteristics;
    }
    [[nodiscard]] bool over() const { return m_over; } ///< whether the sink wants no more parts

private:
    [[nodiscard]] std::int64_t partAt(std::int64_t place) const {
        constexpr std::uint32_t orderOfParts = 1001; // a permutation that no factor uses
        return m_options.meanWidth_um ? static_cast<std::int64_t>(permuted(
                   static_cast<std::uint64_t>(place), static_cast<std::uint64_t>(m_source.parts()),
                   m_source.seed(), orderOfParts))
                                      : place;
    }

    bool runPart(std::int64_t place, BatchStatistics& mine, PartQueue& queue) {
        if (m_over) {
            return false;
        }
        const std::int64_t part = partAt(place);
        std::vector<double> values = m_source.values(part);
        const SimulationResult result =
            simulateUnchecked(m_source.projectWith(values), nullptr, m_options.stop);
        if (result.status == RunStatus::stopped) {
            return false;
        }
        PartOutcome outcome;
        measure(result, m_characteristics, outcome);
        mine.add(outcome, part, m_characteristics, m_source.scores(values));
        if (m_options.done) {
            m_options.done->fetch_add(1, std::memory_order_relaxed);
        }
        if (m_options.sink && !queue.put(place, {part, std::move(values), std::move(outcome)})) {
            m_over = true;
            return false;
        }
        return true;
    }

    const ScenarioSource& m_source;
    const BatchOptions& m_options;
    std::vector<Characteristic> m_characteristics;
    std::atomic<bool> m_over = false;
};

bool narrowEnough(const BatchStatistics& statistics,
                  const std::vector<Characteristic>& characteristics, double width_um) {
    for (std::size_t i = 0; i < statistics.values.size(); ++i) {
        const ValueStatistics& values = statistics.values[i];
        if (std::string_view(characteristics[i].unit) != "µm") {
            continue;
        }
        if (values.count < 2) {
            return false;
        }
        const Moments moments = momentsOf(values);
        const Interval interval =
            studentInterval(moments.mean, moments.deviation, values.count, confidence95);
        if (interval.high - interval.low > width_um) {
            return false;
        }
    }
    return !statistics.values.empty();
}

BatchResult resultFor(const Project& project) {
    BatchResult result;
    result.project = project;
    result.project.runs.clear();
    result.engineVersion = version;
    result.build = buildId();
    return result;
}

} // namespace

Issues checkBatch(const Project& project) {
    if (!project.batch) {
        return {{IssueCode::missingKey, Severity::error, "/batch", {}, Phrase::anObject}};
    }
    Issues issues = errorsOf(validate(project));
    Issues faults = batchFaults(project);
    issues.insert(issues.end(), faults.begin(), faults.end());
    return issues.empty() ? faultsOfExtremes(project) : issues;
}

PartRange shardRange(std::int64_t parts, int index, int shards) {
    return {parts * (index - 1) / shards, parts * index / shards};
}

BatchResult runBatch(const Project& project, const BatchOptions& options) {
    Issues issues = checkBatch(project);
    if (issues.empty()) {
        return runBatchUnchecked(project, options);
    }
    BatchResult result = resultFor(project);
    result.status = BatchStatus::refused;
    result.issues = std::move(issues);
    return result;
}

BatchResult runBatchUnchecked(const Project& project, const BatchOptions& options) {
    BatchResult result = resultFor(project);
    const ScenarioSource source(project);
    result.batchParts = source.parts();
    result.range = options.range.value_or(PartRange{0, source.parts()});
    result.range.end = std::clamp<std::int64_t>(result.range.end, 0, source.parts());
    result.range.first = std::clamp<std::int64_t>(result.range.first, 0, result.range.end);
    BatchPool pool(source, options);
    const std::int64_t round =
        options.meanWidth_um ? std::max<std::int64_t>(options.round, 1) : source.parts();
    for (std::int64_t first = result.range.first; first < result.range.end; first += round) {
        result.statistics.add(pool.run({first, std::min(first + round, result.range.end)}));
        if ((options.stop.stop_requested() || pool.over())
            && result.statistics.parts < result.range.end - result.range.first) {
            result.status = BatchStatus::stopped;
            break;
        }
        if (options.meanWidth_um && source.isSample()
            && narrowEnough(result.statistics, pool.characteristics(), *options.meanWidth_um)) {
            result.status = BatchStatus::narrowEnough;
            break;
        }
    }
    result.statistics.sort();
    return result;
}

} // namespace sparkout
