// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the manual pages of the programs in both languages and the completion of their command
// lines into a folder with the layout of share/: sparkout-manual FOLDER. With --options it prints a
// line for each option instead: program, the words of the command, name.
#include "app/manual/command_line.h"
#include "app/manual/help_text.h"
#include "core/file/safe_file.h"
#include "core/version.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

using namespace sparkout;
using namespace sparkout::manual;

namespace {

bool write(const std::string& file, const std::string& text) {
    std::error_code error; // a folder that cannot be created is reported by its file
    std::filesystem::create_directories(std::filesystem::path(file).parent_path(), error);
    if (const auto failed = writeFileSafely(file, text)) {
        std::fprintf(stderr, "%s: %s\n", failed->path.c_str(), fileStepText(failed->step));
        return false;
    }
    return true;
}

bool writeAll(const Program& program, const std::string& folder) {
    const std::string name = program.name;
    for (const auto& [file, text] :
         {std::pair{"/man/man1/" + name + ".1", manualPage(program, Tongue::english, version)},
          std::pair{"/man/ru/man1/" + name + ".1", manualPage(program, Tongue::russian, version)},
          std::pair{"/bash-completion/completions/" + name, bashCompletion(program)},
          std::pair{"/zsh/vendor-completions/_" + name, zshCompletion(program)},
          std::pair{"/fish/vendor_completions.d/" + name + ".fish", fishCompletion(program)}}) {
        if (!write(folder + file, text)) {
            return false;
        }
    }
    return true;
}

void printOptions(const Program& program) {
    for (const Command* command : withAllBelow(program)) {
        const bool isWhole = command == &program;
        const std::string words = isWhole ? "" : ' ' + std::string(command->name);
        for (const Option& option : isWhole ? optionsOf(program) : command->options) {
            std::printf("%s%s %s\n", program.name, words.c_str(), option.name);
        }
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::string argument = argc == 2 ? argv[1] : "";
    if (argument == "--options") {
        printOptions(windowProgram());
        printOptions(commandLineProgram());
        return 0;
    }
    if (argument.empty()) {
        std::fputs("usage: sparkout-manual FOLDER | --options\n", stderr);
        return 2;
    }
    return writeAll(windowProgram(), argument) && writeAll(commandLineProgram(), argument) ? 0 : 1;
}
