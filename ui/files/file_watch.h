// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/disk_state.h"
#include "ui/session/background.h"

#include <QFileSystemWatcher>
#include <QTimer>

namespace sparkout {

/// Looks whether another program changes the file of the document. The system tells when something
/// happens in its folder, a file that is replaced included; check() asks where it does not tell, as
/// on a network disk. The hash of the content decides, so rewriting the same text is no change.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject* parent = nullptr);

    /// Follows this file, known to hold `hash`. An empty path ends it.
    void follow(const QString& path, const QByteArray& hash);
    void pause(); ///< until follow(): the document writes the file itself
    void check(); ///< answered by changed(), later

signals:
    /// What stands there now is not what the document knows; once for each such content.
    void changed(sparkout::DiskState state);
    void restored(); ///< after changed(): what the document knows stands there again

private:
    void watchPaths();
    void look();
    void judge(const DiskState& state, const std::optional<FileStamp>& stamp);

    QString m_path;
    QByteArray m_known;
    QByteArray m_told; ///< hash that was reported already
    bool m_toldMissing = false;
    std::optional<FileStamp> m_stamp;
    quint64 m_round = 0; ///< answers to an older question are dropped
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
    Background m_background;
};

} // namespace sparkout
