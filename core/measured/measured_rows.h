// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"

#include <string_view>

namespace sparkout {

/// Reads the lines of a table with headings; `readMeasured()` without the steps common to all
/// forms.
[[nodiscard]] ReadMeasured readRows(std::string_view text, const MeasuredTable& table,
                                    const MeasuredContext& context, const std::stop_token& stop);

} // namespace sparkout
