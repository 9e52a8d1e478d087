// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sparkout {

enum class Severity { error, warning };

/// What is wrong with an input. Each code has one sentence, see issueTemplate().
enum class IssueCode {
    empty,
    notJson,
    tooLarge,
    tooDeep,
    tooManyValues,
    stringTooLong,
    wrongFormat,
    newerVersion,
    duplicateKey,
    unknownKey,
    missingKey,
    wrongType,
    outOfRange,
    notOneOf,
    unusual,
    wrongCount,
    notEven,
    fewRadii,
    deviationsReversed,
    zoneTooShort,
    wheelTooNarrow,
    wheelTooLarge,
    complianceMissing,
    influenceUnknown,
    sparkOutNotLast,
    feedUnused,
    feedMissing,
    stocksDoNotSumUp,
    tooManyStages,
    notUsedHere,
    internalTraverse,
    shaftTooShort,
    targetOutsideField,
    sparkOutLeaves,
    stageIdle,
    dwellRounded,
    noSuchNumber,
    variedTwice,
    sourceMissing, ///< in catalogues
};

/// One fault of an input: where, what stands there, what may stand there.
struct Issue {
    IssueCode code;
    Severity severity = Severity::error;
    std::string path;  ///< JSON pointer, e.g. "/wheel/width_mm"; empty for the whole file
    std::string value; ///< what was found, as written in the file
    std::string limit; ///< what is allowed: a range with its unit, a list, another quantity;
                       ///< another input by its JSON pointer, in brackets

    friend bool operator==(const Issue&, const Issue&) = default;
};

using Issues = std::vector<Issue>;

[[nodiscard]] bool hasErrors(const Issues& issues);

/// The sentence of a code with the places {value} and {limit}, marked for translation in the
/// context "Issue". The core fills nothing in: the window and the command line do.
[[nodiscard]] const char* issueTemplate(IssueCode code);

/// Puts value and limit of an issue into a (translated) sentence.
[[nodiscard]] std::string fillTemplate(std::string sentence, const Issue& issue);

} // namespace sparkout
