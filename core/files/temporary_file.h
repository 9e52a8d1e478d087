// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Temporary names for saving a file.

#include "core/files/file_system.h"

#include <cstdint>
#include <string>
#include <utility>

namespace sparkout {

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

} // namespace sparkout
