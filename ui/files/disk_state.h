// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>

/// The object on the disk at a path, following symbolic links.
namespace sparkout {

/// Detects without reading whether a file may have changed. Only the hash of its contents proves a
/// change.
struct FileStamp {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::int64_t size = 0;
    std::int64_t modified_ns = 0;
    std::int64_t changed_ns = 0; ///< of the inode, also if the time of modification is set back
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

struct DiskState {
    enum class Kind { missing, unreadable, file };
    Kind kind = Kind::missing;
    QByteArray hash;         ///< hash of the contents, for Kind::file
    std::uint64_t links = 1; ///< number of hard links
};

[[nodiscard]] std::optional<FileStamp> stampOf(const QString& path);
[[nodiscard]] DiskState diskState(const QString& path);

/// The number of names (hard links) of the file; 1 if it does not exist.
[[nodiscard]] std::uint64_t linkCount(const QString& path);

/// Whether a file can be saved there: the folder is writable, and an existing file is not
/// write-protected.
[[nodiscard]] bool mayBeWritten(const QString& path);

/// The path without symbolic links, also for a file that does not exist yet.
[[nodiscard]] QString realPath(const QString& path);

} // namespace sparkout
