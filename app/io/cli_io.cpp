// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_io.h"

#include "app/io/cli_report.h"
#include "app/io/console.h"
#include "core/files/file_system.h"
#include "core/format/project_file.h"
#include "core/printable.h"
#include "core/project/batch_rules.h"
#include "core/setup/setup_file.h"
#include "core/study/recalled_run.h"
#include "words/issue_words.h"
#include "words/lesson_words.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <variant>

namespace sparkout::cli {

namespace {

CapturedOutput* captured = nullptr;

} // namespace

CapturedOutput::CapturedOutput() {
    captured = this;
}

CapturedOutput::~CapturedOutput() {
    captured = nullptr;
}

void print(std::FILE* stream, const std::string& text) {
    if (stream == stdout && captured) {
        captured->m_text += text;
        return;
    }
    printText(stream, text);
}

bool outputTaken() {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) {
        return true;
    }
    print(stderr, "sparkout-cli: the standard output cannot be written: "
                      + std::string(std::strerror(errno)) + '\n');
    return false;
}

int usageError(const std::string& message) {
    print(stderr, "sparkout-cli: " + printable(message) + "; see sparkout-cli --help\n");
    return usage;
}

std::string describe(const FileError& error) {
    std::string text = printable(error.path) + ": " + fileStepText(error.step);
    if (error.systemError != 0) {
        text += ": " + std::string(std::strerror(error.systemError));
    }
    if (error.freeBytes) {
        text += " (" + std::to_string(*error.freeBytes) + " bytes free)";
    }
    return text + '\n';
}

void printIssues(const std::string& file, const Issues& issues) {
    for (const Issue& issue : issues) {
        print(stderr, issueLine(file, issue) + '\n');
    }
}

void printFaults(const std::string& file, const CellFaults& faults) {
    for (const CellFault& fault : faults) {
        std::string at = printable(file);
        at += fault.line > 0 ? ":" + std::to_string(fault.line) : "";
        at += fault.column > 0 ? ":" + std::to_string(fault.column) : "";
        print(stderr, at + ": " + issueSentence(fault.issue) + '\n');
    }
}

std::vector<std::string> printUntrueRuns(const std::string& file, const Project& project) {
    std::vector<std::string> names;
    for (const KeptRunCheck& check : untrueRuns(project)) {
        print(stderr,
              printable(file + ": kept run \"" + check.name + "\": " + keptRunSentence(check))
                  + '\n');
        names.push_back(check.name);
    }
    return names;
}

std::optional<std::string> readOrSay(const std::string& file, std::size_t most) {
    auto content = readFile(pathFromUtf8(file), most);
    if (const auto* error = std::get_if<FileError>(&content)) {
        print(stderr, describe(*error));
        return std::nullopt;
    }
    return std::get<std::string>(std::move(content));
}

namespace {

bool isOfBatch(const Issue& issue, const Setup& setup) {
    return std::ranges::any_of(setup.surfaces, [&issue](const GroundSurface& surface) {
        return std::ranges::any_of(batchFaults(surface.project), [&issue](const Issue& fault) {
            return fault.code == issue.code && issue.path.ends_with(fault.path);
        });
    });
}

} // namespace

std::optional<Setup> loadSetup(const std::string& file, BatchFaults faults) {
    const auto content = readOrSay(file, limits::fileBytes);
    if (!content) {
        return std::nullopt;
    }
    ReadSetup read = readSetup(*content);
    if (read.setup && faults == BatchFaults::left) {
        std::erase_if(read.issues,
                      [&read](const Issue& issue) { return isOfBatch(issue, *read.setup); });
    } else if (read.setup && faults == BatchFaults::errors) {
        for (Issue& issue : read.issues) {
            issue.severity = isOfBatch(issue, *read.setup) ? Severity::error : issue.severity;
        }
    }
    printIssues(file, read.issues);
    if (read.issues.size() == limits::issues) {
        print(stderr, printable(file) + ": no further faults are listed\n");
    }
    return hasErrors(read.issues) ? std::nullopt : std::move(read.setup);
}

int save(const std::string& file, const std::string& content) {
    if (const auto error = writeFileSafely(pathFromUtf8(file), content)) {
        print(stderr, describe(*error));
        return refused;
    }
    return done;
}

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code ignored;
    return std::filesystem::equivalent(pathFromUtf8(a), pathFromUtf8(b), ignored);
}

bool replacesProject(const std::string& file, const std::string& project) {
    return pathFromUtf8(file).extension() == ".sparkout" || isSameFile(file, project);
}

} // namespace sparkout::cli
