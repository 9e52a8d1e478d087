// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

/// Shipped examples carry an English title and notes in both languages.
namespace sparkout {

/// The title of a shipped example, or the name of its part, of a surface or of a kept run, in the
/// program's language; another text as it is.
[[nodiscard]] QString exampleTitle(const std::string& title);
/// What the program calls a kept run by itself. Files hold it in English, as the titles of
/// examples.
enum class GivenName { run, worstPart };
[[nodiscard]] std::string givenRunName(GivenName kind, const QString& number); ///< "Run 3"
/// The name of a kept run in the program's language: of an example, or one that the program gave,
/// also with the number of its repetition, "Run 3 (2)"; one that was typed as it is.
[[nodiscard]] QString runName(const std::string& name);
/// Those paragraphs of its notes that are in the program's language, without the verdict written
/// down for the tests; all, if none is.
[[nodiscard]] QString exampleNotes(const std::string& notes);

} // namespace sparkout
