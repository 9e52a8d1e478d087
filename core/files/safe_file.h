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

/// The step at which a read or a save failed.
enum class FileStep {
    inspect,     ///< finding the object at the path, following symbolic links
    notRegular,  ///< a directory, FIFO, socket or device
    readOnly,    ///< the file is there and may not be written
    open,        ///< opening the folder (a save) or the file (a read)
    create,      ///< creating the temporary file beside the target
    permissions, ///< setting the mode of the file to be replaced
    write,
    sync,
    close,
    backup, ///< keeping the previous version as NAME.bak
    rename, ///< putting the new file in place
    verify, ///< reading back: EILSEQ when the bytes are not the bytes written
    read,
    tooLarge, ///< the file exceeds the caller's limit
    changed,  ///< the contents are not those that the caller expects to replace
    content,  ///< the reader of such files would refuse the bytes, which were not written
};

/// Why a file was not read or not written. The caller formulates it.
struct FileError {
    std::string path; ///< as given by the caller
    FileStep step = FileStep::inspect;
    int systemError = 0;                    ///< errno, or 0 without a system error
    std::optional<std::uint64_t> freeBytes; ///< free space of the target's disk, for a failed save
    /// false: the file still has the old bytes (or does not exist). true: the new file is in place,
    /// but the disk did not confirm it; a power failure may lose it.
    bool replaced = false;
};

struct WriteOptions {
    /// Keeps the previous version as NAME.bak. If that fails, so does the save.
    bool keepBackup = false;
    /// sha256() of the contents that the caller expects to replace; empty: no file. Other contents
    /// are not replaced, and the save fails with FileStep::changed. Such saves take turns, and the
    /// contents are compared again after exchanging the files, where the system can, so that no
    /// version of another program is lost.
    std::optional<std::string> expected = std::nullopt;
};

/// Greatest number of attempts of a writer that merges its change into the current contents, which
/// another program may change each time, before it fails with FileStep::changed.
inline constexpr int mergeAttempts = 100;

/// The only function that writes files: afterwards the path has exactly the old or exactly the new
/// bytes, whatever fails or is killed in between, and success is reported only once the new bytes
/// are on the disk and have been read back.
///
/// A temporary file in the same folder is written, synced, read back and renamed over the target,
/// then the folder is synced. A symbolic link stays and its target is written. The mode is kept,
/// owner and group as far as the system allows; access lists and extended attributes are not, and
/// another hard link keeps the old text. Leftovers of a killed save of the same file
/// (".sparkout-*.tmp") are removed by the next one.
[[nodiscard]] std::optional<FileError> writeFileSafely(const std::filesystem::path& path,
                                                       std::string_view bytes,
                                                       const WriteOptions& options = {});

/// The contents of a regular file of at most maxBytes.
[[nodiscard]] std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                                            std::size_t maxBytes);

/// Renames a damaged file to NAME.damaged, or NAME.damaged-2, -3, … so that no earlier one is
/// replaced. Returns the new path, or why the file could not be renamed.
[[nodiscard]] std::variant<std::filesystem::path, FileError>
putAside(const std::filesystem::path& path);

/// The description of a step, marked for translation in the context "FileError".
[[nodiscard]] const char* fileStepText(FileStep step);

} // namespace sparkout
