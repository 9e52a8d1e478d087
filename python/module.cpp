// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/project_object.h"
#include "python/remedy_objects.h"
#include "python/starting.h"
#include "python/study_objects.h"

#include "core/version.h"

PYBIND11_MODULE(sparkout, module) {
    module.doc() = "Cylindrical grinding cycles, computed pass by pass.";
    module.attr("__version__") = sparkout::version;
    sparkout::python::bindProject(module);
    sparkout::python::bindStudies(module);
    sparkout::python::bindRemedies(module);
    sparkout::python::bindStarting(module);
}
