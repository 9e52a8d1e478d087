// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/help_text.h"

#include <algorithm>
#include <string_view>

namespace sparkout::manual {

namespace {

const std::string notice = "written from the table of the program's options (app/manual)\n";

/// The beginning of a description, as shown by shells.
std::string briefly(const Text& text) {
    const std::string_view all = text.english;
    return std::string(all.substr(0, all.find_first_of(";:.(\"")));
}

std::string namesOf(const Command& command) {
    std::string all;
    for (const Option& option : optionsOf(command)) {
        all += (all.empty() ? "" : " ") + std::string(option.name);
    }
    return all;
}

std::string commandNames(const Command& command) {
    std::string all;
    for (const Command& each : command.commands) {
        all += std::string(each.lastWord()) + ' ';
    }
    return all;
}

/// The completion of a value: choices are offered even if other values are allowed.
Kind completionOf(const Value& value) {
    return *value.choices != '\0' ? Kind::choice : value.kind;
}

const char* kindName(Kind kind) {
    switch (kind) {
    case Kind::project: return "project";
    case Kind::file: return "file";
    case Kind::folder: return "folder";
    case Kind::choice: return "choice";
    default: return "anything";
    }
}

std::string functionName(const Program& program) {
    std::string name = std::string("_") + program.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

// --- bash
// -----------------------------------------------------------------------------------------

/// Completes the value of an option, by the previous word.
std::string bashValues(const Command& command, const std::string& indent) {
    std::string all;
    for (const Option& option : command.options) {
        const Kind kind = completionOf(option.value);
        if (kind == Kind::none) {
            continue;
        }
        all += indent + "    " + option.name + ") kind=\"" + kindName(kind) + '"';
        if (kind == Kind::choice) {
            all += std::string(" words=\"") + option.value.choices + '"';
        }
        all += " ;;\n";
    }
    return all.empty() ? all : indent + "case $prev in\n" + all + indent + "esac\n";
}

/// Selects the typed command; `word` is the index of its word.
std::string bashLevel(const Command& command, int word, const std::string& indent) {
    if (command.commands.empty()) {
        const bool isWord = command.operands.kind == Kind::anything; // options are allowed, too
        return indent + "kind=\"" + (isWord ? "word" : kindName(command.operands.kind))
               + "\" options=\"" + namesOf(command) + "\"\n" + bashValues(command, indent);
    }
    const std::string number = std::to_string(word);
    std::string all = indent + "if ((COMP_CWORD == " + number + ")); then\n" + indent
                      + "    mapfile -t COMPREPLY < <(compgen -W \"" + commandNames(command)
                      + namesOf(command) + "\" -- \"$cur\")\n" + indent + "    return\n" + indent
                      + "fi\n" + indent + "case ${COMP_WORDS[" + number + "]} in\n";
    for (const Command& each : command.commands) {
        all += indent + "    " + std::string(each.lastWord()) + ")\n"
               + bashLevel(each, word + 1, indent + "        ") + indent + "        ;;\n";
    }
    return all + indent + "    *) return ;;\n" + indent + "esac\n";
}

constexpr const char* bashEnd = R"(    case $kind in
        choice) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur") ;;
        anything) ;;
        *)
            if [[ $cur == -* ]]; then
                mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
                return
            fi
            compopt -o filenames 2>/dev/null
            case $kind in
                project) mapfile -t COMPREPLY < <(
                    compgen -f -X '!*.sparkout' -- "$cur"
                    compgen -d -- "$cur"
                ) ;;
                file) mapfile -t COMPREPLY < <(compgen -f -- "$cur") ;;
                folder) mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
            esac
            ;;
    esac
}
)";

} // namespace

std::string bashCompletion(const Program& program) {
    const std::string function = functionName(program);
    std::string all = "# bash: " + notice + function + "() {\n";
    all += "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    local kind words=\"\" options\n    COMPREPLY=()\n";
    all += bashLevel(program, 1, "    ");
    return all + bashEnd + "complete -F " + function + ' ' + program.name + '\n';
}

// --- zsh
// ------------------------------------------------------------------------------------------

