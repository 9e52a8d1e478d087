// SPDX-License-Identifier: GPL-3.0-or-later
// A program of somebody else's: simulates the project files it is called with, and asks everything
// of one that is no project at all.
#include <core/sparkout.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

int main(int argc, char** argv) {
    if (sparkout::simulate(sparkout::Project{}).status != sparkout::RunStatus::refused) {
        std::puts("an empty project was not refused");
        return 1;
    }
    if (sparkout::evaluate(sparkout::Project{})->ran()) {
        std::puts("an empty project was evaluated");
        return 1;
    }
    sparkout::Project unfit;
    unfit.batch.emplace();
    unfit.sweep.emplace().inputs.resize(1);
    for (const sparkout::Project& project : {sparkout::Project{}, unfit}) {
        if (sparkout::runBatch(project).status != sparkout::BatchStatus::refused
            || sparkout::runBatch(project).issues.empty() || sparkout::runWholeBatch(project)->ran()
            || sparkout::runSweep(project).ran() || !sparkout::runSweep(project).points.empty()) {
            std::puts("a batch or a sweep of no project was run");
            return 1;
        }
    }
    for (int i = 1; i < argc; ++i) {
        std::ifstream file(argv[i]);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const sparkout::ReadResult read = sparkout::readProject(text);
        if (!read.project) {
            std::printf("%s: refused, %zu faults\n", argv[i], read.issues.size());
            return 1;
        }
        const sparkout::SimulationResult result = sparkout::simulate(*read.project);
        bool holds = result.status == sparkout::RunStatus::completed;
        for (const auto& each : sparkout::evaluateConstraints(result)) {
            holds = holds && each.holds;
        }
        std::printf("%s %.17g %d\n", argv[i], result.time_s / 60, holds ? 1 : 0);
    }
    return 0;
}
