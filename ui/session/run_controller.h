// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/setup/removed_volumes.h"
#include "core/setup/setup.h"
#include "core/study/evaluate.h"
#include "ui/session/newest_job.h"

#include <QObject>

#include <functional>
#include <optional>
#include <stop_token>

namespace sparkout {

/// Runs projects off the window's thread. A project is taken by value, its outcome comes back as a
/// signal in the thread of the controller; a newer request stops the older one, whose result is
/// dropped. Destroying the controller stops the run and waits for it. With the run its cycle is
/// decided for every stock within one infeed, where that takes a moment; else afterwards.
class RunController : public QObject {
    Q_OBJECT

public:
    using Runner = std::function<OutcomePtr(const Project&, const std::stop_token&)>;

    explicit RunController(QObject* parent = nullptr, Runner runner = evaluate);

    /// Runs the last of these surfaces, with the wheel as those before it leave it. Numbers that
    /// are missing are the outcome of a project that is not complete: it is not run.
    void request(Setup upTo, Issues missing = {});
    void request(Project project); ///< of a surface alone
    void stop();                   ///< and drops its outcome
    /// The same in the calling thread.
    [[nodiscard]] OutcomePtr outcomeOf(const Setup& upTo, const Issues& missing,
                                       const std::stop_token& stop = {}) const;
    [[nodiscard]] const Runner& runner() const { return m_runner; }
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] double lastRun_ms() const { return m_lastRun_ms; }
    /// The stocks of the outcome that was finished last; nothing: not decided, or not yet.
    [[nodiscard]] const std::optional<JudgedStocks>& stocks() const { return m_stocks; }
    [[nodiscard]] bool areStocksComing() const { return m_areStocksComing; }

signals:
    void started();
    void finished(sparkout::OutcomePtr outcome);
    void stocksDecided(); ///< after the outcome

private:
    Runner m_runner;
    bool m_running = false;
    double m_lastRun_ms = 0;
    std::optional<JudgedStocks> m_stocks;
    bool m_areStocksComing = false;
    mutable RemovedVolumes m_removed; ///< of the surfaces before: an edit seldom concerns them
    NewestJob m_job;                  ///< last: stopped before what it uses is gone
};

} // namespace sparkout
