// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/sweep_run.h"

#include "core/batch/characteristics.h"
#include "core/batch/worker_pool.h"
#include "core/file/output_json.h"
#include "core/project/machine.h"
#include "core/project/number_input.h"
#include "core/project/part.h"
#include "core/project/range_check.h"
#include "core/project/sweep.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/ranges.h"
#include "core/quality/result_names.h"
#include "core/quality/roughness.h"
#include "core/simulation/simulate.h"
#include "core/text.h"
#include "core/units.h"
#include "core/version.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace sparkout {

std::vector<SweepEntry> sweepEntries(const SweepResult& sweep, bool each) {
    std::vector<SweepEntry> entries;
    const auto& all = sweep.quantities;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string& name = all[i].name;
        if (std::ranges::find(entries, name, &SweepEntry::key) != entries.end()) {
            continue;
        }
        SweepEntry entry{name, {}};
        for (std::size_t q = i; q < all.size(); ++q) {
            if (all[q].name == name) {
                entry.quantities.push_back(q);
            }
        }
        entries.push_back(entry);
        for (const std::size_t q : entry.quantities) {
            if (each && entry.quantities.size() > 1) {
                entries.push_back({name + ' ' + std::to_string(all[q].section), {q}});
            }
        }
    }
    return entries;
}

std::optional<std::size_t> worstAt(const SweepPoint& point, const SweepEntry& entry) {
    std::optional<std::size_t> worst;
    for (const std::size_t q : entry.quantities) {
        if (point.values.empty() || std::isnan(point.values[q].value)) {
            continue;
        }
        const SweepValue& value = point.values[q];
        const bool limited =
            worst && !std::isnan(value.margin) && !std::isnan(point.values[*worst].margin);
        if (!worst
            || (limited ? value.margin < point.values[*worst].margin
                        : value.value > point.values[*worst].value)) {
            worst = q;
        }
    }
    return worst;
}

bool changesNothing(const SweepResult& sweep) {
    const SweepPoint* first = nullptr;
    for (const SweepPoint& point : sweep.points) {
        if (point.status != SweepStatus::done) {
            return false;
        }
        first = first ? first : &point;
        const bool same =
            std::ranges::equal(point.values, first->values, [](const auto& a, const auto& b) {
                const auto equal = [](double x, double y) {
                    return x == y || (std::isnan(x) && std::isnan(y));
                };
                return equal(a.value, b.value) && equal(a.low, b.low) && equal(a.high, b.high);
            });
        if (!same) {
            return false;
        }
    }
    return sweep.points.size() > 1;
}

namespace {

using nlohmann::ordered_json;

constexpr int digitsBetween = 10;

double roundedBetween(double value, double low, double high) {
    char buffer[64];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value,
                                            std::chars_format::general, digitsBetween);
    std::from_chars(buffer, end, value);
    return std::clamp(value, low, high);
}

std::vector<SweptInput> sweptInputs(const Project& project) {
    std::vector<SweptInput> inputs;
    for (const SweepAxis& axis : project.sweep->inputs) {
        const auto input = numberInput(project, axis.input);
        inputs.push_back({axis, input->field->unit, sweepValues(axis, input->integer)});
    }
    return inputs;
}

using Quantities = std::vector<SweepQuantity>;

class SweepPool {
public:
    SweepPool(SweepResult& result, const SweepOptions& options)
        : m_result(result), m_options(options), m_base(withMeasuredRa(result.project)) {
        m_base.batch.reset(); // no cycle uses them
        m_base.optimisation.reset();
        m_base.sweep.reset();
    }

    void run() {
        const auto count = static_cast<std::int64_t>(m_result.points.size());
        m_listOf.resize(m_result.points.size());
        forEachIndex(workerCount(m_options.threads), 0, count, m_options.stop,
                     [this](std::size_t, std::int64_t index) {
                         return runPoint(static_cast<std::size_t>(index));
                     });
        gatherQuantities();
        for (std::size_t i = 0; i < m_listOf.size(); ++i) {
            place(m_listOf[i], m_result.points[i]);
        }
    }

private:
    bool runPoint(std::size_t index) {
        Project project = m_base;
        putSweptValues(project, m_result.project.sweep->inputs, m_result.valuesAt(index));
        SweepPoint& mine = m_result.points[index];
        Issues issues = validate(project);
        std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
        if (!issues.empty()) {
            mine.status = SweepStatus::refused;
            mine.issues = std::move(issues);
        } else {
            const SimulationResult result = simulateUnchecked(project, nullptr, m_options.stop);
            if (result.status == RunStatus::stopped) {
                return false;
            }
            if (result.status == RunStatus::completed) {
                MeasuredPoint measured = measurePoint(result);
                mine = std::move(measured.point);
                m_listOf[index] = listOf(std::move(measured.quantities));
            } else {
                mine.status = SweepStatus::notReached;
                mine.run = result.status;
            }
        }
        if (m_options.done) {
            m_options.done->fetch_add(1, std::memory_order_relaxed);
        }
        return true;
    }

