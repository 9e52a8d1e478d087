// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/sweep_edits.h"

#include "core/file/project_file.h"
#include "core/project/number_input.h"
#include "core/project/sweep.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr int usualPoints = 21, mapPoints = 11;

double twoDigits(double value) {
    char buffer[64];
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 2);
    std::from_chars(buffer, end, value);
    return value;
}

/// The field's usual range, otherwise 0 to 1; extended to the current value.
Range usualRange(const NumberInput& input) {
    Range soft = input.field->soft;
    const double now = input.value.value_or(soft.low);
    soft = {std::min(soft.low, now), std::max(soft.high, now)};
    const bool bounded =
        std::isfinite(soft.low) && std::isfinite(soft.high) && soft.low < soft.high;
    return bounded ? soft : Range{0, 1};
}

Range about(double value) {
    const double half = twoDigits(value / 2), twice = twoDigits(value * 2);
    return {std::min(half, twice), std::max(half, twice)};
}

/// The nearest value that may be; an open end itself may not.
double allowedValue(double value, const Range& allowed) {
    const double inside = std::clamp(value, allowed.low, allowed.high);
    const double beside = std::isfinite(allowed.high) ? (allowed.high - allowed.low) / 1000 : 1e-3;
    return allowed.lowOpen && inside <= allowed.low ? allowed.low + beside : inside;
}

Project sweepOnly(Project project) {
    project.title.clear();
    project.author.clear();
    project.notes.clear();
    project.batch.reset();
    project.optimisation.reset();
    project.measured.reset();
    project.runs.clear();
    if (project.sweep && sweepFaults(project).empty()) {
        const std::vector<SweepAxis> axes = project.sweep->inputs;
        std::vector<double> values;
        std::ranges::transform(axes, std::back_inserter(values), &SweepAxis::from);
        putSweptValues(project, axes, values);
    }
    return project;
}

} // namespace

SweepAxis usualAxis(const Project& project, const std::string& path) {
    SweepAxis axis{path, 0, 1, usualPoints, SweepSpacing::linear};
    const auto input = numberInput(project, path);
    if (!input) {
        return axis;
    }
    const bool given = input->value && *input->value != 0;
    const Range range = given ? about(*input->value) : usualRange(*input);
    const auto end = [&input](double value, bool up) {
        const double whole = up ? std::ceil(value) : std::floor(value);
        return allowedValue(input->integer ? whole : value, input->allowed);
    };
    axis.from = end(range.low, false);
    axis.to = end(range.high, true);
    if (axis.to <= axis.from) { // at an end of the allowed range
        axis.from = allowedValue(axis.to - 1, input->allowed);
        axis.to = allowedValue(axis.from + 1, input->allowed);
    }
    return axis;
}

Project withSweptInput(Project project, std::size_t place, const std::string& path) {
    std::vector<SweepAxis> axes = project.sweep ? project.sweep->inputs : std::vector<SweepAxis>();
    if (place < axes.size()) {
        axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(place));
    }
    if (!path.empty()) {
        SweepAxis axis = usualAxis(project, path);
        axis.points = axes.empty() ? usualPoints : mapPoints;
        const std::size_t at = std::min(place, axes.size());
        axes.insert(axes.begin() + static_cast<std::ptrdiff_t>(at), std::move(axis));
    }
    if (axes.empty()) {
        project.sweep.reset();
    } else {
        project.sweep = Sweep{std::move(axes)};
    }
    return project;
}

Project withSweepAxis(Project project, std::size_t place, const SweepAxis& axis) {
    if (project.sweep && place < project.sweep->inputs.size()
        && project.sweep->inputs[place].input == axis.input) {
        project.sweep->inputs[place] = axis;
    }
    return project;
}

Project withPoint(Project project, const SweepResult& sweep, std::size_t point) {
    putSweptValues(project, sweep.project.sweep->inputs, sweep.valuesAt(point));
    return project;
}

bool sameSweep(const Project& a, const Project& b) {
    return sameProject(sweepOnly(a), sweepOnly(b));
}

} // namespace sparkout
