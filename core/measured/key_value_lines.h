// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"

#include <string_view>
#include <vector>

/// Lines time|key|value, possibly with further keys and values, as written by machine adapters. The
/// time is a number of seconds, or an ISO 8601 date and time.
namespace sparkout {

/// The keys of the first lines, in their order.
[[nodiscard]] std::vector<ColumnMatch> matchKeys(std::string_view text);

/// Reads the lines into one trace for each key. A value UNAVAILABLE is skipped.
[[nodiscard]] ReadMeasured readKeyValueLines(std::string_view text, const MeasuredTable& table,
                                             const MeasuredContext& context,
                                             const std::stop_token& stop);

} // namespace sparkout
