// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/io/exit_status.h"
#include "core/files/safe_file.h"
#include "core/issue.h"
#include "core/measured/cell_fault.h"
#include "core/setup/setup.h"

#include <cstdio>
#include <optional>
#include <string>

namespace sparkout::cli {

void print(std::FILE* stream, const std::string& text);

/// As long as it lives, what is printed to the standard output is kept instead.
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

/// Whether everything printed so far has reached the standard output; says so if not.
[[nodiscard]] bool outputTaken();

/// Says what is wrong with the command line; returns its exit status.
int usageError(const std::string& message);

/// "FILE: what went wrong", a line.
[[nodiscard]] std::string describe(const FileError& error);

void printIssues(const std::string& file, const Issues& issues);

/// The faults of a table, each by its line and column.
void printFaults(const std::string& file, const CellFaults& faults);

/// The bytes of a file; nothing when it cannot be read, which is said.
[[nodiscard]] std::optional<std::string> readOrSay(const std::string& file, std::size_t most);

/// Reads and checks a set-up, of one surface or several; prints every fault, one a line.
[[nodiscard]] std::optional<Setup> loadSetup(const std::string& file);

/// Writes a file; returns the exit status.
[[nodiscard]] int save(const std::string& file, const std::string& content);

[[nodiscard]] bool isSameFile(const std::string& a, const std::string& b);

/// Whether writing to the file would lose a project, by a slip on the command line.
[[nodiscard]] bool replacesProject(const std::string& file, const std::string& project);

} // namespace sparkout::cli
