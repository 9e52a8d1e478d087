// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table_text.h"

#include <QString>

#include <memory>

namespace sparkout {

/// The text of a table of measurements, and its origin.
struct MeasuredSource {
    QString name; ///< name of the file; empty: pasted
    TableText text;
};

using MeasuredSourcePtr = std::shared_ptr<const MeasuredSource>;

} // namespace sparkout
