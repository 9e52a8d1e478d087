// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <string>

namespace sparkout {

/// A text in both languages of the program; if only one is given, both are the same.
struct Bilingual {
    std::string ru, en;

    [[nodiscard]] bool empty() const { return ru.empty() && en.empty(); }
    [[nodiscard]] const std::string& in(bool russian) const {
        return (russian ? ru : en).empty() ? (russian ? en : ru) : (russian ? ru : en);
    }
    friend bool operator==(const Bilingual&, const Bilingual&) = default;
};

template <>
const StructInfo& tableOf<Bilingual>();

} // namespace sparkout
