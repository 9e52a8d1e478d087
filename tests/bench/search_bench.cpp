// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the searches for the quickest cycle are. The lines are `BENCH name value target ratio`:
// value in ns of processor time, or a count; ratio to the time allowed, or to another search of the
// same run. The exit status is 1 when a ratio is beyond four times its target.
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/project/batch.h"
#include "core/search/optimise.h"
#include "core/search/robust.h"
#include "core/simulation/simulate.h"
#include "tests/whole_project.h"

#include <cstdio>
#include <ctime>
#include <string>
#include <variant>
#include <vector>

using namespace sparkout;

namespace {

constexpr double ns = 1e9;

Project example(const std::string& name) {
    const auto text =
        readFile(SPARKOUT_SOURCE_DIR "/resources/examples/" + name, limits::fileBytes);
    return readProject(std::get<std::string>(text)).project.value();
}

SteppedLevels steps(double step, int count) {
    return {step, step * count, step};
}

/// The shaft 30h6 with accuracy, burn and power; 144 settings of a stage's feeds, 14 last stocks.
Project shaft(double stages) {
    Project p = example("shaft-30h6-factory.sparkout");
    p.optimisation = Optimisation{};
    p.optimisation->stages = {stages};
    p.optimisation->stock_step_mm = 0.005;
    p.optimisation->last_stock_mm = std::vector<double>{0.005, 0.07};
    p.optimisation->radial_feed_mm = steps(0.001, 12);
    p.optimisation->axial_feed_mm_min = steps(300, 12);
    return p;
}

/// A plunge with so many feeds and levels of stock, and up to five stages.
Project plunge(int feeds, int levels) {
    Project p = example("plunge-shaft-two-stage.sparkout");
    p.optimisation->stages = {1, 2, 3, 4, 5};
    p.optimisation->stock_step_mm = p.part->stock_mm / levels;
    p.optimisation->non_increasing = false;
    p.optimisation->radial_feed_mm_min = steps(0.8 / feeds, feeds);
    return p;
}

/// With a batch of 64 corners: stock, runout, dullness, flow stress, wheel diameter and compliance,
/// two each.
Project withCorners(Project project) {
    const auto between = [](double from, double to) {
        Factor factor;
        factor.uniform = {from, to};
        return factor;
    };
    Batch batch;
    batch.scenarios = Scenarios::corners;
    batch.factors.stock_mm = between(project.part->stock_mm, project.part->stock_mm + 0.01);
    batch.factors.initial_runout_mm =
        between(project.part->initial_runout_mm, project.part->initial_runout_mm + 0.01);
    batch.factors.dullness = between(project.wheel->dullness, project.wheel->dullness + 0.01);
    batch.factors.flow_stress_mpa =
        between(project.material->flow_stress_mpa, 1.05 * project.material->flow_stress_mpa);
    batch.factors.wheel_diameter_mm =
        between(project.wheel->diameter_mm - 20, project.wheel->diameter_mm);
    batch.factors.compliance = between(1, 1.1);
    project.batch = batch;
    project.optimisation->scenarios = OptimisationScenarios::corners;
    return project;
}

struct Timed {
    SearchSummary search;
    double cpu_s = 0;
};

template <class Search>
double processorTime_s(const Search& search) {
    const std::clock_t begin = std::clock();
    search();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

Timed timed(const Project& project, SearchMethod method) {
    Timed result;
    SearchOptions options;
    options.method = method;
    result.cpu_s = processorTime_s([&] { result.search = optimise(project, options); });
    return result;
}

bool beyond = false;

void report(const char* name, double value, double target, double ratio) {
    std::printf("BENCH %s %.4g %.2f %.3f\n", name, value, target, ratio);
    beyond |= ratio > 4 * target;
}

/// Against the processor time allowed [s].
void report(const char* name, const Timed& result, double allowed_s) {
    report(name, result.cpu_s * ns, 1, result.cpu_s / allowed_s);
    beyond |=
        result.search.status != SearchStatus::proved && result.search.status != SearchStatus::found;
}

/// What a stopped search knows: 1 − bound/best after 2 s of processor time.
void stopped(const char* name, const Project& project) {
    SearchOptions options;
    std::stop_source stop;
    options.stop = stop.get_token();
    const std::clock_t begin = std::clock();
    options.onProgress = [&](const SearchProgress&) {
        if (std::clock() - begin > 2 * CLOCKS_PER_SEC) {
            stop.request_stop();
        }
    };
    const SearchSummary search = optimise(project, options);
    const double best_s = static_cast<double>(search.best.value().time_us) * 1e-6;
    std::printf("BENCH %s %.3g - -\n", name, 1 - search.bound_s / best_s);
}

/// Both searches once, as a user has them: against the nominal one. The answer holds for every
/// stock at each corner of the other factors. The trials of cycles on parts of the batch are
/// counted apart, against as many plain runs.
void robust(const Project& asked, double nominal_s) {
    const Project project = withCorners(asked);
    RobustSummary summary;
    const double cpu_s =
        processorTime_s([&] { summary = optimiseRobustly(project, undecidedScenarios(project)); });
    beyond |= !summary.holdsInSample || !summary.decided || summary.decided->corners != 32;
    if (summary.search.best) {
        const Project best = withBest(project, summary.search);
        const double decided_s = processorTime_s([&] { beyond |= failingCase(best).has_value(); });
        std::printf("BENCH optimise_robust_decided %.4g - -\n", decided_s * ns); // among it
        FreshPartsTrial trial;
        const double trial_s = processorTime_s([&] { trial = triedOnFreshParts(best, 1); });
        beyond |= trial.bad.has_value();
        const int runs = trial.good.tried + best.batch->parts;
        const double runs_s = processorTime_s([&] {
            for (int i = 0; i < runs; ++i) {
                beyond |= simulateUnchecked(best).status != RunStatus::completed;
            }
        });
        report("optimise_trial_on_parts", trial_s * ns, 1.5, trial_s / runs_s);
        const double searched_s = cpu_s - (1 + summary.incapable) * trial_s;
        report("optimise_robust_every_stock_at_64_corners", searched_s * ns, 10,
               searched_s / nominal_s);
    }
}

} // namespace

int main() {
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // each line when it is known
    const Project two = shaft(2);
    const Timed pruned = timed(two, SearchMethod::pruned);
    report("optimise_pruned_290304", pruned, 0.5);
    robust(two, pruned.cpu_s); // before what leaves the heap in pieces
    const Timed full = timed(two, SearchMethod::full);
    report("optimise_full_290304", full, 20); // 10 s on two cores
    beyond |= full.search.gridSize != 290304
              || full.search.best.value().cycle != pruned.search.best.value().cycle;
    std::printf("BENCH optimise_visits_full_per_pruned %lld - %.0f\n", full.search.visits,
                static_cast<double>(full.search.visits)
                    / static_cast<double>(pruned.search.visits));
    report("optimise_pruned_three_stages_9e8", timed(shaft(3), SearchMethod::pruned), 60);
    report("optimise_plunge_10_feeds_10_levels", timed(plunge(10, 10), SearchMethod::pruned), 1);
    const Project large = plunge(20, 40);
    report("optimise_plunge_20_feeds_40_levels_published", timed(large, SearchMethod::published),
           2);
    report("optimise_plunge_20_feeds_40_levels_labels", timed(large, SearchMethod::labels), 2);
    stopped("optimise_plunge_20_feeds_40_levels_gap_after_2_s", large);
    return beyond ? 1 : 0;
}
