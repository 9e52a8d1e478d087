// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the engine is, against what this processor can do at all: the floor of a pass is the
// bare vectorised square root over as many doubles, measured in the same run. The last lines are
// `BENCH name value target ratio`: value in ns (of a pass, of a visit, …), ratio to the floor or –.
// Minima over interleaved repetitions, so that a busy machine does not matter much. The exit status
// is 1 when a ratio is beyond four times its target.
#include "core/batch/batch_run.h"
#include "core/file/project_file.h"
#include "core/process/pass_kernel.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/simulation/limit_watch.h"
#include "core/simulation/simulate.h"
#include "core/surface/accuracy.h"
#include "core/surface/burn_table.h"
#include "tests/core/support/demanding_project.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

using namespace sparkout;

namespace {

// --- the floor -----------------------------------------------------------------------------------

[[gnu::always_inline]] inline void squareRoots(const double* __restrict in, double* __restrict out,
                                               std::size_t count) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = std::sqrt(in[i]);
    }
}
[[gnu::noinline]] void rootsBaseline(const double* in, double* out, std::size_t count) {
    squareRoots(in, out, count);
}
[[gnu::noinline, gnu::target("avx2")]] void rootsAvx2(const double* in, double* out,
                                                      std::size_t count) {
    squareRoots(in, out, count);
}
using RootFunction = void (*)(const double*, double*, std::size_t);

RootFunction rootFunction(VectorUnit unit) {
    return unit == VectorUnit::avx2 ? rootsAvx2 : rootsBaseline;
}

const char* unitName(VectorUnit unit) {
    return unit == VectorUnit::avx2 ? "avx2" : "baseline";
}

void floorOfRoots(benchmark::State& state, VectorUnit unit, std::size_t count) {
    const RootFunction roots = rootFunction(unit);
    std::vector<double> in(count), out(count);
    for (std::size_t i = 0; i < count; ++i) {
        in[i] = 1.234567e-3 * (1 + 0.01 * static_cast<double>(i)); // as C² + 4Ah is
    }
    for (auto _ : state) {
        roots(in.data(), out.data(), count);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
}

// --- a pass --------------------------------------------------------------------------------------

// The feed goes on with every pass, so that each lane keeps cutting about as deep as in a real one.
// Scenarios, like sections, are one behind the other, each with all its radii.
void pass(benchmark::State& state, PassFunction cut, std::size_t radii, std::size_t scenarios) {
    const std::size_t count = radii * scenarios;
    Lanes lanes(count);
    LaneCoefficients coefficients(count);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const double scenario = static_cast<double>(lane / radii);
        lanes.share[lane] = static_cast<double>(lane % radii + 1) / static_cast<double>(radii);
        coefficients.set(lane, 2e-5 * (1 + 0.1 * scenario), 1228, 2851 * (1 + 0.05 * scenario));
    }
    PassFeed feed{0, 0, 0.005, 0.005};
    const PassRange range{0, count, 1228, 2851};
    PeakForces peaks(scenarios, radii);
    for (auto _ : state) {
        peaks.passBegins(lanes, range, 0, scenarios);
        const double root = cut(lanes, coefficients, feed, range);
        benchmark::DoNotOptimize(root);
        benchmark::ClobberMemory();
        feed.base += 0.005;
    }
}

// --- a whole cycle -------------------------------------------------------------------------------

const char* const shaft30h6 = R"({
  "format": "sparkout-project", "version": 1, "title": "Shaft 30h6", "operation": "traverse",
  "part": { "diameter_mm": 30, "upper_deviation_um": 0, "lower_deviation_um": -16,
    "length_mm": 92, "stock_mm": 0.15, "initial_runout_mm": 0.02 },
  "material": { "flow_stress_mpa": 2000 },
  "wheel": { "diameter_mm": 500, "width_mm": 50, "dullness": 0.02 },
  "machine": { "wheel_speed_m_s": 30, "work_speed_rpm": 180, "plunge_feed_mm_min": 0.5,
    "overrun_entry_mm": 12, "overrun_exit_mm": 12, "dwell_entry_s": 0.333, "dwell_exit_s": 0,
    "compliance_mm_per_n": { "rz1": 1.2e-4, "nz": 1.7e-4, "rz2": 1.5e-4 } },
  "cycle": { "stages": [
    { "radial_feed_mm": 0.004, "axial_feed_mm_min": 1800, "stock_mm": 0.110 },
    { "radial_feed_mm": 0.001, "axial_feed_mm_min": 300, "stock_mm": 0.040 } ] } })";

