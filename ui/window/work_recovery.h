// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/recovery_store.h"

#include <QCoreApplication>

class QWidget;

namespace sparkout {

class DiskWait;
class Document;
class FileGuard;
class FileNotices;

/// Brings back unsaved work that a crash left, or that was given up a while ago.
class WorkRecovery {
    Q_DECLARE_TR_FUNCTIONS(WorkRecovery)

public:
    WorkRecovery(Document& document, FileGuard& guard, FileNotices& notices, DiskWait& wait,
                 QWidget* window);

    bool offer(bool alsoDiscarded); ///< true: the document now is such work

private:
    bool recover(const RecoveryItem& item);

    Document& m_document;
    FileGuard& m_guard;
    FileNotices& m_notices;
    DiskWait& m_wait;
    QWidget* m_window;
};

} // namespace sparkout