    /// One list for all points with the same quantities, as most have.
    const Quantities* listOf(Quantities quantities) {
        const std::lock_guard lock(m_mutex);
        for (const Quantities& list : m_lists) {
            if (list == quantities) {
                return &list;
            }
        }
        return &m_lists.emplace_back(std::move(quantities));
    }

    /// Each once, in the order of the points, independent of the threads.
    void gatherQuantities() {
        Quantities& all = m_result.quantities;
        const Quantities* last = nullptr;
        for (const Quantities* list : m_listOf) {
            if (!list || list == last) {
                continue;
            }
            last = list;
            for (const SweepQuantity& quantity : *list) {
                if (std::ranges::find(all, quantity) == all.end()) {
                    all.push_back(quantity);
                }
            }
        }
    }

    /// Sets the values of a point in the order of all quantities.
    void place(const Quantities* list, SweepPoint& point) {
        if (!list || *list == m_result.quantities) {
            return;
        }
        const std::vector<SweepValue> own = std::move(point.values);
        point.values.assign(m_result.quantities.size(), {});
        for (std::size_t i = 0; i < own.size(); ++i) {
            const auto at = std::ranges::find(m_result.quantities, (*list)[i]);
            point.values[static_cast<std::size_t>(at - m_result.quantities.begin())] = own[i];
        }
    }

    SweepResult& m_result;
    const SweepOptions& m_options;
    Project m_base;
    std::vector<const Quantities*> m_listOf; ///< of each point; null: none
    std::deque<Quantities> m_lists;          ///< guarded by the mutex
    std::mutex m_mutex;
};

constexpr double percent = 100;

class PointMeasure {
public:
    explicit PointMeasure(const SimulationResult& result)
        : m_result(result), m_constraints(evaluateConstraints(result)) {}

    MeasuredPoint measure() {
        m_measured.point.status = SweepStatus::done;
        m_measured.point.run = m_result.status;
        add("time", "s", {m_result.time_s});
        addLeastMargin();
        for (std::size_t i = 0; i < m_result.sections.size(); ++i) {
            addSection(m_result.sections[i], static_cast<int>(i));
        }
        for (const ConstraintResult& constraint : worstByKind(m_constraints)) {
            if (requirementOf(constraint.kind).scope != ConstraintScope::section) {
                add(requirementOf(constraint.kind).key, requirementOf(constraint.kind).unit,
                    valueOf(constraint));
            }
        }
        add("peak_normal_force", "N", {m_result.peakNormalForce_n});
        add("peak_power", "kW", {m_result.peakPower_w / units::wPerKw});
        return std::move(m_measured);
    }

private:
    void add(const char* name, const char* unit, const SweepValue& value, Zone zone = Zone::section,
             int section = -1) {
        m_measured.quantities.push_back({name, unit, zone, section});
        m_measured.point.values.push_back(value);
    }

    static SweepValue valueOf(const ConstraintResult& constraint) {
        if (!constraint.isWhole || !isComputed(constraint)) {
            return {}; // strips stay uncut, or the wheel is not known
        }
        SweepValue value{constraint.value};
        (constraint.isLeast ? value.low : value.high) = constraint.limit;
        value.margin = constraint.margin;
        return value;
    }

    /// Like a batch: settings, such as those limited by the machine's ranges, have no margin of
    /// that kind.
    void addLeastMargin() {
        SweepPoint& point = m_measured.point;
        point.good = true;
        std::optional<double> least;
        for (const ConstraintResult& constraint : m_constraints) {
            point.good = point.good && constraint.holds;
            if (requirementOf(constraint.kind).scope != ConstraintScope::setting
                && constraint.isWhole && isComputed(constraint)) {
                least =
                    std::min(least.value_or(constraint.relativeMargin), constraint.relativeMargin);
            }
        }
        if (least) {
            SweepValue value{*least * percent};
            value.low = 0;
            value.margin = value.value;
            add("least_margin", "%", value);
        }
    }

