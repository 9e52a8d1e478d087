// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/system_text.h"

#include <QFile>

namespace sparkout {

std::string systemText(const QString& text) {
#ifdef Q_OS_WIN
    return text.toStdString();
#else
    return QFile::encodeName(text).toStdString();
#endif
}

QString fromSystemText(const std::string& text) {
#ifdef Q_OS_WIN
    return QString::fromStdString(text);
#else
    return QFile::decodeName(QByteArray::fromStdString(text));
#endif
}

} // namespace sparkout
