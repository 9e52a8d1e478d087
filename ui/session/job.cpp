// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/job.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace sparkout {

NewestJob::NewestJob(QObject* parent) : QObject(parent) {
    m_pool.setMaxThreadCount(1);
}

NewestJob::~NewestJob() {
    m_stop.request_stop();
    m_pool.clear();
    m_pool.waitForDone();
}

void NewestJob::stop() {
    m_stop.request_stop();
    m_stop = std::stop_source();
    ++m_newest;
}

void NewestJob::start(Job job) {
    stop();
    m_pool.start([this, number = m_newest, stop = m_stop.get_token(), job = std::move(job)] {
        if (stop.stop_requested()) {
            return;
        }
        job(stop, [this, number](Answer answer) {
            QMetaObject::invokeMethod(
                this,
                [this, number, answer = std::move(answer)] {
                    if (number == m_newest) { // otherwise it is outdated
                        answer();
                    }
                },
                Qt::QueuedConnection);
        });
    });
}

Job::Job(QObject* parent) : QObject(parent) {
    constexpr int tick_ms = 100;
    m_progress.setInterval(tick_ms);
    connect(&m_progress, &QTimer::timeout, this, &Job::reportProgress);
}

void Job::run(std::int64_t parts, Work work) {
    drop();
    m_stop = std::stop_source();
    m_done = std::make_shared<std::atomic<std::int64_t>>(0);
    m_parts = parts;
    m_took.start();
    m_progress.start();
    m_job.start([this, work = std::move(work), done = m_done,
                 wanted = m_stop](const std::stop_token& newer, const NewestJob::Post& post) {
        std::stop_source either = wanted; // the two share one state
        const std::stop_callback dropped(newer, [&either] { either.request_stop(); });
        const int processors = static_cast<int>(std::thread::hardware_concurrency());
        const auto answer = [this, &post](NewestJob::Answer taken, bool isLast) {
            post([this, taken = std::move(taken), isLast] {
                if (isLast) {
                    m_progress.stop();
                }
                taken();
                emit answered();
            });
        };
        const Means means{std::max(1, processors - 1), either.get_token(), done.get(),
                          [&answer](NewestJob::Answer now) { answer(std::move(now), false); }};
        answer(work(means), true);
    });
}

void Job::stop() {
    m_stop.request_stop();
}

void Job::drop() {
    m_progress.stop();
    m_job.stop();
}

void Job::reportProgress() {
    const std::int64_t done = m_done->load(std::memory_order_relaxed);
    emit progressed(
        done, m_parts,
        done > 0 ? took_s() * static_cast<double>(m_parts - done) / static_cast<double>(done) : -1);
}

} // namespace sparkout
