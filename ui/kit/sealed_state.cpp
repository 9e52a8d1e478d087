// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/sealed_state.h"

#include <QCryptographicHash>
#include <QDataStream>
#include <QIODevice>

namespace sparkout {

namespace {

QByteArray checksum(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha1);
}

} // namespace

QByteArray sealed(const QList<QByteArray>& parts) {
    QByteArray body;
    QDataStream stream(&body, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_0);
    stream << parts;
    return checksum(body) + body;
}

std::optional<QList<QByteArray>> unsealed(const QByteArray& bytes, qsizetype count) {
    const qsizetype length = QCryptographicHash::hashLength(QCryptographicHash::Sha1);
    const QByteArray body = bytes.mid(length);
    if (body.isEmpty() || checksum(body) != bytes.left(length)) {
        return std::nullopt;
    }
    QDataStream stream(body);
    stream.setVersion(QDataStream::Qt_6_0);
    QList<QByteArray> parts;
    stream >> parts;
    return stream.status() == QDataStream::Ok && parts.size() == count ? std::optional(parts)
                                                                       : std::nullopt;
}

} // namespace sparkout
