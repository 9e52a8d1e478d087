// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <stop_token>

namespace sparkout {

/// Computations outside the window's thread, one job at a time: a newer job stops the older one,
/// whose answers are discarded. The destructor stops the job and waits for it.
class NewestJob : public QObject {
    Q_OBJECT

public:
    using Answer = std::function<void()>;
    /// Runs an answer later in the thread of this object, unless a newer job has been started.
    using Post = std::function<void(Answer)>;
    using Job = std::function<void(const std::stop_token&, const Post&)>;

    explicit NewestJob(QObject* parent = nullptr);
    ~NewestJob() override;

    void start(Job job);
    void stop(); ///< stops the job and discards its answers

private:
    QThreadPool m_pool;
    std::stop_source m_stop;
    quint64 m_newest = 0;
};

} // namespace sparkout
