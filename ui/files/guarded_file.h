// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/backup_history.h"
#include "ui/files/file_lock.h"
#include "ui/files/file_watch.h"
#include "ui/session/project_io.h"

#include <QObject>

#include <optional>

namespace sparkout {

/// A file that the window owns, of a project, a work or a lesson: who may write it, whether
/// somebody else has written it, the way it is saved, and the versions it had before. It asks
/// nobody anything: GuardQuestions does.
class GuardedFile : public QObject {
    Q_OBJECT

public:
    enum class Access {
        write,
        readOnly, ///< the file or its folder takes no writing
        conflict, ///< somebody else has it open, see holder()
    };

    explicit GuardedFile(QObject* parent = nullptr);

    /// From now on the file is locked and watched, and earlier versions are kept in this folder;
    /// an empty one: none are. Unprotected (pictures, tests, trials) nothing but the saved file and
    /// its NAME.bak is ever written.
    void protect(const QString& stateFolder);
    void unprotect();

    /// Claims the right to write a file that is about to be opened or saved to. The file that is
    /// followed stays locked meanwhile; the claim takes its place when that one is followed.
    Access claim(const QString& path);
    Access takeOver(); ///< after a conflict
    void dropClaim();
    [[nodiscard]] const LockHolder& holder() const { return m_claim.holder(); }
    /// What keeps the file from being locked; empty: nothing.
    [[nodiscard]] const QString& strangeLock() const { return m_lock.strange(); }
    /// A file that nobody works in, such as an example, needs no lock until it is saved to.
    void unlock() { m_lock.release(); }

    /// The content in the window is that of this file, known to hold bytes of this hash; no hash:
    /// there is none yet. An empty path: the content has no file.
    void follow(const QString& path, const QByteArray& hash, bool readOnly = false);
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] const QByteArray& hash() const { return m_hash; }
    [[nodiscard]] bool isReadOnly() const { return m_isReadOnly; } ///< a save goes elsewhere

    /// What stands at a path, if it is the file and somebody else has changed it. A write that
    /// follows may replace this version, and no other.
    [[nodiscard]] std::optional<DiskState> changedOutside(const QString& path);

    /// Writes a content, which is followed once all of it is known to be on the disk. The version
    /// it replaces is kept. A version of the file that nobody knows of is not replaced
    /// (FileStep::changed).
    [[nodiscard]] std::optional<FileError> write(const QString& path, const MakeContent& make);

    [[nodiscard]] const BackupHistory* history() const { return m_history ? &*m_history : nullptr; }
    [[nodiscard]] FileWatch& watch() { return m_watch; }

signals:
    void changedOnDisk(sparkout::DiskState state);
    void restoredOnDisk();

private:
    void settleClaim();
    void followDisk();
    [[nodiscard]] bool isFile(const QString& path) const;
    [[nodiscard]] bool isKnown(const QByteArray& hash) const; ///< empty: that there is no file
    [[nodiscard]] std::optional<std::string> expectedAt(const QString& path) const;
    void keepEarlierVersion(const QString& path) const;

    QString m_path;
    QByteArray m_hash;
    bool m_isReadOnly = false;
    bool m_isProtected = false;
    FileWatch m_watch;
    FileLock m_lock;                 ///< of the file
    FileLock m_claim;                ///< of the one it may become
    QString m_claimed;               ///< real path of the claim; empty: none
    bool m_keepLock = false;         ///< the claimed file is the one that is locked already
    QByteArray m_attempted;          ///< hash of a save the disk did not confirm
    std::optional<DiskState> m_seen; ///< at the last look, and may be replaced
    std::optional<BackupHistory> m_history;
};

} // namespace sparkout
