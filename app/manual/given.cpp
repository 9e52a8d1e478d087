// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/given.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <type_traits>

namespace sparkout::manual {

namespace {

/// "a, b or c".
std::string joined(const std::vector<std::string>& items, const std::string& last) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == items.size() ? ' ' + last + ' ' : ", ") + items[i];
    }
    return text;
}

std::string numberText(double value) {
    std::array<char, 32> text{};
    const bool isWhole = value == std::floor(value); // all bounds are below 1e18
    const auto end = isWhole
                         ? std::to_chars(text.begin(), text.end(), static_cast<long long>(value))
                         : std::to_chars(text.begin(), text.end(), value);
    return {text.begin(), end.ptr};
}

/// The accepted values: "a number from 1 to 1024", "plunge or traverse".
std::string whatIsNeeded(const Value& value) {
    switch (value.kind) {
    case Kind::choice: {
        const auto words = wordsOf(value.choices);
        return joined({words.begin(), words.end()}, "or");
    }
    case Kind::integer:
    case Kind::integers:
    case Kind::number:
    case Kind::numbers:
        return value.is
               + (value.low == aboveZero
                      ? " above 0, up to " + numberText(value.high)
                      : " from " + numberText(value.low) + " to " + numberText(value.high))
               + (value.kind == Kind::integers || value.kind == Kind::numbers
                      ? " with commas between"
                      : "");
    default: return value.is;
    }
}

std::string refusalOf(const Option& option, const std::string* given) {
    return option.name + (" needs " + whatIsNeeded(option.value))
           + (given ? ", not “" + *given + "”" : "");
}

/// A number that is not an integer may have a decimal comma.
template <class Number>
std::optional<Number> numberIn(std::string text, const Value& value) {
    if constexpr (std::is_floating_point_v<Number>) {
        std::ranges::replace(text, ',', '.');
    }
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole && number >= value.low && number <= value.high ? std::optional(number)
                                                                  : std::nullopt;
}

/// Parses a list; empty if one is invalid.
template <class Number>
std::vector<Number> numbersIn(std::string_view text, const Value& value) {
    std::vector<Number> numbers;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const auto number = numberIn<Number>(std::string(text.substr(0, comma)), value);
        if (!number) {
            return {};
        }
        numbers.push_back(*number);
        if (comma == text.size()) {
            return numbers;
        }
        text.remove_prefix(comma + 1);
    }
}

bool isValue(const std::string& text, const Value& value) {
    switch (value.kind) {
    case Kind::anything: return true;
    case Kind::choice: return std::ranges::count(wordsOf(value.choices), text) > 0;
    case Kind::integer: return numberIn<int>(text, value).has_value();
    case Kind::integers: return !numbersIn<int>(text, value).empty();
    case Kind::number: return numberIn<double>(text, value).has_value();
    case Kind::numbers: return !numbersIn<double>(text, value).empty();
    default: return !text.empty();
    }
}

/// The number of letters to insert, remove, replace or exchange with the next.
std::size_t slipsBetween(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last, row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::move(last);
        last = row;
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
    }
    return row.back();
}

/// " (did you mean --json?)": the names with at most one slip in three letters, and those with this
/// beginning; empty if there are none.
std::string nearOnes(std::string_view word, const std::vector<std::string>& names) {
    constexpr std::size_t lettersToASlip = 3, enoughToBegin = 4; // with the dashes
    const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
    std::vector<std::string> near;
    std::ranges::copy_if(names, std::back_inserter(near), [&](std::string_view name) {
        return slipsBetween(word, name) <= letters / lettersToASlip
               || (word.size() >= enoughToBegin && name.starts_with(word));
    });
    return near.empty() ? "" : " (did you mean " + joined(near, "or") + "?)";
}

std::string unknownOption(const Command& command, const std::string& word) {
    std::vector<std::string> names;
    for (const Option& option : optionsOf(command)) {
        names.emplace_back(option.name);
    }
    return "unknown option " + word + nearOnes(word, names);
}

bool looksLikeOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-';
}

} // namespace

const Option& Given::row(std::string_view option) const {
    const Option* row = optionNamed(*m_command, option);
    if (!row) {
        throw std::logic_error(m_command->name + (" has no " + std::string(option)));
    }
    return *row;
}

bool Given::has(std::string_view option) const {
    return m_values.contains(row(option).name);
}

const std::string& Given::text(std::string_view option) const {
    static const std::string none;
    const auto value = m_values.find(row(option).name);
    return value == m_values.end() ? none : value->second;
}

const Value& Given::value(std::string_view option, Kind kind) const {
    const Value& value = row(option).value;
    if (value.kind != kind) {
        throw std::logic_error(std::string(option) + " has a value of another kind");
    }
    return value;
}

std::optional<int> Given::integer(std::string_view option) const {
    return numberIn<int>(text(option), value(option, Kind::integer));
}

std::optional<double> Given::number(std::string_view option) const {
    return numberIn<double>(text(option), value(option, Kind::number));
}

