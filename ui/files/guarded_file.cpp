// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/guarded_file.h"

#include "core/format/project_file.h"

#include <utility>

namespace sparkout {

GuardedFile::GuardedFile(QObject* parent) : QObject(parent) {
    connect(&m_watch, &FileWatch::changed, this, &GuardedFile::changedOnDisk);
    connect(&m_watch, &FileWatch::restored, this, &GuardedFile::restoredOnDisk);
}

void GuardedFile::protect(const QString& stateFolder) {
    m_isProtected = true;
    m_history = stateFolder.isEmpty() ? std::nullopt : std::optional(BackupHistory(stateFolder));
}

void GuardedFile::unprotect() {
    m_isProtected = false;
    m_history.reset();
}

bool GuardedFile::isFile(const QString& path) const {
    return !m_path.isEmpty() && realPath(path) == realPath(m_path);
}

GuardedFile::Access GuardedFile::claim(const QString& path) {
    dropClaim();
    m_claimed = realPath(path);
    m_keepLock = isFile(path) && m_lock.stillOurs();
    if (!mayBeWritten(path)) {
        return Access::readOnly;
    }
    if (m_keepLock || !m_isProtected) {
        return Access::write;
    }
    switch (m_claim.acquire(path)) {
    case FileLock::State::conflict: return Access::conflict;
    case FileLock::State::noRight: return Access::readOnly;
    default: return Access::write; // a missing lock must not prevent work
    }
}

GuardedFile::Access GuardedFile::takeOver() {
    return m_claim.takeOver() == FileLock::State::conflict ? Access::conflict : Access::write;
}

void GuardedFile::dropClaim() {
    m_claim.release();
    m_claimed.clear();
    m_keepLock = false;
}

/// The contents are now those of the claimed file.
void GuardedFile::settleClaim() {
    if (m_claim.state() == FileLock::State::conflict) {
        m_claim.release();
    }
    if (!m_keepLock) {
        m_lock = std::move(m_claim);
    }
    dropClaim();
}

void GuardedFile::follow(const QString& path, const QByteArray& hash, bool readOnly) {
    const bool isSame = isFile(path);
    m_path = path;
    m_hash = hash;
    m_isReadOnly = readOnly;
    if (!m_claimed.isEmpty() && isFile(m_claimed)) {
        settleClaim();
    } else if (!isSame) {
        m_lock.release();
    }
    followDisk();
}

void GuardedFile::followDisk() {
    m_attempted.clear();
    m_seen.reset();
    if (m_isProtected) {
        m_watch.follow(m_path, m_hash);
    }
}

bool GuardedFile::isKnown(const QByteArray& hash) const {
    return hash == m_hash || (!hash.isEmpty() && hash == m_attempted);
}

std::optional<DiskState> GuardedFile::changedOutside(const QString& path) {
    m_seen.reset();
    if (!isFile(path)) {
        return {};
    }
    DiskState state;
    runAside([&] { state = diskState(path); });
    if (state.kind == DiskState::Kind::unreadable) {
        return {}; // it cannot be checked; the save reports the error
    }
    m_seen = state;
    return isKnown(state.hash) ? std::nullopt : m_seen;
}

/// The version that a write may replace; empty: any, since the user has chosen the file.
std::optional<std::string> GuardedFile::expectedAt(const QString& path) const {
    if (!isFile(path)) {
        return std::nullopt;
    }
    const QByteArray& hash = m_seen ? m_seen->hash : m_attempted.isEmpty() ? m_hash : m_attempted;
    return hash.toHex().toStdString();
}

/// Keeps the version about to be replaced. A failure does not prevent saving: the version also
/// becomes NAME.bak, without which a save is refused.
void GuardedFile::keepEarlierVersion(const QString& path) const {
    const auto old = readFile(systemPath(path), limits::fileBytes);
    const auto* bytes = std::get_if<std::string>(&old);
    if (m_history && bytes != nullptr) {
        const bool isOwn = isFile(path) && isKnown(contentHash(*bytes));
        (void)m_history->keep(path, *bytes, QDateTime::currentDateTimeUtc(),
                              isOwn ? BackupHistory::Whose::own : BackupHistory::Whose::foreign);
    }
}

std::optional<FileError> GuardedFile::write(const QString& path, const MakeContent& make) {
    m_watch.pause();
    SavedContent saved;
    runAside([&, expected = expectedAt(path)] {
        keepEarlierVersion(path);
        saved = saveContent(make, path, {.keepBackup = true, .expected = expected});
    });
    if (saved.error) {
        followDisk();
        m_attempted = saved.error->replaced ? saved.hash : QByteArray();
        return saved.error;
    }
    follow(path, saved.hash);
    return {};
}

} // namespace sparkout
