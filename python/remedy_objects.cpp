// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/remedy_objects.h"

#include "core/sparkout.h"
#include "python/interruptible.h"
#include "python/project_object.h"
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

std::optional<std::vector<std::string>> opposedIn(const FoundRemedies& self) {
    if (!self.result.conflict) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (const auto& each : {self.result.conflict->first, self.result.conflict->second}) {
        if (each) {
            names.emplace_back(requirementOf(each->kind).key);
        }
    }
    return names;
}

} // namespace

void bindRemedies(py::module_& module) {
    py::class_<FoundRemedy>(module, "Remedy", "A change of one setting that helps.")
        .def_property_readonly(
            "path", [](const FoundRemedy& self) { return self.remedy.setting.path(self.project); },
            "JSON pointer of the input; of a stage more, the stage")
        .def_property_readonly("before",
                               [](const FoundRemedy& self) { return self.remedy.setting.before; })
        .def_property_readonly("value", [](const FoundRemedy& self) { return self.remedy.value; })
        .def_property_readonly(
            "failing", [](const FoundRemedy& self) { return self.remedy.failing; },
            "the next value towards the present one, which does not do")
        .def_property_readonly(
            "time_s", [](const FoundRemedy& self) { return self.remedy.time_s; }, "of the cycle")
        .def_property_readonly("time_change_s",
                               [](const FoundRemedy& self) { return self.remedy.timeChange_s; })
        .def_property_readonly(
            "text",
            [](const FoundRemedy& self) { return RemedyWording().line(self.project, self.remedy); })
        .def_property_readonly(
            "project",
            [](const FoundRemedy& self) {
                return checkedProject(self.remedy.applied(self.project));
            },
            "with the change");
    py::class_<FoundRemedies>(module, "Remedies", "What would help.")
        .def_property_readonly(
            "goal", [](const FoundRemedies& self) { return goalKey(self.result.goal); },
            "holds, room or none")
        .def_property_readonly("remedies", &listOf, "at most three, the shortest cycle first")
        .def_property_readonly("opposed", &opposedIn,
                               "where none helps, the requirements that pull against each other")
        .def_property_readonly(
            "text",
            [](const FoundRemedies& self) {
                const RemedyResult& result = self.result;
                return result.conflict
                           ? RemedyWording().conflict(self.project, result.goal, *result.conflict)
                           : std::string();
            },
            "where none helps, why");
    module.def("remedies", &remediesOf, py::arg("project"),
               "Finds changes of one setting after which everything holds, or has room.");
}

} // namespace sparkout::python
