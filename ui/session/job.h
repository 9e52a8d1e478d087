// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <utility>

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

/// Work outside the window's thread, one at a time: a newer one replaces the older. It leaves one
/// processor to the window. The destructor stops the work and waits for it.
class Job : public QObject {
    Q_OBJECT

public:
    explicit Job(QObject* parent = nullptr);

    struct Means {
        int threads = 1;
        std::stop_token stop;
        std::atomic<std::int64_t>* done =
            nullptr; ///< counter of the finished parts, set by the work
        /// Runs a function in the window's thread while the work continues.
        std::function<void(NewestJob::Answer)> post;
    };

    /// Computes `work(means)` in another thread and passes the result to `take` in the window's
    /// thread. `parts`: number of parts that the work counts; 0: it counts none.
    template <class Work, class Take>
    void start(std::int64_t parts, Work work, Take take) {
        run(parts, [work = std::move(work), take = std::move(take)](const Means& means) {
            return NewestJob::Answer([take, result = work(means)] { take(result); });
        });
    }
    void stop(); ///< ends the work; its result is what it has finished
    void drop(); ///< ends the work without a result
    [[nodiscard]] bool running() const { return m_progress.isActive(); }
    [[nodiscard]] double took_s() const { return double(m_took.elapsed()) / 1000; }

signals:
    void progressed(qint64 done, qint64 parts, double left_s); ///< left_s < 0: not known yet
    void answered(); ///< a result was taken; the last one once the work no longer runs

private:
    using Work = std::function<NewestJob::Answer(const Means&)>;

    void run(std::int64_t parts, Work work);
    void reportProgress();

    QTimer m_progress;
    QElapsedTimer m_took;
    qint64 m_parts = 0;
    std::shared_ptr<std::atomic<std::int64_t>> m_done; ///< shared with the running work
    std::stop_source m_stop;
    NewestJob m_job; ///< last member: destroyed before the members that its work uses
};

} // namespace sparkout
