// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "core/issue.h"
#include "core/project/project.h"

#include <pybind11/pybind11.h>

#include <string>

namespace sparkout::python {

/// A project that has no error: it can be run.
struct ValidProject {
    Project project;
    Issues warnings;
};

/// Reads the text of a project file. Raises ProjectError.
[[nodiscard]] ValidProject readText(const std::string& text);

/// Project, Issue and ProjectError.
void bindProject(pybind11::module_& module);

/// A project that was made of another one; raises ProjectError where it is refused.
[[nodiscard]] ValidProject checkedProject(Project project);

/// Raises OSError with errno and the path, as Python's own open() does.
[[noreturn]] void raiseFileError(const FileError& error);
/// Raises ProjectError with these faults.
[[noreturn]] void raiseFaults(const Issues& issues);
/// The same with a sentence that is of the project as a whole.
[[noreturn]] void raiseRefusal(const std::string& sentence, const Issues& issues = {});

} // namespace sparkout::python
