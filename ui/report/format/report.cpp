// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/report.h"

#include "ui/text/number_text.h"

namespace sparkout::report {

QString Report::origin() const {
    QStringList parts{program, file, dateText(date)};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

} // namespace sparkout::report
