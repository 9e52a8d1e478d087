// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/file_system.h"
#include "core/files/safe_file.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

// The common steps of saving a file whole (safe_file.cpp) and in parts (safe_file_writer.cpp).
namespace sparkout {

// Temporary names for saving a file.

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
