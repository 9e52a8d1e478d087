// SPDX-License-Identifier: GPL-3.0-or-later
// Saves known bytes and prints what the safe writer reported; driven by safe_file_faults.py.
//   safe_file_probe save PATH SIZE SEED [--backup]   one save
//   safe_file_probe loop PATH SIZE [--backup]        saves seeds 1, 2, ... until it is killed
//   safe_file_probe cases     a save for each line "PATH SIZE SEED [--backup]" of the input
//   safe_file_probe read PATH LIMIT
#include "core/file/safe_file.h"

#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <unistd.h>

using namespace sparkout;

namespace {

/// The same bytes as content() in safe_file_faults.py.
std::string content(std::size_t size, const std::string& seed) {
    std::string text = seed + " " + std::to_string(size) + "\n";
    while (text.size() < size)
        text += seed + ",";
    text.resize(size);
    return text;
}

const char* stepName(FileStep step) {
    switch (step) {
    case FileStep::inspect: return "inspect";
    case FileStep::notRegular: return "notRegular";
    case FileStep::readOnly: return "readOnly";
    case FileStep::open: return "open";
    case FileStep::create: return "create";
    case FileStep::permissions: return "permissions";
    case FileStep::write: return "write";
    case FileStep::sync: return "sync";
    case FileStep::close: return "close";
    case FileStep::backup: return "backup";
    case FileStep::rename: return "rename";
    case FileStep::verify: return "verify";
    case FileStep::read: return "read";
    case FileStep::tooLarge: return "tooLarge";
    case FileStep::changed: return "changed";
    case FileStep::content: return "content";
    }
    return "?";
}

/// One line: "ok" or "error STEP ERRNO replaced=0|1 free=BYTES|-".
bool print(const std::optional<FileError>& error) {
    std::string line = "ok\n";
    if (error)
        line = "error " + std::string(stepName(error->step)) + " "
               + std::to_string(error->systemError) + " replaced=" + (error->replaced ? "1" : "0")
               + " free=" + (error->freeBytes ? std::to_string(*error->freeBytes) : "-") + "\n";
    std::cout << line << std::flush;
    return !error;
}

/// Marks the system calls of the save in strace's output.
void mark(const char* name) {
    (void)!::access(name, F_OK);
}

bool saveOnce(const std::string& path, std::size_t size, const std::string& seed, bool backup) {
    const std::string bytes = content(size, seed);
    mark("/sparkout-probe-begin");
    const auto error = writeFileSafely(path, bytes, {.keepBackup = backup});
    mark("/sparkout-probe-end");
    return print(error);
}

int saveForever(const std::string& path, std::size_t size, bool backup) {
    for (long seed = 1;; ++seed) {
        if (writeFileSafely(path, content(size, std::to_string(seed)), {.keepBackup = backup}))
            return 1;
        std::cout << seed << "\n" << std::flush;
    }
}

int saveEachCase() {
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string path, seed, backup;
        std::size_t size = 0;
        words >> path >> size >> seed >> backup;
        print(writeFileSafely(path, content(size, seed), {.keepBackup = !backup.empty()}));
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    const std::string mode = argc > 1 ? argv[1] : "";
    const bool backup = argc > 1 && std::strcmp(argv[argc - 1], "--backup") == 0;
    if (mode == "save" && argc >= 5)
        return saveOnce(argv[2], std::strtoul(argv[3], nullptr, 10), argv[4], backup) ? 0 : 1;
    if (mode == "loop" && argc >= 4)
        return saveForever(argv[2], std::strtoul(argv[3], nullptr, 10), backup);
    if (mode == "cases")
        return saveEachCase();
    if (mode == "read" && argc >= 4) {
        const auto result = readFile(argv[2], std::strtoul(argv[3], nullptr, 10));
        const auto* error = std::get_if<FileError>(&result);
        return print(error != nullptr ? std::optional(*error) : std::nullopt) ? 0 : 1;
    }
    std::cerr << "usage: safe_file_probe save PATH SIZE SEED [--backup] | loop PATH SIZE "
                 "[--backup] | cases | read PATH LIMIT\n";
    return 2;
}
