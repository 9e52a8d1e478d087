// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/catalogue_store.h"

#include <QString>

#include <vector>

namespace sparkout {

/// An input given by a catalogue entry.
struct CatalogueChange {
    const Field* field;
    std::string key; ///< within the entry's value: "stiffness_n_um/headstock"
    QString now;     ///< value in the project, translated, without its unit
    QString then;    ///< value in the entry; "not known"
    bool changed;
    const ValueSource* source; ///< null for texts
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
