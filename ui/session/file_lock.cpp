// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/file_lock.h"

#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "ui/session/project_io.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QSysInfo>

#include <cerrno>
#include <utility>

#ifdef Q_OS_WIN
QT_BEGIN_NAMESPACE
extern Q_CORE_EXPORT int qt_ntfs_permission_lookup;
QT_END_NAMESPACE
#endif

namespace sparkout {

namespace {

std::optional<FileFacts> factsOf(const QString& path) {
    FileFacts found;
    if (factsAt(systemPath(path), Links::followed, found) != 0) {
        return {};
    }
    return found;
}

} // namespace

std::optional<FileStamp> stampOf(const QString& path) {
    const auto found = factsOf(path);
    if (!found) {
        return {};
    }
    return FileStamp{found->device, found->inode, found->size, found->modified_ns,
                     found->changed_ns};
}

DiskState diskState(const QString& path) {
    DiskState state;
    const auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        state.kind =
            error->systemError == ENOENT ? DiskState::Kind::missing : DiskState::Kind::unreadable;
        return state;
    }
    state.kind = DiskState::Kind::file;
    state.hash = contentHash(std::get<std::string>(read));
    state.links = linkCount(path);
    return state;
}

std::uint64_t linkCount(const QString& path) {
    const auto found = factsOf(path);
    return found ? found->links : 1;
}

bool mayBeWritten(const QString& path) {
    const QString real = realPath(path);
    const auto found = factsOf(real);
    // Checks the mode, too: the system lets root write anything.
    if (found && (found->writeProtected || !mayWriteFile(systemPath(real)))) {
        return false;
    }
    return mayAddFiles(systemPath(QFileInfo(real).absolutePath()));
}

QString realPath(const QString& path) {
    const QFileInfo info(path);
    if (const QString real = info.canonicalFilePath(); !real.isEmpty()) {
        return real;
    }
    const QString folder = QFileInfo(info.absolutePath()).canonicalFilePath();
    return folder.isEmpty() ? info.absoluteFilePath() : QDir(folder).filePath(info.fileName());
}

namespace {

constexpr std::int64_t largestLock = 4096; ///< in bytes; a lock has a few hundred

/// QLockFile guards the removal of a dead lock by a helper file.
QString helperOf(const QString& lock) {
    return lock + QStringLiteral(".rmlock");
}

/// A program killed while removing a dead lock leaves the helper behind.
void removeHelper(const QString& lock) {
    const QString helper = helperOf(lock);
    if (QFileInfo::exists(helper)) {
        QLockFile file(helper);
        file.setStaleLockTime(0);
        (void)file.tryLock(0); // taken over if unused, and removed by the destructor
    }
}

bool sameLock(const FileStamp& a, const FileStamp& b) {
    return a.device == b.device && a.inode == b.inode && a.size == b.size
           && a.modified_ns == b.modified_ns;
}

/// The name of the user who owns a file. On Windows Qt looks for it only on request.
QString ownerOf(const QFileInfo& file) {
#ifdef Q_OS_WIN
    ++qt_ntfs_permission_lookup;
    const QString owner = file.owner();
    --qt_ntfs_permission_lookup;
    return owner;
#else
    return file.owner();
#endif
}

} // namespace

bool isThisComputer(const QString& host) {
    const QString own = QSysInfo::machineHostName();
#ifdef Q_OS_WIN
    return host.compare(own.left(15), Qt::CaseInsensitive) == 0;
#else
    return host == own;
#endif
}

QString strangeLock(const QString& lock) {
    for (const QString& path : {lock, helperOf(lock)}) {
        FileFacts found;
        if (factsAt(systemPath(path), Links::notFollowed, found) == 0
            && (found.kind != FileKind::regular || found.size > largestLock)) {
            return path;
        }
    }
    return {};
}

FileLock::FileLock() = default;
FileLock::~FileLock() {
    release();
}
FileLock::FileLock(FileLock&& other) noexcept
    : m_lock(std::move(other.m_lock))
    , m_path(std::exchange(other.m_path, {}))
    , m_stamp(std::exchange(other.m_stamp, {}))
    , m_state(std::exchange(other.m_state, State::none))
    , m_holder(std::exchange(other.m_holder, {}))
    , m_strange(std::exchange(other.m_strange, {})) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    if (this != &other) {
        release();
        m_lock = std::move(other.m_lock);
        m_path = std::exchange(other.m_path, {});
        m_stamp = std::exchange(other.m_stamp, {});
        m_state = std::exchange(other.m_state, State::none);
        m_holder = std::exchange(other.m_holder, {});
        m_strange = std::exchange(other.m_strange, {});
    }
    return *this;
}

QString FileLock::lockPath(const QString& file) {
    const QFileInfo real(realPath(file)); // one lock for all symbolic links to a file
    return real.absolutePath() + QStringLiteral("/.~") + real.fileName() + QStringLiteral(".lock");
}

FileLock::State FileLock::acquire(const QString& file) {
    release();
    m_path = lockPath(file);
    m_strange = strangeLock(m_path);
    if (!m_strange.isEmpty()) {
        m_state = State::noLock;
        return m_state;
    }
    m_lock = std::make_unique<QLockFile>(m_path);
    m_lock->setStaleLockTime(0);
    return tryLock();
}

FileLock::State FileLock::takeOver() {
    if (m_state == State::conflict) {
        // Does not remove a lock that a program on this host holds open; the user may.
        if (!m_lock->removeStaleLockFile()) {
            QFile::remove(m_path);
        }
        return tryLock();
    }
    return m_state;
}

FileLock::State FileLock::tryLock() {
    if (m_lock->isLocked()) {
        return m_state;
    }
    if (m_lock->tryLock(0)) {
        m_state = State::held;
        m_stamp = stampOf(m_path);
        removeHelper(m_path);
        return m_state;
    }
    switch (m_lock->error()) {
    case QLockFile::LockFailedError:
        m_state = State::conflict;
        readHolder();
        break;
    case QLockFile::PermissionError: m_state = State::noRight; break;
    default: m_state = State::failed;
    }
    return m_state;
}

void FileLock::readHolder() {
    m_holder = {};
    m_holder.readable = m_lock->getLockInfo(&m_holder.process, &m_holder.host, &m_holder.program);
    const QFileInfo info(m_path);
    m_holder.user = ownerOf(info);
    m_holder.since = info.lastModified();
}

bool FileLock::stillOurs() const {
    const auto now = stampOf(m_path);
    return m_state == State::held && now && m_stamp && sameLock(*now, *m_stamp);
}

void FileLock::release() {
    if (m_state == State::held && !stillOurs()) {
        // QLockFile removes by name: the lock of a new holder must not be removed.
        const std::filesystem::path lock = systemPath(m_path);
        const std::filesystem::path kept =
            systemPath(m_path + u'.' + QString::number(QCoreApplication::applicationPid()));
        if (linkPath(lock, kept) == 0) {
            m_lock.reset();
            (void)renamePath(kept, lock);
        }
    }
    m_lock.reset();
    m_state = State::none;
    m_stamp.reset();
    m_path.clear();
    m_strange.clear();
}

} // namespace sparkout
