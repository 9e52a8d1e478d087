// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/starting.h"

#include "core/field.h"
#include "core/project/iso286.h"
#include "core/project/operation.h"
#include "core/project/validate.h"
#include "core/study/new_project.h"
#include "python/project_object.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace sparkout::python {

namespace py = pybind11;

namespace {

/// One of the words that an argument may be.
[[noreturn]] void raiseChoice(const char* argument, const std::string& value, const char* allowed) {
    throw py::value_error(std::string(argument) + ": \"" + value + "\"; allowed: " + allowed);
}

Operation operationNamed(const std::string& name) {
    const auto choices = choicesOf<Operation>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (name == choices[i].key) {
            return Operation::ofIndex(i);
        }
    }
    raiseChoice("operation", name, "plunge, traverse");
}

StartingEnds endsNamed(const std::optional<std::string>& shoulder) {
    if (!shoulder) {
        return {};
    }
    const bool both = *shoulder == "both";
    if (!both && *shoulder != "headstock" && *shoulder != "tailstock") {
        raiseChoice("shoulder", *shoulder, "headstock, tailstock, both");
    }
    return {.freeAtHeadstock = !both && *shoulder != "headstock",
            .freeAtTailstock = !both && *shoulder != "tailstock"};
}

ValidProject startingOf(const std::string& size, double length_mm, double stock_mm, bool bore,
                        const std::optional<std::string>& operation,
                        const std::optional<std::string>& shoulder, std::optional<double> ra_um,
                        const std::string& machine, const std::string& wheel,
                        const std::string& material) {
    const auto designation = parseSizeDesignation(size);
    auto drawing = designation ? drawingOf(*designation) : std::nullopt;
    if (!drawing) {
        raiseChoice("size", size,
                    "a nominal size up to 500 mm with its field of ISO 286, as 35k6 or 60H7");
    }
    drawing->name = size + " × " + numberText(length_mm);
    if (bore) {
        drawing->surface = Surface::internal;
    }
    if (operation) {
        drawing->operation = operationNamed(*operation);
    }
    drawing->length_mm = length_mm;
    drawing->stock_mm = stock_mm;
    drawing->ends = endsNamed(shoulder);
    drawing->tolerance.roughness_ra_um = ra_um;
    Issues issues;
    const auto entries = startingEntries({machine, wheel, material}, *drawing, issues);
    if (!entries) {
        raiseFaults(issues);
    }
    StartingAnswer answer = drawnProject(*drawing, *entries);
    if (!answer.start) {
        raiseFaults(answer.issues);
    }
    return {std::move(answer.start->project), std::move(answer.issues)};
}

} // namespace

void bindStarting(py::module_& module) {
    module.def(
        "starting", &startingOf, py::arg("size"), py::kw_only(), py::arg("length_mm"),
        py::arg("stock_mm"), py::arg("bore") = false, py::arg("operation") = py::none(),
        py::arg("shoulder") = py::none(), py::arg("ra_um") = py::none(), py::arg("machine") = "",
        py::arg("wheel") = "", py::arg("material") = "",
        "A project with a starting cycle, a usual batch and a usual search for a surface of a "
        "drawing, as `sparkout-cli new` writes "
        "it: `size` with its field (\"35k6\", for a bore \"60H7\"), ground length and stock per "
        "side in mm. `operation`: plunge or traverse; `shoulder`: headstock, tailstock or both, "
        "where the wheel cannot run over the end; machine, wheel and material are names of the "
        "shipped catalogue, or parts of them.");
}

} // namespace sparkout::python
