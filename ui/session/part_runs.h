// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/judgement.h"
#include "core/quality/constraints.h"
#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "core/setup/wheel_wear.h"
#include "core/study/search.h"
#include "core/study/whole_batch.h"
#include "ui/session/document.h"
#include "ui/session/job.h"
#include "ui/session/run_controller.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// Result of a batch or a search of one surface.
struct SurfaceStudy {
    enum class Kind { batch, search };
    Kind kind = Kind::batch;
    std::size_t surface = 0;
    bool isSetUp = true; ///< for a batch: the surface has one
    Issues issues;       ///< faults with which it, or an earlier surface, cannot be run
    BatchOutcomePtr batch;
    SearchOutcomePtr search;
};
using SurfaceStudyPtr = std::shared_ptr<const SurfaceStudy>;

/// Options ticked for the searches of all surfaces; an option that does not apply to a surface is
/// ignored there.
struct SearchTicks {
    bool phases = false; ///< the answer must be fit for any stock within one infeed
    bool refine = false; ///< refine the answer between the levels
};

/// The batches or the searches of all surfaces in their order, each with the wheel in the state
/// left by the earlier ones; in a search by the cycles found for them.
class PartStudy : public Job {
    Q_OBJECT

public:
    using Job::Job;

    void startBatches(const Setup& setup); ///< counts parts
    /// Starts the searches and counts thousandths of each; a surface without a search gets the
    /// usual one.
    void startSearches(const Setup& setup, SearchTicks ticks = {});

signals:
    void surfaceDone(sparkout::SurfaceStudyPtr study);
    void finished(bool stopped);

private:
    using One = std::function<void(SurfaceStudy&, Setup&, const Project&, const Means&)>;
    void runAll(const Setup& setup, SurfaceStudy::Kind kind, std::int64_t parts, One one);
};

/// Status of the cycle of a surface of the set-up.
struct SurfaceStatus {
    enum class State {
        notRun,  ///< not run yet, or an earlier surface cannot be run
        refused, ///< its inputs are refused
        ran
    };
    State state = State::notRun;
    Judgement judgement;          ///< judgement of the cycle, if it was run
    bool areStocksComing = false; ///< the stocks are being decided
    bool isBatchComing = false;   ///< the batch is quick, and has not been run yet
    double time_s = 0;
    std::vector<ConstraintResult> requirements{}; ///< worst requirement of each kind
    bool isRoughnessEstimate = false;             ///< Ra is not calibrated
    RemovedMetal removed{};

    [[nodiscard]] bool ran() const { return state == State::ran; }
    [[nodiscard]] bool isCompleted() const { ///< whether the cycle ends by itself, at size
        return ran() && judgement.status == RunStatus::completed;
    }
    [[nodiscard]] bool holds() const { return ran() && !isFailure(judgement.state); }
};

/// Runs all surfaces of a document after every edit, in another thread and in their order, each
/// with the wheel in the state left by the earlier ones, and then decides on the stocks of each.
/// Once the surface in front is judged, the quick batches of the others are run, one at a time.
/// Surfaces that an edit does not affect are not run again.
class PartRuns : public QObject {
    Q_OBJECT

public:
    explicit PartRuns(Document& document, QObject* parent = nullptr);

    /// Returns the status of each surface of the document.
    [[nodiscard]] const std::vector<SurfaceStatus>& statuses() const { return m_statuses; }
    [[nodiscard]] bool running() const { return m_running; }
    /// Returns whether every surface is ground to size and meets every requirement.
    [[nodiscard]] bool holds() const;
    [[nodiscard]] std::optional<PieceTime> time() const; ///< time once every surface is completed
    /// Takes the judgement of the current surface: in a set-up with one surface it is not run a
    /// second time, in others its judgement is used, which may include a batch.
    void setJudged(const JudgedRun& judged);
    void judgeBatches(bool isOn); ///< sets whether batches are run; in a lesson they are not
    /// Takes a batch that was run for the whole part, if it is that of the current inputs.
    void takeStudy(const SurfaceStudyPtr& study);

signals:
    void changed();

private:
    /// A run that need not be repeated.
    struct Known {
        SurfaceStatePtr surface;
        WheelWear wear;
        RemovedMetal removedBefore;
        SurfaceStatus status;

        [[nodiscard]] bool isOf(const Known& wanted) const;
    };
    using KnownList = std::vector<Known>;
    /// A surface that was just run.
    struct Fresh {
        std::size_t surface;
        Known known;
        SurfaceRun run;
    };

    void follow();
    [[nodiscard]] bool takeKnown();
    void take(std::size_t surface, Known run);
    void takeFront(std::size_t surface, SurfaceStatus& status) const;
    void takeBatch(std::size_t surface, Known run, const BatchOutcomePtr& batch);
    void runNextBatch();
    [[nodiscard]] Known shownRun(std::size_t surface) const; ///< the run behind its status
    /// Returns a surface that is to be run after the earlier ones have removed this metal.
    static Known wantedRun(const SetupState& state, std::size_t surface,
                           const RemovedMetal& removed);
    static Project wornBefore(const Known& run); ///< the project that it is a run of
    /// Runs a surface; returns nothing where the inputs are refused.
    static std::optional<SurfaceRun> runOf(const Known& wanted, const std::stop_token& stop);

    Document& m_document;
    std::vector<SurfaceStatus> m_statuses;
    KnownList m_known;
    std::optional<Judgement> m_front; ///< judgement of the current surface, with its batch
    bool m_isFrontComing = false;     ///< the current surface is still being judged
    bool m_judgesBatches = true;
    bool m_running = false;
    NewestJob m_job; ///< the last two: stopped before the members that they use are destroyed
    Job m_batchJob;
};

} // namespace sparkout
