// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_kept_runs.h"

#include "app/io/cli_io.h"
#include "core/printable.h"
#include "core/study/recalled_run.h"
#include "words/lesson_words.h"

namespace sparkout::cli {

std::vector<std::string> printUntrueRuns(const std::string& file, const Project& project) {
    std::vector<std::string> names;
    for (const KeptRunCheck& check : untrueRuns(project)) {
        print(stderr,
              printable(file + ": kept run \"" + check.name + "\": " + keptRunSentence(check))
                  + '\n');
        names.push_back(check.name);
    }
    return names;
}

} // namespace sparkout::cli
