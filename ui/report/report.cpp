// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report.h"

#include <QLocale>

namespace sparkout::report {

QString Report::origin() const {
    QStringList parts{program, file, QLocale().toString(date, QLocale::ShortFormat)};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

} // namespace sparkout::report
