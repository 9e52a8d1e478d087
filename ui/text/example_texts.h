// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <string>

/// Shipped examples carry an English title and notes in both languages.
namespace sparkout {

/// The names of the shipped files in the order of the gallery. The program begins with the first
/// one where no file is given.
[[nodiscard]] QStringList exampleFiles();
/// The title of a shipped example, or the name of its part, of a surface or of a kept run, in the
/// program's language; any other text unchanged.
[[nodiscard]] QString exampleTitle(const std::string& title);
/// The names that the program gives to kept runs. Files have them in English, like the titles of
/// examples.
enum class GivenName { run, worstPart };
[[nodiscard]] std::string givenRunName(GivenName kind, const QString& number); ///< "Run 3"
/// The name of a kept run in the program's language, if it belongs to an example or was given by
/// the program, also with the number of its repetition, "Run 3 (2)"; a typed name unchanged.
[[nodiscard]] QString runName(const std::string& name);
/// The paragraphs of its notes in the program's language, without the verdict for the tests; all if
/// there are none.
[[nodiscard]] QString exampleNotes(const std::string& notes);

} // namespace sparkout