/// The shaft held to every requirement, to those of its cuts less tightly than the tests'.
Project demandingShaft() {
    Project p = fixtures::demanding(readProject(shaft30h6).project.value());
    p.material->burn_rise_k = 700;
    p.part->tolerance.roughness_ra_um = 1.6;
    p.machine->wheel_drive_kw = 7.5;
    return p;
}

// The passes of a plunge cycle, again and again: 30 revolutions at 5 µm, each nearer to burning
// than any before, 50 at 1 µm and 20 of spark-out.
// With `sparking` the passes of a spark-out alone, which come no nearer.
void passWithEveryConstraint(benchmark::State& state, bool sparking) {
    const Project project = demandingShaft();
    Blank blank;
    for (int k = 0; k < 36; ++k) { // an ellipse, 20 µm out of round
        blank.depth_mm.push_back(0.01 * (1 - std::cos(std::numbers::pi * k / 9)));
    }
    blank.totalInfeed_mm = 0.2;
    LimitWatch watch(project, blank);
    int revolution = 0;
    Lanes lanes(36);
    LaneCoefficients coefficients(36);
    for (std::size_t lane = 0; lane < 36; ++lane) {
        lanes.share[lane] = static_cast<double>(lane + 1) / 36;
        coefficients.set(lane, 2e-5, 1228, 2851);
    }
    lanes.depth_mm = blank.depth_mm;
    watch.prepare(lanes);
    PeakForces peaks(1, 36);
    const PassFunction cut = widestPassFunction();
    const Place place{.stage = 1, .cycleCount = 1, .revolution = 1};
    PassFeed feed{0, 0, 0.005, 0.005};
    for (auto _ : state) {
        const PassRange range{0, 36, 1228, 2851};
        peaks.passBegins(lanes, range, 0, 1);
        const double root = cut(lanes, coefficients, feed, range);
        watch.passDone(lanes, range, root, feed, &place, 0, 1);
        watch.stepDone(lanes, {feed.cap, feed.base + feed.cap, 0.33, 1, 0});
        benchmark::DoNotOptimize(root);
        benchmark::ClobberMemory();
        feed.base += feed.rate;
        feed.rate = feed.cap = ++revolution < 30 ? 0.005 : revolution < 80 ? 0.001 : 0;
        if (revolution == 100 && sparking) {
            revolution = 80;
        } else if (revolution == 100) { // the next cycle
            revolution = 0;
            feed = {0, 0, 0.005, 0.005};
            lanes.depth_mm = blank.depth_mm;
            watch.restart(lanes);
        }
    }
}

void cycle(benchmark::State& state, bool traced) {
    const ReadResult read = readProject(shaft30h6);
    if (!read.project) {
        state.SkipWithError("the project is refused");
        return;
    }
    Trajectory trajectory;
    long long visits = 0;
    for (auto _ : state) {
        const SimulationResult result =
            simulateUnchecked(*read.project, traced ? &trajectory : nullptr);
        visits = result.visits;
        benchmark::DoNotOptimize(visits);
    }
    state.counters["visits"] = static_cast<double>(visits);
}

