// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include <csignal>

#include <unistd.h>

namespace sparkout::cli {

void prepareConsole() {
    std::signal(SIGPIPE, SIG_IGN);
}

void useConsoleOfCaller() {}

std::vector<std::string> argumentsOf(int argc, char** argv) {
    return {argv + (argc > 0 ? 1 : 0), argv + argc};
}

bool isTerminal(std::FILE* stream) {
    return ::isatty(::fileno(stream)) == 1;
}

} // namespace sparkout::cli
