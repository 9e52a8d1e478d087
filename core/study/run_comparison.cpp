// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/run_comparison.h"

#include "core/batch/judgement.h"
#include "core/digits.h"
#include "core/file/project_file.h"
#include "core/project/part.h"
#include "core/quality/result_names.h"
#include "core/quality/roughness.h"
#include "core/simulation/simulate.h"
#include "core/study/outcome.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace sparkout {

RecalledRun recallRun(const std::string& inputs, const std::stop_token& stop) {
    RecalledRun run;
    ReadResult read = readProject(inputs);
    run.issues = std::move(read.issues);
    if (!read.project) {
        return run;
    }
    const OutcomePtr outcome = evaluate(*read.project, stop);
    if (!outcome) {
        return run; // stopped: nobody asks any more
    }
    run.issues = outcome->issues;
    if (outcome->ran()) {
        run.summary = summarise(outcome->result, outcome->accuracy, outcome->constraints);
        FeedSeries feeds = outcome->feeds;
        for (FeedColumn& column : feeds.columns) {
            column.passIndex = {}; // the trajectory does not exist any more
        }
        run.feeds = std::make_shared<const FeedSeries>(std::move(feeds));
    }
    return run;
}

KeptRunCheck checkKeptRun(const KeptRun& run, const std::stop_token& stop) {
    KeptRunCheck check;
    check.name = run.name;
    check.engineVersion = run.engine_version;
    ReadResult read = readProject(run.inputs.text, stop);
    if (stop.stop_requested()) {
        return check;
    }
    if (!read.project) {
        check.issues = std::move(read.issues);
        return check;
    }
    auto summary = readSummary(run.summary.text);
    if (!summary) {
        check.isReadable = false;
        return check;
    }
    const SimulationResult result = simulateUnchecked(*read.project, nullptr, stop);
    if (result.status == RunStatus::stopped) {
        return check;
    }
    const PartAccuracy accuracy = accuracyOf(result);
    check.kept = std::make_shared<const ReadSummary>(std::move(*summary));
    check.now = std::make_shared<const RunSummary>(
        summarise(result, accuracy, evaluateConstraints(result, accuracy)));
    check.changed = changedSince(*check.kept, *check.now);
    return check;
}

std::vector<KeptRunCheck> untrueRuns(const Project& project, const std::stop_token& stop) {
    std::vector<KeptRunCheck> untrue;
    for (const KeptRun& run : project.runs) {
        KeptRunCheck check = checkKeptRun(run, stop);
        if (!check.isTrue()) {
            untrue.push_back(std::move(check));
        }
    }
    return untrue;
}

