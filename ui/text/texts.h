// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"

#include <QString>

/// The core's texts in the present language. The core marks them, the session words them.
namespace sparkout {

[[nodiscard]] QString inputText(const char* text);       ///< label, hint, meaning of null
[[nodiscard]] QString choiceText(const char* text);      ///< label of a choice
[[nodiscard]] QString requirementText(const char* text); ///< label and other words of a row
[[nodiscard]] QString structText(const char* text);      ///< name of a struct
[[nodiscard]] QString unitText(const char* unit);        ///< "mm/min" → "мм/мин"
[[nodiscard]] QString zoneText(const char* key);         ///< "rz1" → "РЗ1"

/// A range with its unit: "0.5 to 1000 mm", "above 0, up to 5 mm"; empty when unbounded.
[[nodiscard]] QString rangeShown(const Range& range, const char* unit);

/// The same in figures: "0.5…1000 mm", ">0…5 mm".
[[nodiscard]] QString rangeBrief(const Range& range, const char* unit);

/// The sentence of an issue with value and limit filled in.
[[nodiscard]] QString issueText(const Issue& issue);
/// The same with the numbers that stand in the file.
[[nodiscard]] QString fileIssueText(const Issue& issue);

/// Where an issue is, in words: "Cycle › Stage 2 › Axial feed".
[[nodiscard]] QString locationText(const std::string& path);
/// The same as the inputs have it, where stock may be on the diameter.
[[nodiscard]] QString inputLocation(const std::string& path);

/// A file name or another text from outside as it may stand in a message of one line.
[[nodiscard]] QString printableText(const QString& text);

/// A text of many lines for a file of another program: what such a file cannot hold or would obey
/// (NUL, marks that turn the reading direction) is shown as U+FFFD.
[[nodiscard]] QString harmlessText(QString text);

/// Rich text with indices below the line: "S_ax" → "S<sub>ax</sub>"; the text is escaped first.
[[nodiscard]] QString withIndices(const QString& text);

} // namespace sparkout
