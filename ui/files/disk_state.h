// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>

/// What stands on the disk at a path, symbolic links followed.
namespace sparkout {

/// Tells whether a file may have changed without reading it. It never proves that it has: the hash
/// of the content does.
struct FileStamp {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t size = 0;
    std::int64_t modified_ns = 0;
    std::int64_t changed_ns = 0; ///< of the inode: also when the time of modification is set back
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

struct DiskState {
    enum class Kind { missing, unreadable, file };
    Kind kind = Kind::missing;
    QByteArray hash;         ///< of the content, with Kind::file
    std::uint64_t links = 1; ///< names the file has
};

[[nodiscard]] std::optional<FileStamp> stampOf(const QString& path);
[[nodiscard]] DiskState diskState(const QString& path);

/// How many names (hard links) the file has; 1 when there is none.
[[nodiscard]] std::uint64_t linkCount(const QString& path);

/// Whether a save could put a file there: the folder takes new files, and a file that is there
/// already is not write-protected.
[[nodiscard]] bool mayBeWritten(const QString& path);

/// The path without symbolic links, also of a file that does not exist yet.
[[nodiscard]] QString realPath(const QString& path);

} // namespace sparkout
