// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"

#include <QString>

#include <memory>
#include <variant>
#include <vector>

namespace sparkout {

/// A text in its form for searching: case, ё and е, decimal comma and point, and letters that look
/// alike in Cyrillic and Latin (25А and 25A, 500×50 and 500x50) make no difference.
[[nodiscard]] QString searchForm(const QString& text);

/// A grade in Latin letters, as used in papers: ШХ15 → ShKh15.
[[nodiscard]] QString inLatinLetters(const QString& text);

/// Whether a text in its search form contains every word of a query.
[[nodiscard]] bool matchesQuery(const QString& searchFormOfText, const QString& query);

enum class CatalogueKind { materials, wheels, machines };

using CatalogueEntry = std::variant<MaterialEntry, WheelEntry, MachineEntry>;

[[nodiscard]] QString entryName(const CatalogueEntry& entry);
[[nodiscard]] QString entryNote(const CatalogueEntry& entry); ///< translated
[[nodiscard]] const std::vector<ValueSource>& sourcesOf(const CatalogueEntry& entry);
/// The project with the values of an entry.
[[nodiscard]] Project withEntry(const CatalogueEntry& entry, Project project);

struct CatalogueItem {
    CatalogueEntry entry;
    bool own = false; ///< the user's, not a shipped one
    QString search;   ///< searchable text, in its search form
};

/// A catalogue: the shipped entries and the user's own. These have a file of their own; entries
/// written there by another window are kept. An unreadable file is never written.
class CatalogueStore {
public:
    /// Without a folder the own entries are lost with this object.
    [[nodiscard]] static std::unique_ptr<CatalogueStore> make(CatalogueKind kind,
                                                              const QString& folder);
    virtual ~CatalogueStore() = default;

    [[nodiscard]] CatalogueKind kind() const { return m_kind; }
    [[nodiscard]] const QString& ownFile() const { return m_ownFile; }
    [[nodiscard]] const std::vector<CatalogueItem>& items() const { return m_items; }
    [[nodiscard]] bool hasOwn(const QString& name) const;
    /// The reason why the own entries cannot be read; empty if they can.
    [[nodiscard]] const QString& fault() const { return m_fault; }

    virtual void refresh() = 0; ///< reads the user's file
    /// Renames an unreadable file, so that a new one can be begun. @param[out] aside the new name,
    /// on success
    [[nodiscard]] QString putAside(QString& aside);

    // Each returns the reason why nothing was written; empty on success. Saves the project's values
    // under a name, replacing an own entry with that name.
    [[nodiscard]] virtual QString save(const Project& project, const QString& name) = 0;
    /// Saves entries of this kind unchanged, each replacing the user's entry with its name.
    [[nodiscard]] virtual QString keep(const std::vector<CatalogueEntry>& entries) = 0;
    [[nodiscard]] virtual QString rename(const QString& from, const QString& to) = 0;
    [[nodiscard]] virtual QString remove(const QString& name) = 0;

protected:
    CatalogueStore(CatalogueKind kind, const QString& folder);

    CatalogueKind m_kind;
    QString m_ownFile;
    std::vector<CatalogueItem> m_items;
    QString m_fault;
};

/// An input given by a catalogue entry.
struct CatalogueChange {
    const Field* field;
    std::string key; ///< within the entry's value: "stiffness_n_um/headstock"
    QString now;     ///< value in the project, translated, without its unit
    QString then;    ///< value in the entry; "not known"
    bool changed;
    const ValueSource* source; ///< null for texts, and for what the entry lacks
};

/// Shown for a value that is unknown to an entry.
[[nodiscard]] QString notKnown();

/// The changes to a project by applying an entry, and the unchanged values, in the order of the
/// tables. The sources are those of the entry.
[[nodiscard]] std::vector<CatalogueChange> changesBy(const CatalogueEntry& entry,
                                                     const Project& project);

/// A value's source as text: the reference and its note, or "estimate", with its plausible range.
[[nodiscard]] QString sourceShown(const ValueSource& source, const Field& field, bool own);
/// The references of an entry, each once.
[[nodiscard]] QString sourcesShown(const CatalogueItem& item);

} // namespace sparkout
