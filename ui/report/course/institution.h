// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QVariantMap>

#include <string>

namespace sparkout {

namespace report {

/// The place of the works: additional data for their title pages. All may be empty.
struct Institution {
    std::string ministry;
    std::string university;
    std::string faculty; ///< or institute
    std::string department;
    std::string discipline;
    std::string accepted; ///< by whom: post and name
    std::string place;    ///< town

    friend bool operator==(const Institution&, const Institution&) = default;

    /// The form kept in the settings, without empty values.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Institution fromKept(const QVariantMap& kept);
};

} // namespace report

template <>
const StructInfo& tableOf<report::Institution>();

} // namespace sparkout
