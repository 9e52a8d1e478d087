// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_guard.h"

#include "ui/session/document.h"

#include <utility>

namespace sparkout {

FileGuard::FileGuard(Document& document, QObject* parent)
    : GuardedFile(parent), m_document(document) {
    connect(&document, &Document::replaced, this, &FileGuard::followDocument);
}

FileGuard::~FileGuard() = default;

void FileGuard::protect(const QString& stateFolder, Autosave::Times times) {
    GuardedFile::protect(stateFolder);
    m_recovery.emplace(stateFolder);
    m_autosave = std::make_unique<Autosave>(m_document, *m_recovery, times);
    connect(m_autosave.get(), &Autosave::failed, this, &FileGuard::autosaveFailed);
    connect(m_autosave.get(), &Autosave::written, this, &FileGuard::autosaved);
}

void FileGuard::followDocument() {
    follow(m_document.filePath(), m_document.diskHash(), m_document.readOnly());
}

std::optional<FileError> FileGuard::save(const QString& path) {
    const Setup setup = m_document.setup();
    if (auto error = write(path, [&setup] { return projectText(setup); })) {
        return error;
    }
    m_document.markSaved(path, hash());
    if (m_autosave) {
        m_autosave->saved();
    }
    return {};
}

void FileGuard::adoptRecovery(RecoveryClaimPtr claim) {
    if (m_autosave) {
        m_autosave->adopt(std::move(claim));
    }
}

} // namespace sparkout
