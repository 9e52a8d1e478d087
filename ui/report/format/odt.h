// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QByteArray>

namespace sparkout::report {

/// An editable OpenDocument text of the blocks: tables are tables, figures are pictures with
/// descriptions, equations are lines. A form is A4 landscape, other reports are portrait.
[[nodiscard]] QByteArray odt(const Report& report);

} // namespace sparkout::report
