// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/console.h"

#include "core/files/file_system.h"

#include <fcntl.h>
#include <io.h>
// Before what needs it.
#include <windows.h>

#include <shellapi.h>

namespace sparkout::cli {

void prepareConsole() {
    ::SetConsoleOutputCP(CP_UTF8);
    for (std::FILE* stream : {stdout, stderr}) {
        ::_setmode(::_fileno(stream), _O_BINARY);
    }
    const HANDLE errors = ::GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    if (::GetConsoleMode(errors, &mode)) { // so that a line of progress can be written over
        ::SetConsoleMode(errors, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
}

void useConsoleOfCaller() {
    const bool none = ::GetStdHandle(STD_OUTPUT_HANDLE) == nullptr;
    if (none && ::AttachConsole(ATTACH_PARENT_PROCESS)) {
        (void)std::freopen("CONOUT$", "w", stdout);
        (void)std::freopen("CONOUT$", "w", stderr);
    }
    ::SetConsoleOutputCP(CP_UTF8);
}

std::vector<std::string> argumentsOf(int /*argc*/, char** /*argv*/) {
    std::vector<std::string> words;
    int count = 0; // those of main() are in letters of one language alone
    if (wchar_t** const given = ::CommandLineToArgvW(::GetCommandLineW(), &count)) {
        for (int i = 1; i < count; ++i) {
            words.push_back(utf8(std::filesystem::path(given[i])));
        }
        ::LocalFree(given);
    }
    return words;
}

bool isTerminal(std::FILE* stream) {
    DWORD mode = 0; // NUL is a terminal to _isatty()
    return ::GetConsoleMode(reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(stream))), &mode);
}

} // namespace sparkout::cli
