// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace sparkout {

namespace limits {
// Of a list whose row allows any number; what comes after is not even read.
inline constexpr std::size_t listItems = 1'000;     ///< objects, or rows of numbers
inline constexpr std::size_t listNumbers = 100'000; ///< numbers
inline constexpr std::size_t levels = 5'000;        ///< of a grid, listed
} // namespace limits

/// A key that was not given; whether it had to be is known once the whole project is read.
struct MissingKey {
    const Field* field;
    const void* owner;
    std::string path;
};

/// Fills a struct from a JSON object by its table: types and keys are checked here, ranges by
/// validate(). Keys named in `skip` are somebody else's.
void readByTable(const nlohmann::json& object, const StructInfo& table, void* owner,
                 const std::string& path, Issues& issues, std::vector<MissingKey>& missing,
                 const std::vector<std::string>& skip = {});

} // namespace sparkout
