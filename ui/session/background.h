// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>

/// File work off the window's thread: a disk may take its time.
namespace sparkout {

/// One job after the other, in a thread of its own. Destroying it waits for the job that runs.
class Background : public QObject {
    Q_OBJECT

public:
    using Answer = std::function<void()>;

    explicit Background(QObject* parent = nullptr);
    ~Background() override;

    /// `job` runs aside; what it returns runs afterwards in the thread of this object.
    void start(std::function<Answer()> job);
    void wait(); ///< until every job is done and answered

private:
    QThreadPool m_pool;
};

/// Runs `work` aside and comes back when it is done. Meanwhile the window is painted and timers
/// fire, but keys and clicks wait.
void runAside(const std::function<void()>& work);

} // namespace sparkout
