// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pack/pack.h"
#include "ui/files/catalogue_store.h"
#include "ui/session/company.h"

#include <QCoreApplication>
#include <QString>

#include <vector>

namespace sparkout {

/// The parts of a pack, as texts and types of the window.
enum class PackPart { machine, wheel, material, company, lesson };

class PackParts {
    Q_DECLARE_TR_FUNCTIONS(PackParts)

public:
    [[nodiscard]] static QString name(PackPart part); ///< "Machine"

    [[nodiscard]] static std::vector<CatalogueEntry> entries(const Pack& pack, PackPart part);
    static void add(const CatalogueEntry& entry, Pack& pack);

    /// The document heads of a pack, without unknown keys and without a refused logo. Its picture
    /// is not decoded.
    [[nodiscard]] static Company company(const Pack& pack);
    [[nodiscard]] static QString logoFault(const Pack& pack);   ///< empty: its logo is valid
    static void setCompany(const Company& company, Pack& pack); ///< without a refused logo

    /// The title of a lesson in the window's language.
    [[nodiscard]] static QString title(const Lesson& lesson);
};

/// The kind of catalogue of a part that is an entry of one.
[[nodiscard]] CatalogueKind kindOf(PackPart part);

} // namespace sparkout
