// SPDX-License-Identifier: GPL-3.0-or-later
// What the usual search comes to: of all shipped examples about their cycles, and of the five
// surfaces of a trial about starting cycles, beside the search that each file states. A line for
// each: the time of the cycle and how many of 500 fresh parts are bad; of the answer of the usual
// search rough and finish feed, spark-out, and how long it was searched [s]. The exit status is 1
// where more parts are bad than the answer promises, or no answer is found where the cycle that the
// search is about is good itself. A search is stopped after 20 s; without an answer by then it
// says so.
#include "core/batch/batch_check.h"
#include "core/batch/fresh_parts.h"
#include "core/batch/scenario_source.h"
#include "core/deadline_stop.h"
#include "core/digits.h"
#include "core/files/safe_file.h"
#include "core/format/project_file.h"
#include "core/phases/cycle_trial.h"
#include "core/phases/sampled_phases.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/material.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "core/simulation/simulate.h"
#include "core/starting/starting_project.h"
#include "core/study/search.h"
#include "core/study/usual_search.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace sparkout;

namespace {

constexpr double mostSearch_s = 20;
constexpr int otherDraw = 1000; // than any that a search tries its answers on

std::string textOf(const std::filesystem::path& file) {
    return std::get<std::string>(readFile(file.string(), limits::fileBytes));
}

Factor between(double from, double to) {
    Factor factor;
    factor.uniform = std::vector<double>{from, to};
    return factor;
}

/// With its own batch, or where it has none one by which starting cycles were tried: stock ± 20 µm,
/// dullness 0.015…0.03, compliance ± 10 %, flow stress ± 12 %.
Project withBatch(Project project) {
    if (project.batch && checkBatch(project).empty()) {
        return project;
    }
    constexpr double stock_mm = 0.02, leastDullness = 0.015, mostDullness = 0.03;
    constexpr double compliance = 0.1, stress = 0.12;
    const double stress_mpa = project.material->flow_stress_mpa;
    const double around_mm = std::min(stock_mm, project.part->stock_mm / 4);
    Batch batch;
    batch.factors.stock_mm =
        between(project.part->stock_mm - around_mm, project.part->stock_mm + around_mm);
    batch.factors.dullness = between(leastDullness, mostDullness);
    batch.factors.compliance = between(1 - compliance, 1 + compliance);
    batch.factors.flow_stress_mpa = between((1 - stress) * stress_mpa, (1 + stress) * stress_mpa);
    Project with = project;
    with.batch = batch;
    return checkBatch(with).empty() ? with : project;
}

/// Of 500 fresh parts; nothing: it has no batch that can be run.
std::optional<int> badOf(const Project& project) {
    if (!project.batch || !checkBatch(project).empty()) {
        return std::nullopt;
    }
    const ScenarioSource source(withFreshParts(project, otherDraw));
    int bad = 0;
    for (std::int64_t part = 0; part < source.parts(); ++part) {
        bad += tried(source.project(part), {}).value().holds ? 0 : 1;
    }
    return bad;
}

std::string number(double value) {
    constexpr int digits = 4;
    return fixed(value, digits);
}

/// "21.4 (0)".
std::string cell(const Project& project) {
    const SimulationResult result = simulateUnchecked(project);
    const std::optional<int> bad = badOf(project);
    return (result.status == RunStatus::completed ? number(result.time_s) : std::string("no end"))
           + " (" + (bad ? std::to_string(*bad) : std::string("-")) + ")";
}

struct Answered {
    std::optional<Project> project;
    int candidate = 0;
    double took_s = 0;
    bool isStopped = false;
};

Answered answerOf(const Project& project) {
    const std::clock_t begin = std::clock();
    const DeadlineStop deadline({}, DeadlineStop::Duration(mostSearch_s));
    const SearchOutcomePtr found = search(project, {}, deadline.token());
    Answered answered;
    answered.isStopped = found->search.status == SearchStatus::stopped;
    answered.took_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (const FoundCycle* answer = found->ran() ? found->answer() : nullptr) {
        answered.project = withFound(project, *answer);
        answered.candidate = answer->candidate;
    }
    return answered;
}

/// "1.09, 0.13, 12": rough feed, finish feed, spark-out, in traverse with the axial feeds.
std::string stagesOf(const Project& project) {
    std::string text;
    for (const Stage& stage : project.cycle->stages) {
        text += text.empty() ? "" : ", ";
        if (const auto steps = stage.sparkOutSteps()) {
            text += std::to_string(*steps);
            continue;
        }
        if (stage.continuousFeed_mm_min() > 0) {
            text += "S_c " + numberText(stage.continuousFeed_mm_min());
        } else {
            text += numberText((stage.*project.operation->radial().value).value_or(0));
        }
        if (const StageFeed* axial = project.operation->axial()) {
            text += '/' + numberText((stage.*axial->value).value_or(0));
        }
    }
    return text;
}

/// One line; false: it does not hold what it promises.
bool compare(const std::string& name, const Project& stated, const Project& start) {
    Project usual = start;
    usual.optimisation.reset();
    usual = usualSearch(std::move(usual));
    const Answered answer = answerOf(usual);
    std::string before = "-";
    if (stated.optimisation) {
        const Answered own = answerOf(stated);
        before = own.project ? cell(*own.project) : "none";
    }
    std::printf("USUAL %s | before %s | about %s | %s | %s | %.2f s\n", name.c_str(),
                before.c_str(), cell(start).c_str(),
                answer.project     ? cell(*answer.project).c_str()
                : answer.isStopped ? "stopped"
                                   : "none",
                answer.project ? stagesOf(*answer.project).c_str() : "-", answer.took_s);
    std::fflush(stdout);
    if (!answer.project) {
        const std::optional<int> bad = badOf(start);
        const std::optional<CycleTrial> trial = tried(start, {});
        return answer.isStopped || !bad || *bad > 0 || !trial || !trial->holds;
    }
    const std::optional<int> bad = badOf(*answer.project);
    return !bad
           || *bad <= mostFailing(freshPartCount, std::max(answer.candidate, 1)) * freshPartCount;
}

} // namespace

int main() {
    const std::filesystem::path root = SPARKOUT_SOURCE_DIR;
    bool isKept = true;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(root / "resources/examples")) {
        if (entry.path().extension() == ".sparkout") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) {
        const Project project = withBatch(readProject(textOf(file)).project.value());
        isKept &= compare(file.stem().string(), project, project);
    }
    const Setup setup = readSetup(textOf(root / "tests/data/trials/val.sparkout")).setup.value();
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const Project project = withBatch(wornProject(setup, i).project);
        isKept &= compare(setup.surfaces[i].name, project, withStartingCycle(project));
    }
    return isKept ? 0 : 1;
}
