// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
#include "ui/files/recovery_file.h"

#include <QString>

#include <memory>
#include <optional>
#include <vector>

class QLockFile;

namespace sparkout {

/// A name in the recovery folder that belongs to one running session: as long as this object
/// lives, no other instance takes the recovery file for one that a crash left.
class RecoveryClaim {
public:
    ~RecoveryClaim();
    [[nodiscard]] const QString& file() const { return m_file; } ///< of the recovery file

private:
    friend class RecoveryStore;
    RecoveryClaim(QString file, std::unique_ptr<QLockFile> lock);
    QString m_file;
    std::unique_ptr<QLockFile> m_lock;
};
using RecoveryClaimPtr = std::shared_ptr<const RecoveryClaim>;

/// The right to offer what crashes left: as long as this object lives, no other instance offers it
/// as well. One for all files: there may be thousands of them.
class RecoveryOffer;
using RecoveryOfferPtr = std::shared_ptr<const RecoveryOffer>;

/// One recovery file found at the start.
struct RecoveryItem {
    enum class State { ready, damaged, discarded };
    State state = State::ready;
    QString file;
    RecoveryHeader header;
    RecoveryOfferPtr offer; ///< null for a discarded one
};

/// The folder with the recovery files of all sessions, and the folder of the discarded ones.
/// Nothing here is ever deleted but what was discarded 14 days ago.
class RecoveryStore {
public:
    explicit RecoveryStore(const QString& stateFolder);

    [[nodiscard]] const QString& folder() const { return m_folder; }
    [[nodiscard]] const QString& discardedFolder() const { return m_discarded; }

    /// A new name, locked; null when the folder cannot be used.
    [[nodiscard]] RecoveryClaimPtr claimNew() const;

    /// What sessions that no longer run left behind, newest first; nothing while another instance
    /// is offering it, which `offeredElsewhere` then says.
    [[nodiscard]] std::vector<RecoveryItem> left(bool* offeredElsewhere = nullptr) const;
    /// The name of an item, for the session that goes on in its file. Null: another session was
    /// quicker, or what stands at the name of its lock is none.
    [[nodiscard]] RecoveryClaimPtr claim(const RecoveryItem& item) const;
    /// Whether another session goes on in its file.
    [[nodiscard]] bool inUse(const RecoveryItem& item) const;
    [[nodiscard]] std::vector<RecoveryItem> discarded() const; ///< newest first

    /// Moves a recovery file to the discarded ones; false when it stayed where it was.
    bool discard(const QString& file) const;
    void removeOldDiscarded(const QDateTime& now) const;

    static constexpr int discardedDays = 14;

private:
    [[nodiscard]] RecoveryClaimPtr claim(const QString& id) const;
    [[nodiscard]] static RecoveryItem readItem(const QString& file);
    [[nodiscard]] QString lockOf(const QString& id) const;
    [[nodiscard]] bool inUse(const QString& id) const;
    void tidy(const QString& id) const;

    QString m_folder;
    QString m_discarded;
};

/// Where this user's programs keep what outlives a start but is no document and no setting.
[[nodiscard]] QString userStateFolder();

/// Makes a folder only its user can read; false when there is none afterwards.
bool makePrivateFolder(const QString& path);

} // namespace sparkout
