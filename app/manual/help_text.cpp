// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/help_text.h"

#include <algorithm>
#include <string_view>

namespace sparkout::manual {

namespace {

constexpr std::size_t lineWidth = 96, commandColumn = 12, optionColumn = 24, statusColumn = 12;

/// Signs, not bytes.
std::size_t widthOf(std::string_view text) {
    std::size_t width = 0;
    for (const char c : text) {
        width += (static_cast<unsigned char>(c) & 0xc0U) != 0x80U ? 1 : 0;
    }
    return width;
}

/// A term and what it means, which stands in its column and is broken there.
std::string entry(const std::string& term, std::string_view text, std::size_t column) {
    std::string all = term;
    std::size_t at = widthOf(term);
    if (!term.empty() && at + 2 > column) {
        all += '\n';
        at = 0;
    }
    all.append(column - at, ' ');
    at = column;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
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
    std::string term = std::string("  ") + option.name;
    if (*option.value != '\0') {
        term += std::string(" ") + option.value;
    }
    return entry(term, option.text.english, optionColumn);
}

/// A line of the synopsis; what follows it stands below what follows the command.
std::string usageLine(const Program& program, std::string_view line) {
    const std::size_t command = program.commands.empty() ? 0 : line.find(' ') + 1;
    const std::string begin = std::string("  ") + program.name + ' ';
    std::string all = begin;
    for (const char c : line) {
        all += c;
        if (c == '\n') {
            all.append(begin.size() + command, ' ');
        }
    }
    return all + '\n';
}

} // namespace

std::string helpText(const Program& program) {
    std::string all = std::string(program.name) + ": " + program.purpose.english + "\n\n";
    for (const char* line : program.synopsis) {
        all += usageLine(program, line);
    }
    all += '\n' + entry("", program.description.english, 0) + '\n';
    for (const Command& command : program.commands) {
        all += entry(command.name, command.text.english, commandColumn);
        for (const Option& option : command.options) {
            all += entryOf(option);
        }
    }
    if (!program.commands.empty()) {
        all += '\n';
    }
    for (const Option& option : program.options) {
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

} // namespace sparkout::manual
