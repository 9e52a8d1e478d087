// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/catalogue_store.h"

#include "core/catalogue/catalogue_check.h"
#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "core/file/struct_json.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/wheel.h"
#include "core/sha256.h"
#include "ui/session/background.h"
#include "ui/session/guarded_file.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>

namespace sparkout {

QString searchForm(const QString& text) {
    static const QString cyrillic = QStringLiteral("авекмнорстухё×,");
    static const QString latin = QStringLiteral("abekmhopctyxex.");
    QString form = text.toLower();
    for (QChar& letter : form) {
        if (const qsizetype at = cyrillic.indexOf(letter); at >= 0) {
            letter = latin[at];
        }
    }
    return form;
}

QString inLatinLetters(const QString& text) {
    static const QString cyrillic = QStringLiteral("абвгдеёжзийклмнопрстуфхцчшщъыьэюя");
    static const QStringList latin =
        QStringLiteral("a b v g d e e zh z i y k l m n o p r s t u f kh ts ch sh shch _ y _ e yu "
                       "ya")
            .split(u' ');
    QString result;
    for (const QChar letter : text) {
        const qsizetype at = cyrillic.indexOf(letter.toLower());
        QString sound = at < 0 ? QString(letter) : latin[at];
        if (at >= 0 && letter.isUpper()) {
            sound[0] = sound[0].toUpper();
        }
        result += sound.remove(u'_');
    }
    return result;
}

bool matchesQuery(const QString& searchFormOfText, const QString& query) {
    const QStringList words = searchForm(query).split(u' ', Qt::SkipEmptyParts);
    return std::all_of(words.begin(), words.end(), [&searchFormOfText](const QString& word) {
        return searchFormOfText.contains(word);
    });
}

namespace {

QString fileOf(CatalogueKind kind) {
    static constexpr const char* fileNames[] = {"materials.json", "wheels.json", "machines.json"};
    return QString::fromLatin1(fileNames[static_cast<int>(kind)]);
}

const char* keyOf(CatalogueKind kind) {
    static constexpr const char* keys[] = {"material", "wheel", "machine"};
    return keys[static_cast<int>(kind)];
}

/// Why a catalogue's text is refused: its first fault, with the input if it concerns one.
QString faultText(const Issues& issues, CatalogueKind kind) {
    const auto first = std::find_if(issues.begin(), issues.end(), [](const Issue& issue) {
        return issue.severity == Severity::error;
    });
    if (first == issues.end()) {
        return {};
    }
    static const std::string value = "/value/";
    const std::size_t at = first->path.find(value);
    const QString place = at == std::string::npos
                              ? QString::fromStdString(first->path)
                              : locationText(std::string("/") + keyOf(kind) + "/"
                                             + first->path.substr(at + value.size()));
    return place.isEmpty() ? issueText(*first) : place + QStringLiteral(": ") + issueText(*first);
}

/// Name, both notes, grade or marking, and the sources.
template <class Entry>
QString searchFormOf(const Entry& entry) {
    const QString name = QString::fromStdString(entry.name);
    QString all = name + u' ' + inLatinLetters(name);
    for (const std::string* text : {&entry.note, &entry.note_ru}) {
        all += u' ' + QString::fromStdString(*text);
    }
    if constexpr (std::is_same_v<Entry, MaterialEntry>) {
        all += u' ' + QString::fromStdString(entry.value.grade);
    } else if constexpr (std::is_same_v<Entry, WheelEntry>) {
        all += u' ' + QString::fromStdString(entry.value.marking);
    } else {
        all += u' ' + QString::fromStdString(entry.value.name);
    }
    for (const ValueSource& source : entry.sources) {
        all += u' ' + sourceText(source.source);
    }
    return searchForm(all);
}

template <class Entry>
class Store : public CatalogueStore {
public:
    Store(CatalogueKind kind, const QString& folder) : CatalogueStore(kind, folder) {
        QFile file(QStringLiteral(":/catalogue/") + fileOf(kind));
        if (file.open(QIODevice::ReadOnly)) {
            const QByteArray text = file.readAll();
            m_shipped = readCatalogue<Entry>({text.constData(), std::size_t(text.size())})
                            .entries.value_or(std::vector<Entry>());
        }
        refresh();
    }

    void refresh() override {
        if (!m_ownFile.isEmpty()) {
            readOwn();
        }
        m_items.clear();
        for (const Entry& entry : mergedEntries(m_shipped, m_own)) {
            const bool own = std::any_of(m_own.begin(), m_own.end(), [&](const Entry& mine) {
                return mine.name == entry.name;
            });
            m_items.push_back({entry, own, searchFormOf(entry)});
        }
    }

    QString save(const Project& project, const QString& name) override {
        return keep({entryOf<Entry>(project, name.toStdString())});
    }

    QString keep(const std::vector<CatalogueEntry>& entries) override {
        return change([&](std::vector<Entry>& own) {
            for (const CatalogueEntry& each : entries) {
                const auto& entry = std::get<Entry>(each);
                const auto old = find(own, entryName(each));
                if (old == own.end()) {
                    own.push_back(entry);
                } else {
                    *old = entry;
                }
            }
        });
    }

    QString rename(const QString& from, const QString& to) override {
        return change([&](std::vector<Entry>& own) {
            if (const auto entry = find(own, from); entry != own.end()) {
                entry->name = to.toStdString();
            }
        });
    }

