// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>

namespace sparkout::report {

inline constexpr qsizetype mostLogoBytes = 1 << 20;

/// A PNG or SVG file as a picture for paper; null when it is none, or too large.
[[nodiscard]] QImage logoImage(const QByteArray& bytes);

} // namespace sparkout::report
