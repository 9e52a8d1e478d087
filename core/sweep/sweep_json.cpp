// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sweep/sweep_json.h"

#include "core/format/output_json.h"
#include "core/quality/result_names.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr Output<SweepResult> sweepRows[] = {
    {{.key = "status", .hint = "completed or stopped"},
     [](const SweepResult& s) { return std::string(s.stopped ? "stopped" : "completed"); }},
};

constexpr Output<SweptInput> sweptInputRows[] = {
    {{.key = "input", .hint = "JSON pointer of what is varied"},
     [](const SweptInput& i) { return i.axis.input; }},
    {{.key = "unit", .hint = "unit of its values"}, [](const SweptInput& i) { return i.unit; }},
};

constexpr Output<SweepPoint> sweepPointRows[] = {
    {{.key = "status", .hint = "not_run, refused, cannot_reach_size or completed"},
     [](const SweepPoint& p) { return std::string(sweepStatusKey(p.status)); }},
    {{.key = "ok", .hint = "whether every requirement holds"},
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
    sweepNumber<&SweepValue::margin>("margin", "positive when it holds"),
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
