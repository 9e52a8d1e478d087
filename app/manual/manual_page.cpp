// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/help_text.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace sparkout::manual {

namespace {

constexpr Text nameHead{"NAME", "ИМЯ"}, synopsisHead{"SYNOPSIS", "ОБЗОР"},
    descriptionHead{"DESCRIPTION", "ОПИСАНИЕ"}, commandsHead{"COMMANDS", "КОМАНДЫ"},
    optionsHead{"OPTIONS", "ПАРАМЕТРЫ"}, notesHead{"NOTES", "ЗАМЕЧАНИЯ"},
    statusHead{"EXIT STATUS", "КОД ЗАВЕРШЕНИЯ"}, seeHead{"SEE ALSO", "СМ. ТАКЖЕ"},
    manualName{"User Commands", "Пользовательские команды"};

/// Escapes a text so that roff finds no request or escape in it.
std::string roff(std::string_view text) {
    std::string all;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) {
            all += "\\&";
        }
        all += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
        begins = c == '\n';
    }
    return all;
}

std::string head(const Text& text, Tongue tongue) {
    return std::string(".SH \"") + text.in(tongue) + "\"\n";
}

std::string entry(const std::string& term, const char* text) {
    return ".TP\n" + term + '\n' + roff(text) + '\n';
}

std::string entryOf(const Option& option, Tongue tongue) {
    std::string term = "\\fB" + roff(option.name) + "\\fR";
    if (*option.shortName != '\0') {
        term += ", \\fB" + roff(option.shortName) + "\\fR";
    }
    if (const std::string value = valueShown(option); !value.empty()) {
        term += " \\fI" + roff(value) + "\\fR";
    }
    return entry(term, option.text.in(tongue));
}

std::string commandsOf(const Program& program, Tongue tongue) {
    std::string all;
    for (const Command& top : program.commands) {
        for (const Command* command : withAllBelow(top)) {
            all += ".SS " + roff(command->name) + '\n' + roff(command->text.in(tongue)) + '\n';
            for (const Option& option : command->options) {
                all += entryOf(option, tongue);
            }
        }
    }
    return all;
}

/// A reference to the other program.
std::string seeAlso(const Program& program) {
    const Program& other = &program == &windowProgram() ? commandLineProgram() : windowProgram();
    return "\\fB" + roff(other.name) + "\\fR(1)\n";
}

} // namespace

std::string manualPage(const Program& program, Tongue tongue, const std::string& version) {
    std::string title = program.name;
    std::ranges::transform(title, title.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    std::string all = ".\\\" Written from the table of the program's options (app/manual).\n";
    all += ".TH " + roff(title) + " 1 \"\" \"Sparkout " + version + "\" \"" + manualName.in(tongue)
           + "\"\n";
    all += head(nameHead, tongue) + roff(program.name) + " \\- " + roff(program.text.in(tongue))
           + '\n';
    all += head(synopsisHead, tongue) + ".nf\n";
    constexpr std::size_t synopsisWidth = 72; // of 80, indented
    std::istringstream lines(usageLines(program, program, synopsisWidth));
    for (std::string line; std::getline(lines, line);) {
        const std::string_view name = line.starts_with(program.name) ? program.name : "";
        all += "\\fB" + roff(name) + "\\fR" + roff(line.substr(name.size())) + '\n';
    }
    all += ".fi\n" + head(descriptionHead, tongue) + roff(program.description.in(tongue)) + '\n';
    if (!program.commands.empty()) {
        all += head(commandsHead, tongue) + commandsOf(program, tongue);
    }
    all += head(optionsHead, tongue);
    for (const Option& option : optionsOf(program)) {
        all += entryOf(option, tongue);
    }
    all += head(notesHead, tongue);
    for (const Text& note : program.notes) {
        all += roff(note.in(tongue)) + "\n.PP\n";
    }
    all.erase(all.size() - 4); // removes the paragraph after the last one
    all += head(statusHead, tongue);
    for (const Status& status : program.statuses) {
        all += entry(std::string("\\fB") + status.codes + "\\fR", status.text.in(tongue));
    }
    return all + head(seeHead, tongue) + seeAlso(program);
}

} // namespace sparkout::manual
