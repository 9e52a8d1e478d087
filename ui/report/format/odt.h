// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QByteArray>

namespace sparkout::report {

/// An OpenDocument text of the blocks, to be edited: tables are tables, figures are pictures with
/// their descriptions, equations are lines. A form is A4 landscape, other reports are upright.
[[nodiscard]] QByteArray odt(const Report& report);

} // namespace sparkout::report
