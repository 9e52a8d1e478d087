// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/documents/report_kinds.h"

namespace sparkout::report {

/// The accuracy passport: what the cycle makes of a batch of parts against the drawing, from the
/// inputs and factors to the verdict, so that it can be computed again. Without a batch it tells
/// the nominal part alone, and says so.
[[nodiscard]] Report passport(const Subject& subject);

} // namespace sparkout::report
