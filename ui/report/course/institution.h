// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariantMap>

#include <span>

namespace sparkout::report {

/// The place of the works: additional data for their title pages. All may be empty.
struct Institution {
    QString ministry;
    QString university;
    QString faculty; ///< or institute
    QString department;
    QString discipline;
    QString acceptedBy; ///< post and name
    QString place;      ///< town

    friend bool operator==(const Institution&, const Institution&) = default;

    /// The form kept in the settings, without empty values.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Institution fromKept(const QVariantMap& kept);
};

/// A text of the institution: its key in the settings and its label.
struct InstitutionField {
    const char* key;
    QString Institution::*value;
    const char* label; ///< in English, translated in the context Institution
};
[[nodiscard]] std::span<const InstitutionField> institutionFields();

} // namespace sparkout::report
