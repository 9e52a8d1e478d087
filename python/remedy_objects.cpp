// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/remedy_objects.h"

#include "core/sparkout.h"
#include "python/interruptible.h"
#include "python/project_object.h"
#include "python/requirement_list.h"
#include "words/remedy_words.h"

#include <pybind11/stl.h>

#include <optional>
#include <stop_token>
#include <string>
#include <utility>
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

std::optional<std::string> nameOf(const std::optional<ConstraintResult>& requirement) {
    return requirement ? std::optional<std::string>(requirementOf(requirement->kind).key)
                       : std::nullopt;
}

void bindRemedy(py::module_& module) {
    py::class_<FoundRemedy>(module, "Remedy", "A change of one setting that helps.")
        .def_property_readonly(
            "path", [](const FoundRemedy& self) { return self.remedy.setting.path(self.project); },
            "JSON pointer of the input; of a stage more, the stage")
        .def_property_readonly(
            "before", [](const FoundRemedy& self) { return self.remedy.before(); },
            "None for a stage more")
        .def_property_readonly("value", [](const FoundRemedy& self) { return self.remedy.value; })
        .def_property_readonly(
            "failing", [](const FoundRemedy& self) { return self.remedy.failing; },
            "the next value towards the present one, which was run and fails")
        .def_property_readonly(
            "holds_beyond", [](const FoundRemedy& self) { return self.remedy.holdsBeyond; },
            "whether the next value farther off that was tried helps, too")
        .def_property_readonly(
            "time_s", [](const FoundRemedy& self) { return self.remedy.time_s; }, "of the cycle")
        .def_property_readonly(
            "time_change_s", [](const FoundRemedy& self) { return self.remedy.timeChange_s; },
            "None where the cycle as it is does not end by itself")
        .def_property_readonly(
            "stock_mm",
            [](const FoundRemedy& self) -> std::optional<std::pair<double, double>> {
                const std::optional<StockRange>& stocks = self.remedy.stocks;
                return stocks ? std::optional(std::pair(stocks->from_mm, stocks->to_mm))
                              : std::nullopt;
            },
            "stocks per side, for each of which it holds; None under position control, where it "
            "holds for stocks drawn at random")
        .def_property_readonly(
            "phases", [](const FoundRemedy& self) { return self.remedy.phases; },
            "number of stocks drawn at random that it holds for; 0 where stock_mm is decided")
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

void bindConflict(py::module_& module) {
    py::class_<FoundConflict>(module, "RemedyConflict",
                              "Why none of the values that were tried helps.")
        .def_property_readonly(
            "kind", [](const FoundConflict& self) { return conflictKey(self.conflict.kind); },
            "stocks, warned, idle, opposed, several or unmended")
        .def_property_readonly(
            "first", [](const FoundConflict& self) { return nameOf(self.conflict.first); },
            "the requirement that fails most; None where the cycle does not end by itself")
        .def_property_readonly(
            "second", [](const FoundConflict& self) { return nameOf(self.conflict.second); },
            "the one that fails with the setting")
        .def_property_readonly(
            "path",
            [](const FoundConflict& self) {
                const std::optional<RemedySetting>& setting = self.conflict.setting;
                return setting ? std::optional(setting->path(self.project)) : std::nullopt;
            },
            "JSON pointer of the setting that comes nearest")
        .def_property_readonly(
            "value",
            [](const FoundConflict& self) {
                return self.conflict.setting ? std::optional(self.conflict.value) : std::nullopt;
            },
            "of that setting")
        .def_property_readonly(
            "stock_mm",
            [](const FoundConflict& self) {
                return self.conflict.kind == RemedyConflict::Kind::stocks
                           ? std::optional(self.conflict.stock_mm)
                           : std::nullopt;
            },
            "stock per side for which the cycle fails with it; None unless the kind is stocks");
}

} // namespace

void bindRemedies(py::module_& module) {
    bindRemedy(module);
    bindConflict(module);
    py::class_<FoundRemedies>(module, "Remedies", "What would help.")
        .def_property_readonly(
            "goal", [](const FoundRemedies& self) { return goalKey(self.result.goal); },
            "holds, room or none")
        .def_property_readonly("remedies", &listOf, "at most three, the shortest cycle first")
        .def_property_readonly("conflict", &conflictIn, "why none helps, where none does")
        .def_property_readonly(
            "settings", [](const FoundRemedies& self) { return self.result.settings; },
            "that there are to try")
        .def_property_readonly("tried", [](const FoundRemedies& self) { return self.result.tried; })
        .def_property_readonly(
            "found", [](const FoundRemedies& self) { return self.result.found; },
            "settings that help")
        .def_property_readonly(
            "runs", [](const FoundRemedies& self) { return self.result.runs; }, "of cycles")
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
