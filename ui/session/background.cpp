// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/background.h"

#include <QEventLoop>
#include <QThread>

#include <memory>

namespace sparkout {

void runInBackground(const std::function<void()>& work) {
    const std::unique_ptr<QThread> thread(QThread::create(work));
    QEventLoop loop;
    QObject::connect(thread.get(), &QThread::finished, &loop, &QEventLoop::quit);
    thread->start();
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    thread->wait();
}

} // namespace sparkout