// 20 coupled sections, 36 radii, 300 revolutions: 220 that feed, 80 that spark out.
const char* const coupledShaft = R"({
  "format": "sparkout-project", "version": 1, "title": "Coupled sections", "operation": "plunge",
  "part": { "diameter_mm": 30, "upper_deviation_um": 0, "lower_deviation_um": -16,
    "length_mm": 40, "stock_mm": 0.2, "initial_runout_mm": 0.02,
    "shaft": { "segments": [ { "length_mm": 60, "diameter_mm": 22 },
      { "length_mm": 80, "diameter_mm": 30 }, { "length_mm": 50, "diameter_mm": 18 } ],
      "ground_from_mm": 70 } },
  "material": { "flow_stress_mpa": 2000 },
  "wheel": { "diameter_mm": 600, "width_mm": 40, "dullness": 0.02 },
  "machine": { "wheel_speed_m_s": 35, "work_speed_rpm": 180,
    "stiffness_n_um": { "headstock": 40, "tailstock": 20, "wheel_head": 50 } },
  "gauge": { "control": "position" },
  "sections": 20, "sections_coupled": true,
  "cycle": { "stages": [ { "radial_feed_mm_min": 0.18, "stock_mm": 0.2 },
    { "spark_out": 80 } ] } })";

void coupledCycle(benchmark::State& state) {
    const ReadResult read = readProject(coupledShaft);
    if (!read.project) {
        state.SkipWithError("the project is refused");
        return;
    }
    for (auto _ : state) {
        const SimulationResult result = simulateUnchecked(*read.project);
        if (result.status != RunStatus::completed || result.cycleCount != 300) {
            state.SkipWithError("not the cycle it should be");
        }
    }
}

/// The same cycle of the most sections there may be, deflecting each other or not.
void manySections(benchmark::State& state, bool coupled) {
    Project project = readProject(coupledShaft).project.value();
    project.sections = 200;
    project.sections_coupled = coupled;
    for (auto _ : state) {
        const SimulationResult result = simulateUnchecked(project);
        if (result.status != RunStatus::completed || result.cycleCount != 300) {
            state.SkipWithError("not the cycle it should be");
        }
    }
}

/// The same cycle with everything asked, and its verdict.
void demandingCycle(benchmark::State& state, bool verdict) {
    const Project project = demandingShaft();
    for (auto _ : state) {
        const SimulationResult result = simulateUnchecked(project);
        benchmark::DoNotOptimize(verdict ? evaluateConstraints(result).size() : 0);
    }
}

/// Parts of a batch of the shaft, its stock, runout and dullness scattering, on one thread.
constexpr int partsOfBatch = 500;
void batchOfShafts(benchmark::State& state) {
    Project project = readProject(shaft30h6).project.value();
    project.batch = Batch{};
    project.batch->parts = partsOfBatch;
    project.batch->factors.stock_mm.emplace().uniform = {0.14, 0.16};
    project.batch->factors.initial_runout_mm.emplace().normal = {0.02, 0.003};
    project.batch->factors.dullness.emplace().grows = {0.015, 0.03};
    BatchOptions options;
    options.threads = 1;
    for (auto _ : state) {
        if (runBatch(project, options).statistics.parts != partsOfBatch) {
            state.SkipWithError("not the batch it should be");
        }
    }
}

void readAndValidate(benchmark::State& state) {
    for (auto _ : state) {
        const ReadResult read = readProject(shaft30h6); // validates too
        benchmark::DoNotOptimize(read.project.has_value());
    }
}

void validateAlone(benchmark::State& state) {
    const ReadResult read = readProject(shaft30h6);
    if (!read.project) {
        state.SkipWithError("the project is refused");
        return;
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(validate(*read.project).size());
    }
}

// --- what becomes of a cycle ---------------------------------------------------------------------

// The most sections and radii a project may have, out of round by a few lobes.
void accuracyOfPart(benchmark::State& state, std::size_t sections, std::size_t radii) {
    std::vector<std::vector<double>> values(sections, std::vector<double>(radii));
    std::vector<SectionShape> shapes;
    for (std::size_t j = 0; j < sections; ++j) {
        const auto z = static_cast<double>(j);
        for (std::size_t k = 0; k < radii; ++k) {
            const double phi =
                2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(radii);
            values[j][k] = 15 + 0.003 * std::cos(2 * phi) + 0.002 * std::cos(phi + 0.01 * z)
                           + 0.0005 * std::sin(37 * phi * phi + z) + 1e-5 * z;
        }
        shapes.push_back({0.5 * z, values[j]});
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(partAccuracy(shapes, 0).totalRunout_mm);
    }
}

