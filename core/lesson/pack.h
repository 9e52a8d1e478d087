// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"
#include "core/issue.h"
#include "core/lesson/lesson.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Data that a shop or a class passes on in one file: entries of the catalogues, the heads of
/// documents and lessons. Nothing in it is run.
namespace sparkout {

/// A lesson and the file it came from.
struct PackedLesson {
    std::string file; ///< file name without a folder, see isLessonFileName()
    Lesson lesson;
};

struct Pack {
    std::string title, note;
    std::vector<MachineEntry> machines;
    std::vector<WheelEntry> wheels;
    std::vector<MaterialEntry> materials;
    std::map<std::string, std::string> company; ///< texts of the heads of documents by their keys
    std::string logo;                           ///< a PNG or JPEG file in base64
    std::vector<PackedLesson> lessons;

    /// Number of entries, lessons, and the company's data, which count as one.
    [[nodiscard]] std::size_t count() const;
};

/// Whether a text is a plain lesson file name on every system: no folder, no character that Windows
/// refuses, suffix `.sparkout-lesson`, at most 120 bytes.
[[nodiscard]] bool isLessonFileName(std::string_view name);

// The file of a pack, `.sparkout-pack`: one UTF-8 JSON text. Its "machines", "wheels" and
// "materials" are catalogues, and its "lessons" lessons, each as in a file of its own.

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
