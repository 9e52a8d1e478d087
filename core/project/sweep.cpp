// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/sweep.h"

#include "core/project/conditions.h"
#include "core/project/number_input.h"
#include "core/text.h"

#include <cmath>
#include <string>
#include <utility>

namespace sparkout {

namespace {

class SweepRules {
public:
    explicit SweepRules(const Project& project) : m_project(project) {}

    Issues check() {
        const auto& axes = m_project.sweep->inputs;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            checkAxis(axes[i], "/sweep/inputs/" + std::to_string(i));
        }
        if (axes.size() == 2 && axes[0].input == axes[1].input) {
            add(IssueCode::variedTwice, "/sweep/inputs/1/input", Quoted{'"' + axes[1].input + '"'},
                Phrase::anotherInput);
        }
        return std::move(m_issues);
    }

private:
    void checkAxis(const SweepAxis& axis, const std::string& path) {
        const auto input = numberInput(m_project, axis.input);
        if (!input) {
            add(IssueCode::noSuchNumber, path + "/input", Quoted{'"' + axis.input + '"'},
                Phrase::pathOfInput);
            return;
        }
        const char* const unit = input->field->unit;
        const bool inside =
            checkEnd(axis.from, *input, path + "/from") && checkEnd(axis.to, *input, path + "/to");
        if (inside && axis.spacing == SweepSpacing::logarithmic && axis.from <= 0) {
            add(IssueCode::outOfRange, path + "/from", Amount{axis.from, unit},
                Bounds{{.low = 0, .lowOpen = true}, unit});
        } else if (inside && axis.to <= axis.from) {
            add(IssueCode::outOfRange, path + "/to", Amount{axis.to, unit},
                Bounds{{.low = axis.from, .lowOpen = true}, unit});
        }
    }

    bool checkEnd(double value, const NumberInput& input, const std::string& path) {
        const char* const unit = input.field->unit;
        if (!input.allowed.contains(value)) {
            add(IssueCode::outOfRange, path, Amount{value, unit}, Bounds{input.allowed, unit});
            return false;
        }
        if (input.integer && value != std::floor(value)) {
            add(IssueCode::wrongType, path, Amount{value}, Phrase::wholeNumber);
            return false;
        }
        return true;
    }

    void add(IssueCode code, std::string path, Detail value, Detail limit) {
        m_issues.push_back(
            {code, Severity::error, std::move(path), std::move(value), std::move(limit)});
    }

    const Project& m_project;
    Issues m_issues;
};

} // namespace

Issues sweepFaults(const Project& project) {
    return project.sweep ? SweepRules(project).check() : Issues();
}

template <>
std::span<const Choice> choicesOf<SweepSpacing>() {
    static const std::array choices{Choice{"linear", SPARKOUT_NOOP("Choice", "equal steps")},
                                    Choice{"logarithmic", SPARKOUT_NOOP("Choice", "equal ratios")}};
    return choices;
}

template <>
const StructInfo& tableOf<SweepAxis>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            SweepAxis, input, .label = SPARKOUT_NOOP("Input", "Input"),
            .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input", "Path of any number of the file that a cycle reads, as "
                                           "`/wheel/dullness` or `/cycle/stages/0/stock_mm`.")),
        SPARKOUT_FIELD(SweepAxis, from, .label = SPARKOUT_NOOP("Input", "From"),
                       .hard = {-1e9, 1e9}, .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Minimum value, in the unit of the input.")),
        SPARKOUT_FIELD(SweepAxis, to, .label = SPARKOUT_NOOP("Input", "To"), .hard = {-1e9, 1e9},
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Maximum value, in the unit of the input.")),
        SPARKOUT_FIELD(SweepAxis, points, .label = SPARKOUT_NOOP("Input", "Points"),
                       .hard = {2, 101},
                       .hint = SPARKOUT_NOOP("Input", "Number of values, both ends included.")),
        SPARKOUT_FIELD(
            SweepAxis, spacing, .label = SPARKOUT_NOOP("Input", "Spacing"),
            .hint = SPARKOUT_NOOP(
                "Input",
                "Values at equal steps, or at equal ratios of positive values (logarithmic).")),
    };
    static const StructInfo info =
        makeTable<SweepAxis>(SPARKOUT_NOOP("Struct", "Varied input"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Sweep>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Sweep, inputs, .label = SPARKOUT_NOOP("Input", "Varied inputs"), .hard = {1, 2},
            .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input", "One varied input gives curves, two give a map.")),
    };
    static const StructInfo info = makeTable<Sweep>(SPARKOUT_NOOP("Struct", "Sweep"), rows);
    return info;
}

} // namespace sparkout
