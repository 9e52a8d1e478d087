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

/// Exports and imports packs.
class PackCommands : public QObject {
    Q_OBJECT

public:
    PackCommands(Settings& settings, QWidget* window);

    /// Locks a pack while writing from now on, and keeps replaced versions in this folder.
    void protect(const QString& stateFolder) { m_file.protect(stateFolder); }
    void exportPack();
    void importPack();
    void importFile(const QString& path); ///< asks which parts to apply

    /// Whether a path is that of a pack, by its name.
    [[nodiscard]] static bool isPack(const QString& path);

private:
    Settings& m_settings;
    QWidget* m_window;
    GuardedFile m_file; ///< last exported pack
    DiskWait m_wait;
    GuardQuestions m_questions;
};

} // namespace sparkout
