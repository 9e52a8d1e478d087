// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_guard.h"

#include "core/format/project_file.h"
#include "ui/session/document.h"

#include <QFileInfo>

namespace sparkout {

namespace {

/// The version that is about to be replaced. That it could not be kept stops no save: the version
/// also becomes NAME.bak, and a save without that is refused.
void keepEarlierVersion(const BackupHistory& history, const QString& path) {
    const auto old = readFile(systemPath(path), limits::fileBytes);
    if (const auto* bytes = std::get_if<std::string>(&old)) {
        (void)history.keep(path, *bytes, QDateTime::currentDateTimeUtc());
    }
}

} // namespace

FileGuard::FileGuard(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&document, &Document::replaced, this, &FileGuard::followDocument);
    connect(&m_watch, &FileWatch::changed, this, &FileGuard::changedOnDisk);
    connect(&m_watch, &FileWatch::restored, this, &FileGuard::restoredOnDisk);
}

FileGuard::~FileGuard() = default;

void FileGuard::protect(const QString& stateFolder, Autosave::Times times) {
    m_recovery.emplace(stateFolder);
    m_history.emplace(stateFolder);
    m_autosave = std::make_unique<Autosave>(m_document, *m_recovery, times);
    connect(m_autosave.get(), &Autosave::failed, this, &FileGuard::autosaveFailed);
    connect(m_autosave.get(), &Autosave::written, this, &FileGuard::autosaved);
}

bool FileGuard::isDocumentsFile(const QString& path) const {
    return !m_document.filePath().isEmpty() && realPath(path) == realPath(m_document.filePath());
}

FileGuard::Access FileGuard::claim(const QString& path) {
    dropClaim();
    m_claimed = realPath(path);
    m_keepLock = isDocumentsFile(path) && m_lock.stillOurs();
    if (!mayBeWritten(path)) {
        return Access::readOnly;
    }
    if (m_keepLock || !m_recovery) {
        return Access::write;
    }
    switch (m_claim.acquire(path)) {
    case FileLock::State::conflict: return Access::conflict;
    case FileLock::State::noRight: return Access::readOnly;
    default: return Access::write; // no lock, of a full disk for one, keeps nobody from working
    }
}

FileGuard::Access FileGuard::takeOver() {
    return m_claim.takeOver() == FileLock::State::conflict ? Access::conflict : Access::write;
}

void FileGuard::dropClaim() {
    m_claim.release();
    m_claimed.clear();
    m_keepLock = false;
}

/// The document is in the claimed file now.
void FileGuard::settleClaim() {
    if (m_claim.state() == FileLock::State::conflict) {
        m_claim.release();
    }
    if (!m_keepLock) {
        m_lock = std::move(m_claim);
    }
    dropClaim();
}

void FileGuard::followDocument() {
    if (!m_claimed.isEmpty() && isDocumentsFile(m_claimed)) {
        settleClaim();
    } else {
        m_lock.release();
    }
    followDisk();
}

void FileGuard::followDisk() {
    m_attempted.clear();
    if (m_recovery) {
        m_watch.follow(m_document.filePath(), m_document.diskHash());
    }
}

std::optional<DiskState> FileGuard::changedOutside(const QString& path) const {
    if (!isDocumentsFile(path) || m_document.diskHash().isEmpty()) {
        return {};
    }
    DiskState state;
    runAside([&] { state = diskState(path); });
    const bool known = state.kind == DiskState::Kind::file
                       && (state.hash == m_document.diskHash() || state.hash == m_attempted);
    // What cannot be read cannot be judged; the save itself will say what is wrong there.
    return known || state.kind == DiskState::Kind::unreadable ? std::nullopt : std::optional(state);
}

std::optional<FileError> FileGuard::save(const QString& path) {
    m_watch.pause();
    SavedProject saved;
    runAside([&, setup = m_document.setup()] {
        if (m_history) {
            keepEarlierVersion(*m_history, path);
        }
        saved = saveProject(setup, path, {.keepBackup = true});
    });
    if (saved.error) {
        followDisk();
        m_attempted = saved.error->replaced ? saved.hash : QByteArray();
        return saved.error;
    }
    m_document.markSaved(path, saved.hash);
    settleClaim();
    if (m_autosave) {
        m_autosave->saved();
    }
    followDisk();
    return {};
}

void FileGuard::adoptRecovery(RecoveryClaimPtr claim) {
    if (m_autosave) {
        m_autosave->adopt(std::move(claim));
    }
}

} // namespace sparkout
