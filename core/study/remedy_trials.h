// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/deadline_stop.h"
#include "core/project/project.h"
#include "core/study/remedies.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Parts of a batch that were run with a changed setting.
struct RunParts {
    std::int64_t parts = 0; ///< number of parts; running ends once too many are bad
    std::int64_t bad = 0;
    std::optional<Project> worst; ///< the bad one with the least margin, as run
    bool isGood = false;          ///< no more are bad than the batch allows
};

/// Runs parts of a project's batch with a change of the project, to check remedies.
class RemedyParts {
public:
    /// Number of parts taken from a larger batch, spread over it.
    static constexpr std::int64_t mostParts = 128;

    /// Has no parts for a project without a batch, or with an invalid one.
    explicit RemedyParts(Project project);

    [[nodiscard]] bool isEmpty() const { return m_parts.empty(); }
    /// A change of a part.
    using Change = std::function<Project(Project)>;
    /// Runs the parts of the batch, first those that were bad last time. Empty after a stop.
    [[nodiscard]] std::optional<RunParts> run(const Change& change, const std::stop_token& stop);
    /// Runs the parts of withFreshParts(), different ones for every `draw`. Empty after a stop.
    [[nodiscard]] std::optional<RunParts> runFresh(const Change& change, int draw,
                                                   const std::stop_token& stop) const;

private:
    [[nodiscard]] bool isTooMany(const RunParts& run) const;

    Project m_project; ///< with its batch
    std::vector<Project> m_parts;
    std::vector<std::size_t> m_order;
    double m_allowedShare = 0;
};

/// The result of a changed setting, relative to the goal.
struct RemedyTrial {
    /// Whether the goal is reached without overrunning another stage, and every requirement is met
    /// for the other stocks and, up to the allowed share, for the parts of the batch.
    bool holds = false;
    double time_s = 0;
    std::vector<ConstraintResult> worst; ///< worst of each kind
};

/// Runs the cycles for a search for remedies, and records conflicts of requirements.
class RemedyTrials {
public:
    RemedyTrials(const SimulationResult& result, const std::vector<ConstraintResult>& constraints,
                 const RemedyOptions& options);

    /// The failure of the unchanged cycle; if the nominal part is good, later trials include every
    /// stock and the batch. Empty if the search is over.
    [[nodiscard]] std::optional<RemedyFault> fault();
    /// Empty if the search is over.
    [[nodiscard]] std::optional<RemedyTrial> run(const RemedySetting& setting, double value);
    /// Tests a change to be offered on random stocks, unless its phases are decided, and on random
    /// parts of the batch. False if it fails for one, or for more than allowed, or if the search is
    /// over.
    [[nodiscard]] bool confirm(Remedy& remedy);
    /// Whether a size violates most without a change: a target moves sizes and nothing else.
    [[nodiscard]] bool isOfSize() const {
        return m_first
               && (m_first->kind == ConstraintKind::diameterMin
                   || m_first->kind == ConstraintKind::diameterMax);
    }
    [[nodiscard]] bool isStopped() const { return m_options.stop.stop_requested(); }
    [[nodiscard]] bool isOver() const { return m_end.token().stop_requested(); }
    [[nodiscard]] long long runs() const { return m_runs; }

    /// The conflicting requirements in the best trial: that with the greatest least relative margin
    /// of its violations, or preferably one that meets everything but overruns one more stage. If
    /// every trial violates the first requirement, the trial that violates it least, with the other
    /// violations.
    [[nodiscard]] RemedyConflict conflict() const;

private:
    /// The best trial for a kind of conflict.
    struct Nearest {
        RemedySetting setting;
        double value;
        std::optional<ConstraintResult> second;
        double margin; ///< relative, of the second; if the first is still violated, of the first
        double stock_mm = 0; ///< another stock than the stated one
    };
    using Flags = std::array<bool, constraintKinds>;

    [[nodiscard]] std::optional<Project> failingStock(const Project& changed) const;
    [[nodiscard]] bool confirmStocks(Remedy& remedy);
    [[nodiscard]] bool confirmBatch(Remedy& remedy);
    /// The worst violation on a part; empty if its cycle does not end by itself, or if the search
    /// is over.
    [[nodiscard]] std::optional<ConstraintResult> worstOf(const Project& fails) const;
    /// Records a violation for another stock or part, if it is smaller than the recorded one.
    void learnPart(const RemedySetting& setting, double value, const Project& fails,
                   std::optional<Nearest>& nearest);
    [[nodiscard]] bool isMet(const ConstraintResult& constraint) const;
    void learn(const RemedySetting& setting, double value, const RemedyTrial& trial);

    const RemedyOptions& m_options;
    DeadlineStop m_end;
    Project m_project; ///< without data that a run does not use
    RemedyGoal m_goal;
    RemedyParts m_parts;
    std::optional<ConstraintResult> m_first; ///< empty: the cycle does not end by itself
    Flags m_failing{};                       ///< without a change
    std::ptrdiff_t m_idle;                   ///< stages run over
    long long m_runs = 0;
    std::optional<Nearest> m_opposed, m_several, m_closest;
    std::optional<Nearest> m_stocks;    ///< all is met but for another stock, by the least
    std::optional<Nearest> m_batch;     ///< all is met but for too many parts of the batch
    int m_candidates = 0;               ///< changes tried on random stocks
    int m_drawnBatches = 0;             ///< and on parts of the batch
    std::optional<Nearest> m_idleTrial; ///< the first that meets all, with a stage more run over
};

} // namespace sparkout
