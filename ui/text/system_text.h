// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

/// Texts as the core and the system have them: in the bytes of the locale on POSIX, in UTF-8 on
/// Windows, where Qt's own functions know the letters of one language alone.
namespace sparkout {

[[nodiscard]] std::string systemText(const QString& text);
[[nodiscard]] QString fromSystemText(const std::string& text);

} // namespace sparkout
