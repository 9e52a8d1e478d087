// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/background.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QThread>

#include <memory>

namespace sparkout {

namespace {

/// Shorter work needs no event loop, since the delay is not noticed.
constexpr int unfelt_ms = 20;

} // namespace

Background::Background(QObject* parent) : QObject(parent) {
    m_pool.setMaxThreadCount(1);
}

Background::~Background() {
    m_pool.clear();
    m_pool.waitForDone();
}

void Background::start(std::function<Answer()> job) {
    m_pool.start([this, work = std::move(job)] {
        QMetaObject::invokeMethod(this, work(), Qt::QueuedConnection);
    });
}

void Background::wait() {
    m_pool.waitForDone();
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
}

void runAside(const std::function<void()>& work) {
    const std::unique_ptr<QThread> thread(QThread::create(work));
    QEventLoop loop;
    QObject::connect(thread.get(), &QThread::finished, &loop, &QEventLoop::quit);
    thread->start();
    if (!thread->wait(unfelt_ms)) {
        if (!thread->isFinished()) {
            loop.exec(QEventLoop::ExcludeUserInputEvents);
        }
        thread->wait();
    }
}

} // namespace sparkout
