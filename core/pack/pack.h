// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue_entry.h"
#include "core/lesson/lesson.h"

#include <cstddef>
#include <map>
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

} // namespace sparkout
