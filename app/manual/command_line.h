// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

/// The command lines of the programs, in both languages: an option is one row. The parser
/// (given.h), `--help`, the manual pages and the completion of the shells use these rows.
namespace sparkout::manual {

enum class Tongue { english, russian };

struct Text {
    const char* english;
    const char* russian;

    [[nodiscard]] const char* in(Tongue tongue) const {
        return tongue == Tongue::english ? english : russian;
    }
};

enum class Kind {
    none,
    anything, ///< any text, including an empty one
    text,
    project,
    file,
    folder,
    choice,
    integer,
    integers, ///< separated by commas
    number,
    numbers
};

/// The value of an option: its display, and what the parser accepts.
struct Value {
    Kind kind = Kind::none;
    const char* shown = "";   ///< "N", "OUT.csv"; of a choice empty: the choices
    const char* is = "";      ///< expected value: "a length in mm"
    const char* choices = ""; ///< separated by spaces; for a text the proposed ones
    double low = 0, high = 0; ///< bounds of a number
};

inline constexpr double aboveZero = 1e-9; ///< the lowest number that is "above 0"
inline constexpr int highestInteger = std::numeric_limits<int>::max();

constexpr Value textLike(const char* shown, const char* is, const char* proposed = "") {
    return {Kind::text, shown, is, proposed};
}
constexpr Value projectFile(const char* shown) {
    return {Kind::project, shown, "a file name"};
}
constexpr Value file(const char* shown) {
    return {Kind::file, shown, "a file name"};
}
constexpr Value folder(const char* shown) {
    return {Kind::folder, shown, "a folder"};
}
constexpr Value choice(const char* choices, const char* shown = "") {
    return {Kind::choice, shown, "", choices};
}
constexpr Value integer(const char* shown, int low, int high) {
    return {Kind::integer, shown, "a number", "", double(low), double(high)};
}
constexpr Value integers(const char* shown, int low, int high) {
    return {Kind::integers, shown, "numbers", "", double(low), double(high)};
}
constexpr Value number(const char* shown, const char* is, double low, double high) {
    return {Kind::number, shown, is, "", low, high};
}
constexpr Value numbers(const char* shown, const char* is, double low, double high) {
    return {Kind::numbers, shown, is, "", low, high};
}

struct Option {
    const char* name = "";      ///< "--json", "-o"
    const char* shortName = ""; ///< "-h"
    Value value{};
    bool isRequired = false;
    const char* needs = ""; ///< options, separated by spaces, one of which is required with it
    const char* group = ""; ///< at most one option of a group may be given
    Text text;              ///< its effect

    [[nodiscard]] bool isNamed(std::string_view word) const {
        return word == name || (!word.empty() && word == shortName);
    }
};

/// The option of every program and command.
inline constexpr Option helpOption{.name = "--help",
                                   .shortName = "-h",
                                   .text = {"prints this text", "печатает список параметров"}};

/// The operands of a command.
struct Operands {
    const char* shown = ""; ///< "FILE"
    Kind kind = Kind::none;
    const char* is = ""; ///< "a file"
    std::size_t least = 0, most = 0;
};

inline constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

/// A command with subcommands, or one that can be run.
struct Command {
    const char* name = ""; ///< in full: "course grade"
    Operands operands{};
    Text text;
    std::vector<Option> options{};
    std::vector<Command> commands{};

    [[nodiscard]] std::string_view lastWord() const;
};

struct Status {
    const char* codes;
    Text text;
};

/// A program, whose text is its purpose in half a line.
struct Program : Command {
    std::vector<const char*> forms; ///< usage lines of a program without commands
    Text description;
    std::vector<Text> notes; ///< paragraphs
    std::vector<Status> statuses;
};

[[nodiscard]] const Program& windowProgram();      ///< sparkout
[[nodiscard]] const Program& commandLineProgram(); ///< sparkout-cli

/// Null if there is no command or option with this name.
[[nodiscard]] const Command* commandNamed(const Command& among, std::string_view lastWord);
[[nodiscard]] const Option* optionNamed(const Command& command, std::string_view name);

/// The options of a command, including --help.
[[nodiscard]] std::vector<Option> optionsOf(const Command& command);

/// The command and all its subcommands, each before its own.
[[nodiscard]] std::vector<const Command*> withAllBelow(const Command& command);

/// The words of "a b c".
[[nodiscard]] std::vector<std::string_view> wordsOf(std::string_view text);
[[nodiscard]] std::string valueShown(const Option& option); ///< "N", "part|system"
[[nodiscard]] std::string asTyped(const Option& option);    ///< "--parts N"

} // namespace sparkout::manual
