// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"

#include <QString>

#include <memory>
#include <variant>
#include <vector>

namespace sparkout {

enum class CatalogueKind { materials, wheels, machines };

using CatalogueEntry = std::variant<MaterialEntry, WheelEntry, MachineEntry>;

[[nodiscard]] QString entryName(const CatalogueEntry& entry);
[[nodiscard]] QString entryNote(const CatalogueEntry& entry); ///< in the present language
[[nodiscard]] const std::vector<ValueSource>& sourcesOf(const CatalogueEntry& entry);
/// The project with what an entry gives.
[[nodiscard]] Project withEntry(const CatalogueEntry& entry, Project project);

struct CatalogueItem {
    CatalogueEntry entry;
    bool own = false; ///< the user's, not a shipped one
    QString search;   ///< all one may look it up by, in its search form
};

/// A catalogue: the shipped entries and the user's own. Those stand in a file of their own; what
/// another window has written there meanwhile, until the moment of writing, is kept. A file that
/// cannot be read is never written.
class CatalogueStore {
public:
    /// Without a folder the own entries live as long as this does.
    [[nodiscard]] static std::unique_ptr<CatalogueStore> make(CatalogueKind kind,
                                                              const QString& folder);
    virtual ~CatalogueStore() = default;

    [[nodiscard]] CatalogueKind kind() const { return m_kind; }
    [[nodiscard]] const QString& ownFile() const { return m_ownFile; }
    [[nodiscard]] const std::vector<CatalogueItem>& items() const { return m_items; }
    [[nodiscard]] bool hasOwn(const QString& name) const;
    /// Why the own entries cannot be read, in words; empty when they can.
    [[nodiscard]] const QString& fault() const { return m_fault; }

    virtual void refresh() = 0; ///< reads the user's file
    /// Moves an unreadable file to a name that is free, so that a new one can be begun.
    /// @param[out] aside that name, where it succeeds
    [[nodiscard]] QString putAside(QString& aside);

    // Each says in words why nothing was written; empty when it was.
    /// Keeps what the project has under a name; in place of an own entry of that name.
    [[nodiscard]] virtual QString save(const Project& project, const QString& name) = 0;
    /// Keeps entries of this kind as they are, each in place of an own one of its name.
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

} // namespace sparkout
