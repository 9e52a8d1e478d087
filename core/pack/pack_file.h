// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/pack/pack.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// The file of a pack, `.sparkout-pack`: one UTF-8 JSON text. Its "machines", "wheels" and
/// "materials" are catalogues, and its "lessons" lessons, each as in a file of its own.
namespace sparkout {

inline constexpr const char* packFormat = "sparkout-pack";
inline constexpr int packVersion = 1;

namespace limits {
inline constexpr std::size_t packText = 1000;      ///< bytes of a title
inline constexpr std::size_t packNote = 4000;      ///< bytes of a note
inline constexpr std::size_t packLessons = 100;    ///< lessons in one pack
inline constexpr std::size_t logoText = 1'400'000; ///< letters of base64: of a megabyte
} // namespace limits

struct ReadPack {
    std::optional<Pack> pack; ///< given without errors
    Issues issues;
};

/// Reads a pack strictly: every part like its own file; two entries or lessons with one name and
/// lesson names that are not plain file names are faults. Returns all faults at once.
[[nodiscard]] ReadPack readPack(std::string_view text);

/// The text of a pack: equal packs give equal bytes; empty parts are omitted.
[[nodiscard]] std::string writePack(const Pack& pack);

} // namespace sparkout