void burnTable(benchmark::State& state) {
    const BurnModel model{Project{}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(BurnTable(model, 700, 0.2).limit(0.1));
    }
}

void burnOfAStretch(benchmark::State& state) {
    const BurnTable table(BurnModel{Project{}}, 700, 0.2);
    for (auto _ : state) {
        benchmark::DoNotOptimize(table.over(0.1, 0.12, 0.2)->centre);
    }
}

// --- the summary ---------------------------------------------------------------------------------

/// Keeps the shortest time of each benchmark [ns], and its visits.
class Minima : public benchmark::ConsoleReporter {
public:
    Minima() : ConsoleReporter(OO_None) {}
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration) {
                continue;
            }
            failed |= run.error_occurred;
            const std::string name = run.run_name.function_name;
            const double ns = run.cpu_accumulated_time / static_cast<double>(run.iterations) * 1e9;
            const auto found = shortest.find(name);
            if (found == shortest.end() || ns < found->second) {
                shortest[name] = ns;
            }
            const auto visits = run.counters.find("visits");
            if (visits != run.counters.end()) {
                visitsOf[name] = visits->second;
            }
        }
    }
    std::map<std::string, double> shortest;
    std::map<std::string, double> visitsOf;
    bool failed = false;
};

std::string floorName(VectorUnit unit, std::size_t count) {
    return std::string("roots_") + std::to_string(count) + "_" + unitName(unit);
}

struct PassCase {
    const char* name;
    std::size_t radii, scenarios;
    double target; ///< most times the floor; 0: reported only
};

constexpr PassCase passCases[] = {{"pass_36_radii", 36, 1, 2.0},
                                  {"pass_4_radii", 4, 1, 0},
                                  {"pass_4_radii_8_scenarios", 4, 8, 2.5}};
constexpr VectorUnit units[] = {VectorUnit::baseline, VectorUnit::avx2};

/// One line; true when it is beyond four times its target.
bool report(const std::string& name, double ns, double target, double ratio) {
    std::printf("BENCH %s %.4g ", name.c_str(), ns);
    target > 0 ? std::printf("%.2f ", target) : std::printf("- ");
    ratio > 0 ? std::printf("%.2f\n", ratio) : std::printf("-\n");
    return target > 0 && ratio > 4 * target;
}

bool summary(const Minima& minima) {
    bool beyond = false;
    const auto time = [&](const std::string& name) {
        const auto found = minima.shortest.find(name);
        return found == minima.shortest.end() ? std::numeric_limits<double>::quiet_NaN()
                                              : found->second;
    };
    for (const VectorUnit unit : units) {
        if (!isSupported(unit)) {
            continue;
        }
        for (const PassCase& c : passCases) {
            const std::string name = std::string(c.name) + "_" + unitName(unit);
            const double floor = time(floorName(unit, c.radii * c.scenarios));
            report(floorName(unit, c.radii * c.scenarios), floor, 0, 0);
            // The target is the engine's: it holds for the unit the engine takes.
            const double target = unit == widestUnit() ? c.target : 0;
            beyond |= report(name, time(name), target, time(name) / floor);
        }
    }
    for (const char* name : {"simulate_plain", "simulate_traced"}) {
        const auto visits = minima.visitsOf.find(name);
        if (visits != minima.visitsOf.end()) {
            report(std::string(name) + "_per_visit", time(name) / visits->second, 0, 0);
        }
        report(name, time(name), 0, 0);
    }
    // here the ratio is to 100 ms
    beyond |= report("simulate_coupled_20x300x36", time("simulate_coupled_20x300x36"), 1.0,
                     time("simulate_coupled_20x300x36") / 100e6);
    // to the same sections uncoupled
    report("simulate_sections_200x300x36", time("simulate_sections_200x300x36"), 0, 0);
    beyond |= report("simulate_coupled_200x300x36", time("simulate_coupled_200x300x36"), 8,
                     time("simulate_coupled_200x300x36") / time("simulate_sections_200x300x36"));
    // to 200 µs: 100,000 parts on two processors in 10 s
    const double part = time("batch_of_shafts") / partsOfBatch;
    beyond |= report("batch_part", part, 1.0, part / 200e3);
    const double floor = time(floorName(widestUnit(), 36));
    const double demanding = time("pass_36_radii_every_constraint");
    beyond |= report("pass_36_radii_every_constraint", demanding, 2.5, demanding / floor);
    const double quiet = time("pass_36_radii_no_new_worst");
    beyond |= report("pass_36_radii_no_new_worst", quiet, 2.5, quiet / floor);
    for (const char* name :
         {"simulate_every_constraint", "simulate_and_verdict", "read_project", "validate",
          "accuracy_3_by_36", "accuracy_200_by_360", "burn_table", "burn_stretch"}) {
        report(name, time(name), 0, 0);
    }
    return beyond;
}

