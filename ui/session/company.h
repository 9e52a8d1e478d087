// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QVariantMap>

#include <span>

namespace sparkout {

struct CardEntries;

/// Who makes the documents: what their heads have beside the project. All of it may be empty.
struct Company {
    QString name;
    QString department;
    QString developed; ///< names of those who sign
    QString checked;
    QString agreed;
    QString standards; ///< who checks against the standards
    QString approved;
    QString designation;                  ///< of the document
    QString part;                         ///< designation of the part
    QString shop, area, place, operation; ///< their numbers
    QByteArray logo; ///< the bytes of a file; refused unless it is as Logo says

    friend bool operator==(const Company&, const Company&) = default;

    /// With the numbers that a project gives in place of its own.
    [[nodiscard]] Company with(const CardEntries& entries) const;
    /// As settings keep it; what is empty is left out.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Company fromKept(const QVariantMap& kept);
};

/// A text of it: its key in the settings and its name.
struct CompanyField {
    const char* key;
    QString Company::*value;
    const char* label; ///< in English, to be translated in the context Company
};
[[nodiscard]] std::span<const CompanyField> companyFields();

} // namespace sparkout
