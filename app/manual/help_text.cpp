// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/help_text.h"

#include <string_view>
#include <vector>

namespace sparkout::manual {

namespace {

constexpr std::size_t lineWidth = 96, commandColumn = 12, optionColumn = 24, statusColumn = 12;

/// The number of characters, not bytes.
std::size_t widthOf(std::string_view text) {
    std::size_t width = 0;
    for (const char c : text) {
        width += (static_cast<unsigned char>(c) & 0xc0U) != 0x80U ? 1 : 0;
    }
    return width;
}

/// A term and its description, which is wrapped in a column.
std::string entry(const std::string& term, std::string_view text, std::size_t column) {
    std::string all = term;
    std::size_t at = widthOf(term);
    if (!term.empty() && at + 2 > column) {
        all += '\n';
        at = 0;
    }
    all.append(column - at, ' ');
    at = column;
    for (const std::string_view word : wordsOf(text)) {
        if (at > column && at + 1 + widthOf(word) > lineWidth) {
            all += '\n';
            all.append(column, ' ');
            at = column;
        }
        if (at > column) {
            all += ' ';
            ++at;
        }
        all += word;
        at += widthOf(word);
    }
    return all + '\n';
}

std::string entryOf(const Option& option) {
    const std::string other = *option.shortName == '\0' ? "" : std::string(", ") + option.shortName;
    return entry("  " + asTyped(option) + other, option.text.english, optionColumn);
}

/// A command and its operands and options, wrapped at the width and indented below them.
std::string broken(const std::string& begin, const std::vector<std::string>& parts,
                   std::size_t width) {
    std::string all = begin;
    std::size_t at = widthOf(begin);
    for (const std::string& part : parts) {
        if (at > widthOf(begin) && at + 1 + widthOf(part) > width) {
            all += '\n' + std::string(widthOf(begin), ' ');
            at = widthOf(begin);
        }
        all += ' ' + part;
        at += 1 + widthOf(part);
    }
    return all + '\n';
}

/// The operands and options of a command, with optional ones in brackets; alternatives are grouped.
std::vector<std::string> partsOf(const Command& command) {
    std::vector<std::string> parts{command.operands.shown};
    for (const Option& option : command.options) {
        std::string part;
        bool isFirst = true;
        for (const Option& other : command.options) {
            const std::string_view group = other.group;
            if (&other == &option || (!group.empty() && group == option.group)) {
                isFirst = isFirst && (!part.empty() || &other == &option);
                part += (part.empty() ? "" : " | ") + asTyped(other);
            }
        }
        if (isFirst) {
            parts.push_back(option.isRequired ? part : '[' + part + ']');
        }
    }
    return parts;
}

/// The words of a usage line; a part in brackets is one word.
std::vector<std::string> partsOf(std::string_view form) {
    std::vector<std::string> parts;
    for (const std::string_view word : wordsOf(form)) {
        const bool isOpen =
            !parts.empty() && parts.back().starts_with('[') && !parts.back().ends_with(']');
        if (isOpen) {
            parts.back() += ' ' + std::string(word);
        } else {
            parts.emplace_back(word);
        }
    }
    return parts;
}

std::string blockOf(const Command& command) {
    std::string all;
    for (const Command* each : withAllBelow(command)) {
        all += entry(each->name, each->text.english, commandColumn);
        for (const Option& option : each->options) {
            all += entryOf(option);
        }
    }
    return all;
}

bool isWhole(const Program& program, const Command& command) {
    return &command == &program;
}

std::string wholeHelp(const Program& program) {
    std::string all = std::string(program.name) + ": " + program.text.english + "\n\n";
    all += usageLines(program, program, lineWidth, "  ");
    all += '\n' + entry("", program.description.english, 0) + '\n';
    for (const Command& command : program.commands) {
        all += blockOf(command);
    }
    if (!program.commands.empty()) {
        all += '\n';
    }
    for (const Option& option : optionsOf(program)) {
        all += entryOf(option);
    }
    all += '\n';
    for (const Text& note : program.notes) {
        all += entry("", note.english, 0) + '\n';
    }
    all += "Exit status\n";
    for (const Status& status : program.statuses) {
        all += entry(std::string("  ") + status.codes, status.text.english, statusColumn);
    }
    return all;
}

} // namespace

std::string usageLines(const Program& program, const Command& command, std::size_t width,
                       const std::string& indent) {
    const std::string begin = indent + program.name;
    std::string all;
    if (isWhole(program, command)) {
        for (const char* form : program.forms) {
            all += broken(begin, partsOf(form), width);
        }
    }
    for (const Command* each : withAllBelow(command)) {
        if (each->commands.empty() && !isWhole(program, *each)) {
            all += broken(begin + ' ' + each->name, partsOf(*each), width);
        }
    }
    if (isWhole(program, command) && program.forms.empty()) {
        std::string alone;
        for (const Option& option : optionsOf(program)) {
            alone += (alone.empty() ? "" : " | ") + asTyped(option);
        }
        all += broken(begin, {alone}, width);
    }
    return all;
}

std::string helpText(const Program& program, const Command& command) {
    if (isWhole(program, command)) {
        return wholeHelp(program);
    }
    return usageLines(program, command, lineWidth, "  ") + '\n' + blockOf(command) + '\n'
           + entryOf(helpOption);
}

} // namespace sparkout::manual
