// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/issue.h"

#include "core/text.h"

#include <algorithm>

namespace sparkout {

bool hasErrors(const Issues& issues) {
    return std::any_of(issues.begin(), issues.end(),
                       [](const Issue& issue) { return issue.severity == Severity::error; });
}

const char* issueTemplate(IssueCode code) {
    switch (code) {
    case IssueCode::empty: return SPARKOUT_NOOP("Issue", "the file is empty");
    case IssueCode::notJson:
        return SPARKOUT_NOOP("Issue",
                             "the text is not valid JSON in UTF-8: line {value}, column {limit}");
    case IssueCode::tooLarge:
        return SPARKOUT_NOOP("Issue", "{value} is too large; allowed: at most {limit}");
    case IssueCode::tooDeep:
        return SPARKOUT_NOOP("Issue", "values are nested too deeply; allowed: {limit} levels");
    case IssueCode::tooManyValues:
        return SPARKOUT_NOOP("Issue", "too many values; allowed: at most {limit}");
    case IssueCode::stringTooLong:
        return SPARKOUT_NOOP("Issue", "the text is {value} long; allowed: at most {limit}");
    case IssueCode::wrongFormat:
        return SPARKOUT_NOOP("Issue", "{value} is not a Sparkout project; expected {limit}");
    case IssueCode::newerVersion:
        return SPARKOUT_NOOP("Issue", "version {value} was written by a newer Sparkout; this one "
                                      "reads versions {limit}");
    case IssueCode::duplicateKey: return SPARKOUT_NOOP("Issue", "this key stands here twice");
    case IssueCode::unknownKey:
        return SPARKOUT_NOOP("Issue", "unknown key {value}; allowed: {limit}");
    case IssueCode::missingKey:
        return SPARKOUT_NOOP("Issue", "this value is required; allowed: {limit}");
    case IssueCode::wrongType:
        return SPARKOUT_NOOP("Issue", "{value} is of the wrong type; expected: {limit}");
    case IssueCode::outOfRange:
        return SPARKOUT_NOOP("Issue", "{value} is out of range; allowed: {limit}");
    case IssueCode::notOneOf:
        return SPARKOUT_NOOP("Issue", "{value} is not one of the choices; allowed: {limit}");
    case IssueCode::unusual: return SPARKOUT_NOOP("Issue", "{value} is unusual; usual: {limit}");
    case IssueCode::wrongCount:
        return SPARKOUT_NOOP("Issue", "there are {value} values; expected: {limit}");
    case IssueCode::notEven:
        return SPARKOUT_NOOP("Issue", "{value} is odd; allowed: an even number, {limit}");
    case IssueCode::fewRadii:
        return SPARKOUT_NOOP("Issue", "{value} radii cannot tell a lobed form from eccentricity; "
                                      "better: {limit}");
    case IssueCode::deviationsReversed:
        return SPARKOUT_NOOP("Issue", "the lower deviation {value} is not below the upper one; "
                                      "allowed: below {limit}");
    case IssueCode::zoneTooShort:
        return SPARKOUT_NOOP("Issue", "{value} leaves no zone between the reversal zones; "
                                      "allowed: {limit}");
    case IssueCode::wheelTooNarrow:
        return SPARKOUT_NOOP("Issue", "{value} does not cover the ground length of a plunge "
                                      "cycle; allowed: {limit}");
    case IssueCode::wheelTooLarge:
        return SPARKOUT_NOOP("Issue", "{value} does not fit into the hole; allowed: {limit}");
    case IssueCode::complianceMissing:
        return SPARKOUT_NOOP("Issue", "no compliance is given and none can be computed; needed: "
                                      "{limit}");
    case IssueCode::influenceUnknown:
        return SPARKOUT_NOOP("Issue", "how a force in one section deflects the others does not "
                                      "follow from compliances as given; needed: {limit}");
    case IssueCode::sparkOutNotLast:
        return SPARKOUT_NOOP("Issue", "only the last stage may be a spark-out; this is stage "
                                      "{value} of {limit}");
    case IssueCode::feedUnused:
        return SPARKOUT_NOOP("Issue", "a spark-out stage feeds nothing: {value} is not used");
    case IssueCode::feedMissing:
        return SPARKOUT_NOOP("Issue", "{value} would never reach size; allowed: {limit}");
    case IssueCode::stocksDoNotSumUp:
        return SPARKOUT_NOOP("Issue", "the stages' stocks sum to {value}, the part's stock is "
                                      "{limit}; the first stage takes what the later ones leave");
    case IssueCode::tooManyStages:
        return SPARKOUT_NOOP("Issue", "{value} stages need more gauge commands than there are; "
                                      "allowed: {limit}");
    case IssueCode::notUsedHere:
        return SPARKOUT_NOOP("Issue", "{value} is not used here; it applies to {limit}");
    case IssueCode::internalTraverse:
        return SPARKOUT_NOOP("Issue",
                             "{value} surfaces are ground by plunge only; allowed: {limit}");
    case IssueCode::shaftTooShort:
        return SPARKOUT_NOOP("Issue", "the shaft is {value} long; needed: {limit}");
    case IssueCode::targetOutsideField:
        return SPARKOUT_NOOP("Issue",
                             "the target {value} lies outside the tolerance field {limit}");
    case IssueCode::sparkOutLeaves:
        return SPARKOUT_NOOP("Issue", "the part stays {value} above size: a spark-out feeds "
                                      "nothing, and the deflection did not give back its stock of "
                                      "{limit}");
    case IssueCode::stageIdle:
        return SPARKOUT_NOOP("Issue",
                             "stage {value} of {limit} makes no step: those before it have "
                             "already removed its stock");
    case IssueCode::dwellRounded:
        return SPARKOUT_NOOP("Issue",
                             "a dwell of {value} is made as {limit}, in whole revolutions");
    case IssueCode::noSuchNumber:
        return SPARKOUT_NOOP("Issue", "{value} is no number that this project reads; needed: "
                                      "{limit}");
    case IssueCode::variedTwice:
        return SPARKOUT_NOOP("Issue", "{value} is varied twice; needed: {limit}");
    case IssueCode::sourceMissing:
        return SPARKOUT_NOOP("Issue", "{value} says neither where it comes from nor that it is an "
                                      "estimate; needed: its line in {limit}");
    }
    return "";
}

std::string fillTemplate(std::string sentence, const Issue& issue) {
    // Both places are looked for before either is filled: a value may itself hold "{limit}".
    std::string out;
    for (std::size_t i = 0; i < sentence.size();) {
        if (sentence.compare(i, 7, "{value}") == 0) {
            out += issue.value;
            i += 7;
        } else if (sentence.compare(i, 7, "{limit}") == 0) {
            out += issue.limit;
            i += 7;
        } else {
            out += sentence[i++];
        }
    }
    return out;
}

} // namespace sparkout
