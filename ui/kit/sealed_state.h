// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>

#include <optional>

/// Saved states of widgets with a checksum: Qt accepts some damaged states and puts panels out of
/// reach.
namespace sparkout {

[[nodiscard]] QByteArray sealed(const QList<QByteArray>& parts);
/// The parts; empty if the bytes are damaged or contain another number of parts.
[[nodiscard]] std::optional<QList<QByteArray>> unsealed(const QByteArray& bytes, qsizetype count);

} // namespace sparkout
