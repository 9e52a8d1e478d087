// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The console from which a program was started: the differences between systems are in
// console_posix.cpp and console_windows.cpp.

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout::cli {

/// Call before anything is printed: a closed pipe then is a write error, and output is UTF-8 with
/// lines that end in \n only.
void prepareConsole();

/// A program with a window has no console on Windows: connects it to that of its caller, if there
/// is one and the output is not redirected.
void useConsoleOfCaller();

/// The words after the program's name, in the encoding of the core's texts: the system's bytes on
/// POSIX, UTF-8 on Windows.
[[nodiscard]] std::vector<std::string> argumentsOf(int argc, char** argv);

[[nodiscard]] bool isTerminal(std::FILE* stream);

/// The only way for texts to the standard output and the standard error: control characters, which
/// may come from any name or answer, are shown as \uXXXX, except line ends.
void printText(std::FILE* stream, std::string_view text);

/// Prints a text in place of the last line of a terminal.
void printOverLine(std::FILE* terminal, std::string_view text);

} // namespace sparkout::cli
