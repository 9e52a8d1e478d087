// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_io.h"

#include "app/cli_report.h"
#include "app/console.h"
#include "app/stop_signals.h"
#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/printable.h"
#include "core/project/batch.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "core/study/run_comparison.h"
#include "words/issue_words.h"
#include "words/lesson_words.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <utility>
#include <variant>

namespace sparkout::cli {

Surfaces::Surfaces(const manual::Given& given, BatchFaults faults)
    : m_given(given), m_file(given.operands.front()) {
    const std::string& surface = given.text("--surface");
    auto setup = loadSetup(m_file, faults);
    m_status = setup ? done : refused;
    if (!setup) {
        return;
    }
    m_setup = std::move(*setup);
    m_chosen.resize(m_setup.surfaces.size());
    std::iota(m_chosen.begin(), m_chosen.end(), std::size_t{0});
    m_isWhole = !m_setup.isPlain();
    if (const auto found = m_setup.find(surface)) {
        m_chosen = {*found};
        m_isWhole = false;
        return;
    }
    if (surface.empty() || surface == "all") {
        return;
    }
    std::string names;
    for (std::size_t i = 0; i < m_setup.surfaces.size(); ++i) {
        constexpr std::size_t most = 40; // greatest number of letters shown of a name
        const std::string name = m_setup.surfaces[i].name.substr(0, most);
        names += (i > 0 ? ", " : "") + std::to_string(i + 1) + (name.empty() ? "" : " " + name);
    }
    m_status = usageError(m_file + " has no surface " + surface + "; it has: " + names);
}

bool Surfaces::isWhole() const {
    return m_isWhole;
}

int Surfaces::oneFor(std::initializer_list<const char*> options) const {
    for (const char* option : options) {
        if (isWhole() && m_given.has(option)) {
            return usageError(std::string(option) + " needs one surface: name it with --surface");
        }
    }
    return done;
}

std::string Surfaces::nameOf(std::size_t surface) const {
    const std::string& name = m_setup.surfaces[surface].name;
    return m_setup.isPlain() ? m_file
                             : m_file + ": surface " + std::to_string(surface + 1) + ' ' + name;
}

std::string Surfaces::heading(std::size_t surface) const {
    return (surface > 0 ? "\n" : "") + std::string("surface ") + std::to_string(surface + 1) + "  "
           + printable(m_setup.surfaces[surface].name) + "\n\n";
}

int Surfaces::runOne(const Setup& setup, const Command& command, std::size_t surface) const {
    WornProject worn = wornProject(setup, surface);
    if (!worn.issues.empty()) {
        printIssues(nameOf(worn.surface), worn.issues);
        return refused;
    }
    return command(std::move(worn.project), surface, nameOf(surface));
}

int Surfaces::run(const Command& command) const {
    return run(m_setup, command);
}

int Surfaces::run(const Setup& setup, const Command& command) const {
    const bool json = m_given.has("--json");
    if (!isWhole()) {
        return runOne(setup, command, m_chosen.front());
    }
    int status = done;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::size_t surface : m_chosen) {
        int one = done;
        if (json) {
            const CapturedOutput output;
            one = runOne(setup, command, surface);
            const auto object = nlohmann::ordered_json::parse(output.text(), nullptr, false);
            nlohmann::ordered_json entry = {{"name", m_setup.surfaces[surface].name}};
            entry.update(object.is_object() ? object : nlohmann::ordered_json::object());
            entry["exit_status"] = one;
            all.push_back(std::move(entry));
        } else {
            print(stdout, heading(surface));
            one = runOne(setup, command, surface);
        }
        status = status == done ? one : status;
        if (caughtSignal() != 0) {
            break;
        }
    }
    if (json) {
        print(stdout, printJson({{"surfaces", std::move(all)}}));
    }
    return status;
}

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
