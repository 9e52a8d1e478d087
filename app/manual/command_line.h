// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

/// What the programs take on their command lines, in both languages. `--help`, the manual pages and
/// the completion of the shells are written from it, and the programs accept no option that is not
/// in it.
namespace sparkout::manual {

enum class Tongue { english, russian };

struct Text {
    const char* english;
    const char* russian;

    [[nodiscard]] const char* in(Tongue tongue) const {
        return tongue == Tongue::english ? english : russian;
    }
};

/// What a value is, for the completion of shells.
enum class Kind { none, anything, project, file, folder, choice };

struct Option {
    const char* name;    ///< "--json", "-o"
    const char* value;   ///< as it is shown: "N", "OUT.csv"; empty: it takes none
    Kind kind;           ///< of its value
    const char* choices; ///< with spaces between, of a choice
    Text text;           ///< what it does
};

struct Command {
    const char* name;
    Kind operand;
    Text text;
    std::vector<Option> options;
};

struct Status {
    const char* codes;
    Text text;
};

struct Program {
    const char* name;
    Text purpose;                      ///< in half a line
    std::vector<const char*> synopsis; ///< lines as typed, the same in both languages
    Text description;
    std::vector<Option> options;   ///< of a program without commands, or of all commands
    std::vector<Command> commands; ///< the first argument of all
    std::vector<Text> notes;       ///< paragraphs
    std::vector<Status> statuses;
};

[[nodiscard]] const Program& windowProgram();      ///< sparkout
[[nodiscard]] const Program& commandLineProgram(); ///< sparkout-cli

/// Null: it has no command or option of that name.
[[nodiscard]] const Command* commandNamed(const Program& program, std::string_view name);
[[nodiscard]] const Option* optionNamed(const std::vector<Option>& options, std::string_view name);

} // namespace sparkout::manual
