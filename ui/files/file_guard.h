// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/autosave.h"
#include "ui/files/guarded_file.h"

#include <memory>
#include <optional>

namespace sparkout {

class Document;

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
