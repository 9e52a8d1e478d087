// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace sparkout {

/// Joins the non-empty texts.
[[nodiscard]] inline QString joined(QStringList texts, const QString& between) {
    texts.removeAll(QString());
    return texts.join(between);
}

} // namespace sparkout
