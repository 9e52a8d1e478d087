// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

#include <QDateTime>
#include <QString>

#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

namespace sparkout {

/// Limits on the kept versions of one file.
struct BackupCaps {
    int files = 25;
    int filesADay = 5;
    qint64 bytes = qint64{100} << 20;
    std::chrono::seconds apart{300}; ///< least time between kept versions
};

/// An earlier version of a file.
struct EarlierVersion {
    QString file;
    QDateTime when; ///< time of its replacement
    qint64 bytes = 0;
};

/// The versions of a file that saving replaced, in a folder of the program. (The last one is also
/// beside the file as NAME.bak.)
class BackupHistory {
public:
    explicit BackupHistory(const QString& stateFolder, BackupCaps caps = {});

    enum class Whose {
        own,    ///< may be dropped soon after the last kept one
        foreign ///< perhaps the only copy: always kept
    };
    /// Keeps these bytes, which a save is about to replace, within the limits, and drops versions
    /// that exceed them. The first version of a day outlives the others of that day.
    std::optional<FileError> keep(const QString& path, std::string_view bytes, const QDateTime& now,
                                  Whose whose = Whose::own) const;
    [[nodiscard]] std::vector<EarlierVersion> versions(const QString& path) const; ///< newest first

    [[nodiscard]] QString folderOf(const QString& path) const;

private:
    void drop(std::vector<EarlierVersion> versions, const QDateTime& now) const;

    QString m_folder;
    BackupCaps m_caps;
};

/// The versions in the history and the NAME.bak beside the file, newest first.
[[nodiscard]] std::vector<EarlierVersion> earlierVersions(const BackupHistory& history,
                                                          const QString& path);

} // namespace sparkout
