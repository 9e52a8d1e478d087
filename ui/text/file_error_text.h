// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

#include <QString>

namespace sparkout {

/// Why a file was not read, or not saved.
[[nodiscard]] QString readErrorText(const FileError& error);
[[nodiscard]] QString saveErrorText(const FileError& error);

} // namespace sparkout