    void addSection(const SectionResult& section, int index) {
        const Part& part = *m_result.project.part;
        const auto addHere = [&](const char* name, const SweepValue& value) {
            add(name, "µm", value, section.zone, index);
        };
        if (!FinishedSurface(m_result.project).isWhole()) {
            return;
        }
        SweepValue diameter{meanDeviation_um(section, part.diameter_mm)};
        diameter.low = part.lower_deviation_um;
        diameter.high = part.upper_deviation_um;
        diameter.margin = std::min(diameter.value - diameter.low, diameter.high - diameter.value);
        addHere("diameter", diameter);
        bool runout = false, roundness = false;
        for (const ConstraintResult& constraint : m_constraints) {
            if (requirementOf(constraint.kind).scope == ConstraintScope::section
                && constraint.section == index) {
                addHere(requirementOf(constraint.kind).key, valueOf(constraint));
                runout = runout || constraint.kind == ConstraintKind::radialRunout;
                roundness = roundness || constraint.kind == ConstraintKind::roundness;
            }
        }
        if (!runout) {
            addHere(requirementOf(ConstraintKind::radialRunout).key,
                    {section.radialRunout_mm * units::umPerMm});
        }
        if (!roundness) {
            const auto place = static_cast<std::size_t>(index);
            addHere(requirementOf(ConstraintKind::roundness).key,
                    {roundnessOf(m_result, place) * units::umPerMm});
        }
    }

    const SimulationResult& m_result;
    std::vector<ConstraintResult> m_constraints;
    MeasuredPoint m_measured;
};

constexpr Output<SweepResult> sweepRows[] = {
    {{.key = "status", .hint = "completed or stopped"},
     [](const SweepResult& s) { return std::string(s.stopped ? "stopped" : "completed"); }},
};

constexpr Output<SweptInput> sweptInputRows[] = {
    {{.key = "input", .hint = "JSON pointer of the varied input"},
     [](const SweptInput& i) { return i.axis.input; }},
    {{.key = "unit", .hint = "unit of its values"}, [](const SweptInput& i) { return i.unit; }},
};

constexpr Output<SweepPoint> sweepPointRows[] = {
    {{.key = "status", .hint = "not_run, refused, cannot_reach_size or completed"},
     [](const SweepPoint& p) { return std::string(sweepStatusKey(p.status)); }},
    {{.key = "ok", .hint = "whether every requirement is met"},
     [](const SweepPoint& p) { return p.good; }},
};

/// Omits missing values.
template <double SweepValue::*number>
constexpr Output<SweepFigure> sweepNumber(const char* key, const char* hint) {
    return {{.key = key, .hint = hint},
            [](const SweepFigure& f) { return f.value.*number; },
            nullptr,
            [](const SweepFigure& f) { return !std::isnan(f.value.*number); }};
}

constexpr Output<SweepFigure> sweepFigureRows[] = {
    {{.key = "name", .hint = "a requirement, or time, least_margin, diameter …"},
     [](const SweepFigure& f) { return f.quantity.name; }},
    {{.key = "where"},
     [](const SweepFigure& f) { return sectionOrPart(f.quantity.zone, f.quantity.section); }},
    {{.key = "unit", .hint = "of value, limits and margin; empty for a plain number"},
     [](const SweepFigure& f) { return f.quantity.unit; }},
    {{.key = "value"}, [](const SweepFigure& f) { return f.value.value; }},
    sweepNumber<&SweepValue::low>("low", "lower limit"),
    sweepNumber<&SweepValue::high>("high", "upper limit"),
    sweepNumber<&SweepValue::margin>("margin", "positive when the requirement is met"),
};

ordered_json pointJson(const SweepResult& sweep, std::size_t index,
                       std::string (*sentence)(const Issue& issue)) {
    const SweepPoint& point = sweep.points[index];
    ordered_json json = {{"values", sweep.valuesAt(index)}};
    json.update(outputsJson(sweepPointOutputs(), point));
    json["results"] = ordered_json::array();
    for (const Issue& issue : point.issues) {
        json["refused"].push_back(issue.path + ": " + sentence(issue));
    }
    for (std::size_t q = 0; q < point.values.size(); ++q) {
        if (!std::isnan(point.values[q].value)) {
            json["results"].push_back(
                outputsJson(sweepFigureOutputs(), {sweep.quantities[q], point.values[q]}));
        }
    }
    return json;
}

} // namespace

