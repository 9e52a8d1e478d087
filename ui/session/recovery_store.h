// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "core/setup/setup.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class QLockFile;

namespace sparkout {

/// The data of a document besides its project.
struct RecoveryHeader {
    QString title;
    QString path; ///< path of the user's file; empty: never saved
    QDateTime when;
    QByteArray diskHash; ///< hash of the user's file when last read or written; may be empty
    bool readOnly = false;
    bool modified = true;            ///< false: the edits had been undone again
    std::vector<std::string> open{}; ///< missing inputs, for which the project has substitutes
};

struct RecoveryContent {
    RecoveryHeader header;
    std::optional<Setup> setup; ///< absent: the file is damaged
};

/// The header, and whether the text after it is undamaged.
struct RecoveryGlance {
    RecoveryHeader header;
    bool whole = false;
};

/// The recovery file: one line of JSON about the contents, then the project text. The line has the
/// SHA-256 of the text and of the names of open inputs, so that damage is detected.
[[nodiscard]] std::string recoveryText(const RecoveryHeader& header, const Setup& setup);

/// The readable part: for a damaged file perhaps the header, perhaps nothing.
[[nodiscard]] RecoveryContent readRecovery(std::string_view text);
/// Much quicker, without reading the project.
[[nodiscard]] RecoveryGlance glanceAtRecovery(std::string_view text);

/// A name in the recovery folder owned by a running session: during its lifetime no other instance
/// takes the recovery file for one left by a crash.
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

/// The right to offer the work of crashed sessions: during its lifetime no other instance offers
/// it. One for all files, since there may be thousands.
class RecoveryOffer;
using RecoveryOfferPtr = std::shared_ptr<const RecoveryOffer>;

/// A recovery file found at the start.
struct RecoveryItem {
    enum class State { ready, damaged, discarded };
    State state = State::ready;
    QString file;
    RecoveryHeader header;
    RecoveryOfferPtr offer; ///< null for a discarded one
};

/// The folder with the recovery files of all sessions, and the folder of the discarded ones. Only
/// files discarded 14 days ago are deleted.
class RecoveryStore {
public:
    explicit RecoveryStore(const QString& stateFolder);

    [[nodiscard]] const QString& folder() const { return m_folder; }
    [[nodiscard]] const QString& discardedFolder() const { return m_discarded; }

    /// A new name, locked; null if the folder cannot be used.
    [[nodiscard]] RecoveryClaimPtr claimNew() const;

    /// The work of sessions that no longer run, newest first; empty while another instance offers
    /// it, which `offeredElsewhere` reports.
    [[nodiscard]] std::vector<RecoveryItem> left(bool* offeredElsewhere = nullptr) const;
    /// The name of an item, for a session that continues in its file. Null if another session was
    /// quicker, or if the lock is invalid.
    [[nodiscard]] RecoveryClaimPtr claim(const RecoveryItem& item) const;
    /// Whether another session continues in its file.
    [[nodiscard]] bool inUse(const RecoveryItem& item) const;
    [[nodiscard]] std::vector<RecoveryItem> discarded() const; ///< newest first

    /// Moves a recovery file to the discarded ones; false if it could not be moved.
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

/// The folder for the user's program state, which is neither documents nor settings.
[[nodiscard]] QString userStateFolder();

/// Makes a folder that only its user can read; false on failure.
bool makePrivateFolder(const QString& path);

} // namespace sparkout
