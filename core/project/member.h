// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Finding a member of a project, or of any struct that has a table, by its JSON pointer.

namespace sparkout {

/// A value of a struct without further rows: its path, its row and the struct that has it as a
/// member. For a list of structs the number of items is such a value, too.
struct Leaf {
    std::string path; ///< "/cycle/stages/0/stock_mm"
    const Field* field;
    const void* owner;
};

/// All values below a struct in the order of its table; for a struct that is not given only its
/// row.
[[nodiscard]] std::vector<Leaf> leavesOf(const StructInfo& table, const void* owner);

/// A member: its row and the struct that holds it; both null if not found.
struct Member {
    const Field* field = nullptr;
    void* owner = nullptr;
    explicit operator bool() const { return owner != nullptr; }
};

struct ConstMember {
    const Field* field = nullptr;
    const void* owner = nullptr;
    explicit operator bool() const { return owner != nullptr; }
    [[nodiscard]] bool relevant(const Project& project) const {
        return !field->relevant || field->relevant(project, owner);
    }
};

/// The member at a path such as "/wheel/width_mm". Optional structs on the way are created if
/// `create` is true.
[[nodiscard]] Member findMember(Project& project, std::string_view path, bool create = false);

/// The member for reading; optional structs that are not given answer with their defaults.
[[nodiscard]] ConstMember findMember(const Project& project, std::string_view path);

/// The member at a path of any struct; nothing is created, and a member below an optional struct
/// that is not given has no owner.
[[nodiscard]] Member memberIn(const StructInfo& table, void* root, std::string_view path);
[[nodiscard]] ConstMember memberIn(const StructInfo& table, const void* root,
                                   std::string_view path);

/// The value of a row of numbers; empty if it is not given.
[[nodiscard]] std::optional<double> numberIn(const Field& field, const void* owner);
void setNumberIn(const Field& field, void* owner, std::optional<double> value);

/// The row nearest to a path, which may point into a value ("/machine/compliance_mm_per_n/rz1").
[[nodiscard]] const Field* nearestField(const Project& project, std::string_view path);

} // namespace sparkout
