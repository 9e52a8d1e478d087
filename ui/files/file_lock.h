// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/disk_state.h"

#include <QDateTime>
#include <QString>

#include <memory>

class QLockFile;

namespace sparkout {

/// Who holds a lock, as far as its file tells.
struct LockHolder {
    bool readable =
        false; ///< false: the lock file holds no sense, only its owner and time are known
    QString user;
    QString host;
    QString program;
    qint64 process = 0;
    QDateTime since;
};

/// "This file is open": the hidden file .~NAME.lock beside it. The lock of a program that no longer
/// runs on this host is taken over; one of another host is respected, however old, and so is one
/// that cannot be read, until the user says otherwise.
class FileLock {
public:
    enum class State {
        none,
        held,
        conflict, ///< somebody else has it, see holder()
        noRight,  ///< the folder takes no files
        failed,   ///< the lock could not be written, by a full disk for one
        noLock,   ///< what stands at the lock's name is no lock: see strange()
    };

    FileLock();
    ~FileLock();
    FileLock(FileLock&&) noexcept;
    FileLock& operator=(FileLock&&) noexcept;

    State acquire(const QString& file);
    State takeOver(); ///< after a conflict, when the user said so
    void release();

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const LockHolder& holder() const { return m_holder; }
    /// What stood in the way, with State::noLock.
    [[nodiscard]] const QString& strange() const { return m_strange; }
    /// Whether a held lock is still the one on the disk: somebody else may have taken it over.
    [[nodiscard]] bool stillOurs() const;

    [[nodiscard]] static QString lockPath(const QString& file);

private:
    State tryLock();
    void readHolder();

    std::unique_ptr<QLockFile> m_lock;
    QString m_path; ///< of the lock file
    std::optional<FileStamp> m_stamp;
    State m_state = State::none;
    LockHolder m_holder;
    QString m_strange;
};

/// Whether a lock was written on this computer, by its name there: on Windows that is the one of
/// NetBIOS, in capitals and of 15 letters at most.
[[nodiscard]] bool isThisComputer(const QString& host);

/// What stands at the name of a lock, or of the helper that removes a dead one, and is no lock: a
/// link, a pipe, a device, a folder, a file of more than a lock holds. It is never opened, for
/// that may not come back. Empty: a lock, or nothing.
[[nodiscard]] QString strangeLock(const QString& lock);

} // namespace sparkout