std::vector<double> SweepResult::valuesAt(std::size_t point) const {
    const std::size_t across = inputs.front().values.size();
    std::vector<double> values{inputs.front().values[point % across]};
    if (inputs.size() > 1) {
        values.push_back(inputs[1].values[point / across]);
    }
    return values;
}

Issues checkSweep(const Project& project) {
    if (!project.sweep) {
        return {{IssueCode::missingKey, Severity::error, "/sweep", {}, Phrase::anObject}};
    }
    Issues issues = checkRanges(project);
    std::erase_if(issues, [](const Issue& issue) {
        return issue.severity != Severity::error || !issue.path.starts_with("/sweep/");
    });
    return issues.empty() ? sweepFaults(project) : issues;
}

std::vector<double> sweepValues(const SweepAxis& axis, bool integer) {
    std::vector<double> values;
    const int last = axis.points - 1;
    for (int i = 0; i <= last; ++i) {
        const double share = static_cast<double>(i) / last;
        double value = i == 0 ? axis.from : axis.to;
        if (i > 0 && i < last) {
            value = axis.spacing == SweepSpacing::logarithmic
                        ? axis.from * std::pow(axis.to / axis.from, share)
                        : axis.from + (axis.to - axis.from) * share;
            value = roundedBetween(integer ? std::round(value) : value, axis.from, axis.to);
        }
        if (values.empty() || value > values.back()) {
            values.push_back(value);
        }
    }
    return values;
}

std::int64_t pointsOf(const Project& project) {
    if (!checkSweep(project).empty()) {
        return 0;
    }
    std::int64_t points = 1;
    for (const SweptInput& input : sweptInputs(project)) {
        points *= static_cast<std::int64_t>(input.values.size());
    }
    return points;
}

void putSweptValues(Project& project, const std::vector<SweepAxis>& axes,
                    const std::vector<double>& values) {
    const auto isDiameter = [&](std::size_t i) { return axes[i].input == "/wheel/diameter_mm"; };
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (isDiameter(i)) {
            changeWheelDiameter(project, values[i]);
        }
    }
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (!isDiameter(i)) {
            setNumberInput(project, axes[i].input, values[i]);
        }
    }
    resolveWaves(project);
}

SweepResult runSweep(const Project& project, const SweepOptions& options) {
    SweepResult result;
    result.project = project;
    result.project.runs.clear();
    result.engineVersion = version;
    result.issues = checkSweep(project);
    if (!result.ran()) {
        return result;
    }
    result.inputs = sweptInputs(project);
    result.points.resize(static_cast<std::size_t>(pointsOf(project)));
    SweepPool(result, options).run();
    result.stopped = std::ranges::any_of(result.points, [](const SweepPoint& point) {
        return point.status == SweepStatus::pending;
    });
    return result;
}

MeasuredPoint measurePoint(const SimulationResult& result) {
    return PointMeasure(result).measure();
}

std::span<const Output<SweepResult>> sweepOutputs() {
    return sweepRows;
}

std::span<const Output<SweptInput>> sweptInputOutputs() {
    return sweptInputRows;
}

std::span<const Output<SweepPoint>> sweepPointOutputs() {
    return sweepPointRows;
}

std::span<const Output<SweepFigure>> sweepFigureOutputs() {
    return sweepFigureRows;
}

const char* sweepStatusKey(SweepStatus status) {
    constexpr std::array keys{"not_run", "refused", "cannot_reach_size", "completed"};
    return keys[static_cast<std::size_t>(status)];
}

std::string sweepJson(const SweepResult& sweep, std::string (*sentence)(const Issue& issue)) {
    ordered_json json = outputsJson(sweepOutputs(), sweep);
    json["inputs"] = outputsJsonOfEach(sweptInputOutputs(), sweep.inputs);
    json["points"] = ordered_json::array();
    for (std::size_t i = 0; i < sweep.inputs.size(); ++i) {
        json["inputs"][i]["values"] = sweep.inputs[i].values;
    }
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        json["points"].push_back(pointJson(sweep, i, sentence));
    }
    return json.dump(2) + '\n';
}

} // namespace sparkout
