// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout::manual {

/// A command with the options and operands it was given. To ask for an option that the table does
/// not give to the command, or for a value of another kind, is a mistake of the program: it throws
/// std::logic_error.
class Given {
public:
    explicit Given(const Command& of) : m_command(&of) {}

    [[nodiscard]] const Command& command() const { return *m_command; }
    std::vector<std::string> operands; ///< as many as the table says

    [[nodiscard]] bool has(std::string_view option) const;
    [[nodiscard]] const std::string& text(std::string_view option) const; ///< empty: not given
    [[nodiscard]] std::optional<int> integer(std::string_view option) const;
    [[nodiscard]] std::optional<double> number(std::string_view option) const;
    [[nodiscard]] std::vector<int> integers(std::string_view option) const; ///< empty: not given

    /// Why the text of an option is refused, where the command reads it itself: "--shard needs I/N,
    /// not “3”".
    [[nodiscard]] std::string refusal(std::string_view option) const;

private:
    friend struct Reading;
    [[nodiscard]] const Option& row(std::string_view option) const;
    [[nodiscard]] const Value& value(std::string_view option, Kind kind) const;

    const Command* m_command;
    std::map<std::string_view, std::string> m_values; ///< by the name of the row
};

/// The words after the program's name, read by its table.
struct Reading {
    Reading(const Program& program, const std::vector<std::string>& words);

    Given given;
    std::string fault; ///< what is wrong with them, in half a sentence; empty: nothing
    bool asksForHelp = false;

private:
    std::size_t readCommand(const std::vector<std::string>& words);
    std::size_t readOption(const std::vector<std::string>& words, std::size_t at);
    void checkTogether();
    [[nodiscard]] std::string contradictionOf(const Option& option) const;
};

} // namespace sparkout::manual
