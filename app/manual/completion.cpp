// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/completion.h"

#include <algorithm>
#include <string_view>

namespace sparkout::manual {

namespace {

const std::string notice = "written from the table of the program's options (app/manual)\n";

/// What a shell shows of a description: its beginning.
std::string briefly(const Text& text) {
    const std::string_view all = text.english;
    return std::string(all.substr(0, all.find_first_of(";:.(\"")));
}

std::string namesOf(const std::vector<Option>& options) {
    std::string all;
    for (const Option& option : options) {
        all += (all.empty() ? "" : " ") + std::string(option.name);
    }
    return all;
}

const char* kindName(Kind kind) {
    switch (kind) {
    case Kind::project: return "project";
    case Kind::file: return "file";
    case Kind::folder: return "folder";
    case Kind::choice: return "choice";
    case Kind::none:
    case Kind::anything: break;
    }
    return "anything";
}

std::string functionName(const Program& program) {
    std::string name = std::string("_") + program.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

// --- bash
// -----------------------------------------------------------------------------------------

/// What stands after an option, by the word before.
std::string bashValues(const std::vector<Option>& options, const std::string& indent) {
    std::string all;
    for (const Option& option : options) {
        if (option.kind == Kind::none) {
            continue;
        }
        all += indent + "    " + option.name + ") kind=\"" + kindName(option.kind) + '"';
        if (option.kind == Kind::choice) {
            all += std::string(" words=\"") + option.choices + '"';
        }
        all += " ;;\n";
    }
    return all.empty() ? all : indent + "case $prev in\n" + all + indent + "esac\n";
}

std::string bashState(Kind operand, const std::vector<Option>& options, const std::string& indent) {
    return indent + "kind=\"" + kindName(operand) + "\" options=\"" + namesOf(options) + "\"\n"
           + bashValues(options, indent);
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
    if (program.commands.empty()) {
        all += bashState(Kind::project, program.options, "    ");
    } else {
        std::string commands;
        for (const Command& command : program.commands) {
            commands += std::string(command.name) + ' ';
        }
        all += "    if ((COMP_CWORD == 1)); then\n        mapfile -t COMPREPLY < <(compgen -W \""
               + commands + namesOf(program.options)
               + "\" -- \"$cur\")\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n";
        for (const Command& command : program.commands) {
            all += std::string("        ") + command.name + ")\n"
                   + bashState(command.operand, command.options, "            ")
                   + "            ;;\n";
        }
        all += "        *) return ;;\n    esac\n";
    }
    return all + bashEnd + "complete -F " + function + ' ' + program.name + '\n';
}

// --- zsh
// ------------------------------------------------------------------------------------------

namespace {

/// In single quotes and in a specification of _arguments.
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
    case Kind::none:
    case Kind::anything: break;
    }
    return " ";
}

std::string zshArguments(Kind operand, const std::vector<Option>& options,
                         const std::string& indent) {
    std::string all = indent + "_arguments";
    for (const Option& option : options) {
        all += " \\\n" + indent + "    '" + option.name + '[' + zshText(briefly(option.text)) + ']';
        if (option.kind != Kind::none) {
            all += ':' + zshText(option.value) + ':' + zshAction(option.kind, option.choices);
        }
        all += '\'';
    }
    return all + " \\\n" + indent + "    '*:" + kindName(operand) + ':' + zshAction(operand, "")
           + "'\n";
}

} // namespace

std::string zshCompletion(const Program& program) {
    std::string all = std::string("#compdef ") + program.name + "\n# zsh: " + notice;
    if (program.commands.empty()) {
        return all + zshArguments(Kind::project, program.options, "");
    }
    all += "local -a commands=(\n";
    for (const Command& command : program.commands) {
        all += std::string("    '") + command.name + ':' + zshText(briefly(command.text)) + "'\n";
    }
    all += ")\nif ((CURRENT == 2)); then\n    _describe command commands\n    compadd -- "
           + namesOf(program.options)
           + "\n    return\nfi\nshift words\n((CURRENT--))\ncase $words[1] in\n";
    for (const Command& command : program.commands) {
        all += std::string("    ") + command.name + ")\n"
               + zshArguments(command.operand, command.options, "        ") + "        ;;\n";
    }
    return all + "esac\n";
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

/// What an operand or a value completes to; empty: it is files, or nothing that could be listed.
std::string fishCandidates(Kind kind, const char* choices) {
    return kind == Kind::project  ? "(__fish_complete_suffix .sparkout)"
           : kind == Kind::folder ? "(__fish_complete_directories)"
           : kind == Kind::choice ? choices
                                  : "";
}

std::string fishOption(const std::string& begin, const Option& option) {
    const std::string_view name = option.name;
    const bool isLong = name.starts_with("--");
    std::string all = begin + (isLong ? " -l " : " -s ") + std::string(name.substr(isLong ? 2 : 1));
    const std::string candidates = fishCandidates(option.kind, option.choices);
    if (option.kind == Kind::file) {
        all += " -r -F";
    } else if (option.kind != Kind::none) {
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

} // namespace

std::string fishCompletion(const Program& program) {
    const std::string begin = std::string("complete -c ") + program.name;
    std::string all = "# fish: " + notice + begin + " -f\n";
    const std::string first = begin + (program.commands.empty() ? "" : " -n __fish_use_subcommand");
    for (const Option& option : program.options) {
        all += fishOption(first, option);
    }
    if (program.commands.empty()) {
        return all + fishOperand(begin, Kind::project);
    }
    for (const Command& command : program.commands) {
        all += first + " -a " + command.name + " -d " + fishQuoted(briefly(command.text)) + '\n';
        const std::string seen = begin + " -n '__fish_seen_subcommand_from " + command.name + "'";
        for (const Option& option : command.options) {
            all += fishOption(seen, option);
        }
        all += fishOperand(seen, command.operand);
    }
    return all;
}

} // namespace sparkout::manual
