// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
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

/// Project files in and out, as plain functions of values: they may run in any thread.
namespace sparkout {

[[nodiscard]] std::filesystem::path systemPath(const QString& path);

/// SHA-256: how the session knows the bytes of a file again, whatever its times say.
[[nodiscard]] QByteArray contentHash(std::string_view bytes);

/// A project text read: opened, refused with faults, or not read at all. Unfinished work, in which
/// only a rule between values is broken, is a set-up with its faults beside it.
struct LoadedProject {
    std::optional<Setup> setup;
    Issues issues;
    std::optional<FileError> error;
    QByteArray hash; ///< of the bytes read
};

/// A stop leaves nothing: neither a set-up, nor issues, nor an error.
[[nodiscard]] LoadedProject parseProject(std::string_view text, const std::stop_token& stop = {});
[[nodiscard]] LoadedProject loadProject(const QString& path, const std::stop_token& stop = {});

struct SavedContent {
    std::optional<FileError> error;
    QByteArray hash; ///< of the bytes to be written
};

/// What a file shall hold; nothing when its own reader would refuse that.
using MakeContent = std::function<std::optional<std::string>()>;

/// Makes the content, writes it, reads the file again and compares the hash: only then is it saved.
/// A content that its reader would refuse never reaches the disk (FileStep::content).
[[nodiscard]] SavedContent saveContent(const MakeContent& make, const QString& path,
                                       const WriteOptions& options = {});

/// The text of a set-up, read back and compared.
[[nodiscard]] std::optional<std::string> projectText(const Setup& setup);

} // namespace sparkout
