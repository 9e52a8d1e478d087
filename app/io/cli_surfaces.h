// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/io/cli_io.h"
#include "app/manual/given.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace sparkout::cli {

/// The surfaces of a file that a command applies to: `--surface NAME|N|all`.
class Surfaces {
public:
    /// Reads the file; reports its faults, or that it has no such surface.
    explicit Surfaces(const manual::Given& given, BatchFaults faults = BatchFaults::warnings);

    [[nodiscard]] int status() const { return m_status; } ///< `done` if surfaces were chosen
    [[nodiscard]] const Setup& setup() const { return m_setup; }
    /// Whether all surfaces of a set-up are chosen.
    [[nodiscard]] bool isWhole() const;
    /// For options that apply to a single surface: `done`, or an error that asks for its name.
    [[nodiscard]] int oneFor(std::initializer_list<const char*> options) const;

    [[nodiscard]] std::string nameOf(std::size_t surface) const; ///< for messages
    [[nodiscard]] std::string heading(std::size_t surface) const;

    /// A command on one project; `name`, for messages, is that of the file, with the surface if
    /// there are several.
    using Command =
        std::function<int(Project project, std::size_t surface, const std::string& name)>;
    /// Runs a command on each surface, with a heading above each text or all results in one JSON
    /// object. The exit status is the first that is not `done`; Ctrl+C ends the run after the
    /// surface that it interrupts.
    [[nodiscard]] int run(const Command& command) const;
    /// Runs a command on the projects of a set-up that the command may change meanwhile.
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
