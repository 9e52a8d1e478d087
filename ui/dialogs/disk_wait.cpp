// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/disk_wait.h"

#include "ui/session/background.h"

#include <QCursor>
#include <QGuiApplication>

namespace sparkout {

void DiskWait::during(const std::function<void()>& work) {
    m_busy = true;
    work();
    m_busy = false;
}

void DiskWait::aside(const std::function<void()>& work) {
    during([&work] {
        QGuiApplication::setOverrideCursor(Qt::WaitCursor);
        runAside(work);
        QGuiApplication::restoreOverrideCursor();
    });
}

} // namespace sparkout