namespace {

using RunValues = std::vector<RunValue>;

// --- inputs and results of a run ----------------------------------------------------------------

bool leftStrips(const RunSummary& summary) {
    return std::ranges::any_of(summary.requirements, [](const RequirementSummary& requirement) {
        return requirement.name == requirementOf(ConstraintKind::overlap).key && !requirement.ok;
    });
}

/// Whether a value of a summary belongs to the finished surface.
bool isOfSurface(std::string_view key) {
    return key.starts_with("diameter_deviation") || key == "radial_runout_um"
           || key == "roundness_um" || key == "cylindricity_um" || key == "total_runout_um"
           || key == "radii_um";
}

/// "stage 2": 2.
std::optional<int> numberBehind(std::string_view word, std::string_view text) {
    if (!text.starts_with(word)) {
        return std::nullopt;
    }
    int number = 0;
    std::from_chars(text.data() + word.size(), text.data() + text.size(), number);
    return number;
}

/// The requirements that are known, without those of a surface that was ground in part.
std::vector<ConstraintResult> wholeOf(const RunSummary& summary, const Project* inputs) {
    const bool isWhole = !leftStrips(summary);
    std::vector<ConstraintResult> known;
    for (const RequirementSummary& requirement : summary.requirements) {
        const std::optional<ConstraintResult> constraint =
            constraintOf(requirement, isWhole, inputs);
        if (constraint && constraint->isWhole) {
            known.push_back(*constraint);
        }
    }
    return known;
}

void addRequirements(const RunSummary& summary, const Project* inputs, RunValues& values) {
    for (const ConstraintResult& constraint : wholeOf(summary, inputs)) {
        values.push_back(
            {"/requirements/" + std::string(requirementOf(constraint.kind).key) + "/margin",
             RequirementMargin{constraint}});
    }
    if (const std::optional<ConstraintResult> worst = leastMargin(summary, inputs)) {
        values.push_back({"/worst", WorstMargin{*worst}});
    }
    if (const std::optional<Light> light = verdictOf(summary, inputs)) {
        values.push_back({"/verdict", *light});
    }
}

// --- whether two are the same -------------------------------------------------------------------

/// A number in its stated digits, with a point; never −0. Empty if it is not finite.
std::string stated(double value, const ResultDigits& digits) {
    if (!std::isfinite(value)) {
        return {};
    }
    const int decimals =
        digits.decimals < 0 ? decimalsOf(value, digits.significant) : digits.decimals;
    return fixed(value, decimals);
}

bool sameDigits(double a, double b, const ResultDigits& digits) {
    return stated(a, digits) == stated(b, digits);
}

bool same(const Leaf& a, const Leaf& b, bool isResult) {
    const Field& field = *a.field;
    if (isResult && field.kind == Kind::number) {
        return sameDigits(field.as<double>(a.owner), field.as<double>(b.owner), digitsOf(field));
    }
    if (field.kind == Kind::objectList) {
        return field.size(a.owner) == field.size(b.owner);
    }
    return !field.same || field.same(a.owner, b.owner); // an object that neither has
}

bool same(const StageCount& a, const StageCount& b, bool) {
    return a.count == b.count;
}

bool isRange(const ConstraintResult& constraint) {
    return requirementOf(constraint.kind).source == LimitSource::range;
}

/// A setting's margin is stated as a ratio; without one, by whether it is in its range.
bool sameRatio(const ConstraintResult& a, const ConstraintResult& b) {
    const std::optional<double> first = ratioInRange(a), second = ratioInRange(b);
    const auto text = [](double ratio) { return stated(ratio, {-1, digitsOfRatio(ratio)}); };
    return first && second ? text(*first) == text(*second)
                           : !first && !second && a.holds == b.holds;
}

bool same(const RequirementMargin& a, const RequirementMargin& b, bool) {
    const int decimals = requirementOf(a.requirement.kind).digits.shown;
    return isRange(a.requirement) ? sameRatio(a.requirement, b.requirement)
                                  : marginKnown(a.requirement) == marginKnown(b.requirement)
                                        && sameDigits(statedMargin(a.requirement),
                                                      statedMargin(b.requirement), {decimals});
}

bool same(const WorstMargin& a, const WorstMargin& b, bool) {
    constexpr double perCent = 100;
    const auto place = [](const ConstraintResult& r) {
        return std::tuple(r.kind, r.zone, r.section, r.stage);
    };
    return place(a.requirement) == place(b.requirement)
           && (isRange(a.requirement)
                   ? sameRatio(a.requirement, b.requirement)
                   : sameDigits(perCent * a.requirement.relativeMargin,
                                perCent * b.requirement.relativeMargin, {-1, worstDigits}));
}

bool same(Light a, Light b, bool) {
    return a == b;
}

bool same(const std::optional<RunValue>& a, const std::optional<RunValue>& b, bool isResult) {
    if (!a || !b) {
        return !a && !b;
    }
    return a->value.index() == b->value.index()
           && std::visit(
               [&](const auto& value) {
                   using Value = std::decay_t<decltype(value)>;
                   return same(value, std::get<Value>(b->value), isResult);
               },
               a->value);
}

/// Adds the rows in which the runs differ; values of only one run keep their position.
void addDiffering(const std::vector<RunValues>& runs, bool isResult,
                  std::vector<ComparedRow>& rows) {
    std::vector<std::string> order;
    std::map<std::string, ComparedRow> byPath;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        auto at = order.begin();
        for (const RunValue& value : runs[run]) {
            const auto [row, isNew] = byPath.try_emplace(value.path);
            if (isNew) {
                at = std::next(order.insert(at, value.path));
                row->second = {value.path, isResult, {}};
                row->second.runs.resize(runs.size());
            } else {
                at = std::next(std::ranges::find(order, value.path));
            }
            row->second.runs[run] = value;
        }
    }
    for (const std::string& path : order) {
        ComparedRow& row = byPath.at(path);
        const std::optional<RunValue>* first = nullptr;
        bool differs = false;
        for (std::size_t run = 0; run < runs.size(); ++run) {
            if (!runs[run].empty()) { // otherwise it is unknown
                first = first ? first : &row.runs[run];
                differs = differs || !same(*first, row.runs[run], isResult);
            }
        }
        if (differs) {
            rows.push_back(std::move(row));
        }
    }
}

/// A position along the ground length, from 0 to 1.
double placeShare(const RunPlaces& run, std::size_t zone) {
    const double length_mm = run.project.part->length_mm;
    return length_mm > 0 ? run.summary.zones.at(zone).position_mm / length_mm : 0;
}

} // namespace

ResultDigits digitsOf(const Field& result) {
    const std::string_view unit(result.unit);
    return unit == "µm" ? ResultDigits{2} : ResultDigits{-1, unit == "min" ? 4 : 3};
}

std::vector<RunValue> inputsRead(const Project& project) {
    RunValues values;
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        const Field& field = *leaf.field;
        const bool isRead = !field.relevant || field.relevant(project, leaf.owner);
        const bool isOther = leaf.path.starts_with("/runs") || leaf.path.starts_with("/sweep")
                             || leaf.path.starts_with("/measured");
        if (isRead && !isOther) {
            values.push_back({leaf.path, leaf});
        }
    }
    return values;
}

