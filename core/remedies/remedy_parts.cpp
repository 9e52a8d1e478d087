// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remedies/remedy_parts.h"

#include "core/batch/batch_run.h"
#include "core/batch/fresh_parts.h"
#include "core/batch/scenario_source.h"
#include "core/phases/cycle_trial.h"
#include "core/project/batch.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

/// Counts parts one by one.
class PartCount {
public:
    explicit PartCount(std::int64_t parts) { m_run.parts = parts; }

    /// Whether the part is good; empty after a stop.
    std::optional<bool> add(Project part, const std::stop_token& stop) {
        const std::optional<CycleTrial> trial = tried(part, stop);
        if (!trial) {
            return std::nullopt;
        }
        if (!trial->holds) {
            ++m_run.bad;
            if (!m_run.worst || trial->leastMargin < m_least) {
                m_least = trial->leastMargin;
                m_run.worst = std::move(part);
            }
        }
        return trial->holds;
    }
    [[nodiscard]] const RunParts& run() const { return m_run; }

private:
    RunParts m_run;
    double m_least = std::numeric_limits<double>::infinity();
};

} // namespace

RemedyParts::RemedyParts(Project project) : m_project(std::move(project)) {
    if (!m_project.batch || !checkBatch(m_project).empty()) {
        return;
    }
    m_allowedShare = m_project.batch->most_outside_share.value_or(0);
    const ScenarioSource source(m_project);
    const std::int64_t all = source.parts(), taken = std::min(all, mostParts);
    constexpr std::int64_t odd = 40'503; // with 2^f corners, visits each once
    for (std::int64_t i = 0; i < taken; ++i) {
        m_parts.push_back(source.project(source.isSample() ? i * all / taken : i * odd % all));
    }
    m_order.resize(m_parts.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
}

bool RemedyParts::isTooMany(const RunParts& run) const {
    return static_cast<double>(run.bad) > m_allowedShare * static_cast<double>(run.parts);
}

std::optional<RunParts> RemedyParts::run(const Change& change, const std::stop_token& stop) {
    PartCount count(static_cast<std::int64_t>(m_parts.size()));
    for (std::size_t i = 0; i < m_order.size() && !isTooMany(count.run()); ++i) {
        const std::optional<bool> isGood = count.add(change(m_parts[m_order[i]]), stop);
        if (!isGood) {
            return std::nullopt;
        }
        if (!*isGood) {
            const auto at = m_order.begin() + static_cast<std::ptrdiff_t>(i);
            std::rotate(m_order.begin(), at, at + 1);
        }
    }
    RunParts run = count.run();
    run.isGood = !isTooMany(run);
    return run;
}

std::optional<RunParts> RemedyParts::runFresh(const Change& change, int draw,
                                              const std::stop_token& stop) const {
    Project drawn = withFreshParts(change(m_project), draw);
    if (!checkBatch(drawn).empty()) {
        return RunParts{}; // it cannot be run with the change
    }
    const ScenarioSource source(std::move(drawn));
    PartCount count(source.parts());
    for (std::int64_t part = 0; part < source.parts() && !isTooMany(count.run()); ++part) {
        if (!count.add(source.project(part), stop)) {
            return std::nullopt;
        }
    }
    RunParts run = count.run();
    run.isGood = !isTooMany(run);
    return run;
}

} // namespace sparkout
