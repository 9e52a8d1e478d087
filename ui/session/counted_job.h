// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/newest_job.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

namespace sparkout {

/// Work whose parts are counted, off the window's thread, one at a time: a newer one drops the
/// older. It leaves one processor to the window. Destroying it ends what runs and waits for it.
class CountedJob : public QObject {
    Q_OBJECT

public:
    explicit CountedJob(QObject* parent = nullptr);

    struct Means {
        int threads = 1;
        std::stop_token stop;
        std::atomic<std::int64_t>* done = nullptr; ///< the work counts its parts here
    };

    void stop(); ///< ends it; what is done until then is the outcome
    void drop(); ///< ends it without an outcome
    [[nodiscard]] bool running() const { return m_progress.isActive(); }

signals:
    void progressed(qint64 done, qint64 parts, double left_s); ///< left_s below 0: not known yet

protected:
    /// Computes, and says what to do with it in the window's thread.
    using Work = std::function<NewestJob::Answer(const Means&)>;

    void run(std::int64_t parts, Work work);

private:
    void tell();

    QTimer m_progress;
    QElapsedTimer m_took;
    qint64 m_parts = 0;
    std::shared_ptr<std::atomic<std::int64_t>> m_done; ///< shared with the work that is running
    std::stop_source m_stop;
    NewestJob m_job; ///< the last member: gone before what its work uses
};

} // namespace sparkout
