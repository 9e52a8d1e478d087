// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sparkout {

enum class Severity { error, warning };

/// The kind of fault of an input. Each code has one sentence, see words/issue_words.h.
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
    unusualTogether, ///< combined with other inputs
    wrongCount,
    notEven,
    fewRadii,
    deviationsReversed,
    zoneTooShort,
    wheelTooNarrow,
    wheelTooLarge,
    machineMisfit, ///< of part or wheel: beyond what the machine takes
    complianceMissing,
    influenceUnknown,
    sparkOutNotLast,
    feedUnused,
    feedMissing,
    stocksDoNotSumUp,
    tooManyStages,
    notUsedHere,
    notWithThreshold, ///< the force has no threshold
    tooMuchGap,
    gapBetweenRadii,
    gaugeDropsIn,
    wallOverrun,
    stripAtWall,
    shoulderInTheWay, ///< of the overrunning wheel
    shouldersTooNear, ///< for the wheel to plunge between them
    shaftTooShort,
    targetOutsideField,
    sparkOutLeaves,
    stageIdle,
    dwellRounded,
    lobesUnknown,
    wavesUnresolved, ///< of a wheel out of true, by too few radii
    noSuchNumber,
    sameName,
    sharedKey,
    variedTwice,
    sourceMissing, ///< in catalogues
    noSuchInput,   ///< in lessons
    nameTwice,     ///< in packs
    severalFit,    ///< matches several names of the catalogue
    otherMachines, ///< machines of the catalogue that take a part
    otherWheel,    ///< wheel of the catalogue that leaves a required Ra
    noLaw,         ///< of a factor of a batch
    notAProject,   ///< a text that does not even begin as one
    notAFileName,  ///< in packs
};

namespace limits {
inline constexpr std::size_t issues = 200; ///< greatest number of listed faults
} // namespace limits

/// An expected or found value of an issue that is neither a number nor a key.
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
    std::string_view formula = {}; ///< its meaning, in the symbols of the model page
    friend bool operator==(const Amount&, const Amount&) = default;
};

struct Count {
    std::int64_t number = 0;
    std::string_view unit = {};
    std::string_view field = {}; ///< the input that requires it, as a JSON pointer
    friend bool operator==(const Count&, const Count&) = default;
};

/// For a number of type size_t.
[[nodiscard]] constexpr Count countOf(std::size_t number, std::string_view unit = {}) {
    return {static_cast<std::int64_t>(number), unit, {}};
}

/// The allowed range of a number.
struct Bounds {
    Range range;
    std::string_view unit = {};
    std::string_view field = {};   ///< the input that determines an end, as a JSON pointer
    std::string_view formula = {}; ///< the formula of an end, in the symbols of the model page
    bool highOpen = false;
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Keys of the file, or its choices.
struct Keys {
    enum class Kind { members, choices, alternatives };
    std::vector<std::string> keys;
    Kind kind = Kind::members;
    friend bool operator==(const Keys&, const Keys&) = default;
};

/// Digits as in the file: whole numbers of any size, and numbers outside the range of a double.
struct Numeral {
    std::string digits;
    friend bool operator==(const Numeral&, const Numeral&) = default;
};

/// A value as written in the file: "text" with its quotes, true, null, […].
struct Quoted {
    std::string text;
    friend bool operator==(const Quoted&, const Quoted&) = default;
};

using Detail = std::variant<std::monostate, Amount, Count, Bounds, Keys, Phrase, Numeral, Quoted>;

/// A ground length that the wheel neither covers nor travels along, and the data that decide which
/// wheel fits.
struct WheelNeed {
    double length_mm = 0;
    double overrun_entry_mm = 0, overrun_exit_mm = 0;
    std::optional<double> bore_mm = {}; ///< a wheel must be smaller; not given: a shaft
    friend bool operator==(const WheelNeed&, const WheelNeed&) = default;
};

/// A fault of an input: its path, its value and the allowed one. The text is made by
/// words/issue_words.h. Units, fields and formulas are static texts of the program.
struct Issue {
    IssueCode code;
    Severity severity = Severity::error;
    std::string path; ///< JSON pointer, e.g. "/wheel/width_mm"; empty for the whole file
    Detail value;     ///< value found
    Detail limit;     ///< allowed value, or the one compared with
    std::optional<WheelNeed> wheel = {}; ///< of zoneTooShort and wheelTooNarrow

    friend bool operator==(const Issue&, const Issue&) = default;
};

using Issues = std::vector<Issue>;

[[nodiscard]] bool hasErrors(const Issues& issues);

} // namespace sparkout
