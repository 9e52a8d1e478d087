// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/recovery_file.h"

#include "core/setup/setup_file.h"
#include "ui/session/project_io.h"

#include <QJsonArray>
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
const QString openKey = QStringLiteral("open");
constexpr std::size_t longestHeader = 64u << 10;

QByteArray hexOf(const QJsonObject& object, const QString& key) {
    return QByteArray::fromHex(object.value(key).toString().toLatin1());
}

QByteArray hashOf(std::string_view text, const std::vector<std::string>& open) {
    if (open.empty()) {
        return contentHash(text);
    }
    std::string all(text);
    for (const std::string& path : open) {
        all += path + '\n';
    }
    return contentHash(all);
}

/// The line before the project's text; empty if there is none.
std::string_view headOf(std::string_view text) {
    const std::size_t end = text.find('\n');
    return end == std::string_view::npos || end > longestHeader ? std::string_view()
                                                                : text.substr(0, end);
}

} // namespace

std::string recoveryText(const RecoveryHeader& header, const Setup& setup) {
    const std::string text = writeSetup(setup);
    QJsonArray open;
    for (const std::string& path : header.open) {
        open.append(QString::fromStdString(path));
    }
    const QJsonObject object{
        {formatKey, format},
        {hashKey, QString::fromLatin1(hashOf(text, header.open).toHex())},
        {titleKey, header.title},
        {pathKey, header.path},
        {whenKey, header.when.toUTC().toString(Qt::ISODateWithMs)},
        {diskHashKey, QString::fromLatin1(header.diskHash.toHex())},
        {readOnlyKey, header.readOnly},
        {modifiedKey, header.modified},
        {openKey, open},
    };
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString() + '\n' + text;
}

RecoveryGlance glanceAtRecovery(std::string_view text) {
    RecoveryGlance glance;
    const std::string_view head = headOf(text);
    const QJsonObject object =
        QJsonDocument::fromJson(QByteArray(head.data(), qsizetype(head.size()))).object();
    if (object.value(formatKey).toString() != format) {
        return glance;
    }
    glance.header = {
        object.value(titleKey).toString(),
        object.value(pathKey).toString(),
        QDateTime::fromString(object.value(whenKey).toString(), Qt::ISODateWithMs),
        hexOf(object, diskHashKey),
        object.value(readOnlyKey).toBool(),
        object.value(modifiedKey).toBool(true),
    };
    for (const QJsonValue& path : object.value(openKey).toArray()) {
        glance.header.open.push_back(path.toString().toStdString());
    }
    glance.whole =
        hashOf(text.substr(head.size() + 1), glance.header.open) == hexOf(object, hashKey);
    return glance;
}

RecoveryContent readRecovery(std::string_view text) {
    RecoveryGlance glance = glanceAtRecovery(text);
    RecoveryContent content{std::move(glance.header), std::nullopt};
    if (glance.whole) {
        content.setup = parseProject(text.substr(headOf(text).size() + 1)).setup;
    }
    return content;
}

} // namespace sparkout
