// SPDX-License-Identifier: GPL-3.0-or-later
// A program of somebody else's: searches the grid of a project file and prints the quickest time.
#include <core/sparkout.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

int main(int argc, char** argv) {
    std::ifstream file(argc > 1 ? argv[1] : "");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const sparkout::ReadResult read = sparkout::readProject(text);
    if (!read.project) {
        return 1;
    }
    sparkout::Project unfit;
    unfit.optimisation.emplace().stock_step_mm = 0;
    for (const sparkout::Project& project : {sparkout::Project{}, unfit}) {
        if (sparkout::search(project, {})->ran()) {
            std::puts("a project that is none was searched");
            return 1;
        }
    }
    const sparkout::SearchOutcomePtr found = sparkout::search(*read.project, {});
    std::printf("%.17g\n", found->answer() ? found->answer()->time_s / 60 : 0.0);
    return 0;
}
