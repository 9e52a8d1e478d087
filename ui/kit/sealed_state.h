// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>

#include <optional>

/// Saved states of widgets behind a check sum: Qt takes some damaged states for good ones and puts
/// panels where nobody finds them.
namespace sparkout {

[[nodiscard]] QByteArray sealed(const QList<QByteArray>& parts);
/// The parts, or nothing when the bytes are damaged or hold another number of parts.
[[nodiscard]] std::optional<QList<QByteArray>> unsealed(const QByteArray& bytes, qsizetype count);

} // namespace sparkout
