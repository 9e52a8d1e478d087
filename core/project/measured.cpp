// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/measured.h"

#include "core/project/conditions.h"
#include "core/project/project.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace sparkout {

namespace {

constexpr Range sizes_um{-1e6, 1e6};
constexpr Range forms_um{0, 1e5};

class MeasuredRules {
public:
    explicit MeasuredRules(const Project& project)
        : m_measured(*project.measured), m_places(placeCount(project)) {}

    Issues check() {
        for (std::size_t i = 0; i < m_measured.parts.size(); ++i) {
            checkPlace(m_measured.parts[i].place, at("parts", i));
        }
        for (std::size_t i = 0; i < m_measured.traces.size(); ++i) {
            checkTrace(m_measured.traces[i], at("traces", i));
        }
        for (std::size_t i = 0; i < m_measured.summaries.size(); ++i) {
            const MeasuredSummary& summary = m_measured.summaries[i];
            checkPlace(summary.place, at("summaries", i));
            if (summary.least_um && summary.greatest_um && sizes_um.contains(*summary.least_um)
                && *summary.greatest_um < *summary.least_um) {
                add(IssueCode::outOfRange, Severity::error, at("summaries", i) + "/greatest_um",
                    Amount{*summary.greatest_um, "µm"},
                    Bounds{.range = {.low = *summary.least_um}, .unit = "µm"});
            }
        }
        return std::move(m_issues);
    }

private:
    static std::string at(const char* list, std::size_t index) {
        return "/measured/" + std::string(list) + "/" + std::to_string(index);
    }

    void add(IssueCode code, Severity severity, std::string path, Detail value, Detail limit) {
        if (m_issues.size() < limits::issues) {
            m_issues.push_back(
                {code, severity, std::move(path), std::move(value), std::move(limit)});
        }
    }

    /// A part with fewer sections than when it was measured keeps the data, but nothing is compared
    /// with them.
    void checkPlace(int place, const std::string& path) {
        if (place >= m_places) {
            add(IssueCode::outOfRange, Severity::warning, path + "/place", Count{place},
                Bounds{{0, static_cast<double>(m_places - 1)}});
        }
    }

    void checkTrace(const MeasuredTrace& trace, const std::string& path) {
        if (trace.place) {
            checkPlace(*trace.place, path);
        }
        const std::vector<double>& times = trace.time_s.values();
        if (times.size() > limits::traceSamples) {
            add(IssueCode::wrongCount, Severity::error, path + "/time_s", countOf(times.size()),
                Bounds{{.high = static_cast<double>(limits::traceSamples)}});
        }
        if (trace.values.size() != times.size()) {
            add(IssueCode::wrongCount, Severity::error, path + "/values",
                countOf(trace.values.size()), countOf(times.size()));
        }
        const auto falls = std::ranges::adjacent_find(times, std::greater<>());
        if (falls != times.end()) {
            const auto index = static_cast<std::size_t>(falls - times.begin()) + 1;
            add(IssueCode::outOfRange, Severity::error, path + "/time_s/" + std::to_string(index),
                Amount{times[index], "s"}, Bounds{.range = {.low = *falls}, .unit = "s"});
        }
    }

    const Measured& m_measured;
    int m_places;
    Issues m_issues;
};

} // namespace

Issues measuredFaults(const Project& project) {
    return project.measured ? MeasuredRules(project).check() : Issues();
}

