// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/remedy_trials.h"

#include "core/batch/batch_run.h"
#include "core/batch/scenario_source.h"
#include "core/phases/failing_stock.h"
#include "core/phases/sampled_phases.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/quality/verdict.h"
#include "core/simulation/simulate.h"

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

/// A copy that is cheap to make.
Project bare(Project project) {
    project.runs.clear();
    project.notes.clear();
    project.batch.reset();
    project.optimisation.reset();
    project.sweep.reset();
    return project;
}

Project withBatch(const Project& project) {
    Project copy = bare(project);
    copy.batch = project.batch;
    return copy;
}

std::ptrdiff_t idleStages(const SimulationResult& result) {
    return std::ranges::count(result.countsByStage, 0);
}

std::size_t indexOf(const ConstraintResult& constraint) {
    return static_cast<std::size_t>(constraint.kind);
}

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

RemedyTrials::RemedyTrials(const SimulationResult& result,
                           const std::vector<ConstraintResult>& constraints,
                           const RemedyOptions& options)
    : m_options(options)
    , m_end(options.stop, options.budget)
    , m_project(bare(result.project))
    , m_goal(remedyGoal(result, constraints))
    , m_parts(result.status == RunStatus::refused ? Project{} : withBatch(result.project))
    , m_idle(idleStages(result)) {
    if (result.status != RunStatus::completed) {
        return; // its requirements are those of an interrupted cycle
    }
    if (const ConstraintResult* worst = worstRequirement(constraints)) {
        m_first = *worst;
    }
    for (const ConstraintResult& each : constraints) {
        m_failing[indexOf(each)] |= !isMet(each);
    }
}

bool RemedyTrials::isMet(const ConstraintResult& constraint) const {
    return constraint.holds && (m_goal != RemedyGoal::room || !isClose(constraint));
}

std::optional<RemedyFault> RemedyTrials::fault() {
    if (m_goal == RemedyGoal::holds) {
        return RemedyFault::part;
    }
    RemedyFault fault = RemedyFault::none;
    std::optional<Project> fails = failingStock(m_project);
    if (fails) {
        fault = RemedyFault::stocks;
    } else if (!m_parts.isEmpty() && !isOver()) {
        std::optional<RunParts> parts =
            m_parts.run([](Project part) { return part; }, m_end.token());
        if (parts && !parts->isGood) {
            fault = RemedyFault::batch;
            fails = std::move(parts->worst);
        }
    }
    if (fails) {
        m_goal = RemedyGoal::holds;
        m_first = worstOf(*fails);
    }
    return isOver() ? std::nullopt : std::optional(fault);
}

std::optional<ConstraintResult> RemedyTrials::worstOf(const Project& fails) const {
    std::optional<ConstraintResult> worst;
    const SimulationResult result = simulateUnchecked(fails, nullptr, m_end.token());
    if (result.status == RunStatus::completed) {
        for (const ConstraintResult& each : evaluateConstraints(result)) {
            if (!each.holds && (!worst || each.relativeMargin < worst->relativeMargin)) {
                worst = each;
            }
        }
    }
    return worst;
}

std::optional<RemedyTrial> RemedyTrials::run(const RemedySetting& setting, double value) {
    if (isOver()) {
        return {};
    }
    ++m_runs;
    const Project changed = setting.applied(m_project, value);
    const SimulationResult result = simulateUnchecked(changed, nullptr, m_end.token());
    if (isOver()) {
        return {};
    }
    RemedyTrial trial;
    if (result.status != RunStatus::completed) {
        return trial;
    }
    trial.time_s = result.time_s;
    const std::vector<ConstraintResult> all = evaluateConstraints(result);
    trial.worst = worstByKind(all);
    const bool met =
        std::ranges::all_of(all, [this](const ConstraintResult& each) { return isMet(each); });
    trial.holds = met && idleStages(result) <= m_idle;
    if (!met) {
        learn(setting, value, trial);
    } else if (!trial.holds && !m_idleTrial && setting.isSingle()) {
        m_idleTrial.emplace(Nearest{setting, value, std::nullopt, 0});
    } else if (trial.holds) {
        std::optional<Project> fails = failingStock(changed);
        if (isOver()) {
            return {}; // possibly incomplete
        }
        trial.holds = !fails;
        if (fails) {
            learnPart(setting, value, *fails, m_stocks);
        }
    }
    if (trial.holds && !m_parts.isEmpty()) {
        const std::optional<RunParts> parts = m_parts.run(
            [&](Project part) { return setting.applied(std::move(part), value); }, m_end.token());
        if (!parts) {
            return {};
        }
        trial.holds = parts->isGood;
        if (!parts->isGood) {
            learnPart(setting, value, *parts->worst, m_batch);
        }
    }
    return trial;
}

