// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/course/course_options.h"

#include "app/io/cli_io.h"
#include "core/files/file_system.h"

#include <charconv>

namespace sparkout::cli {

namespace {

std::optional<std::uint32_t> seedOf(const std::string& text) {
    std::uint32_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && seed <= 2147483647U ? std::optional(seed) : std::nullopt;
}

/// What the value of an option of a command must be; null: it has none of that name.
const char* valueOfCourse(const std::string& command, const std::string& option) {
    const bool makes = command == "variants", grades = command == "grade";
    return (makes || grades) && option == "--group" ? "a file name"
           : grades && option == "--answers"        ? "a file name"
           : grades && option == "-o"               ? "a file name"
           : makes && option == "-d"                ? "a folder"
           : makes && option == "--seed"            ? "a number from 0 to 2147483647"
                                                    : nullptr;
}

bool readCourseValue(const std::string& option, const std::string& value, CourseOptions& options) {
    if (option == "--seed") {
        options.seed = seedOf(value);
        return options.seed.has_value();
    }
    (option == "--group"     ? options.group
     : option == "--answers" ? options.answers
     : option == "-o"        ? options.output
                             : options.folder) = value;
    return !value.empty();
}

bool* courseSwitch(const std::string& option, CourseOptions& options) {
    const bool makes = options.command == "variants", grades = options.command == "grade";
    return !makes && option == "--json"               ? &options.json
           : grades && option == "--csv"              ? &options.csv
           : grades && option == "--xlsx"             ? &options.xlsx
           : (makes || grades) && option == "--force" ? &options.force
                                                      : nullptr;
}

/// What is wrong with what `grade` is to write; empty: nothing.
std::string outputFault(const CourseOptions& options) {
    if (int(options.json) + int(options.csv) + int(options.xlsx) > 1) {
        return "only one of --json, --csv and --xlsx";
    }
    if (options.xlsx && options.output.empty()) {
        return "--xlsx needs -o OUT.xlsx";
    }
    if (!options.xlsx && !options.output.empty()) {
        return "-o needs --xlsx";
    }
    if (!options.xlsx && options.force) {
        return "--force needs --xlsx";
    }
    const bool isBook = pathFromUtf8(options.output).extension() == ".xlsx";
    return options.xlsx && !isBook ? "-o needs a name that ends with .xlsx: " + options.output
                                   : std::string();
}

int checkCourse(const CourseOptions& options) {
    const std::string& command = options.command;
    const std::size_t wanted = command == "grade" ? 2 : 1;
    if (options.operands.size() > wanted) {
        return usageError("one file or folder too many: " + options.operands[wanted]);
    }
    if (options.operands.size() < wanted) {
        return usageError("course " + command
                          + (command == "check"      ? " needs a file"
                             : command == "variants" ? " needs a lesson"
                                                     : " needs a lesson and a folder of works"));
    }
    if (command == "variants"
        && (options.group.empty() || options.folder.empty() || !options.seed)) {
        return usageError("course variants needs --group, --seed and -d");
    }
    const std::string fault = command == "grade" ? outputFault(options) : std::string();
    return fault.empty() ? done : usageError(fault);
}

} // namespace

int parseCourse(const std::vector<std::string>& arguments, CourseOptions& options) {
    if (arguments.empty()) {
        return usageError("course needs one of check, variants and grade");
    }
    options.command = arguments.front();
    if (options.command != "check" && options.command != "variants" && options.command != "grade") {
        return usageError("unknown command course " + options.command);
    }
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if (const char* needs = valueOfCourse(options.command, argument)) {
            if (++i == arguments.size() || !readCourseValue(argument, arguments[i], options)) {
                return usageError(argument + " needs " + needs);
            }
        } else if (bool* given = courseSwitch(argument, options)) {
            *given = true;
        } else if (argument.empty() || (argument.size() > 1 && argument[0] == '-')) {
            return usageError("unknown option " + argument);
        } else {
            options.operands.push_back(argument);
        }
    }
    return checkCourse(options);
}

} // namespace sparkout::cli
