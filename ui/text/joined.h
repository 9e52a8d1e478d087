// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace sparkout {

/// Those that are not empty, one after the other.
[[nodiscard]] inline QString joined(QStringList texts, const QString& between) {
    texts.removeAll(QString());
    return texts.join(between);
}

} // namespace sparkout
