// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/time_unit.h"

#include "core/units.h"
#include "ui/text/texts.h"

namespace sparkout {

TimeUnit::TimeUnit(double longest_s) : m_seconds(timeUnit_s(longest_s)) {}

QString TimeUnit::text() const {
    return unitText(m_seconds > 1 ? "min" : "s");
}

QString TimeUnit::titled(const QString& name) const {
    return QStringLiteral("%1, %2").arg(name, text());
}

} // namespace sparkout
