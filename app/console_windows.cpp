// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include "core/file/file_system.h"

#include <fcntl.h>
#include <io.h>
// Must precede the headers that need it.
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
    if (::GetConsoleMode(errors, &mode)) { // lets a line of progress be overwritten
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
    int count = 0; // the arguments of main() have only the letters of one language
    if (wchar_t** const given = ::CommandLineToArgvW(::GetCommandLineW(), &count)) {
        for (int i = 1; i < count; ++i) {
            words.push_back(utf8(std::filesystem::path(given[i])));
        }
        ::LocalFree(given);
    }
    return words;
}

bool isTerminal(std::FILE* stream) {
    DWORD mode = 0; // distinguishes a terminal from NUL, which _isatty() does not
    return ::GetConsoleMode(reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(stream))), &mode);
}

} // namespace sparkout::cli