void registerAll() {
    for (const VectorUnit unit : units) {
        if (!isSupported(unit)) {
            continue;
        }
        for (const PassCase& c : passCases) {
            const std::size_t count = c.radii * c.scenarios;
            benchmark::RegisterBenchmark(floorName(unit, count).c_str(), floorOfRoots, unit, count);
            benchmark::RegisterBenchmark((std::string(c.name) + "_" + unitName(unit)).c_str(), pass,
                                         unit == widestUnit() ? widestPassFunction()
                                                              : passFunction(unit),
                                         c.radii, c.scenarios);
        }
    }
    benchmark::RegisterBenchmark("simulate_plain", cycle, false);
    benchmark::RegisterBenchmark("simulate_traced", cycle, true);
    benchmark::RegisterBenchmark("pass_36_radii_every_constraint", passWithEveryConstraint, false);
    benchmark::RegisterBenchmark("pass_36_radii_no_new_worst", passWithEveryConstraint, true);
    benchmark::RegisterBenchmark("simulate_every_constraint", demandingCycle, false);
    benchmark::RegisterBenchmark("simulate_and_verdict", demandingCycle, true);
    benchmark::RegisterBenchmark("simulate_coupled_20x300x36", coupledCycle);
    benchmark::RegisterBenchmark("simulate_sections_200x300x36", manySections, false);
    benchmark::RegisterBenchmark("simulate_coupled_200x300x36", manySections, true);
    benchmark::RegisterBenchmark("batch_of_shafts", batchOfShafts);
    benchmark::RegisterBenchmark("read_project", readAndValidate);
    benchmark::RegisterBenchmark("validate", validateAlone);
    benchmark::RegisterBenchmark("accuracy_3_by_36", accuracyOfPart, 3, 36);
    benchmark::RegisterBenchmark("accuracy_200_by_360", accuracyOfPart, 200, 360);
    benchmark::RegisterBenchmark("burn_table", burnTable);
    benchmark::RegisterBenchmark("burn_stretch", burnOfAStretch);
}

} // namespace

int main(int argc, char** argv) {
    // Short repetitions, shuffled: every figure sees the machine's quiet moments. Options given on
    // the command line come last and win.
    std::vector<std::string> defaults{"--benchmark_min_time=0.01", "--benchmark_repetitions=12",
                                      "--benchmark_enable_random_interleaving=true"};
    std::vector<char*> arguments{argv[0]};
    for (std::string& option : defaults) {
        arguments.push_back(option.data());
    }
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
        return 2;
    }
    registerAll();
    Minima minima;
    benchmark::RunSpecifiedBenchmarks(&minima);
    const bool beyond = summary(minima);
    return beyond || minima.failed ? 1 : 0;
}