std::vector<RunValue> resultsStated(const ReadSummary& summary, const Project* inputs) {
    RunValues values;
    const bool strips = leftStrips(summary.summary);
    for (const Leaf& leaf : leavesOf(tableOf<RunSummary>(), &summary.summary)) {
        const Field& field = *leaf.field;
        if (summary.missing.contains(leaf.path) || leaf.path.starts_with("/requirements")
            || (strips && isOfSurface(field.key))) {
            continue;
        }
        if (leaf.path == "/counts_by_stage") {
            const auto& counts = field.as<std::vector<double>>(leaf.owner);
            for (std::size_t i = 0; i < counts.size(); ++i) {
                values.push_back({leaf.path + '/' + std::to_string(i), StageCount{i, counts[i]}});
            }
        } else if (field.kind == Kind::number || field.kind == Kind::integer
                   || field.kind == Kind::choice) {
            values.push_back({leaf.path, leaf});
        }
    }
    addRequirements(summary.summary, inputs, values);
    return values;
}

std::vector<ComparedRow> compareRuns(const std::vector<ComparedRun>& runs) {
    std::vector<RunValues> inputs, results;
    for (const ComparedRun& run : runs) {
        inputs.push_back(run.inputs ? inputsRead(*run.inputs) : RunValues());
        results.push_back(run.summary ? resultsStated(*run.summary, run.inputs) : RunValues());
    }
    std::vector<ComparedRow> rows;
    addDiffering(inputs, false, rows);
    addDiffering(results, true, rows);
    return rows;
}

std::optional<ConstraintResult> constraintOf(const RequirementSummary& requirement, bool isWhole,
                                             const Project* inputs) {
    const Requirement* const row = requirementNamed(requirement.name);
    if (!row) {
        return std::nullopt;
    }
    ConstraintResult constraint{row->kind};
    constraint.section = -1;
    for (const Zone zone : {Zone::rz1, Zone::nz, Zone::rz2}) {
        if (requirement.where == zoneKey(zone)) {
            constraint.zone = zone;
            constraint.section = static_cast<int>(zone);
        }
    }
    constraint.section = numberBehind("section ", requirement.where).value_or(constraint.section);
    constraint.stage = numberBehind("stage ", requirement.where).value_or(0);
    constraint.limit = requirement.limit;
    constraint.value = requirement.value;
    constraint.margin = requirement.margin;
    constraint.relativeMargin = requirement.relative_margin;
    constraint.holds = requirement.ok;
    const bool isAbove = (constraint.value - constraint.limit) * constraint.margin > 0;
    constraint.isLeast = row->isLeast || (isRange(constraint) && isAbove); // of the nearer end
    constraint.isWhole = isWhole || !row->isOfSurface();
    if (inputs) {
        constraint.knowsMachine = knowsMachine(row->kind, *inputs);
        if (row->kind == ConstraintKind::roughness) {
            constraint.mostValue = roughnessFactor(*inputs).greatestOf(requirement.value);
        }
    }
    return constraint;
}

std::optional<ConstraintResult> leastMargin(const RunSummary& summary, const Project* inputs) {
    return leastMargin(wholeOf(summary, inputs));
}

std::optional<ConstraintResult> leastMargin(std::span<const ConstraintResult> constraints) {
    std::optional<ConstraintResult> least;
    for (const ConstraintResult& constraint : constraints) {
        if (marginKnown(constraint) != MarginKnown::exactly) {
            continue;
        }
        // the end of a range, or the least number of steps, may be reached
        const bool mayBeMet = isRange(constraint) || constraint.kind == ConstraintKind::leastSteps;
        const bool counts = !mayBeMet || !constraint.holds;
        if (counts && (!least || constraint.relativeMargin < least->relativeMargin)) {
            least = constraint;
        }
    }
    return least;
}

std::optional<Light> verdictOf(const RunSummary& summary, const Project* inputs) {
    if (summary.requirements.empty()) {
        return std::nullopt;
    }
    std::vector<ConstraintResult> constraints;
    for (const RequirementSummary& requirement : summary.requirements) {
        if (const auto constraint = constraintOf(requirement, true, inputs)) {
            constraints.push_back(*constraint);
        }
    }
    const Light light = verdictOf(summary.status, constraints);
    const bool isOpen = inputs && !undecided(*inputs, constraints).empty();
    return isOpen ? std::max(light, Light::undecided) : light;
}

std::optional<double> largestDifference(const std::vector<double>& a,
                                        const std::vector<double>& b) {
    if (a.size() != b.size()) {
        return std::nullopt;
    }
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

bool haveSamePlaces(const RunPlaces& a, const RunPlaces& b) {
    return a.project.operation == b.project.operation
           && a.summary.zones.size() == b.summary.zones.size();
}

std::size_t matchingPlace(const RunPlaces& run, std::size_t zone, const RunPlaces& other) {
    if (haveSamePlaces(run, other)) {
        return zone;
    }
    const double wanted = placeShare(run, zone);
    const auto distance = [&](std::size_t place) {
        return std::abs(placeShare(other, place) - wanted);
    };
    std::size_t nearest = 0;
    for (std::size_t place = 1; place < other.summary.zones.size(); ++place) {
        nearest = distance(place) < distance(nearest) ? place : nearest;
    }
    return nearest;
}

} // namespace sparkout
