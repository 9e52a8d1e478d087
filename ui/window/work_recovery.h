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

/// Restores unsaved work left by a crash, or discarded a while ago.
class WorkRecovery {
    Q_DECLARE_TR_FUNCTIONS(WorkRecovery)

public:
    WorkRecovery(Document& document, FileGuard& guard, FileNotices& notices, DiskWait& wait,
                 QWidget* window);

    bool offer(bool alsoDiscarded); ///< true: the document is now such work

private:
    bool recover(const RecoveryItem& item);

    Document& m_document;
    FileGuard& m_guard;
    FileNotices& m_notices;
    DiskWait& m_wait;
    QWidget* m_window;
};

} // namespace sparkout
