// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The console a program was started from: what differs between systems is in console_posix.cpp and
// console_windows.cpp.

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout::cli {

/// Before anything is printed: a closed pipe is a write error from now on, and what is printed is
/// UTF-8 with lines that end in \n alone.
void prepareConsole();

/// A program with a window has no console on Windows: it prints to that of its caller, if there is
/// one and the output goes nowhere else.
void useConsoleOfCaller();

/// The words after the program's name, as the core takes texts: the system's bytes on POSIX, UTF-8
/// on Windows.
[[nodiscard]] std::vector<std::string> argumentsOf(int argc, char** argv);

[[nodiscard]] bool isTerminal(std::FILE* stream);

/// The one way of texts to the standard output and the standard error: characters that steer a
/// terminal are shown as \uXXXX, whichever name or answer they came with. Line ends alone stay.
void printText(std::FILE* stream, std::string_view text);

/// The same, in place of the line that a terminal has at its end.
void printOverLine(std::FILE* terminal, std::string_view text);

} // namespace sparkout::cli
