// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/disk_state.h"
#include "ui/session/background.h"

#include <QFileSystemWatcher>
#include <QTimer>

namespace sparkout {

/// Detects changes of the document's file by other programs. The system reports events in its
/// folder, including replaced files; check() works without these, as on a network disk. The hash of
/// the contents decides, so rewriting the same text is not a change.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Watches this file, known to have `hash`. An empty path ends it.
    void follow(const QString& path, const QByteArray& hash);
    void pause(); ///< until follow(), while the document writes the file
    void check(); ///< reports by changed(), later

signals:
    /// The file differs from the document's; emitted once for each contents.
    void changed(sparkout::DiskState state);
    void restored(); ///< after changed(): the file has the document's contents again

private:
    void watchPaths();
    void look();
    void judge(const DiskState& state, const std::optional<FileStamp>& stamp);

    QString m_path;
    QByteArray m_known;
    QByteArray m_told; ///< hash reported last
    bool m_toldMissing = false;
    std::optional<FileStamp> m_stamp;
    quint64 m_round = 0; ///< answers to an older question are dropped
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
    Background m_background;
};

} // namespace sparkout
