// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "ui/session/background.h"
#include "ui/session/file_lock.h"
#include "ui/session/project_io.h"

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace sparkout {

/// Limits on the kept versions of one file.
struct BackupCaps {
    int files = 25;
    int filesADay = 5;
    qint64 bytes = qint64{100} << 20;
    std::chrono::seconds apart{300}; ///< least time between kept versions
};

/// An earlier version of a file.
struct EarlierVersion {
    QString file;
    QDateTime when; ///< time of its replacement
    qint64 bytes = 0;
};

/// The versions of a file that saving replaced, in a folder of the program. (The last one is also
/// beside the file as NAME.bak.)
class BackupHistory {
public:
    explicit BackupHistory(const QString& stateFolder, BackupCaps caps = {});

    enum class Whose {
        own,    ///< may be dropped soon after the last kept one
        foreign ///< perhaps the only copy: always kept
    };
    /// Keeps these bytes, which a save is about to replace, within the limits, and drops versions
    /// that exceed them. The first version of a day outlives the others of that day.
    std::optional<FileError> keep(const QString& path, std::string_view bytes, const QDateTime& now,
                                  Whose whose = Whose::own) const;
    [[nodiscard]] std::vector<EarlierVersion> versions(const QString& path) const; ///< newest first

    [[nodiscard]] QString folderOf(const QString& path) const;

private:
    void drop(std::vector<EarlierVersion> versions, const QDateTime& now) const;

    QString m_folder;
    BackupCaps m_caps;
};

/// The versions in the history and the NAME.bak beside the file, newest first.
[[nodiscard]] std::vector<EarlierVersion> earlierVersions(const BackupHistory& history,
                                                          const QString& path);

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

    /// Contents made from those on the disk.
    struct Amendment {
        std::string expected;            ///< sha256() of the contents on the disk; empty: no file
        std::optional<std::string> text; ///< empty: its reader would refuse it
    };
    enum class Waiting { here, aside }; ///< where the disk is waited for; aside: runAside()
    /// Changes a file that any window may change at any time, such as the settings and the user's
    /// catalogues: none of them holds its lock, and each merges its change into the contents that
    /// it finds. `read` reads the file and makes the new contents, and is asked again if another
    /// program writes meanwhile; nothing is written if it returns none. Keeps the replaced version
    /// beside the file and in the folder `backups` there.
    [[nodiscard]] static std::optional<FileError>
    amend(const QString& path, Waiting waiting,
          const std::function<std::optional<Amendment>()>& read);

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
    static void keepEarlierVersion(const BackupHistory& history, const QString& path,
                                   const std::function<bool(const QByteArray& hash)>& isOwn);

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
