// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QVariantMap>

#include <span>

namespace sparkout {

struct CardEntries;

/// Company data in the heads of documents, in addition to the project. All of it may be empty.
struct Company {
    QString name;
    QString department;
    QString developed; ///< names of the signatories
    QString checked;
    QString agreed;
    QString standards; ///< name of the standards checker
    QString approved;
    QString designation;                  ///< designation of the document
    QString part;                         ///< designation of the part
    QString shop, area, place, operation; ///< numbers of shop, area, workplace and operation
    QByteArray logo;                      ///< contents of a file that satisfies Logo

    friend bool operator==(const Company&, const Company&) = default;

    /// Returns the company with the numbers that a project gives in place of its own.
    [[nodiscard]] Company with(const CardEntries& entries) const;
    /// Returns the form in which settings store it; empty texts are left out.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Company fromKept(const QVariantMap& kept);
};

/// A text of the company: its key in the settings and its label.
struct CompanyField {
    const char* key;
    QString Company::*value;
    const char* label; ///< in English, translated in the context Company
};
[[nodiscard]] std::span<const CompanyField> companyFields();

} // namespace sparkout