    QString remove(const QString& name) override {
        return change([&](std::vector<Entry>& own) {
            if (const auto entry = find(own, name); entry != own.end()) {
                own.erase(entry);
            }
        });
    }

private:
    static auto find(std::vector<Entry>& entries, const QString& name) {
        return std::find_if(entries.begin(), entries.end(),
                            [&](const Entry& entry) { return entry.name == name.toStdString(); });
    }

    void readOwn() {
        m_own.clear();
        m_fault.clear();
        m_sha256.clear();
        std::variant<std::string, FileError> bytes;
        runAside([&] { bytes = readFile(systemPath(m_ownFile), limits::fileBytes); });
        if (const auto* error = std::get_if<FileError>(&bytes)) {
            if (error->systemError != ENOENT && error->systemError != ENOTDIR) {
                m_fault = readErrorText(*error);
            }
            return; // no file: no own entries yet
        }
        m_sha256 = sha256(std::get<std::string>(bytes));
        CatalogueRead<Entry> read = readCatalogue<Entry>(std::get<std::string>(bytes));
        if (read.entries) {
            m_own = std::move(*read.entries);
        } else {
            m_fault = faultText(read.issues, m_kind);
        }
    }

    /// Merges a change into the entries that the file has now, since another window may have
    /// written it.
    template <class Change>
    QString change(Change apply) {
        std::vector<Entry> own;
        QString refused;
        const auto changed = [&]() -> std::optional<GuardedFile::Amendment> {
            refresh();
            own = m_own;
            apply(own);
            auto text = checkedCatalogue(own);
            const auto* issues = std::get_if<Issues>(&text);
            refused = !m_fault.isEmpty() ? m_fault
                      : issues           ? faultText(*issues, m_kind)
                                         : QString();
            if (!refused.isEmpty()) {
                return std::nullopt;
            }
            return GuardedFile::Amendment{
                m_sha256,
                issues ? std::nullopt : std::optional(std::get<std::string>(std::move(text)))};
        };
        if (m_ownFile.isEmpty()) {
            (void)changed();
        } else if (const auto error =
                       GuardedFile::amend(m_ownFile, GuardedFile::Waiting::aside, changed)) {
            refused = saveErrorText(*error);
        }
        if (refused.isEmpty()) {
            m_own = std::move(own);
        }
        refresh();
        return refused;
    }

    std::vector<Entry> m_shipped, m_own;
    std::string m_sha256; ///< hash of the file with the own entries as read; empty without a file
};

} // namespace

QString entryName(const CatalogueEntry& entry) {
    return std::visit([](const auto& e) { return QString::fromStdString(e.name); }, entry);
}

QString entryNote(const CatalogueEntry& entry) {
    return std::visit(
        [](const auto& e) {
            const bool russian = QLocale().language() == QLocale::Russian && !e.note_ru.empty();
            return QString::fromStdString(russian ? e.note_ru : e.note);
        },
        entry);
}

const std::vector<ValueSource>& sourcesOf(const CatalogueEntry& entry) {
    return std::visit([](const auto& e) -> const std::vector<ValueSource>& { return e.sources; },
                      entry);
}

Project withEntry(const CatalogueEntry& entry, Project project) {
    std::visit([&project](const auto& e) { applyEntry(e, project); }, entry);
    return project;
}

CatalogueStore::CatalogueStore(CatalogueKind kind, const QString& folder)
    : m_kind(kind)
    , m_ownFile(folder.isEmpty() ? QString()
                                 : folder + QStringLiteral("/catalogue/") + fileOf(kind)) {}

std::unique_ptr<CatalogueStore> CatalogueStore::make(CatalogueKind kind, const QString& folder) {
    switch (kind) {
    case CatalogueKind::materials: return std::make_unique<Store<MaterialEntry>>(kind, folder);
    case CatalogueKind::wheels: return std::make_unique<Store<WheelEntry>>(kind, folder);
    case CatalogueKind::machines: return std::make_unique<Store<MachineEntry>>(kind, folder);
    }
    return nullptr;
}

bool CatalogueStore::hasOwn(const QString& name) const {
    return std::any_of(m_items.begin(), m_items.end(), [&name](const CatalogueItem& item) {
        return item.own && entryName(item.entry) == name;
    });
}

QString CatalogueStore::putAside(QString& aside) {
    const auto moved = sparkout::putAside(systemPath(m_ownFile));
    if (const auto* error = std::get_if<FileError>(&moved)) {
        return saveErrorText(*error);
    }
    aside = QString::fromStdString(utf8(std::get<std::filesystem::path>(moved)));
    refresh();
    return {};
}

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
            if (found == given.end()) {
                continue;
            }
            const ValueSource* const source = sourceOf(sourcesOf(entry), key);
            const ordered_json now = present.is_object() && present.contains(field.key)
                                         ? present.at(field.key)
                                         : ordered_json();
            if (found->is_null()) {
                if (source || !now.is_null()) {
                    changes.push_back({&field, key, shown(now, field),
                                       source ? notKnown() : shown(*found, field), !now.is_null(),
                                       source});
                }
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
                catalogue::appliedPart(writeByTable(table, &e.value), table, e.sources);
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
