// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/kept_texts.h"

#include <string>

namespace sparkout {

QString textIn(const Field& field, const void* owner) {
    return QString::fromStdString(field.as<std::string>(owner)).simplified();
}

QVariantMap keptTexts(const StructInfo& table, const void* owner) {
    QVariantMap kept;
    for (const Field& field : table.fields) {
        if (const QString text = textIn(field, owner); !text.isEmpty()) {
            kept.insert(QString::fromLatin1(field.key), text);
        }
    }
    return kept;
}

void readKeptTexts(const QVariantMap& kept, const StructInfo& table, void* owner) {
    for (const Field& field : table.fields) {
        const QString text = kept.value(QString::fromLatin1(field.key)).toString().simplified();
        field.as<std::string>(owner) =
            text.left(static_cast<qsizetype>(field.hard.high)).toStdString();
    }
}

} // namespace sparkout
