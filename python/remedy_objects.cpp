// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/remedy_objects.h"

#include "core/sparkout.h"
#include "python/interruptible.h"
#include "python/output_attributes.h"
#include "python/project_object.h"
#include "python/requirement_list.h"
#include "words/remedy_words.h"

#include <pybind11/stl.h>

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout::python {

namespace py = pybind11;

namespace {

struct FoundRemedy {
    Project project; ///< as it was
    Remedy remedy;
};

struct FoundConflict {
    Project project; ///< as it was
    RemedyConflict conflict;
};

struct FoundRemedies {
    Project project;
    RemedyResult result;
};

FoundRemedies remediesOf(const ValidProject& project) {
    return interruptible([&](const std::stop_token& stop) {
        const SimulationResult result = simulate(project.project, nullptr, stop);
        RemedyOptions options;
        options.stop = stop;
        return FoundRemedies{project.project,
                             findRemedies(result, evaluateConstraints(result), options)};
    });
}

std::vector<FoundRemedy> listOf(const FoundRemedies& self) {
    std::vector<FoundRemedy> list;
    for (const Remedy& each : self.result.remedies) {
        list.push_back({self.project, each});
    }
    return list;
}

std::optional<FoundConflict> conflictIn(const FoundRemedies& self) {
    return self.result.conflict ? std::optional(FoundConflict{self.project, *self.result.conflict})
                                : std::nullopt;
}

void bindRemedy(py::module_& module) {
    py::class_<FoundRemedy> remedy(module, "Remedy", "A change of one setting that helps.");
    bindOutputs(remedy, remedyOutputs(), [](const FoundRemedy& self) {
        return RemedyOf{self.project, self.remedy};
    });
    remedy
        .def_property_readonly(
            "time_s", [](const FoundRemedy& self) { return self.remedy.time_s; }, "of the cycle")
        .def_property_readonly(
            "time_change_s", [](const FoundRemedy& self) { return self.remedy.timeChange_s; },
            "None where the cycle as it is does not end by itself")
        .def_property_readonly(
            "phases", [](const FoundRemedy& self) { return self.remedy.phases; },
            "number of random stocks for which the cycle is fit; 0 where stock_mm is decided")
        .def_property_readonly(
            "requirements",
            [](const FoundRemedy& self) { return requirementList(self.remedy.requirements); },
            "the worst of each kind")
        .def_property_readonly(
            "text",
            [](const FoundRemedy& self) { return RemedyWording().line(self.project, self.remedy); })
        .def_property_readonly(
            "project",
            [](const FoundRemedy& self) {
                return checkedProject(self.remedy.applied(self.project));
            },
            "with the change");
}

} // namespace

void bindRemedies(py::module_& module) {
    bindRemedy(module);
    py::class_<FoundConflict> conflict(module, "RemedyConflict",
                                       "Why none of the values that were tried helps.");
    bindOutputs(conflict, remedyConflictOutputs(), [](const FoundConflict& self) {
        return RemedyConflictOf{self.project, self.conflict};
    });
    py::class_<FoundRemedies> found(module, "Remedies", "Possible remedies.");
    bindOutputs(found, remedyResultOutputs(), &FoundRemedies::result);
    found
        .def_property_readonly("remedies", &listOf, "at most three, the one that costs least first")
        .def_property_readonly("conflict", &conflictIn, "why none helps, where none does")
        .def_property_readonly(
            "text",
            [](const FoundRemedies& self) {
                const RemedyResult& result = self.result;
                return result.conflict
                           ? RemedyWording().conflict(self.project, result.goal, *result.conflict)
                           : std::string();
            },
            "where none helps, why")
        .def(
            "to_dict",
            [](const FoundRemedies& self) {
                return fromJson(remediesJson(self.project, self.result));
            },
            "All that `sparkout-cli remedies --json` states.");
    module.def("remedies", &remediesOf, py::arg("project"),
               "Finds changes of one setting after which everything holds, or has room.");
}

} // namespace sparkout::python
