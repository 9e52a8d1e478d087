// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

#include <memory>
#include <optional>
#include <string_view>

namespace sparkout {

/// What writeFileSafely() does with bytes that come bit by bit and may be too many for the memory:
/// nothing stands under the path until finish() has put the whole file there. One that is not
/// finished leaves nothing behind.
class SafeFileWriter {
public:
    enum class Existing { replaced, refused };

    SafeFileWriter(const std::filesystem::path& path, Existing existing);
    ~SafeFileWriter();
    SafeFileWriter(const SafeFileWriter&) = delete;
    SafeFileWriter& operator=(const SafeFileWriter&) = delete;

    /// False: this or an earlier step failed; see error().
    bool write(std::string_view bytes);
    /// Syncs, reads back and renames. False: see error().
    bool finish();
    /// Why it failed, if it did. A file that stood in the way is EEXIST.
    [[nodiscard]] const std::optional<FileError>& error() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace sparkout