std::vector<int> Given::integers(std::string_view option) const {
    return numbersIn<int>(text(option), value(option, Kind::integers));
}

std::vector<double> Given::numbers(std::string_view option) const {
    return numbersIn<double>(text(option), value(option, Kind::numbers));
}

std::string Given::refusal(std::string_view option) const {
    return refusalOf(row(option), &text(option));
}

Reading::Reading(const Program& program, const std::vector<std::string>& words) : given(program) {
    bool optionsOver = false;
    for (std::size_t i = readCommand(words); i < words.size() && fault.empty() && !asksForHelp;) {
        if (!optionsOver && looksLikeOption(words[i]) && words[i] != "--") {
            i = readOption(words, i);
            continue;
        }
        if (!optionsOver && words[i] == "--") {
            optionsOver = true;
        } else if (given.operands.size() == given.command().operands.most) {
            fault = "one file or folder too many: " + words[i];
        } else if (!words[i].empty()) {
            given.operands.push_back(words[i]);
        }
        ++i;
    }
    if (fault.empty() && !asksForHelp && given.command().commands.empty()) {
        checkTogether();
    }
}

/// Finds the named command; returns the index of the first word after it. An option in the place of
/// a command, such as --version, must be the only one.
std::size_t Reading::readCommand(const std::vector<std::string>& words) {
    const Command* const program = &given.command();
    for (std::size_t at = 0;; ++at) {
        const Command& among = given.command();
        if (among.commands.empty()) {
            return at;
        }
        if (at < words.size() && looksLikeOption(words[at])) {
            const std::size_t next = readOption(words, at);
            if (fault.empty() && !asksForHelp && next < words.size()) {
                fault = "no operand is allowed with " + words[at] + ": " + words[next];
            }
            return words.size();
        }
        std::vector<std::string> names;
        for (const Command& each : among.commands) {
            names.emplace_back(each.lastWord());
        }
        const bool isNone = at == words.size() || words[at].empty();
        const Command* const named = isNone ? nullptr : commandNamed(among, words[at]);
        if (!named) {
            fault = !isNone ? "unknown command "
                                  + (&among == program ? "" : among.name + std::string(" "))
                                  + words[at] + nearOnes(words[at], names)
                    : &among == program ? "a command is needed"
                                        : among.name + (" needs one of " + joined(names, "and"));
            return words.size();
        }
        given = Given(*named);
    }
}

std::size_t Reading::readOption(const std::vector<std::string>& words, std::size_t at) {
    const std::string& word = words[at];
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    const std::string name = word.substr(0, equals);
    const Option* option = optionNamed(given.command(), name);
    if (!option) {
        fault = unknownOption(given.command(), name);
        return at;
    }
    std::string& value = given.m_values[option->name];
    if (option->value.kind == Kind::none) {
        asksForHelp = option->isNamed(helpOption.name);
        if (equals != std::string::npos) {
            fault = name + " takes no value";
        }
        return at + 1;
    }
    if (equals == std::string::npos && at + 1 == words.size()) {
        fault = refusalOf(*option, nullptr);
        return at;
    }
    value = equals == std::string::npos ? words[at + 1] : word.substr(equals + 1);
    if (!isValue(value, option->value)) {
        fault = refusalOf(*option, &value);
    }
    return at + (equals == std::string::npos ? 2 : 1);
}

/// Checks for missing options and for options that contradict each other.
void Reading::checkTogether() {
    const Command& command = given.command();
    if (given.operands.size() < command.operands.least) {
        fault = command.name + (std::string(" needs ") + command.operands.is);
        return;
    }
    std::vector<std::string> missing;
    for (const Option& option : command.options) {
        if (option.isRequired && !given.has(option.name)) {
            missing.push_back(asTyped(option));
        }
    }
    if (!missing.empty()) {
        fault = command.name + (" needs " + joined(missing, "and"));
    }
    for (const Option& option : command.options) {
        if (fault.empty() && given.has(option.name)) {
            fault = contradictionOf(option);
        }
    }
}

/// The contradiction of a given option; empty if there is none.
std::string Reading::contradictionOf(const Option& option) const {
    std::vector<std::string> group, needed;
    std::size_t givenOfGroup = 0;
    bool hasNeeded = *option.needs == '\0';
    for (const Option& other : given.command().options) {
        if (*option.group != '\0' && std::string_view(other.group) == option.group) {
            group.emplace_back(other.name);
            givenOfGroup += given.has(other.name) ? 1 : 0;
        }
        if (std::ranges::count(wordsOf(option.needs), other.name) > 0) {
            needed.push_back(asTyped(other));
            hasNeeded = hasNeeded || given.has(other.name);
        }
    }
    return givenOfGroup > 1 ? "only one of " + joined(group, "and")
           : hasNeeded      ? ""
                            : option.name + (" needs " + joined(needed, "or"));
}

} // namespace sparkout::manual
