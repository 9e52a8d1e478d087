// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/deadline_stop.h"
#include "core/remedies/remedies.h"
#include "core/remedies/remedy_parts.h"

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

/// A cycle with one setting changed, held against what is to be reached.
struct RemedyTrial {
    /// All that is to be reached, with no stage run over that was not before; and every requirement
    /// for the other stocks of the phase and, but for as many as may be bad, the parts of the
    /// batch.
    bool holds = false;
    double time_s = 0;
    std::vector<ConstraintResult> worst; ///< of each kind
};

/// Runs the cycles that a search for remedies tries, and keeps what they say of requirements that
/// pull against each other.
class RemedyTrials {
public:
    RemedyTrials(const SimulationResult& result, const std::vector<ConstraintResult>& constraints,
                 const RemedyOptions& options);

    /// What is not good as it is; if the part as stated holds, it is to hold for every stock and
    /// the batch from now on. Nothing when it is over.
    [[nodiscard]] std::optional<RemedyFault> fault();
    /// Nothing when it is over.
    [[nodiscard]] std::optional<RemedyTrial> run(const RemedySetting& setting, double value);
    /// Tries the cycle of a change that is to be offered on stocks drawn for it, unless its phases
    /// are decided, and on parts of the batch drawn for it. False: it fails for one, for more than
    /// may be bad, or it is over.
    [[nodiscard]] bool confirm(Remedy& remedy);
    [[nodiscard]] bool isStopped() const { return m_options.stop.stop_requested(); }
    [[nodiscard]] bool isOver() const { return m_end.token().stop_requested(); }
    [[nodiscard]] long long runs() const { return m_runs; }

    /// The requirements that pull against each other in the trial that came nearest: the least
    /// relative margin of what fails in it is the greatest of all. Before that goes a trial that
    /// meets everything, but runs one more stage over. Where every trial leaves the
    /// first one failing, the trial in which it fails least, and what else fails there.
    [[nodiscard]] RemedyConflict conflict() const;

private:
    /// The nearest trial of a kind of conflict.
    struct Nearest {
        RemedySetting setting;
        double value;
        std::optional<ConstraintResult> second;
        double margin;       ///< relative, of the second; where the first fails still, of the first
        double stock_mm = 0; ///< of another stock than the stated one
    };
    using Flags = std::array<bool, constraintKinds>;

    [[nodiscard]] std::optional<Project> failingStock(const Project& changed) const;
    [[nodiscard]] bool confirmStocks(Remedy& remedy);
    [[nodiscard]] bool confirmBatch(Remedy& remedy);
    /// The requirement that fails most on a part; nothing: its cycle does not end by itself, or it
    /// is over.
    [[nodiscard]] std::optional<ConstraintResult> worstOf(const Project& fails) const;
    /// Keeps what fails for another stock or part, if that is nearer to holding than what is kept.
    void learnPart(const RemedySetting& setting, double value, const Project& fails,
                   std::optional<Nearest>& nearest);
    [[nodiscard]] bool isMet(const ConstraintResult& constraint) const;
    void learn(const RemedySetting& setting, double value, const RemedyTrial& trial);

    const RemedyOptions& m_options;
    DeadlineStop m_end;
    Project m_project; ///< with nothing that a run does not read
    RemedyGoal m_goal;
    RemedyParts m_parts;
    std::optional<ConstraintResult> m_first; ///< nothing: the cycle does not end by itself
    Flags m_failing{};                       ///< as it is
    std::ptrdiff_t m_idle;                   ///< stages run over
    long long m_runs = 0;
    std::optional<Nearest> m_opposed, m_several, m_closest;
    std::optional<Nearest> m_stocks;    ///< all holds but for another stock, by the least
    std::optional<Nearest> m_batch;     ///< all holds but for too many parts of the batch
    int m_candidates = 0;               ///< changes that were tried on stocks drawn for them
    int m_drawnBatches = 0;             ///< and on parts of the batch
    std::optional<Nearest> m_idleTrial; ///< the first that meets all, with a stage more run over
};

} // namespace sparkout
