// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/documents/report_kinds.h"

namespace sparkout::report {

/// The accuracy passport: the result of the cycle for a batch of parts compared with the drawing,
/// from the inputs and factors to the verdict, so that it can be reproduced. Without a batch it
/// covers the nominal part alone, and says so.
[[nodiscard]] Report passport(const Subject& subject);

} // namespace sparkout::report
