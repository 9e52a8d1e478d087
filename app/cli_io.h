// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/field.h"
#include "core/file/safe_file.h"
#include "core/issue.h"
#include "core/measured/number_table.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout::cli {

/// Exit status of the program. `interrupted` plus the number of the signal is 130 or 143, as shells
/// report Ctrl+C and SIGTERM, for a command that was ended without an answer, or with a part of it.
/// `nothingFeasible` is an answer, for which every cycle was decided.
enum Exit {
    done = 0,
    refused = 1,
    usage = 2,
    cannotReachSize = 3,
    requirementFails = 4,
    nothingFeasible = 5,
    undecided = 6, ///< no cycle was found, but there may be one: the time was up, or the method
                   ///< proves nothing
    interrupted = 128
};

void print(std::FILE* stream, const std::string& text);

/// During its lifetime, output to the standard output is captured.
class CapturedOutput {
public:
    CapturedOutput();
    ~CapturedOutput();
    CapturedOutput(const CapturedOutput&) = delete;
    CapturedOutput& operator=(const CapturedOutput&) = delete;

    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    friend void print(std::FILE* stream, const std::string& text);
    std::string m_text;
};

/// Whether everything printed so far has reached the standard output; reports a failure.
[[nodiscard]] bool outputTaken();

/// Reports a fault of the command line; returns its exit status.
int usageError(const std::string& message);

/// One line: "FILE: what went wrong".
[[nodiscard]] std::string describe(const FileError& error);

void printIssues(const std::string& file, const Issues& issues);

/// Prints the faults of a table, each with its line and column.
void printFaults(const std::string& file, const CellFaults& faults);

/// Prints the kept runs of a project whose results differ from the engine's to stderr, one on a
/// line; returns their names.
std::vector<std::string> printUntrueRuns(const std::string& file, const Project& project);

/// The bytes of a file; if it cannot be read, reports it and returns an empty value.
[[nodiscard]] std::optional<std::string> readOrSay(const std::string& file, std::size_t most);

/// The faults of a batch that cannot be run, in a file whose cycle can: warnings where the batch is
/// not used, errors that refuse the file, or left to the command that runs the batch.
enum class BatchFaults { warnings, errors, left };

/// Reads and checks a set-up of one surface or several; prints each fault on a line.
[[nodiscard]] std::optional<Setup> loadSetup(const std::string& file,
                                             BatchFaults faults = BatchFaults::warnings);

/// Writes a file; returns the exit status.
[[nodiscard]] int save(const std::string& file, const std::string& content);

[[nodiscard]] bool isSameFile(const std::string& a, const std::string& b);

/// Whether writing to the file would overwrite a project by accident.
[[nodiscard]] bool replacesProject(const std::string& file, const std::string& project);

/// The choice that an option names by its key in files; empty if it is not given.
template <class E>
std::optional<E> choiceOf(const manual::Given& given, std::string_view option) {
    const auto choices = choicesOf<E>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (given.text(option) == choices[i].key) {
            if constexpr (detail::Kinds<E>) {
                return E::ofIndex(i);
            } else {
                return static_cast<E>(i);
            }
        }
    }
    return std::nullopt;
}

/// The surfaces of a file that a command applies to: `--surface NAME|N|all`.
class Surfaces {
public:
    /// Reads the file; reports its faults, or that it does not have this surface.
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
