// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/backup_history.h"
#include "ui/files/file_lock.h"
#include "ui/files/file_watch.h"
#include "ui/session/project_io.h"

#include <QObject>

#include <optional>

namespace sparkout {

/// A file that the window owns, with a project, a work or a lesson: its lock, changes by others,
/// safe saving, and earlier versions. It asks no questions; GuardQuestions does.
class GuardedFile : public QObject {
    Q_OBJECT

public:
    enum class Access {
        write,
        readOnly, ///< the file or its folder is not writable
        conflict, ///< somebody else has it open, see holder()
    };

    explicit GuardedFile(QObject* parent = nullptr);

    /// Locks and watches the file from now on, and keeps earlier versions in this folder (none if
    /// empty). Unprotected (pictures, tests, trials), only the saved file and its NAME.bak are
    /// written.
    void protect(const QString& stateFolder);
    void unprotect();

    /// Claims the right to write a file to be opened or saved to. The current file stays locked
    /// until the claimed one is followed.
    Access claim(const QString& path);
    Access takeOver(); ///< after a conflict
    void dropClaim();
    [[nodiscard]] const LockHolder& holder() const { return m_claim.holder(); }
    /// The obstacle to locking the file; empty if there is none.
    [[nodiscard]] const QString& strangeLock() const { return m_lock.strange(); }
    /// A file that nobody edits, such as an example, needs no lock until it is saved to.
    void unlock() { m_lock.release(); }

    /// The contents in the window are those of this file, which has this hash; without a hash it
    /// does not exist yet. Empty path: the contents have no file.
    void follow(const QString& path, const QByteArray& hash, bool readOnly = false);
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] const QByteArray& hash() const { return m_hash; }
    [[nodiscard]] bool isReadOnly() const { return m_isReadOnly; } ///< a save goes to another file

    /// The file at a path, if somebody else has changed it. A following write may replace this
    /// version, and no other.
    [[nodiscard]] std::optional<DiskState> changedOutside(const QString& path);

    /// Writes contents, and follows the file once they are completely on the disk. Keeps the
    /// replaced version. An unknown version of the file is not replaced (FileStep::changed).
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
    [[nodiscard]] bool isKnown(const QByteArray& hash) const; ///< empty: a missing file
    [[nodiscard]] std::optional<std::string> expectedAt(const QString& path) const;
    void keepEarlierVersion(const QString& path) const;

    QString m_path;
    QByteArray m_hash;
    bool m_isReadOnly = false;
    bool m_isProtected = false;
    FileWatch m_watch;
    FileLock m_lock;                 ///< lock of the file
    FileLock m_claim;                ///< lock of the claimed file
    QString m_claimed;               ///< real path of the claim; may be empty
    bool m_keepLock = false;         ///< the claimed file is the locked one
    QByteArray m_attempted;          ///< hash of a save the disk did not confirm
    std::optional<DiskState> m_seen; ///< at the last check; may be replaced
    std::optional<BackupHistory> m_history;
};

} // namespace sparkout
