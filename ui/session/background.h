// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>

/// File operations outside the window's thread, because a disk may be slow.
namespace sparkout {

/// Runs one job after the other in a thread of its own. The destructor waits for the running job.
class Background : public QObject {
    Q_OBJECT

public:
    using Answer = std::function<void()>;

    explicit Background(QObject* parent = nullptr);
    ~Background() override;

    /// Runs `job` in that thread; the returned function then runs in the thread of this object.
    void start(std::function<Answer()> job);
    void wait(); ///< until every job and its answer are done

private:
    QThreadPool m_pool;
};

/// Runs `work` in another thread and returns when it is done. Meanwhile the window is painted and
/// timers fire, but keys and clicks wait.
void runAside(const std::function<void()>& work);

} // namespace sparkout
