// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/piece_time.h"
#include "core/setup/surface_run.h"
#include "ui/session/cycle_judge.h"
#include "ui/session/document.h"
#include "ui/session/newest_job.h"
#include "ui/session/surface_status.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// Runs all surfaces of a document after every edit, aside and in their order, each with the wheel
/// as those before leave it, and decides then over the stocks of each. What an edit does not
/// concern is not run again.
class PartRuns : public QObject {
    Q_OBJECT

public:
    explicit PartRuns(Document& document, QObject* parent = nullptr);

    /// By surface, as many as the document has.
    [[nodiscard]] const std::vector<SurfaceStatus>& statuses() const { return m_statuses; }
    [[nodiscard]] bool running() const { return m_running; }
    /// Whether every surface is ground to size, and every requirement on each of them holds.
    [[nodiscard]] bool holds() const;
    [[nodiscard]] std::optional<PieceTime> time() const; ///< once every surface is completed
    /// Of the surface in front: in a set-up of one it is not run a second time, in another one its
    /// judgement is taken, which may have a batch.
    void setJudged(const JudgedRun& judged);

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
    /// One that was just run.
    struct Fresh {
        std::size_t surface;
        Known known;
        SurfaceRun run;
    };

    void follow();
    [[nodiscard]] bool takeKnown();
    void take(std::size_t surface, Known run);
    void takeFront(std::size_t surface, SurfaceStatus& status) const;
    /// Nothing where the inputs are refused.
    static std::optional<SurfaceRun> runOf(const SetupState& state, const Known& wanted,
                                           const std::stop_token& stop);

    Document& m_document;
    std::vector<SurfaceStatus> m_statuses;
    KnownList m_known;
    SurfaceStatePtr m_frontOf; ///< the surface that was judged in front
    Judgement m_front;
    bool m_running = false;
    NewestJob m_job; ///< last: stopped before what it uses is gone
};

} // namespace sparkout