namespace {

/// Escapes a text for single quotes in a specification of _arguments.
std::string zshText(std::string_view text) {
    std::string all;
    for (const char c : text) {
        all += c == '\''                                                     ? "'\\''"
               : std::string_view("[]:\\").find(c) != std::string_view::npos ? std::string("\\") + c
                                                                             : std::string(1, c);
    }
    return all;
}

std::string zshAction(Kind kind, const char* choices) {
    switch (kind) {
    case Kind::project: return "_files -g \"*.sparkout\"";
    case Kind::file: return "_files";
    case Kind::folder: return "_files -/";
    case Kind::choice: return std::string("(") + choices + ")";
    default: return " ";
    }
}

std::string zshArguments(const Command& command, const std::string& indent) {
    std::string all = indent + "_arguments";
    for (const Option& option : optionsOf(command)) {
        all += " \\\n" + indent + "    '" + option.name + '[' + zshText(briefly(option.text)) + ']';
        if (const Kind kind = completionOf(option.value); kind != Kind::none) {
            all += ':' + zshText(valueShown(option)) + ':' + zshAction(kind, option.value.choices);
        }
        all += '\'';
    }
    const Kind operand = command.operands.kind;
    return all + " \\\n" + indent + "    '*:" + kindName(operand) + ':' + zshAction(operand, "")
           + "'\n";
}

std::string zshLevel(const Command& command, const std::string& indent) {
    if (command.commands.empty()) {
        return zshArguments(command, indent);
    }
    std::string all = indent + "local -a commands=(\n";
    for (const Command& each : command.commands) {
        all += indent + "    '" + std::string(each.lastWord()) + ':' + zshText(briefly(each.text))
               + "'\n";
    }
    all += indent + ")\n" + indent + "if ((CURRENT == 2)); then\n" + indent
           + "    _describe command commands\n" + indent + "    compadd -- " + namesOf(command)
           + '\n' + indent + "    return\n" + indent + "fi\n" + indent + "shift words\n" + indent
           + "((CURRENT--))\n" + indent + "case $words[1] in\n";
    for (const Command& each : command.commands) {
        all += indent + "    " + std::string(each.lastWord()) + ")\n"
               + zshLevel(each, indent + "        ") + indent + "        ;;\n";
    }
    return all + indent + "esac\n";
}

} // namespace

std::string zshCompletion(const Program& program) {
    return std::string("#compdef ") + program.name + "\n# zsh: " + notice + zshLevel(program, "");
}

// --- fish
// -----------------------------------------------------------------------------------------

namespace {

std::string fishQuoted(std::string_view text) {
    std::string all = "'";
    for (const char c : text) {
        all += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return all + '\'';
}

/// The candidates of an operand or a value; empty for files and for values that cannot be listed.
std::string fishCandidates(Kind kind, const char* choices) {
    return kind == Kind::project  ? "(__fish_complete_suffix .sparkout)"
           : kind == Kind::folder ? "(__fish_complete_directories)"
           : kind == Kind::choice ? choices
                                  : "";
}

std::string fishOption(const std::string& begin, const Option& option) {
    std::string all = begin;
    for (const std::string_view name : {option.name, option.shortName}) {
        all += name.empty()             ? ""
               : name.starts_with("--") ? " -l " + std::string(name.substr(2))
                                        : " -s " + std::string(name.substr(1));
    }
    const Kind kind = completionOf(option.value);
    const std::string candidates = fishCandidates(kind, option.value.choices);
    if (kind == Kind::file) {
        all += " -r -F";
    } else if (kind != Kind::none) {
        all += " -x";
    }
    if (!candidates.empty()) {
        all += " -a " + fishQuoted(candidates);
    }
    return all + " -d " + fishQuoted(briefly(option.text)) + '\n';
}

std::string fishOperand(const std::string& begin, Kind kind) {
    const std::string candidates = fishCandidates(kind, "");
    return begin + (candidates.empty() ? " -F" : " -k -a " + fishQuoted(candidates)) + '\n';
}

/// `here` is true once the words of the command are typed.
std::string fishLevel(const std::string& begin, const Command& command, const std::string& here) {
    const auto where = [&begin](const std::string& condition) {
        return begin + (condition.empty() ? "" : " -n " + fishQuoted(condition));
    };
    const std::string joint = here.empty() ? "" : "; and ";
    const std::string none =
        command.commands.empty() ? here
        : here.empty()           ? "__fish_use_subcommand"
                       : here + "; and not __fish_seen_subcommand_from " + commandNames(command);
    std::string all;
    for (const Option& option : optionsOf(command)) {
        all += fishOption(where(none), option);
    }
    if (command.commands.empty()) {
        return all + fishOperand(where(here), command.operands.kind);
    }
    for (const Command& each : command.commands) {
        const std::string word(each.lastWord());
        all += where(none) + " -a " + word + " -d " + fishQuoted(briefly(each.text)) + '\n'
               + fishLevel(begin, each, here + joint + "__fish_seen_subcommand_from " + word);
    }
    return all;
}

} // namespace

std::string fishCompletion(const Program& program) {
    const std::string begin = std::string("complete -c ") + program.name;
    return "# fish: " + notice + begin + " -f\n" + fishLevel(begin, program, "");
}

} // namespace sparkout::manual
