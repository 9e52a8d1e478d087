// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/sweep_rules.h"

#include "core/project/number_input.h"
#include "core/project/sweep.h"

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

} // namespace sparkout
