// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/catalogue_store.h"

#include <QString>

#include <vector>

namespace sparkout {

/// One input that an entry of a catalogue gives.
struct CatalogueChange {
    const Field* field;
    std::string key; ///< within the entry's value: "stiffness_n_um/headstock"
    QString now;     ///< as the project has it, in the present language, without its unit
    QString then;    ///< as the entry gives it; "not known"
    bool changed;
    const ValueSource* source; ///< null for texts
};

/// In place of a value that an entry says is not known.
[[nodiscard]] QString notKnown();

/// What taking over an entry changes in a project, and what it leaves as it is, in the order of
/// the tables. The sources are the entry's own.
[[nodiscard]] std::vector<CatalogueChange> changesBy(const CatalogueEntry& entry,
                                                     const Project& project);

/// A value's source in words: the reference and its note, or that it is an estimate, with its
/// plausible range.
[[nodiscard]] QString sourceShown(const ValueSource& source, const Field& field, bool own);
/// The references of an entry, each once.
[[nodiscard]] QString sourcesShown(const CatalogueItem& item);

} // namespace sparkout
