// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "ui/session/background.h"
#include "ui/session/guarded_file.h"
#include "ui/session/recovery_store.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace sparkout {

class Document;

/// Keeps a recovery file of the document while it has unsaved changes: shortly after the last
/// change, and with little delay during long typing. Never touches the user's file.
class Autosave : public QObject {
    Q_OBJECT

public:
    struct Times {
        std::chrono::milliseconds idle{2'000};    ///< after the last change
        std::chrono::milliseconds latest{30'000}; ///< after the first change not yet written
    };

    Autosave(Document& document, RecoveryStore store, Times times, QObject* parent = nullptr);
    Autosave(Document& document, RecoveryStore store, QObject* parent = nullptr);
    /// Saves the last changes unless they were discarded.
    ~Autosave() override;

    /// Continues in the recovery file of a crashed session.
    void adopt(RecoveryClaimPtr claim);
    void saved();   ///< the user's file is up to date: removes the recovery file
    void discard(); ///< the user discarded the changes: moves it to the discarded ones
    void flush();   ///< writes pending changes and waits

    [[nodiscard]] QString file() const; ///< empty if there is none

signals:
    void written();
    void failed(sparkout::FileError error); ///< tried again at the next change

private:
    void noteChange();
    void write();
    void stop();
    void moveAway();

    Document& m_document;
    RecoveryStore m_store;
    RecoveryClaimPtr m_claim;
    QTimer m_idle;
    QTimer m_latest;
    Background m_background;
};

/// The guarded file of the document, and its recovery after a crash.
class FileGuard : public GuardedFile {
    Q_OBJECT

public:
    explicit FileGuard(Document& document, QObject* parent = nullptr);
    ~FileGuard() override;

    /// Protects the file, and keeps recovery files in this folder, too.
    void protect(const QString& stateFolder, Autosave::Times times = {});

    /// Saves the document and, once it is completely on the disk, marks it as saved.
    [[nodiscard]] std::optional<FileError> save(const QString& path);
    void followDocument(); ///< also after reloading

    void adoptRecovery(RecoveryClaimPtr claim);
    [[nodiscard]] const RecoveryStore* recovery() const {
        return m_recovery ? &*m_recovery : nullptr;
    }
    [[nodiscard]] Autosave* autosave() { return m_autosave.get(); }

signals:
    void autosaveFailed(sparkout::FileError error);
    void autosaved();

private:
    Document& m_document;
    std::optional<RecoveryStore> m_recovery;
    std::unique_ptr<Autosave> m_autosave;
};

} // namespace sparkout
