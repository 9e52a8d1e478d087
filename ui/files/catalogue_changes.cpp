// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/catalogue_changes.h"

#include "core/catalogue/catalogue_check.h"
#include "core/format/table_reader.h"
#include "core/format/table_writer.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/wheel.h"
#include "ui/text/number_text.h"
#include "ui/text/source_names.h"
#include "ui/text/texts.h"

#include <nlohmann/json.hpp>

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

QString inWords(const char* text) {
    return QCoreApplication::translate("Catalogue", text);
}

const Material& valueIn(const Project& project, const MaterialEntry&) {
    return *project.material;
}
const Wheel& valueIn(const Project& project, const WheelEntry&) {
    return *project.wheel;
}
const Machine& valueIn(const Project& project, const MachineEntry&) {
    return *project.machine;
}

/// A note with the keys of sources in words.
QString withSourceNames(QString note) {
    static const QRegularExpression key(QStringLiteral("\\b[A-Z][A-Z0-9]{5,}\\b"));
    for (auto found = key.match(note); found.hasMatch();) {
        const QString name = sourceText(found.captured().toStdString());
        const QString text = name.isEmpty() ? found.captured() : name;
        note.replace(found.capturedStart(), found.capturedLength(), text);
        found = key.match(note, found.capturedStart() + text.size());
    }
    return note;
}

QString shown(const ordered_json& value, const Field& field) {
    if (value.is_null()) {
        return *field.nullMeaning ? inputText(field.nullMeaning)
                                  : inWords(QT_TRANSLATE_NOOP("Catalogue", "not given"));
    }
    if (value.is_number()) {
        return printedNumber(value.get<double>());
    }
    for (const Choice& choice : field.choices) {
        if (value == choice.key) {
            return choiceText(choice.label);
        }
    }
    if (value.is_string()) {
        return QString::fromStdString(value.get<std::string>());
    }
    QStringList parts;
    for (const ordered_json& part : value) {
        parts += shown(part, field);
    }
    return parts.join(QStringLiteral("; "));
}

/// Visits the given values together with the current ones.
struct Walk {
    const CatalogueEntry& entry;
    std::vector<CatalogueChange>& changes;

    void through(const StructInfo& table, const ordered_json& given, const ordered_json& present,
                 const std::string& prefix) {
        for (const Field& field : table.fields) {
            const auto found = given.find(field.key);
            const std::string key = prefix + field.key;
            const ValueSource* const source = sourceOf(sourcesOf(entry), key);
            if (found == given.end() && !source) {
                continue;
            }
            const ordered_json now = present.is_object() && present.contains(field.key)
                                         ? present.at(field.key)
                                         : ordered_json();
            if (found == given.end()) {
                changes.push_back(
                    {&field, key, shown(now, field), notKnown(), !now.is_null(), source});
            } else if (field.nested && found->is_object()) {
                through(*field.nested, *found, now, key + "/");
            } else {
                changes.push_back(
                    {&field, key, shown(now, field), shown(*found, field), now != *found, source});
            }
        }
    }
};

} // namespace

QString notKnown() {
    return inWords(QT_TRANSLATE_NOOP("Catalogue", "not known"));
}

std::vector<CatalogueChange> changesBy(const CatalogueEntry& entry, const Project& project) {
    std::vector<CatalogueChange> changes;
    std::visit(
        [&](const auto& e) {
            const StructInfo& table = tableOf<std::decay_t<decltype(e.value)>>();
            const ordered_json given =
                catalogue::givenPart(writeByTable(table, &e.value), table, e.sources);
            Walk{entry, changes}.through(table, given, writeByTable(table, &valueIn(project, e)),
                                         {});
        },
        entry);
    return changes;
}

QString sourceShown(const ValueSource& source, const Field& field, bool own) {
    const bool russian = QLocale().language() == QLocale::Russian && !source.note_ru.empty();
    const QString note =
        withSourceNames(QString::fromStdString(russian ? source.note_ru : source.note));
    QStringList parts;
    if (!isEstimate(source)) {
        const QString text = sourceText(source.source);
        parts += text.isEmpty() ? QString::fromStdString(source.source) : text;
    } else if (note.isEmpty()) {
        parts += own ? inWords(QT_TRANSLATE_NOOP("Catalogue", "own value"))
                     : inWords(QT_TRANSLATE_NOOP("Catalogue", "estimate, to be calibrated"));
    }
    parts += note;
    QString text = joined(parts, QStringLiteral("; "));
    if (source.range && source.range->size() == 2) {
        text += QStringLiteral(" (%1)").arg(
            rangeBrief({source.range->front(), source.range->back()}, field.unit));
    }
    return text;
}

QString sourcesShown(const CatalogueItem& item) {
    QStringList texts;
    bool estimates = false;
    for (const ValueSource& source : sourcesOf(item.entry)) {
        estimates = estimates || isEstimate(source);
        const QString text = sourceText(source.source);
        if (!text.isEmpty() && !texts.contains(text)) {
            texts += text;
        }
    }
    if (estimates) {
        texts += item.own ? inWords(QT_TRANSLATE_NOOP("Catalogue", "own values"))
                          : inWords(QT_TRANSLATE_NOOP("Catalogue", "estimates"));
    }
    return texts.join(QStringLiteral("; "));
}

} // namespace sparkout
