// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the help pages of the project and lesson files and the JSON Schemas into a folder,
// resources/help, and the stubs of the Python module, python/sparkout.pyi, from sparkout.pyi.in.
#include "core/file/safe_file.h"
#include "words/json_schema.h"
#include "words/lesson_page.h"
#include "words/reference_page.h"
#include "words/result_schema.h"

#include <cstdio>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

int sayError(const sparkout::FileError& error) {
    std::fprintf(stderr, "%s: %s\n", error.path.c_str(), fileStepText(error.step));
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    using namespace sparkout;
    if (argc != 2 && argc != 3) {
        std::fputs("usage: sparkout-reference FOLDER [STUBS]\n", stderr);
        return 2;
    }
    const std::string folder = argv[1];
    std::vector files{std::pair{folder + "/en/project-file.md", referencePage()},
                      std::pair{folder + "/en/lesson-file.md", lessonPage()},
                      std::pair{folder + "/project.schema.json", projectSchema()},
                      std::pair{folder + "/lesson.schema.json", lessonSchema()},
                      std::pair{folder + "/results.schema.json", resultSchema()}};
    if (argc == 3) {
        constexpr std::uintmax_t most = 1'000'000;
        const auto byHand = readFile(std::string(argv[2]) + ".in", most);
        if (const auto* error = std::get_if<FileError>(&byHand)) {
            return sayError(*error);
        }
        files.emplace_back(argv[2], resultStubs(std::get<std::string>(byHand)));
    }
    for (const auto& [file, text] : files) {
        if (const auto error = writeFileSafely(file, text)) {
            return sayError(*error);
        }
    }
    return 0;
}
