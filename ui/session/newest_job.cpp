// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/newest_job.h"

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

} // namespace sparkout
