// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>
#include <string>

namespace sparkout {

/// The text of a table of measurements, and where it is from.
struct MeasuredSource {
    QString name;       ///< of the file; empty: pasted
    std::string text;   ///< UTF-8
    std::string digest; ///< of the file's bytes, where the text is another writing of them
};

using MeasuredSourcePtr = std::shared_ptr<const MeasuredSource>;

/// From the bytes of a file in UTF-8, in UTF-16 with its mark, or else in Windows-1251, which
/// Russian spreadsheets write.
[[nodiscard]] MeasuredSource measuredSource(const QString& name, std::string bytes);

} // namespace sparkout
