// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QByteArray>
#include <QVariantMap>

#include <string>

namespace sparkout {

struct CardEntries;

/// Company data in the heads of documents, in addition to the project. All of it may be empty.
struct CompanyTexts {
    std::string name;
    std::string department;
    std::string developed; ///< names of the signatories
    std::string checked;
    std::string agreed;
    std::string standards; ///< name of the standards checker
    std::string approved;
    std::string designation;                  ///< designation of the document
    std::string part;                         ///< designation of the part
    std::string shop, area, place, operation; ///< numbers of shop, area, workplace and operation

    friend bool operator==(const CompanyTexts&, const CompanyTexts&) = default;
};

/// The texts and the logo of a company.
struct Company : CompanyTexts {
    QByteArray logo; ///< contents of a file that satisfies Logo

    friend bool operator==(const Company&, const Company&) = default;

    /// Returns the company with the numbers that a project gives in place of its own.
    [[nodiscard]] Company with(const CardEntries& entries) const;
    /// Returns the form in which settings store it; empty texts are left out.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Company fromKept(const QVariantMap& kept);
};

template <>
const StructInfo& tableOf<CompanyTexts>();

} // namespace sparkout
