// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>

class QLockFile;

namespace sparkout {

// The object on the disk at a path, following symbolic links.

/// Detects without reading whether a file may have changed. Only the hash of its contents proves a
/// change.
struct FileStamp {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t size = 0;
    std::int64_t modified_ns = 0;
    std::int64_t changed_ns = 0; ///< of the inode, also if the time of modification is set back
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

struct DiskState {
    enum class Kind { missing, unreadable, file };
    Kind kind = Kind::missing;
    QByteArray hash;         ///< hash of the contents, for Kind::file
    std::uint64_t links = 1; ///< number of hard links
};

[[nodiscard]] std::optional<FileStamp> stampOf(const QString& path);
[[nodiscard]] DiskState diskState(const QString& path);

/// The number of names (hard links) of the file; 1 if it does not exist.
[[nodiscard]] std::uint64_t linkCount(const QString& path);

/// Whether a file can be saved there: the folder is writable, and an existing file is not
/// write-protected.
[[nodiscard]] bool mayBeWritten(const QString& path);

/// The path without symbolic links, also for a file that does not exist yet.
[[nodiscard]] QString realPath(const QString& path);

// The lock of a file.

/// The holder of a lock, from its file.
struct LockHolder {
    bool readable = false; ///< false: the lock file is invalid; only its owner and time are known
    QString user;
    QString host;
    QString program;
    qint64 process = 0;
    QDateTime since;
};

/// "This file is open": the hidden file .~NAME.lock beside it. The lock of a program that no longer
/// runs on this host is taken over; one of another host, of any age, or one that is unreadable is
/// respected unless the user decides otherwise.
class FileLock {
public:
    enum class State {
        none,
        held,
        conflict, ///< held by somebody else, see holder()
        noRight,  ///< the folder is not writable
        failed,   ///< the lock could not be written, for instance on a full disk
        noLock,   ///< another object has the lock's name: see strange()
    };

    FileLock();
    ~FileLock();
    FileLock(FileLock&&) noexcept;
    FileLock& operator=(FileLock&&) noexcept;

    State acquire(const QString& file);
    State takeOver(); ///< after a conflict, if the user decides so
    void release();

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const LockHolder& holder() const { return m_holder; }
    /// The obstacle, for State::noLock.
    [[nodiscard]] const QString& strange() const { return m_strange; }
    /// Whether a held lock is still the one on the disk: somebody else may have taken it over.
    [[nodiscard]] bool stillOurs() const;

    [[nodiscard]] static QString lockPath(const QString& file);

private:
    State tryLock();
    void readHolder();

    std::unique_ptr<QLockFile> m_lock;
    QString m_path; ///< path of the lock file
    std::optional<FileStamp> m_stamp;
    State m_state = State::none;
    LockHolder m_holder;
    QString m_strange;
};

/// Whether a lock was written on this computer, by the host's name: on Windows its NetBIOS name, in
/// capitals and at most 15 letters.
[[nodiscard]] bool isThisComputer(const QString& host);

/// An object with the name of a lock, or of the helper that removes a dead one, that is not a lock:
/// a link, a pipe, a device, a folder, a file that is too large. It is never opened, since that may
/// block. Empty: a lock, or nothing.
[[nodiscard]] QString strangeLock(const QString& lock);

} // namespace sparkout
