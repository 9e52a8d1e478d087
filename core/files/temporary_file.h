// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Temporary names, which saving a file is made of.

#include "core/files/file_system.h"

#include <cstdint>
#include <string>
#include <utility>

namespace sparkout {

/// A name that is removed at the end of the scope unless it was renamed away.
class TemporaryName {
public:
    TemporaryName(const Folder& folder, std::string name)
        : m_folder(&folder), m_name(std::move(name)) {}
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;
    ~TemporaryName();
    void release() { m_name.clear(); }

private:
    const Folder* m_folder; ///< outlives it
    std::string m_name;
};

/// How the temporary names of one target begin, so that the next save finds what a killed one left.
[[nodiscard]] std::string temporaryPrefix(const std::string& target);

/// A new, locked file with an unpredictable name; the lock says "in use" to removeLeftovers().
/// On file systems without locks nothing is ever taken for a leftover. Gives 0 or errno.
[[nodiscard]] int createTemporary(const Folder& folder, const std::string& prefix,
                                  std::uint32_t mode, Descriptor& file, std::string& name);

/// Removes the regular files of this user with that prefix that no running save holds locked.
void removeLeftovers(const Folder& folder, const std::string& prefix);

} // namespace sparkout
