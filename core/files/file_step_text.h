// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"

namespace sparkout {

/// The description of a step, marked for translation in the context "FileError".
[[nodiscard]] const char* fileStepText(FileStep step);

} // namespace sparkout
