// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sparkout {

enum class Severity { error, warning };

/// What is wrong with an input. Each code has one sentence, see words/issue_words.h.
enum class IssueCode {
    empty,
    notJson,
    tooLarge,
    tooDeep,
    tooManyValues,
    stringTooLong,
    wrongFormat,
    newerVersion,
    severalSurfaces,
    duplicateKey,
    unknownKey,
    missingKey,
    wrongType,
    outOfRange,
    notOneOf,
    unusual,
    unusualTogether, ///< beside other inputs
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
    notWithThreshold, ///< of the force
    tooMuchGap,
    gapBetweenRadii,
    gaugeDropsIn,
    wallOverrun,
    stripAtWall,
    shoulderInTheWay, ///< of the wheel as it overruns
    shouldersTooNear, ///< for the wheel to plunge between them
    shaftTooShort,
    targetOutsideField,
    sparkOutLeaves,
    stageIdle,
    dwellRounded,
    lobesUnknown,
    noSuchNumber,
    sameName,
    sharedKey,
    variedTwice,
    sourceMissing, ///< in catalogues
    noSuchInput,   ///< in lessons
    nameTwice,     ///< in packs
    notAFileName,  ///< likewise
};

namespace limits {
inline constexpr std::size_t issues = 200; ///< faults listed at most
} // namespace limits

/// What an issue expects, or found, that is neither a number nor a key.
enum class Phrase {
    number,
    wholeNumber,
    text,
    trueOrFalse,
    object,
    anObject,
    listOfNumbers,
    listOfObjects,
    rowsOrNull,
    zonesOrListOrNull,
    numberOfZone,
    listOrSteps,
    wholeNumberOrUntilSize,
    computedCompliance,
    valueForEachZone,
    anyCompliance,
    quill,
    shaftSteps,
    positiveDefinite,
    anotherInput,
    pathOfInput,
    ruleMax,
    plunge,
    zoneOrSection,
    linesOfBase64,
    nameOfLessonFile,
};

/// A number in its unit.
struct Amount {
    double number = 0;
    std::string_view unit = {};
    std::string_view formula = {}; ///< what it is, in the letters of the model page
    friend bool operator==(const Amount&, const Amount&) = default;
};

struct Count {
    std::int64_t number = 0;
    std::string_view unit = {};
    std::string_view field = {}; ///< the input that asks for it, as a JSON pointer
    friend bool operator==(const Count&, const Count&) = default;
};

/// Of what is counted by a size_t.
[[nodiscard]] constexpr Count countOf(std::size_t number, std::string_view unit = {}) {
    return {static_cast<std::int64_t>(number), unit, {}};
}

/// What a number may be.
struct Bounds {
    Range range;
    std::string_view unit = {};
    std::string_view field = {};   ///< the input that an end follows from, as a JSON pointer
    std::string_view formula = {}; ///< what an end follows from, in the letters of the model page
    bool highOpen = false;
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Keys of the file, or the choices of one.
struct Keys {
    enum class Kind { members, choices, alternatives };
    std::vector<std::string> keys;
    Kind kind = Kind::members;
    friend bool operator==(const Keys&, const Keys&) = default;
};

/// Digits as the file has them: whole numbers of any size, and what no double can hold.
struct Numeral {
    std::string digits;
    friend bool operator==(const Numeral&, const Numeral&) = default;
};

/// A value as the file writes it: "text" with its quotes, true, null, […].
struct Quoted {
    std::string text;
    friend bool operator==(const Quoted&, const Quoted&) = default;
};

using Detail = std::variant<std::monostate, Amount, Count, Bounds, Keys, Phrase, Numeral, Quoted>;

/// One fault of an input: where, what stands there, what may stand there. The words are made by
/// words/issue_words.h. Units, fields and formulas are texts of the program, which outlive it.
struct Issue {
    IssueCode code;
    Severity severity = Severity::error;
    std::string path; ///< JSON pointer, e.g. "/wheel/width_mm"; empty for the whole file
    Detail value;     ///< what was found
    Detail limit;     ///< what is allowed, or what it was held against

    friend bool operator==(const Issue&, const Issue&) = default;
};

using Issues = std::vector<Issue>;

[[nodiscard]] bool hasErrors(const Issues& issues);

} // namespace sparkout
