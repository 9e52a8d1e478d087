// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/disk_wait.h"
#include "ui/dialogs/guard_questions.h"
#include "ui/files/guarded_file.h"

#include <QObject>
#include <QString>

class QWidget;

namespace sparkout {

class Settings;

/// Makes packs and takes them in.
class PackCommands : public QObject {
    Q_OBJECT

public:
    PackCommands(Settings& settings, QWidget* window);

    /// From now on a pack is locked while it is written, and the versions it replaces are kept in
    /// this folder.
    void protect(const QString& stateFolder) { m_file.protect(stateFolder); }
    void exportPack();
    void importPack();
    void importFile(const QString& path); ///< asks what of it is taken

    /// Whether a path is one of a pack, by its name.
    [[nodiscard]] static bool isPack(const QString& path);

private:
    Settings& m_settings;
    QWidget* m_window;
    GuardedFile m_file; ///< that was exported last
    DiskWait m_wait;
    GuardQuestions m_questions;
};

} // namespace sparkout
