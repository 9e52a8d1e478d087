// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/project_object.h"

#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/project/validate.h"
#include "python/output_attributes.h"
#include "words/issue_words.h"

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cerrno>
#include <filesystem>
#include <map>
#include <utility>
#include <variant>

namespace sparkout::python {

namespace py = pybind11;

namespace {

/// Of the module, which is never unloaded.
PyObject* projectError = nullptr;

std::string lineOf(const Issue& issue) {
    return (issue.path.empty() ? std::string() : issue.path + ": ") + issueSentence(issue);
}

ValidProject readPath(const std::filesystem::path& path) {
    const auto read = readFile(path, limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        raiseFileError(*error);
    }
    return readText(std::get<std::string>(read));
}

void writePath(const ValidProject& self, const std::filesystem::path& path) {
    if (const auto error = writeFileSafely(path, writeProject(self.project))) {
        raiseFileError(*error);
    }
}

/// Numbers and arrays of NumPy as Python's own.
py::object plainOf(const py::object& value) {
    if (!py::hasattr(value, "tolist")) {
        throw py::type_error(std::string("a project cannot hold a ")
                             + py::str(py::type::of(value)).cast<std::string>());
    }
    return value.attr("tolist")();
}

nlohmann::ordered_json fromPython(const py::object& value) {
    using namespace py::literals;
    const py::object dumps = py::module_::import("json").attr("dumps");
    const py::object text =
        dumps(value, "allow_nan"_a = false, "default"_a = py::cpp_function(&plainOf));
    return nlohmann::ordered_json::parse(text.cast<std::string>());
}

nlohmann::ordered_json::json_pointer pointerTo(const std::string& path) {
    try {
        return nlohmann::ordered_json::json_pointer(path);
    } catch (const nlohmann::json::exception&) {
        throw py::key_error(path);
    }
}

py::object valueAt(const ValidProject& self, const std::string& path) {
    const auto json = nlohmann::ordered_json::parse(writeProject(self.project));
    const auto pointer = pointerTo(path);
    if (!json.contains(pointer)) {
        throw py::key_error(path);
    }
    return fromJson(json.at(pointer).dump());
}

/// Puts a value where there is one, beside another key or at the end of a list.
void put(nlohmann::ordered_json& json, const std::string& path, nlohmann::ordered_json value) {
    const auto pointer = pointerTo(path);
    const bool isThere = json.contains(pointer);
    const bool hasParent = !pointer.empty() && json.contains(pointer.parent_pointer());
    if (!isThere) {
        if (!hasParent) {
            throw py::key_error(path);
        }
        nlohmann::ordered_json& parent = json.at(pointer.parent_pointer());
        const bool atEnd = parent.is_array() && pointer.back() == std::to_string(parent.size());
        if (!parent.is_object() && !atEnd) {
            throw py::key_error(path);
        }
    }
    json[pointer] = std::move(value);
}

ValidProject withValues(const ValidProject& self, const std::map<std::string, py::object>& values) {
    auto json = nlohmann::ordered_json::parse(writeProject(self.project));
    for (const auto& [path, value] : values) {
        put(json, path, fromPython(value));
    }
    return readText(json.dump());
}

} // namespace

void raiseFileError(const FileError& error) {
    if (error.systemError != 0) {
        errno = error.systemError;
        PyErr_SetFromErrnoWithFilename(PyExc_OSError, error.path.c_str());
    } else {
        PyErr_SetString(PyExc_OSError, (error.path + ": " + fileStepText(error.step)).c_str());
    }
    throw py::error_already_set();
}

void raiseRefusal(const std::string& sentence, const Issues& issues) {
    const auto type = py::reinterpret_borrow<py::object>(projectError);
    py::object error = type(sentence);
    error.attr("issues") = py::cast(issues);
    PyErr_SetObject(projectError, error.ptr());
    throw py::error_already_set();
}

void raiseFaults(const Issues& issues) {
    std::string text;
    for (const Issue& issue : issues) {
        text += (text.empty() ? "" : "\n") + lineOf(issue);
    }
    raiseRefusal(text, issues);
}

ValidProject checkedProject(Project project) {
    Issues issues = validate(project);
    if (hasErrors(issues)) {
        raiseFaults(issues);
    }
    return {std::move(project), std::move(issues)};
}

ValidProject readText(const std::string& text) {
    ReadResult read = readProject(text);
    if (!read.project) {
        raiseFaults(read.issues);
    }
    return {std::move(*read.project), std::move(read.issues)};
}

void bindProject(py::module_& module) {
    projectError = PyErr_NewExceptionWithDoc(
        "sparkout.ProjectError",
        "A project is refused. `issues` has the faults: code, path, value, limit, text.",
        PyExc_ValueError, nullptr);
    module.add_object("ProjectError", py::reinterpret_borrow<py::object>(projectError));

    py::class_<Issue>(module, "Issue", "A fault of an input, or a warning.")
        .def_readonly("path", &Issue::path, "JSON pointer of the input, \"/wheel/width_mm\"")
        .def_property_readonly(
            "code", [](const Issue& self) { return wordsOf(self.code).key; },
            "what kind of fault it is, \"out_of_range\"")
        .def_property_readonly(
            "value", [](const Issue& self) { return Wording().detail(self.value); },
            "what stands there")
        .def_property_readonly(
            "limit", [](const Issue& self) { return Wording().detail(self.limit); },
            "what is allowed there")
        .def_property_readonly("is_error",
                               [](const Issue& self) { return self.severity == Severity::error; })
        .def_property_readonly("text", &issueSentence, "value and limit in a sentence")
        .def("__repr__", [](const Issue& self) { return "<sparkout.Issue " + lineOf(self) + '>'; });

    py::class_<ValidProject>(module, "Project",
                             "The inputs of a cycle, checked: one that is refused cannot be made.")
        .def(py::init(&readText), py::arg("text"), "From the text of a project file.")
        .def_static("read", &readPath, py::arg("path"), "From a project file.")
        .def("write", &writePath, py::arg("path"),
             "Writes a project file: whatever fails, the path holds the old or the new bytes.")
        .def("to_text", [](const ValidProject& self) { return writeProject(self.project); })
        .def(
            "to_dict",
            [](const ValidProject& self) { return fromJson(writeProject(self.project)); },
            "As the project file has it.")
        .def("__getitem__", &valueAt, py::arg("path"),
             "The value at a JSON pointer: project[\"/wheel/dullness\"].")
        .def("with_values", &withValues, py::arg("values"),
             "Another project with these values, by JSON pointer.")
        .def_readonly("warnings", &ValidProject::warnings)
        .def(
            "__eq__",
            [](const ValidProject& self, const ValidProject& other) {
                return sameProject(self.project, other.project);
            },
            py::is_operator())
        .attr("__hash__") = py::none();
}

} // namespace sparkout::python
