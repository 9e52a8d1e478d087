// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

    void exportPack();
    void importPack();
    void importFile(const QString& path); ///< asks what of it is taken

    /// Whether a path is one of a pack, by its name.
    [[nodiscard]] static bool isPack(const QString& path);

private:
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
