// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace sparkout {

/// Where a read or a save stopped.
enum class FileStep {
    inspect,     ///< finding out what stands at the path, symbolic links followed
    notRegular,  ///< a directory, FIFO, socket or device stands there
    readOnly,    ///< the file is there and may not be written
    open,        ///< opening the folder (a save) or the file (a read)
    create,      ///< the temporary file beside the target
    permissions, ///< giving it the mode of the file it will replace
    write,
    sync,
    close,
    backup, ///< keeping the previous version as NAME.bak
    rename, ///< putting the new file in place
    verify, ///< reading back: EILSEQ when the bytes are not the bytes written
    read,
    tooLarge, ///< the file holds more than the caller takes
    changed,  ///< another content stands there than the caller expects to replace
    content,  ///< the reader of such files would refuse the bytes, which were not written
};

/// Why a file was not read or not written. The caller words it.
struct FileError {
    std::string path; ///< as the caller gave it
    FileStep step = FileStep::inspect;
    int systemError = 0;                    ///< errno, or 0 when the system refused nothing
    std::optional<std::uint64_t> freeBytes; ///< free space of the target's disk, for a failed save
    /// false: the file still holds the old bytes (or is still absent). true: the new file stands
    /// in place, but the disk did not confirm it; it may not outlast a power cut.
    bool replaced = false;
};

struct WriteOptions {
    /// Keep the previous version as NAME.bak. A backup that cannot be made stops the save.
    bool keepBackup = false;
    /// sha256() of the content that the caller knows to stand there; empty: no file does. Anything
    /// else is left in place, and the save fails with FileStep::changed. Saves of this kind take
    /// turns; it is compared once more after the files have been exchanged, where the system can
    /// exchange them, so that no version that another program puts there meanwhile is lost.
    std::optional<std::string> expected = std::nullopt;
};

/// How often a writer that merges its change into what stands there reads that anew, as another
/// program may write each time, before it gives up with FileStep::changed.
inline constexpr int mergeAttempts = 100;

/// The one way a file is written: afterwards the path holds exactly the old or exactly the new
/// bytes, whatever fails or is killed in between, and success is reported only once the new bytes
/// are on the disk and have been read back.
///
/// A temporary file in the same folder is written, synced, read back and renamed over the target,
/// then the folder is synced. A symbolic link stays and its target is written. The mode is kept,
/// owner and group as far as the system allows; access lists and extended attributes are not, and
/// another hard link keeps the old text. What a killed save of the same file left behind
/// (".sparkout-*.tmp") is removed by the next one.
[[nodiscard]] std::optional<FileError> writeFileSafely(const std::filesystem::path& path,
                                                       std::string_view bytes,
                                                       const WriteOptions& options = {});

/// The whole content of a regular file of at most maxBytes.
[[nodiscard]] std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                                            std::size_t maxBytes);

/// Renames a damaged file to NAME.damaged, or NAME.damaged-2, -3, … where that is taken: one that
/// was put aside before is never replaced. Gives the new path, or why the file stays.
[[nodiscard]] std::variant<std::filesystem::path, FileError>
putAside(const std::filesystem::path& path);

} // namespace sparkout
