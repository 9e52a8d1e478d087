// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/outcome.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <stop_token>

namespace sparkout {

/// Checks a project, runs its cycle and holds it against the drawing. Null when stopped.
[[nodiscard]] OutcomePtr runProject(const Project& project, const std::stop_token& stop);

/// The only place that starts threads. A project is taken by value, its outcome comes back as a
/// signal in the thread of the controller; a newer request stops the older one, whose result is
/// dropped. Destroying the controller stops the run and waits for it.
class RunController : public QObject {
    Q_OBJECT

public:
    using Runner = std::function<OutcomePtr(const Project&, const std::stop_token&)>;

    explicit RunController(QObject* parent = nullptr, Runner runner = runProject);
    ~RunController() override;

    void request(Project project);
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] double lastRun_ms() const { return m_lastRun_ms; }

signals:
    void started();
    void finished(sparkout::OutcomePtr outcome);

private:
    void deliver(quint64 number, const OutcomePtr& outcome, double time_ms);

    Runner m_runner;
    QThreadPool m_pool;
    std::stop_source m_stop;
    quint64 m_newest = 0;
    bool m_running = false;
    double m_lastRun_ms = 0;
};

} // namespace sparkout
