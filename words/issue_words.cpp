// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/issue_words.h"

#include "core/catalogue/catalogue.h"
#include "core/digits.h"
#include "core/project/validate.h"
#include "core/text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>

namespace sparkout {

std::string placedText(const std::string& sentence, TextPlaces places) {
    std::string out;
    for (std::size_t i = 0; i < sentence.size();) {
        std::size_t taken = 0;
        for (const auto& [name, value] : places) {
            const std::string place = '{' + std::string(name) + '}';
            if (taken == 0 && sentence.compare(i, place.size(), place) == 0) {
                out += value;
                taken = place.size();
            }
        }
        if (taken == 0) {
            out += sentence[i];
            taken = 1;
        }
        i += taken;
    }
    return out;
}

namespace {

std::string joined(const Keys& keys) {
    const bool quoted = keys.kind == Keys::Kind::choices;
    const char* const separator = keys.kind == Keys::Kind::alternatives ? " | " : ", ";
    std::string text;
    for (const std::string& key : keys.keys) {
        text += (text.empty() ? "" : separator) + (quoted ? '"' + key + '"' : key);
    }
    return text;
}

/// Inserts both values. Finds both places first, since a value may contain "{limit}" itself.
std::string filled(const std::string& sentence, const std::string& value,
                   const std::string& limit) {
    std::string out;
    for (std::size_t i = 0; i < sentence.size();) {
        if (sentence.compare(i, 7, "{value}") == 0) {
            out += value;
            i += 7;
        } else if (sentence.compare(i, 7, "{limit}") == 0) {
            out += limit;
            i += 7;
        } else {
            out += sentence[i++];
        }
    }
    return out;
}

/// Whether a wheel is made for the surface; a smaller wheel than for shafts stands on a quill.
bool isForSurface(const Wheel& wheel, const WheelNeed& need) {
    constexpr double leastForShafts_mm = 100;
    return need.bore_mm ? wheel.diameter_mm < *need.bore_mm
                        : wheel.diameter_mm >= leastForShafts_mm;
}

/// Whether both reversal zones leave a zone between them. A wheel overruns an end by a third of its
/// width, or by less where the given overrun is less, as beside a shoulder.
bool travelsAlong(double width_mm, const WheelNeed& need) {
    const auto zone_mm = [width_mm](double overrun_mm) {
        return width_mm - std::min(overrun_mm, width_mm / 3);
    };
    return zone_mm(need.overrun_entry_mm) + zone_mm(need.overrun_exit_mm) < need.length_mm;
}

} // namespace

// A case for each code, nothing else. NOLINTNEXTLINE(readability-function-size)
IssueWords wordsOf(IssueCode code) {
    switch (code) {
    case IssueCode::empty: return {"empty", SPARKOUT_NOOP("Issue", "the file is empty")};
    case IssueCode::notJson:
        return {"not_json",
                SPARKOUT_NOOP("Issue",
                              "the text is not valid JSON in UTF-8: line {value}, column {limit}")};
    case IssueCode::tooLarge:
        return {"too_large",
                SPARKOUT_NOOP("Issue", "{value} is too large; allowed: at most {limit}")};
    case IssueCode::tooDeep:
        return {"too_deep",
                SPARKOUT_NOOP("Issue", "values are nested too deeply; allowed: {limit} levels")};
    case IssueCode::tooManyValues:
        return {"too_many_values",
                SPARKOUT_NOOP("Issue", "too many values; allowed: at most {limit}")};
    case IssueCode::stringTooLong:
        return {"string_too_long",
                SPARKOUT_NOOP("Issue", "the text is {value} long; allowed: at most {limit}")};
    case IssueCode::wrongFormat:
        return {"wrong_format",
                SPARKOUT_NOOP("Issue", "{value} is not a Sparkout project; expected {limit}")};
    case IssueCode::newerVersion:
        return {"newer_version",
                SPARKOUT_NOOP("Issue", "version {value} was written by a newer Sparkout; this one "
                                       "reads versions {limit}")};
    case IssueCode::severalSurfaces:
        return {"several_surfaces",
                SPARKOUT_NOOP("Issue", "a file of version {value} holds several surfaces of a "
                                       "part; the window and sparkout-cli open it")};
    case IssueCode::duplicateKey:
        return {"duplicate_key", SPARKOUT_NOOP("Issue", "this key appears here twice")};
    case IssueCode::unknownKey:
        return {"unknown_key", SPARKOUT_NOOP("Issue", "unknown key {value}; allowed: {limit}")};
    case IssueCode::missingKey:
        return {"missing_key", SPARKOUT_NOOP("Issue", "value missing; allowed: {limit}")};
    case IssueCode::wrongType:
        return {"wrong_type",
                SPARKOUT_NOOP("Issue", "{value} is of the wrong type; expected: {limit}")};
    case IssueCode::outOfRange:
        return {"out_of_range",
                SPARKOUT_NOOP("Issue", "{value} is out of range; allowed: {limit}")};
    case IssueCode::notOneOf:
        return {"not_one_of",
                SPARKOUT_NOOP("Issue", "{value} is not one of the choices; allowed: {limit}")};
    case IssueCode::unusual:
        return {"unusual", SPARKOUT_NOOP("Issue", "{value} is unusual; usual: {limit}")};
    case IssueCode::unusualTogether:
        return {"unusual_together", SPARKOUT_NOOP("Issue", "{value} is unusual beside the other "
                                                           "inputs; usual: {limit}")};
    case IssueCode::wrongCount:
        return {"wrong_count",
                SPARKOUT_NOOP("Issue", "there are {value} values; expected: {limit}")};
    case IssueCode::notEven:
        return {"not_even",
                SPARKOUT_NOOP("Issue", "{value} is odd; allowed: an even number, {limit}")};
    case IssueCode::fewRadii:
        return {"few_radii",
                SPARKOUT_NOOP(
                    "Issue",
                    "{value} radii do not separate lobing from eccentricity; better: {limit}")};
    case IssueCode::deviationsReversed:
        return {"deviations_reversed",
                SPARKOUT_NOOP("Issue", "the lower deviation {value} is not below the upper one; "
                                       "allowed: below {limit}")};
    case IssueCode::zoneTooShort:
        return {"zone_too_short",
                SPARKOUT_NOOP("Issue", "{value} leaves no zone between the reversal zones; "
                                       "allowed: {limit}. A narrower wheel, longer overruns or "
                                       "plunge grinding would help")};
    case IssueCode::wheelTooNarrow:
        return {"wheel_too_narrow",
                SPARKOUT_NOOP("Issue", "{value} does not cover the ground length of a plunge "
                                       "cycle; allowed: {limit}")};
    case IssueCode::wheelTooLarge:
        return {"wheel_too_large",
                SPARKOUT_NOOP("Issue", "{value} does not fit into the hole; allowed: {limit}")};
    case IssueCode::machineMisfit:
        return {"machine_misfit",
                SPARKOUT_NOOP("Issue", "{value} does not fit the machine; allowed: {limit}")};
    case IssueCode::complianceMissing:
        return {"compliance_missing",
                SPARKOUT_NOOP("Issue", "no compliance is given and none can be computed; needed: "
                                       "{limit}")};
    case IssueCode::influenceUnknown:
        return {"influence_unknown",
                SPARKOUT_NOOP("Issue", "given compliances do not determine how a force in one "
                                       "section deflects the others; needed: {limit}")};
    case IssueCode::sparkOutNotLast:
        return {"spark_out_not_last",
                SPARKOUT_NOOP("Issue", "only the last stage may be a spark-out; this is stage "
                                       "{value} of {limit}")};
    case IssueCode::feedUnused:
        return {"feed_unused",
                SPARKOUT_NOOP("Issue", "a spark-out stage has no feed: {value} is not used")};
    case IssueCode::feedMissing:
        return {"feed_missing",
                SPARKOUT_NOOP("Issue", "{value} would never reach size; allowed: {limit}")};
    case IssueCode::stocksDoNotSumUp:
        return {"stocks_do_not_sum_up",
                SPARKOUT_NOOP("Issue", "the stages' stocks sum to {value}, the part's stock is "
                                       "{limit}; the first stage takes what the later ones leave")};
    case IssueCode::tooManyStages:
        return {"too_many_stages",
                SPARKOUT_NOOP(
                    "Issue",
                    "{value} stages need more gauge commands than available; allowed: {limit}")};
    case IssueCode::notUsedHere:
        return {"not_used_here",
                SPARKOUT_NOOP("Issue", "{value} is not used here; it applies to {limit}")};
    case IssueCode::notWithThreshold:
        return {"not_with_threshold",
                SPARKOUT_NOOP("Issue", "{value} belongs to the sources' force law and is not "
                                       "computed for one with a threshold; allowed: {limit}")};
    case IssueCode::tooMuchGap:
        return {"too_much_gap",
                SPARKOUT_NOOP("Issue",
                              "the gaps leave too little of the surface: {value} radii lie outside "
                              "them; needed: {limit}, two of them opposite each other")};
    case IssueCode::gapBetweenRadii:
        return {"gap_between_radii",
                SPARKOUT_NOOP("Issue", "a gap of {value} lies between two radii, which are {limit} "
                                       "apart: it has no effect")};
    case IssueCode::gaugeDropsIn:
        return {"gauge_drops_in",
                SPARKOUT_NOOP("Issue", "this gauge drops into the gaps; needed: {limit}")};
    case IssueCode::wallOverrun:
        return {"wall_overrun",
                SPARKOUT_NOOP("Issue", "{value} runs the wheel into the wall of the blind bore; "
                                       "allowed: {limit}")};
    case IssueCode::stripAtWall:
        return {"strip_at_wall",
                SPARKOUT_NOOP("Issue", "the wheel turns {value} before the wall of the blind bore: "
                                       "the unreached length must be relieved")};
    case IssueCode::shoulderInTheWay:
        return {"shoulder_in_the_way",
                SPARKOUT_NOOP("Issue", "an overrun of {value} runs the wheel into a shoulder of "
                                       "the shaft; allowed: {limit}")};
    case IssueCode::shouldersTooNear:
        return {"shoulders_too_near",
                SPARKOUT_NOOP("Issue", "a wheel {value} wide does not fit between the shoulders of "
                                       "the shaft; allowed: {limit}")};
    case IssueCode::shaftTooShort:
        return {"shaft_too_short",
                SPARKOUT_NOOP("Issue", "the shaft is {value} long; needed: {limit}")};
    case IssueCode::targetOutsideField:
        return {
            "target_outside_field",
            SPARKOUT_NOOP("Issue", "the target {value} lies outside the tolerance band {limit}")};
    case IssueCode::sparkOutLeaves:
        return {"spark_out_leaves",
                SPARKOUT_NOOP("Issue",
                              "the part stays {value} above size: a spark-out has no feed, "
                              "and the deflection did not remove its stock of {limit}")};
    case IssueCode::stageIdle:
        return {"stage_idle",
                SPARKOUT_NOOP("Issue",
                              "stage {value} of {limit} makes no step: those before it have "
                              "already removed its stock")};
    case IssueCode::dwellRounded:
        return {
            "dwell_rounded",
            SPARKOUT_NOOP("Issue", "a dwell of {value} is rounded to {limit}, whole revolutions")};
    case IssueCode::lobesUnknown:
        return {"lobes_unknown",
                SPARKOUT_NOOP("Issue", "the number of lobes is not known: an even one spreads the "
                                       "diameters by {value} in a field of {limit}; judged as an "
                                       "odd one")};
    case IssueCode::wavesUnresolved:
        return {"waves_unresolved",
                SPARKOUT_NOOP("Issue", "{value} radii do not resolve the waves that the wheel "
                                       "prints; needed: {limit}")};
    case IssueCode::noSuchNumber:
        return {"no_such_number",
                SPARKOUT_NOOP("Issue", "{value} is not a number of the project; needed: {limit}")};
    case IssueCode::sameName:
        return {"same_name",
                SPARKOUT_NOOP("Issue", "{value} is already the name of surface {limit}")};
    case IssueCode::sharedKey:
        return {"shared_key",
                SPARKOUT_NOOP("Issue", "{value} applies to all surfaces and belongs outside them")};
    case IssueCode::variedTwice:
        return {"varied_twice", SPARKOUT_NOOP("Issue", "{value} is varied twice; needed: {limit}")};
    case IssueCode::sourceMissing:
        return {"source_missing",
                SPARKOUT_NOOP("Issue", "{value} has neither a source nor a mark as an estimate; "
                                       "needed: its line in {limit}")};
    case IssueCode::noSuchInput:
        return {"no_such_input",
                SPARKOUT_NOOP("Issue", "{value} is not an input of this project; needed: {limit}")};
    case IssueCode::nameTwice:
        return {"name_twice", SPARKOUT_NOOP("Issue", "{value} is named twice")};
    case IssueCode::severalFit:
        return {"several_fit", SPARKOUT_NOOP("Issue", "{value} fits several: {limit}")};
    case IssueCode::otherMachines:
        return {
            "other_machines",
            SPARKOUT_NOOP(
                "Issue",
                "{value} does not accept this part; machines of the catalogue that do: {limit}")};
    case IssueCode::otherWheel:
        return {"other_wheel",
                SPARKOUT_NOOP("Issue", "this wheel usually leaves Ra {value}, more than required; "
                                       "the catalogue's wheel that suits: {limit}")};
    case IssueCode::noLaw:
        return {"no_law", SPARKOUT_NOOP("Issue", "no law given; expected one of {limit}")};
    case IssueCode::notAProject:
        return {"not_a_project",
                SPARKOUT_NOOP("Issue", "this is not a Sparkout project: the text is not valid "
                                       "JSON in UTF-8: line {value}, column {limit}")};
    case IssueCode::notAFileName:
        return {"not_a_file_name",
                SPARKOUT_NOOP("Issue", "{value} cannot be the name of a file; needed: {limit}")};
    }
    return {"", ""};
}

const char* wordsOf(Phrase phrase) {
    switch (phrase) {
    case Phrase::number: return SPARKOUT_NOOP("Limit", "number");
    case Phrase::wholeNumber: return SPARKOUT_NOOP("Limit", "whole number");
    case Phrase::text: return SPARKOUT_NOOP("Limit", "text");
    case Phrase::trueOrFalse: return SPARKOUT_NOOP("Limit", "true or false");
    case Phrase::object: return SPARKOUT_NOOP("Limit", "object");
    case Phrase::anObject: return SPARKOUT_NOOP("Limit", "an object");
    case Phrase::listOfNumbers: return SPARKOUT_NOOP("Limit", "list of numbers");
    case Phrase::listOfObjects: return SPARKOUT_NOOP("Limit", "list of objects");
    case Phrase::rowsOrNull: return SPARKOUT_NOOP("Limit", "list of rows of numbers, or null");
    case Phrase::zonesOrListOrNull:
        return SPARKOUT_NOOP("Limit", "object with rz1, nz, rz2, or list of numbers, or null");
    case Phrase::numberOfZone: return SPARKOUT_NOOP("Limit", "number, mm/N");
    case Phrase::listOrSteps:
        return SPARKOUT_NOOP("Limit", "list of numbers, or object with from, to, step");
    case Phrase::wholeNumberOrUntilSize:
        return SPARKOUT_NOOP("Limit", "whole number or \"until_size\"");
    case Phrase::computedCompliance:
        return SPARKOUT_NOOP("Limit", "a compliance computed from stiffness and shaft");
    case Phrase::valueForEachZone:
        return SPARKOUT_NOOP("Limit", "a value for each zone: { rz1, nz, rz2 }");
    case Phrase::anyCompliance:
        return SPARKOUT_NOOP("Limit",
                             "a compliance as given, or stiffness and shaft to compute it from");
    case Phrase::quill: return SPARKOUT_NOOP("Limit", "length and diameter of the quill");
    case Phrase::shaftSteps:
        return SPARKOUT_NOOP("Limit", "length and diameter of each step of the shaft");
    case Phrase::positiveDefinite: return SPARKOUT_NOOP("Limit", "a positive definite matrix");
    case Phrase::anotherInput: return SPARKOUT_NOOP("Limit", "another input");
    case Phrase::pathOfInput:
        return SPARKOUT_NOOP("Limit", "the path of an input, as /wheel/dullness");
    case Phrase::ruleMax: return SPARKOUT_NOOP("Limit", "one that reads the largest diameter");
    case Phrase::plunge: return SPARKOUT_NOOP("Limit", "plunge");
    case Phrase::zoneOrSection:
        return SPARKOUT_NOOP("Limit", "\"rz1\", \"nz\", \"rz2\", or the number of a section");
    case Phrase::linesOfBase64:
        return SPARKOUT_NOOP("Limit", "a list of texts that are base64 together");
    case Phrase::nameOfLessonFile:
        return SPARKOUT_NOOP("Limit", "the name of a file without a folder, ending in "
                                      ".sparkout-lesson");
    }
    return "";
}

std::string Wording::sentence(const Issue& issue) const {
    const std::string fault = filled(translated("Issue", wordsOf(issue.code).sentence),
                                     detail(issue.value), detail(issue.limit));
    return issue.wheel ? fault + " (" + wheels(*issue.wheel) + ')' : fault;
}

/// The widths of wheels of the shipped catalogue that fit, the nearest first.
std::string Wording::wheels(const WheelNeed& need) const {
    std::set<double, std::greater<>> narrow;
    std::set<double> covering;
    for (const WheelEntry& entry : shippedEntries<WheelEntry>()) {
        const double width_mm = entry.value.width_mm;
        if (!isForSurface(entry.value, need)) {
            continue;
        }
        if (width_mm >= need.length_mm) {
            covering.insert(width_mm);
        } else if (travelsAlong(width_mm, need)) {
            narrow.insert(width_mm);
        }
    }
    std::string fitting;
    const auto add = [&](const auto& widths, const char* text) {
        std::string numbers;
        for (const double width_mm : widths) {
            numbers += (numbers.empty() ? "" : ", ") + number(width_mm);
        }
        if (!numbers.empty()) {
            fitting += (fitting.empty() ? "" : "; ")
                       + filled(translated("WheelWidths", text), numbers, {});
        }
    };
    add(narrow,
        SPARKOUT_NOOP("WheelWidths", "to traverse {value} mm (overruns of a third at most)"));
    add(covering, SPARKOUT_NOOP("WheelWidths", "to plunge {value} mm"));
    return fitting.empty()
               ? translated("WheelWidths",
                            SPARKOUT_NOOP("WheelWidths", "no wheel of the catalogue fits"))
               : filled(
                   translated("WheelWidths",
                              SPARKOUT_NOOP("WheelWidths",
                                            "widths of the catalogue's wheels that fit: {value}")),
                   fitting, {});
}

std::string Wording::detail(const Detail& detail) const {
    return std::visit([this](const auto& each) { return text(each); }, detail);
}

std::string Wording::text(std::monostate) const {
    return {};
}
std::string Wording::text(const Amount& amount) const {
    return withUnit(number(amount.number), amount.unit) + inBrackets({}, amount.formula);
}
std::string Wording::text(const Count& count) const {
    return withUnit(numeral(std::to_string(count.number)), count.unit)
           + inBrackets(count.field, {});
}
std::string Wording::text(const Bounds& bounds) const {
    const auto written = [&](double value) {
        if (bounds.formula.empty()) {
            return number(value);
        }
        constexpr int digits = 8; // a computed end has rounding errors
        const double scale = std::pow(10.0, decimalsOf(value, digits));
        return number(std::round(value * scale) / scale);
    };
    const std::string range =
        bounds.highOpen ? "< " + written(bounds.range.high) : rangeText(bounds.range, "", written);
    return range.empty() ? range
                         : withUnit(range, bounds.unit) + inBrackets(bounds.field, bounds.formula);
}
std::string Wording::text(const Keys& keys) const {
    return joined(keys);
}
std::string Wording::text(Phrase phrase) const {
    return translated("Limit", wordsOf(phrase));
}
std::string Wording::text(const Numeral& value) const {
    return numeral(value.digits);
}
std::string Wording::text(const Quoted& value) const {
    return value.text;
}

std::string Wording::withUnit(const std::string& number, std::string_view unit) const {
    return unit.empty() ? number : number + ' ' + translated("Unit", std::string(unit));
}

std::string Wording::inBrackets(std::string_view field, std::string_view letters) const {
    return field.empty() && letters.empty() ? std::string()
           : field.empty()                  ? " (" + formula(std::string(letters)) + ')'
                                            : " (" + input(std::string(field)) + ')';
}

std::string Wording::translated(const char*, const std::string& text) const {
    return text;
}
std::string Wording::number(double value) const {
    return plainNumber(value);
}
std::string Wording::numeral(const std::string& digits) const {
    return digits;
}
std::string Wording::input(const std::string& path) const {
    return path;
}
std::string Wording::formula(const std::string& letters) const {
    return letters;
}

} // namespace sparkout
