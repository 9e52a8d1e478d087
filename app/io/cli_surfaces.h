// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace sparkout::cli {

/// What a command is to take of a file: `--surface NAME|N|all`.
class Surfaces {
public:
    /// Reads the file; what is wrong with it, or that it has no such surface, is reported.
    explicit Surfaces(const manual::Given& given);

    [[nodiscard]] int status() const { return m_status; } ///< `done`: something was chosen
    [[nodiscard]] const Setup& setup() const { return m_setup; }
    /// All of a set-up, and not one surface alone.
    [[nodiscard]] bool isWhole() const;
    /// Of options that are for one surface: `done`, or that one has to be named, which is reported.
    [[nodiscard]] int oneFor(std::initializer_list<const char*> options) const;

    [[nodiscard]] std::string nameOf(std::size_t surface) const; ///< for messages
    [[nodiscard]] std::string heading(std::size_t surface) const;

    /// A command on one project: the name for messages is that of the file, with the surface where
    /// there are several.
    using Command =
        std::function<int(Project project, std::size_t surface, const std::string& name)>;
    /// Runs it on each, with a heading above each text or all in one JSON object. The exit status
    /// is the first that is not `done`; Ctrl+C ends it after the surface that it interrupts.
    [[nodiscard]] int run(const Command& command) const;
    /// The same on the projects of a set-up that the command may change meanwhile.
    [[nodiscard]] int run(const Setup& setup, const Command& command) const;

private:
    int runOne(const Setup& setup, const Command& command, std::size_t surface) const;

    const manual::Given& m_given;
    std::string m_file;
    Setup m_setup;
    std::vector<std::size_t> m_chosen;
    bool m_isWhole = false;
    int m_status;
};

} // namespace sparkout::cli
