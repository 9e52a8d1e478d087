// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/file_system.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

// Reading a file, and saving one whole, by writeFileSafely(), or in parts, by SafeFileWriter.

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

/// Like writeFileSafely() for bytes written in parts, possibly more than fit into memory: the path
/// does not change until finish() puts the complete file there. An unfinished file leaves nothing
/// behind.
class SafeFileWriter {
public:
    enum class Existing { replaced, refused };

    SafeFileWriter(const std::filesystem::path& path, Existing existing);
    ~SafeFileWriter();
    SafeFileWriter(const SafeFileWriter&) = delete;
    SafeFileWriter& operator=(const SafeFileWriter&) = delete;

    /// False if this or an earlier step failed; see error().
    bool write(std::string_view bytes);
    /// Syncs, reads back and renames. False: see error().
    bool finish();
    /// Why it failed, if it did. An existing file is EEXIST.
    [[nodiscard]] const std::optional<FileError>& error() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

// The common steps of both ways of saving, which write under a temporary name first.

/// A name that is removed at the end of the scope unless it was renamed.
class TemporaryName {
public:
    TemporaryName(const Folder& folder, std::string name)
        : m_folder(&folder), m_name(std::move(name)) {}
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;
    ~TemporaryName();
    void release() { m_name.clear(); }

private:
    const Folder* m_folder; ///< must outlive this object
    std::string m_name;
};

/// The prefix of the temporary names of a target, by which the next save finds leftovers.
[[nodiscard]] std::string temporaryPrefix(const std::string& target);

/// Creates a new, locked file with an unpredictable name; the lock protects it from
/// removeLeftovers(). On file systems without locks nothing counts as a leftover. Returns 0 or
/// errno.
[[nodiscard]] int createTemporary(const Folder& folder, const std::string& prefix,
                                  std::uint32_t mode, Descriptor& file, std::string& name);

/// Removes the regular files of this user with that prefix that no running save has locked.
void removeLeftovers(const Folder& folder, const std::string& prefix);

struct StepFailure {
    FileStep step;
    int systemError;
    bool replaced = false; ///< see FileError::replaced
};
/// The result of a step: empty on success.
using StepOutcome = std::optional<StepFailure>;

/// The file to be replaced: its folder, its name there and, if it exists, the old file, kept open
/// where open files can be replaced.
struct SaveTarget {
    std::filesystem::path parent; ///< parent of the folder
    Folder folder;
    std::string name;
    bool exists = false;
    Descriptor old;
    FileFacts oldFacts;
};

/// Finds the target of a path, following symbolic links, and opens what it needs.
[[nodiscard]] StepOutcome openTarget(std::filesystem::path path, SaveTarget& target);

/// A step whose call gave an error, or none.
[[nodiscard]] StepOutcome outcomeOf(FileStep step, int error, bool replaced = false);

/// Removes leftovers of killed saves of the target, unless another save has its turn in the folder,
/// whose old file briefly has a temporary name. Then creates its temporary file. A new file gets
/// its mode from the umask, a replacing one is private until it is complete.
[[nodiscard]] StepOutcome beginTemporary(const SaveTarget& target, Descriptor& file,
                                         std::string& name);

/// Renames the temporary file to the target's name.
[[nodiscard]] StepOutcome moveIntoPlace(SaveTarget& target, const std::string& temporary);

/// After the rename: makes it durable and opens the file with the target's name.
[[nodiscard]] StepOutcome openPlaced(const SaveTarget& target, Descriptor& placed);

[[nodiscard]] bool sameFile(const Descriptor& a, const Descriptor& b);

/// The failure for the caller, with the free space of the target's disk.
[[nodiscard]] FileError errorOf(const StepFailure& failure, const std::filesystem::path& path,
                                const SaveTarget& target);

} // namespace sparkout
