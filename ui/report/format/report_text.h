// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"
#include "ui/table/sheet.h"

#include <QByteArray>

#include <optional>

namespace sparkout::report {

/// A single file with embedded SVG figures. Also well-formed XML.
[[nodiscard]] QByteArray html(const Report& report);

/// Tables and texts; a figure has a description and an SVG drawing in the file itself.
[[nodiscard]] QByteArray markdown(const Report& report);

/// The formats of an exported report, by file suffix.
enum class Format { pdf, html, markdown, odt };
[[nodiscard]] std::optional<Format> formatOf(const QString& path);

/// Empty on failure or after a stop; only PDF can be stopped, the other formats are quick.
[[nodiscard]] QByteArray bytesOf(const Report& report, Format format,
                                 const KeepGoing& keepGoing = {});

} // namespace sparkout::report
