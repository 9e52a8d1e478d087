// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/file_error_text.h"

#include "core/printable.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QFile>

#include <cstring>

namespace sparkout {

namespace {

/// The reason, the system's message, and the free space after a failed write.
QString details(const FileError& error) {
    QString text = QCoreApplication::translate("FileError", fileStepText(error.step));
    if (error.systemError != 0) {
        text = QCoreApplication::translate("FileError", "%1 (%2)")
                   .arg(text, QString::fromLocal8Bit(std::strerror(error.systemError)));
    }
    if (error.freeBytes) {
        text = QCoreApplication::translate("FileError", "%1; free space: %2")
                   .arg(text, sizeText(qint64(*error.freeBytes)));
    }
    return text;
}

} // namespace

QString readErrorText(const FileError& error) {
    return QCoreApplication::translate("FileError", "“%1” was not opened: %2.")
        .arg(QString::fromStdString(printable(error.path)), details(error));
}

QString saveErrorText(const FileError& error) {
    const QString path = QString::fromStdString(printable(error.path));
    if (error.replaced) {
        return QCoreApplication::translate(
                   "FileError", "“%1” was written, but the disk did not confirm it: %2. Save "
                                "again, or to another disk.")
            .arg(path, details(error));
    }
    return QCoreApplication::translate("FileError",
                                       "“%1” was not saved: %2. Nothing on the disk was changed.")
        .arg(path, details(error));
}

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
