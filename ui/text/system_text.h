// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

/// Texts in the encoding of the core and the system: that of the locale on POSIX, UTF-8 on Windows,
/// where Qt's functions cover the letters of one language only.
namespace sparkout {

[[nodiscard]] std::string systemText(const QString& text);
[[nodiscard]] QString fromSystemText(const std::string& text);

} // namespace sparkout
