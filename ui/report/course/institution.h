// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariantMap>

#include <span>

namespace sparkout::report {

/// Where the works are done: what their title pages have beside the work. All of it may be empty.
struct Institution {
    QString ministry;
    QString university;
    QString faculty; ///< or institute
    QString department;
    QString discipline;
    QString acceptedBy; ///< post and name
    QString place;      ///< town

    friend bool operator==(const Institution&, const Institution&) = default;

    /// As settings keep it; what is empty is left out.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Institution fromKept(const QVariantMap& kept);
};

/// A text of it: its key in the settings and its name.
struct InstitutionField {
    const char* key;
    QString Institution::*value;
    const char* label; ///< in English, to be translated in the context Institution
};
[[nodiscard]] std::span<const InstitutionField> institutionFields();

} // namespace sparkout::report
