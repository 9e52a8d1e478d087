// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/background.h"

#include <QMenu>

#include <vector>

namespace sparkout {

class Settings;

/// The recently opened and saved files, chosen by a digit. A missing file stays in the list,
/// disabled, until it is removed, since its disk may be temporarily absent.
class RecentFilesMenu : public QMenu {
    Q_OBJECT

public:
    RecentFilesMenu(Settings& settings, QWidget* parent);

    void fill(); ///< also before it is shown

signals:
    void chosen(const QString& path);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Entry {
        QString path;
        QAction* action;
    };
    void lookForFiles();
    void showMissing(const QStringList& missing);
    void removeMissing();
    void retranslate();

    Settings& m_settings;
    std::vector<Entry> m_entries;
    QAction* m_separator; ///< the files are above it
    QAction* m_removeMissing;
    QAction* m_clear;
    QStringList m_missing;
    Background m_background; ///< a disk that is away may answer late
};

} // namespace sparkout
