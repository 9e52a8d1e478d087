// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/autosave.h"
#include "ui/files/backup_history.h"
#include "ui/files/file_lock.h"
#include "ui/files/file_watch.h"
#include "ui/session/project_io.h"

#include <QObject>

#include <memory>
#include <optional>

namespace sparkout {

class Document;

/// Keeps the document's file from harm: who may write it, whether somebody else has written it,
/// the way it is saved, and what is left of it after a crash. It asks nobody anything: the window
/// does, and decides.
class FileGuard : public QObject {
    Q_OBJECT

public:
    enum class Access {
        write,
        readOnly, ///< the file or its folder takes no writing
        conflict, ///< somebody else has it open, see holder()
    };

    explicit FileGuard(Document& document, QObject* parent = nullptr);
    ~FileGuard() override;

    /// From now on files are locked and watched, and recovery files and earlier versions are kept
    /// in this folder. Without it (pictures, tests) nothing but the saved file is ever written.
    void protect(const QString& stateFolder, Autosave::Times times = {});

    /// Claims the right to write a file that is about to be opened or saved to. The file the
    /// document has stays locked meanwhile; the claim takes its place when the document follows.
    Access claim(const QString& path);
    Access takeOver(); ///< after a conflict
    void dropClaim();
    [[nodiscard]] const LockHolder& holder() const { return m_claim.holder(); }
    /// What keeps the document's file from being locked; empty: nothing.
    [[nodiscard]] const QString& strangeLock() const { return m_lock.strange(); }

    /// What stands at a path, if it is the document's file and somebody else has changed it.
    [[nodiscard]] std::optional<DiskState> changedOutside(const QString& path) const;

    /// Saves the document and, when all of it is known to be on the disk, marks it saved.
    [[nodiscard]] std::optional<FileError> save(const QString& path);
    /// After the document was reloaded from its file.
    void followDisk();
    /// A file that nobody works in, such as an example, needs no lock until it is saved to.
    void unlock() { m_lock.release(); }

    void adoptRecovery(RecoveryClaimPtr claim);
    [[nodiscard]] const RecoveryStore* recovery() const {
        return m_recovery ? &*m_recovery : nullptr;
    }
    [[nodiscard]] const BackupHistory* history() const { return m_history ? &*m_history : nullptr; }
    [[nodiscard]] Autosave* autosave() { return m_autosave.get(); }
    [[nodiscard]] FileWatch& watch() { return m_watch; }

signals:
    void changedOnDisk(sparkout::DiskState state);
    void restoredOnDisk();
    void autosaveFailed(sparkout::FileError error);
    void autosaved();

private:
    void followDocument();
    void settleClaim();
    [[nodiscard]] bool isDocumentsFile(const QString& path) const;

    Document& m_document;
    FileWatch m_watch;
    FileLock m_lock;         ///< of the document's file
    FileLock m_claim;        ///< of the one it may become
    QString m_claimed;       ///< real path of the claim; empty: none
    bool m_keepLock = false; ///< the claimed file is the document's own, which is locked already
    QByteArray m_attempted;  ///< hash of a save the disk did not confirm
    std::optional<RecoveryStore> m_recovery;
    std::optional<BackupHistory> m_history;
    std::unique_ptr<Autosave> m_autosave;
};

} // namespace sparkout
