// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_io.h"

#include "app/cli_report.h"
#include "core/project/project_file.h"
#include "core/project/safe_file.h"

#include <cstring>
#include <filesystem>
#include <variant>

namespace sparkout::cli {

namespace {

std::string describe(const FileError& error) {
    std::string text = error.path + ": " + fileStepText(error.step);
    if (error.systemError != 0) {
        text += ": " + std::string(std::strerror(error.systemError));
    }
    if (error.freeBytes) {
        text += " (" + std::to_string(*error.freeBytes) + " bytes free)";
    }
    return text + '\n';
}

} // namespace

void print(std::FILE* stream, const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stream);
}

int usageError(const std::string& message) {
    print(stderr, "sparkout-cli: " + message + "; see sparkout-cli --help\n");
    return usage;
}

std::optional<Project> load(const std::string& file) {
    const auto content = readFile(file, limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&content)) {
        print(stderr, describe(*error));
        return std::nullopt;
    }
    ReadResult read = readProject(std::get<std::string>(content));
    for (const Issue& issue : read.issues) {
        print(stderr, issueLine(file, issue) + '\n');
    }
    if (read.issues.size() == limits::issues) {
        print(stderr, file + ": no further faults are listed\n");
    }
    return std::move(read.project);
}

int save(const std::string& file, const std::string& content) {
    if (const auto error = writeFileSafely(file, content)) {
        print(stderr, describe(*error));
        return refused;
    }
    return done;
}

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code ignored;
    return std::filesystem::equivalent(a, b, ignored);
}

} // namespace sparkout::cli
