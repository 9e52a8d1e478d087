// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

/// Shipped examples carry an English title and notes in both languages.
namespace sparkout {

/// The title of a shipped example, or the name of its part, of a surface or of a kept run, in the
/// program's language; another text as it is.
[[nodiscard]] QString exampleTitle(const std::string& title);
/// Those paragraphs of its notes that are in the program's language, without the verdict written
/// down for the tests; all, if none is.
[[nodiscard]] QString exampleNotes(const std::string& notes);

} // namespace sparkout
