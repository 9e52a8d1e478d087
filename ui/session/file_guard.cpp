// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/file_guard.h"

#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"

#include <QFile>
#include <QFileInfo>

#include <utility>

namespace sparkout {

namespace {

FileError noFolder(const RecoveryStore& store) {
    FileError error;
    error.path = systemText(store.folder());
    error.step = FileStep::create;
    return error;
}

} // namespace

Autosave::Autosave(Document& document, RecoveryStore store, Times times, QObject* parent)
    : QObject(parent), m_document(document), m_store(std::move(store)) {
    m_idle.setSingleShot(true);
    m_idle.setInterval(times.idle);
    m_latest.setSingleShot(true);
    m_latest.setInterval(times.latest);
    connect(&m_idle, &QTimer::timeout, this, &Autosave::write);
    connect(&m_latest, &QTimer::timeout, this, &Autosave::write);
    connect(&document, &Document::changed, this, &Autosave::noteChange);
    // The replacing code has asked already. The file of the old document is not overwritten.
    connect(&document, &Document::replaced, this, &Autosave::moveAway);
}

Autosave::Autosave(Document& document, RecoveryStore store, QObject* parent)
    : Autosave(document, std::move(store), Times(), parent) {}

Autosave::~Autosave() {
    flush();
}

void Autosave::adopt(RecoveryClaimPtr claim) {
    m_claim = std::move(claim);
}

void Autosave::noteChange() {
    m_idle.start();
    if (!m_latest.isActive()) {
        m_latest.start();
    }
}

void Autosave::write() {
    m_idle.stop();
    m_latest.stop();
    // An untouched document needs no file; one returned to that state by undo updates its own.
    if (!m_document.modified() && !m_claim) {
        return;
    }
    if (!m_claim) {
        m_claim = m_store.claimNew();
    }
    if (!m_claim) {
        emit failed(noFolder(m_store));
        return;
    }
    const RecoveryHeader header{QString::fromStdString(m_document.project().title),
                                m_document.filePath(),
                                QDateTime::currentDateTimeUtc(),
                                m_document.diskHash(),
                                m_document.readOnly(),
                                m_document.modified(),
                                m_document.allOpenInputs()};
    m_background.start([this, header, setup = m_document.setup(), claim = m_claim] {
        const auto error = writeFileSafely(systemPath(claim->file()), recoveryText(header, setup));
        return Background::Answer([this, error] {
            if (error) {
                emit failed(*error);
            } else {
                emit written();
            }
        });
    });
}

void Autosave::saved() {
    stop();
    if (m_claim) {
        QFile::remove(m_claim->file());
        m_claim.reset();
    }
}

void Autosave::discard() {
    if (m_idle.isActive()) {
        write(); // includes the last change among the discarded ones
    }
    moveAway();
}

/// A file that cannot be moved stays, and is offered at the next start.
void Autosave::moveAway() {
    stop();
    if (m_claim && QFileInfo::exists(m_claim->file())) {
        (void)m_store.discard(m_claim->file());
    }
    m_claim.reset();
}

void Autosave::flush() {
    if (m_idle.isActive()) {
        write();
    }
    m_background.wait();
}

void Autosave::stop() {
    m_idle.stop();
    m_latest.stop();
    m_background.wait();
}

QString Autosave::file() const {
    return m_claim && QFileInfo::exists(m_claim->file()) ? m_claim->file() : QString();
}

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
