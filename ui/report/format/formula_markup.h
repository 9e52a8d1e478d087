// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

namespace sparkout::report {

/// An equation as MathML, which browsers typeset and read aloud.
[[nodiscard]] QString mathMarkup(const Formula& formula);

/// On one line: "a = 2·h/C = 2·3/4 = 1.5 mm"; only indices and powers are marked up.
[[nodiscard]] QString inOneLine(const Formula& formula);

} // namespace sparkout::report
