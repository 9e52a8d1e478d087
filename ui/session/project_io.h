// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "core/issue.h"
#include "core/setup/setup.h"

#include <QByteArray>
#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

/// Reading and writing of project files by plain functions, which may run in any thread.
namespace sparkout {

[[nodiscard]] std::filesystem::path systemPath(const QString& path);

/// Returns the SHA-256 by which the session recognises the contents of a file, whatever its times
/// are.
[[nodiscard]] QByteArray contentHash(std::string_view bytes);

/// Result of reading a project text: opened, refused with faults, or not read at all. Unfinished
/// work, in which only rules between values are broken, is a set-up with faults.
struct LoadedProject {
    std::optional<Setup> setup;
    Issues issues;
    std::optional<FileError> error;
    QByteArray hash; ///< hash of the bytes read
};

/// Reads a project text; after a stop the result is empty.
[[nodiscard]] LoadedProject parseProject(std::string_view text, const std::stop_token& stop = {});
[[nodiscard]] LoadedProject loadProject(const QString& path, const std::stop_token& stop = {});

struct SavedContent {
    std::optional<FileError> error;
    QByteArray hash; ///< hash of the bytes to be written
};

/// Returns the contents of a file; empty if its reader would refuse them.
using MakeContent = std::function<std::optional<std::string>()>;

/// Makes the contents, writes them, reads the file again and compares the hash; only then is it
/// saved. Contents that the reader would refuse are not written (FileStep::content).
[[nodiscard]] SavedContent saveContent(const MakeContent& make, const QString& path,
                                       const WriteOptions& options = {});

/// Returns the text of a set-up without kept runs, which are not inputs of a document.
[[nodiscard]] QByteArray inputsText(Setup setup);

/// Returns the text of a set-up, read back and compared; empty if it differs or is refused.
[[nodiscard]] std::optional<std::string> projectText(const Setup& setup);

} // namespace sparkout
