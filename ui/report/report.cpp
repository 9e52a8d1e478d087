// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report.h"

#include "ui/session/number_text.h"

namespace sparkout::report {

QString Report::origin() const {
    QStringList parts{program, file, dateText(date)};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

} // namespace sparkout::report
