// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QVariantMap>

#include <string>

namespace sparkout {

namespace report {

/// Where the works are done: what their title pages have beside the work. All of it may be empty.
struct Institution {
    std::string ministry;
    std::string university;
    std::string faculty; ///< or institute
    std::string department;
    std::string discipline;
    std::string accepted; ///< by whom: post and name
    std::string place;    ///< town

    friend bool operator==(const Institution&, const Institution&) = default;

    /// As settings keep it; what is empty is left out.
    [[nodiscard]] QVariantMap kept() const;
    [[nodiscard]] static Institution fromKept(const QVariantMap& kept);
};

} // namespace report

template <>
const StructInfo& tableOf<report::Institution>();

} // namespace sparkout
