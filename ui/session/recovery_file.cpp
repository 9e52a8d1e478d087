// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/recovery_file.h"

#include "core/project/project_file.h"
#include "ui/session/project_io.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace sparkout {

namespace {

const QString formatKey = QStringLiteral("format");
const QString format = QStringLiteral("sparkout-recovery");
const QString hashKey = QStringLiteral("sha256");
const QString titleKey = QStringLiteral("title");
const QString pathKey = QStringLiteral("path");
const QString whenKey = QStringLiteral("when");
const QString diskHashKey = QStringLiteral("disk_sha256");
const QString readOnlyKey = QStringLiteral("read_only");
const QString modifiedKey = QStringLiteral("modified");
constexpr std::size_t longestHeader = 64u << 10;

QByteArray hexOf(const QJsonObject& object, const QString& key) {
    return QByteArray::fromHex(object.value(key).toString().toLatin1());
}

} // namespace

std::string recoveryText(const RecoveryHeader& header, const Project& project) {
    const std::string text = writeProject(project);
    const QJsonObject object{
        {formatKey, format},
        {hashKey, QString::fromLatin1(contentHash(text).toHex())},
        {titleKey, header.title},
        {pathKey, header.path},
        {whenKey, header.when.toUTC().toString(Qt::ISODateWithMs)},
        {diskHashKey, QString::fromLatin1(header.diskHash.toHex())},
        {readOnlyKey, header.readOnly},
        {modifiedKey, header.modified},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString() + '\n' + text;
}

RecoveryContent readRecovery(std::string_view text) {
    RecoveryContent content;
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos || end > longestHeader) {
        return content;
    }
    const QJsonObject object =
        QJsonDocument::fromJson(QByteArray(text.data(), qsizetype(end))).object();
    if (object.value(formatKey).toString() != format) {
        return content;
    }
    content.header = {
        object.value(titleKey).toString(),
        object.value(pathKey).toString(),
        QDateTime::fromString(object.value(whenKey).toString(), Qt::ISODateWithMs),
        hexOf(object, diskHashKey),
        object.value(readOnlyKey).toBool(),
        object.value(modifiedKey).toBool(true),
    };
    const std::string_view body = text.substr(end + 1);
    if (contentHash(body) == hexOf(object, hashKey)) {
        content.project = parseProject(body).project;
    }
    return content;
}

} // namespace sparkout