template <>
std::span<const Choice> choicesOf<MeasuredQuantity>() {
    static const std::array choices{
        Choice{"diameter_deviation", SPARKOUT_NOOP("Choice", "diameter deviation")},
        Choice{"radial_runout", SPARKOUT_NOOP("Choice", "radial runout")},
        Choice{"roundness", SPARKOUT_NOOP("Choice", "roundness")},
        Choice{"cylindricity", SPARKOUT_NOOP("Choice", "cylindricity")},
        Choice{"roughness_ra", SPARKOUT_NOOP("Choice", "roughness Ra")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<TraceQuantity>() {
    static const std::array choices{
        Choice{"gauge_size", SPARKOUT_NOOP("Choice", "size at the gauge")},
        Choice{"wheel_power", SPARKOUT_NOOP("Choice", "wheel power")},
        Choice{"spindle_current", SPARKOUT_NOOP("Choice", "spindle current")},
        Choice{"normal_force", SPARKOUT_NOOP("Choice", "normal force")}};
    return choices;
}

template <>
const StructInfo& tableOf<MeasuredPart>() {
    static const std::array rows{
        SPARKOUT_FIELD(MeasuredPart, part, .label = SPARKOUT_NOOP("Input", "Part number"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Number or name of the measured part.")),
        SPARKOUT_FIELD(
            MeasuredPart, place, .label = SPARKOUT_NOOP("Input", "Zone or section"),
            .hard = {0, 199},
            .hint = SPARKOUT_NOOP(
                "Input",
                "Zone or section where it was measured, counted from 0 at the headstock.")),
        SPARKOUT_FIELD(
            MeasuredPart, diameters_mm, .label = SPARKOUT_NOOP("Input", "Measured diameters"),
            .unit = "mm", .hard = {0.1, 3000}, .sparse = true,
            .hint = SPARKOUT_NOOP("Input",
                                  "One diameter, or several around the part, whose mean counts.")),
        SPARKOUT_FIELD(MeasuredPart, roundness_um,
                       .label = SPARKOUT_NOOP("Input", "Measured roundness"), .unit = "µm",
                       .hard = forms_um, .nullMeaning = SPARKOUT_NOOP("Input", "not measured"),
                       .hint = SPARKOUT_NOOP("Input", "Roundness deviation of this section."),
                       .source = "ISO12181"),
        SPARKOUT_FIELD(
            MeasuredPart, radial_runout_um, .label = SPARKOUT_NOOP("Input", "Measured runout"),
            .unit = "µm", .hard = forms_um, .nullMeaning = SPARKOUT_NOOP("Input", "not measured"),
            .hint = SPARKOUT_NOOP("Input", "Radial runout of this section about the centres."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            MeasuredPart, cylindricity_um, .label = SPARKOUT_NOOP("Input", "Measured cylindricity"),
            .unit = "µm", .hard = forms_um, .nullMeaning = SPARKOUT_NOOP("Input", "not measured"),
            .hint = SPARKOUT_NOOP("Input", "Cylindricity deviation of the part, stated once in "
                                           "any of its zones or sections."),
            .source = "ISO12180"),
        SPARKOUT_FIELD(MeasuredPart, roughness_ra_um,
                       .label = SPARKOUT_NOOP("Input", "Measured roughness"), .unit = "µm",
                       .hard = {0, 100}, .nullMeaning = SPARKOUT_NOOP("Input", "not measured"),
                       .hint = SPARKOUT_NOOP("Input", "Arithmetic mean roughness Ra along the "
                                                      "axis."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(MeasuredPart, time, .label = SPARKOUT_NOOP("Input", "When"), .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "When the part was ground or measured.")),
        SPARKOUT_FIELD(MeasuredPart, note, .label = SPARKOUT_NOOP("Input", "Note"), .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Anything worth knowing about the data.")),
    };
    static const StructInfo info =
        makeTable<MeasuredPart>(SPARKOUT_NOOP("Struct", "Measured part"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MeasuredTrace>() {
    static const std::array rows{
        SPARKOUT_FIELD(MeasuredTrace, quantity, .label = SPARKOUT_NOOP("Input", "Quantity"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Quantity recorded over time.")),
        SPARKOUT_FIELD(MeasuredTrace, place, .label = SPARKOUT_NOOP("Input", "Zone or section"),
                       .hard = {0, 199},
                       .nullMeaning = SPARKOUT_NOOP("Input", "where the gauge measures"),
                       .hint = SPARKOUT_NOOP(
                           "Input", "Zone or section where a size was recorded, counted from 0.")),
        SPARKOUT_FIELD(
            MeasuredTrace, factor_kw_per_a, .label = SPARKOUT_NOOP("Input", "Power to current"),
            .unit = "kW/A", .hard = {0, 1000, true}, .soft = {0.05, 2},
            .nullMeaning = SPARKOUT_NOOP("Input", "not known, or the trace is not a current"),
            .hint =
                SPARKOUT_NOOP("Input", "Power of the wheel spindle per ampere of its current.")),
        SPARKOUT_FIELD(MeasuredTrace, idle, .label = SPARKOUT_NOOP("Input", "Idle value"),
                       .hard = {0, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not known"),
                       .hint =
                           SPARKOUT_NOOP("Input", "Power or current of the spindle while "
                                                  "nothing is cut, in the unit of the values.")),
        SPARKOUT_FIELD(MeasuredTrace, time_s, .label = SPARKOUT_NOOP("Input", "Times"), .unit = "s",
                       .hard = {-1e6, 1e6}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Times of the samples in order, none earlier "
                                                      "than the one before it; at most 20,000.")),
        SPARKOUT_FIELD(MeasuredTrace, values, .label = SPARKOUT_NOOP("Input", "Values"),
                       .hard = {-1e6, 1e6}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "One value for each time: a size in mm of "
                                                      "diameter from any zero, a power in kW, a "
                                                      "current in A, a force in N.")),
        SPARKOUT_FIELD(MeasuredTrace, source, .label = SPARKOUT_NOOP("Input", "Source file"),
                       .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Name of the file the samples were read "
                                                      "from.")),
        SPARKOUT_FIELD(MeasuredTrace, source_sha256,
                       .label = SPARKOUT_NOOP("Input", "Digest of the source"), .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "SHA-256 of that file, as hexadecimal "
                                                      "digits.")),
        SPARKOUT_FIELD(
            MeasuredTrace, source_samples, .label = SPARKOUT_NOOP("Input", "Samples of the source"),
            .hard = {0, 1e9}, .sparse = true,
            .hint = SPARKOUT_NOOP("Input", "Number of samples in that file; if they exceeded the "
                                           "limit, they were reduced to means.")),
        SPARKOUT_FIELD(MeasuredTrace, note, .label = SPARKOUT_NOOP("Input", "Note"), .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Anything worth knowing about the data.")),
    };
    static const StructInfo info =
        makeTable<MeasuredTrace>(SPARKOUT_NOOP("Struct", "Measured trace"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MeasuredSummary>() {
    static const std::array rows{
        SPARKOUT_FIELD(MeasuredSummary, quantity, .label = SPARKOUT_NOOP("Input", "Quantity"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Quantity that the statistics describe.")),
        SPARKOUT_FIELD(
            MeasuredSummary, place, .label = SPARKOUT_NOOP("Input", "Zone or section"),
            .hard = {0, 199},
            .hint = SPARKOUT_NOOP(
                "Input",
                "Zone or section where it was measured, counted from 0 at the headstock.")),
        SPARKOUT_FIELD(MeasuredSummary, count, .label = SPARKOUT_NOOP("Input", "Number of parts"),
                       .hard = {2, 1'000'000}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Number of parts that were measured.")),
        SPARKOUT_FIELD(MeasuredSummary, mean_um, .label = SPARKOUT_NOOP("Input", "Mean"),
                       .unit = "µm", .hard = sizes_um, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Mean of the parts; of a diameter its mean "
                                                      "deviation from the nominal one.")),
        SPARKOUT_FIELD(
            MeasuredSummary, half_width_um,
            .label = SPARKOUT_NOOP("Input", "Half width of the interval"), .unit = "µm",
            .hard = {0, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
            .hint = SPARKOUT_NOOP(
                "Input",
                "Half the width of the confidence interval of the mean: the value after ±.")),
        SPARKOUT_FIELD(MeasuredSummary, confidence, .label = SPARKOUT_NOOP("Input", "Confidence"),
                       .hard = {0.5, 0.9999},
                       .hint = SPARKOUT_NOOP("Input", "Confidence of that interval.")),
        SPARKOUT_FIELD(MeasuredSummary, deviation_um,
                       .label = SPARKOUT_NOOP("Input", "Standard deviation"), .unit = "µm",
                       .hard = {0, 1e6}, .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "Standard deviation of the parts. Where it "
                                                      "is not stated, it follows from the "
                                                      "interval of the mean.")),
        SPARKOUT_FIELD(MeasuredSummary, least_um, .label = SPARKOUT_NOOP("Input", "Minimum value"),
                       .unit = "µm", .hard = sizes_um,
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "Minimum value of all parts.")),
        SPARKOUT_FIELD(MeasuredSummary, greatest_um,
                       .label = SPARKOUT_NOOP("Input", "Maximum value"), .unit = "µm",
                       .hard = sizes_um, .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "Maximum value of all parts.")),
        SPARKOUT_FIELD(MeasuredSummary, note, .label = SPARKOUT_NOOP("Input", "Note"),
                       .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Anything worth knowing about the data.")),
    };
    static const StructInfo info =
        makeTable<MeasuredSummary>(SPARKOUT_NOOP("Struct", "Measured statistics"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Calibration>() {
    static const std::array rows{
        SPARKOUT_FIELD(Calibration, input, .label = SPARKOUT_NOOP("Input", "Calibrated input"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Path of the input whose value was found.")),
        SPARKOUT_FIELD(Calibration, value, .label = SPARKOUT_NOOP("Input", "Value found"),
                       .hard = {-1e9, 1e9}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Value that was found, in the unit of the "
                                                      "input.")),
        SPARKOUT_FIELD(Calibration, low, .label = SPARKOUT_NOOP("Input", "Lower end"),
                       .hard = {-1e9, 1e9}, .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "Lower end of its 95 % interval.")),
        SPARKOUT_FIELD(Calibration, high, .label = SPARKOUT_NOOP("Input", "Upper end"),
                       .hard = {-1e9, 1e9}, .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "Upper end of its 95 % interval.")),
        SPARKOUT_FIELD(Calibration, data, .label = SPARKOUT_NOOP("Input", "Data"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Data used for the calibration.")),
        SPARKOUT_FIELD(Calibration, count, .label = SPARKOUT_NOOP("Input", "Measured values"),
                       .hard = {1, 1e9},
                       .hint = SPARKOUT_NOOP("Input", "Number of measured values used.")),
        SPARKOUT_FIELD(Calibration, date, .label = SPARKOUT_NOOP("Input", "Date"), .sparse = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Date and time of the calibration, ISO 8601.")),
    };
    static const StructInfo info =
        makeTable<Calibration>(SPARKOUT_NOOP("Struct", "Calibration"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Measured>() {
    static const std::array rows{
        SPARKOUT_FIELD(Measured, parts, .label = SPARKOUT_NOOP("Input", "Measured parts"),
                       .hard = {0, limits::measuredParts}, .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "A row for each zone or section of a part.")),
        SPARKOUT_FIELD(Measured, traces, .label = SPARKOUT_NOOP("Input", "Measured traces"),
                       .hard = {0, limits::traces}, .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Quantities recorded over the time of a "
                                                      "cycle.")),
        SPARKOUT_FIELD(Measured, summaries, .label = SPARKOUT_NOOP("Input", "Measured statistics"),
                       .hard = {0, 1000}, .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Statistics of parts that are not listed.")),
        SPARKOUT_FIELD(Measured, calibrations, .label = SPARKOUT_NOOP("Input", "Calibrations"),
                       .hard = {0, 1000}, .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "Inputs whose values were found from "
                                                      "measurements.")),
    };
    static const StructInfo info =
        makeTable<Measured>(SPARKOUT_NOOP("Struct", "Measurements"), rows);
    return info;
}

} // namespace sparkout
