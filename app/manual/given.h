// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/command_line.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout::manual {

/// A command with the given options and operands. Requesting an option that the command does not
/// have, or a value of another kind, is a programming error and throws std::logic_error.
class Given {
public:
    explicit Given(const Command& of) : m_command(&of) {}

    [[nodiscard]] const Command& command() const { return *m_command; }
    std::vector<std::string> operands; ///< their number is as in the table

    [[nodiscard]] bool has(std::string_view option) const;
    [[nodiscard]] const std::string& text(std::string_view option) const; ///< empty: not given
    [[nodiscard]] std::optional<int> integer(std::string_view option) const;
    [[nodiscard]] std::optional<double> number(std::string_view option) const;
    // Lists; empty: not given.
    [[nodiscard]] std::vector<int> integers(std::string_view option) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view option) const;

    /// The refusal of an option's text, for commands that parse it themselves: "--shard needs I/N,
    /// not “3”".
    [[nodiscard]] std::string refusal(std::string_view option) const;

private:
    friend struct Reading;
    [[nodiscard]] const Option& row(std::string_view option) const;
    [[nodiscard]] const Value& value(std::string_view option, Kind kind) const;

    const Command* m_command;
    std::map<std::string_view, std::string> m_values; ///< values by the name of the row
};

/// Parses the words after the program's name by its table.
struct Reading {
    Reading(const Program& program, const std::vector<std::string>& words);

    Given given;
    std::string fault; ///< fault of the words, in half a sentence; empty without one
    bool asksForHelp = false;

private:
    std::size_t readCommand(const std::vector<std::string>& words);
    std::size_t readOption(const std::vector<std::string>& words, std::size_t at);
    void checkTogether();
    [[nodiscard]] std::string contradictionOf(const Option& option) const;
};

} // namespace sparkout::manual
