// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the help pages of the project and lesson files and the JSON Schemas into a folder:
// resources/help.
#include "core/files/file_step_text.h"
#include "core/files/safe_file.h"
#include "core/reference/json_schema.h"
#include "core/reference/lesson_page.h"
#include "core/reference/lesson_schema.h"
#include "core/reference/reference_page.h"
#include "core/reference/result_schema.h"

#include <cstdio>
#include <string>

int main(int argc, char** argv) {
    using namespace sparkout;
    if (argc != 2) {
        std::fputs("usage: sparkout-reference FOLDER\n", stderr);
        return 2;
    }
    const std::string folder = argv[1];
    for (const auto& [file, text] : {std::pair{folder + "/en/project-file.md", referencePage()},
                                     std::pair{folder + "/en/lesson-file.md", lessonPage()},
                                     std::pair{folder + "/project.schema.json", projectSchema()},
                                     std::pair{folder + "/lesson.schema.json", lessonSchema()},
                                     std::pair{folder + "/results.schema.json", resultSchema()}}) {
        if (const auto error = writeFileSafely(file, text)) {
            std::fprintf(stderr, "%s: %s\n", error->path.c_str(), fileStepText(error->step));
            return 1;
        }
    }
    return 0;
}
