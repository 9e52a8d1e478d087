// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"

#include <QString>

#include <string>

namespace sparkout {

/// Why a file was not read, or not saved.
[[nodiscard]] QString readErrorText(const FileError& error);
[[nodiscard]] QString saveErrorText(const FileError& error);

/// Texts in the encoding of the core and the system: that of the locale on POSIX, UTF-8 on Windows,
/// where Qt's functions cover the letters of one language only.
[[nodiscard]] std::string systemText(const QString& text);
[[nodiscard]] QString fromSystemText(const std::string& text);

} // namespace sparkout
