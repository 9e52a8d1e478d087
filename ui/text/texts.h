// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <QString>
#include <QStringList>

#include <string_view>
#include <utility>
#include <vector>

/// The core's texts in the current language. The core marks them for translation.
namespace sparkout {

[[nodiscard]] QString inputText(const char* text);       ///< label, hint, meaning of null
[[nodiscard]] QString choiceText(const char* text);      ///< label of a choice
[[nodiscard]] QString requirementText(const char* text); ///< label and other words of a row
[[nodiscard]] QString structText(const char* text);      ///< name of a struct
[[nodiscard]] QString unitText(const char* unit);        ///< "mm/min" → "мм/мин"
[[nodiscard]] QString zoneText(const char* key);         ///< "rz1" → "РЗ1"

/// A range with its unit: "0.5 to 1000 mm", "above 0, up to 5 mm"; empty if unbounded.
[[nodiscard]] QString rangeShown(const Range& range, const char* unit);

/// The range in figures: "0.5…1000 mm", ">0…5 mm".
[[nodiscard]] QString rangeBrief(const Range& range, const char* unit);

/// The sentence of an issue with value and limit filled in.
[[nodiscard]] QString issueText(const Issue& issue);
/// The text with the numbers of the file.
[[nodiscard]] QString fileIssueText(const Issue& issue);

/// The place of an issue in words: "Cycle › Stage 2 › Axial feed".
[[nodiscard]] QString locationText(const std::string& path);
/// The place as the inputs name it, where stock may be on the diameter.
[[nodiscard]] QString inputLocation(const std::string& path);

/// A file name or other external text, made safe for a message of one line.
[[nodiscard]] QString printableText(const QString& text);

/// A text of many lines, made safe for a file of another program: characters that the file cannot
/// contain or would interpret (NUL, marks of direction) become U+FFFD.
[[nodiscard]] QString harmlessText(QString text);

/// Keeps a number on one line with its tolerance and per cent sign.
[[nodiscard]] QString unbroken(QString text);

/// Rich text with indices below the line: "S_ax" → "S<sub>ax</sub>"; the text is escaped first.
[[nodiscard]] QString withIndices(const QString& text);

/// Joins the non-empty texts.
[[nodiscard]] inline QString joined(QStringList texts, const QString& between) {
    texts.removeAll(QString());
    return texts.join(between);
}

/// The text of a source in the current language: "MODEL-5" → "model page, section 5, traverse
/// cycle". Empty for a key that core/SOURCES.md does not have.
[[nodiscard]] QString sourceText(std::string_view key);

/// Every source with its key and text.
[[nodiscard]] std::vector<std::pair<QString, QString>> sourceTexts();

} // namespace sparkout
