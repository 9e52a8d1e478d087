// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/setup/setup.h"
#include "core/setup/worn_project.h"
#include "core/study/outcome.h"
#include "ui/session/newest_job.h"

#include <QObject>

#include <functional>
#include <optional>
#include <stop_token>

namespace sparkout {

/// Runs projects outside the window's thread. A project is taken by value and its outcome is
/// returned by a signal in the thread of the controller; a newer request stops the older one, whose
/// result is discarded. The destructor stops the run and waits for it. The cycle is decided for
/// every stock within one infeed together with the run where that is quick, otherwise afterwards.
class RunController : public QObject {
    Q_OBJECT

public:
    using Runner = std::function<OutcomePtr(const Project&, const std::stop_token&)>;

    explicit RunController(QObject* parent = nullptr, Runner runner = evaluate);

    /// Runs the last of these surfaces, with the wheel in the state left by the earlier ones. With
    /// faults, as missing numbers, the project is not run, and they are the issues of the outcome.
    void request(Setup upTo, Issues faults = {});
    void request(Project project); ///< runs the project of a single surface
    void stop();                   ///< stops the run and discards its outcome
    /// Returns the outcome of request(), computed in the calling thread.
    [[nodiscard]] OutcomePtr outcomeOf(const Setup& upTo, const Issues& faults,
                                       const std::stop_token& stop = {}) const;
    [[nodiscard]] const Runner& runner() const { return m_runner; }
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] double lastRun_ms() const { return m_lastRun_ms; }
    /// Returns the decision on the stocks of the last finished outcome; empty if it is not decided,
    /// or not yet.
    [[nodiscard]] const std::optional<JudgedStocks>& stocks() const { return m_stocks; }
    [[nodiscard]] bool areStocksComing() const { return m_areStocksComing; }

signals:
    void started();
    void finished(sparkout::OutcomePtr outcome);
    void stocksDecided(); ///< emitted after finished()

private:
    Runner m_runner;
    bool m_running = false;
    double m_lastRun_ms = 0;
    std::optional<JudgedStocks> m_stocks;
    bool m_areStocksComing = false;
    mutable RemovedVolumes
        m_removed;   ///< volumes of the earlier surfaces, which an edit seldom affects
    NewestJob m_job; ///< last: stopped before the members that it uses are destroyed
};

} // namespace sparkout
