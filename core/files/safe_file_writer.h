// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

#include <memory>
#include <optional>
#include <string_view>

namespace sparkout {

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

} // namespace sparkout