/// The changed project with another stock for which it fails; empty if none is known, or if the
/// search is over. Most failing changes fail for one of a few stocks, which are tried first, since
/// a cycle that does not end for some takes long.
std::optional<Project> RemedyTrials::failingStock(const Project& changed) const {
    constexpr int few = 4, usual = 16; // stocks a stage
    const bool canDecide = canDecidePhases(changed);
    for (Project& phase : stockPhases(changed, canDecide ? few : usual)) {
        const std::optional<CycleTrial> trial = tried(phase, m_end.token());
        if (!trial || !trial->holds) {
            return trial ? std::optional(std::move(phase)) : std::nullopt;
        }
    }
    return canDecide ? sparkout::failingStock(changed, usualPhases(changed), m_end.token())
                     : std::nullopt;
}

bool RemedyTrials::confirm(Remedy& remedy) {
    return confirmStocks(remedy) && confirmBatch(remedy);
}

bool RemedyTrials::confirmBatch(Remedy& remedy) {
    if (m_parts.isEmpty()) {
        return true;
    }
    const int candidate = ++m_drawnBatches;
    const std::optional<RunParts> parts = m_parts.runFresh(
        [&](Project part) { return remedy.applied(std::move(part)); }, candidate, m_end.token());
    if (!parts) {
        return false;
    }
    remedy.batch = RemedyBatch{parts->parts, parts->bad, candidate};
    if (parts->worst && !parts->isGood) {
        learnPart(remedy.setting, remedy.value, *parts->worst, m_batch);
    }
    return parts->isGood;
}

bool RemedyTrials::confirmStocks(Remedy& remedy) {
    const Project changed = remedy.applied(m_project);
    if (canDecidePhases(changed)) {
        remedy.stocks = usualPhases(changed);
        return true;
    }
    remedy.candidate = ++m_candidates;
    remedy.phases = freshPhaseCount;
    const std::optional<Project> fails =
        failingPhase(changed, static_cast<std::uint32_t>(m_candidates), m_end.token());
    if (fails) {
        learnPart(remedy.setting, remedy.value, *fails, m_stocks);
        return false;
    }
    return !isOver();
}

void RemedyTrials::learnPart(const RemedySetting& setting, double value, const Project& fails,
                             std::optional<Nearest>& nearest) {
    if (!setting.isSingle()) {
        return; // conflicts are only about single settings
    }
    const std::optional<ConstraintResult> worst = worstOf(fails);
    if (isOver()) {
        return;
    }
    const double margin = worst ? worst->relativeMargin : -std::numeric_limits<double>::infinity();
    if (!nearest || margin > nearest->margin) {
        nearest.emplace(Nearest{setting, value, worst, margin, fails.part->stock_mm});
    }
}

void RemedyTrials::learn(const RemedySetting& setting, double value, const RemedyTrial& trial) {
    if (!setting.isSingle()) {
        return;
    }
    const ConstraintResult* known = nullptr; // the worst of the violations without a change
    const ConstraintResult* fresh = nullptr; // and of the new violations
    const ConstraintResult* first = nullptr; // if it is still violated
    for (const ConstraintResult& each : trial.worst) {
        if (isMet(each)) {
            continue;
        }
        if (m_first && each.kind == m_first->kind) {
            first = &each;
            continue;
        }
        const ConstraintResult*& worst = m_failing[indexOf(each)] ? known : fresh;
        if (!worst || each.relativeMargin < worst->relativeMargin) {
            worst = &each;
        }
    }
    if (first) {
        constexpr double noticeable = 1e-3; // relative to the limit
        const double least = m_closest ? m_closest->margin : m_first->relativeMargin + noticeable;
        if (first->relativeMargin > least) {
            const bool ofFresh = fresh && (!known || fresh->relativeMargin < known->relativeMargin);
            const ConstraintResult* const worst = ofFresh ? fresh : known;
            m_closest.emplace(Nearest{setting, value, worst ? std::optional(*worst) : std::nullopt,
                                      first->relativeMargin});
        }
        return;
    }
    const ConstraintResult* const second = known ? known : fresh;
    std::optional<Nearest>& nearest = known ? m_several : m_opposed;
    if (second && (!nearest || second->relativeMargin > nearest->margin)) {
        nearest.emplace(Nearest{setting, value, *second, second->relativeMargin});
    }
}

RemedyConflict RemedyTrials::conflict() const {
    RemedyConflict found;
    found.first = m_first;
    using enum RemedyConflict::Kind;
    const std::pair<const std::optional<Nearest>&, RemedyConflict::Kind> inOrder[] = {
        {m_batch, batch},     {m_stocks, stocks},   {m_idleTrial, idle},
        {m_opposed, opposed}, {m_several, several}, {m_closest, unmended}};
    for (const auto& [nearest, kind] : inOrder) {
        if (!nearest) {
            continue;
        }
        found.kind = kind;
        found.second = nearest->second;
        found.setting = nearest->setting;
        found.value = nearest->value;
        found.stock_mm = nearest->stock_mm;
        break;
    }
    return found;
}

} // namespace sparkout
