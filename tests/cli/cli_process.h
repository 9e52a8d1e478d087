// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/support/project_samples.h"

#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTest>

#include <sys/types.h>

#include <algorithm>
#include <csignal>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Runs of the real program, and what it printed.
namespace cli {

struct ProcessOutcome {
    int status = -1; ///< exit status, −1 for a signal
    std::string out;
    std::string err;

    std::string text() const { return std::to_string(status) + '\n' + out + err; }
};

/// Of a process that runs: the number of one that has ended is 0, which would be the tests
/// themselves.
inline void endBySignal(const QProcess& process, int signal) {
    const auto number = static_cast<pid_t>(process.processId());
    QVERIFY2(number > 0, "it has ended by itself");
    ::kill(number, signal);
}

inline ProcessOutcome outcomeOf(QProcess& process) {
    const bool isSlow = qEnvironmentVariableIsSet("SPARKOUT_LONG")
                        || qEnvironmentVariableIsSet("SPARKOUT_QUICK"); // the sanitizers
    const int patience_ms = isSlow ? 900'000 : 60'000;
    if (!process.waitForFinished(patience_ms)) {
        process.kill();
        process.waitForFinished();
        return {-2, {}, "it hangs"};
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

inline ProcessOutcome run(const QStringList& arguments, const QStringList& environment = {}) {
    QProcess process;
    if (!environment.isEmpty()) {
        process.setEnvironment(environment);
    }
    process.start(SPARKOUT_CLI, arguments);
    return outcomeOf(process);
}

inline bool has(const std::string& text, const std::string& word) {
    return text.find(word) != std::string::npos;
}

/// What a run that ends with this status states as JSON.
inline nlohmann::json answerTo(const QStringList& arguments, int status = 0) {
    const ProcessOutcome outcome = run(arguments);
    if (outcome.status != status) {
        throw std::runtime_error(outcome.text());
    }
    return nlohmann::json::parse(outcome.out);
}

/// Ctrl+C once a cycle is found, however slow the machine is.
inline ProcessOutcome interruptedWithAnAnswer(QStringList arguments) {
    arguments.prepend("optimize");
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(SPARKOUT_CLI, arguments);
    QByteArray progress;
    while (!progress.contains("best ")) {
        if (!process.waitForReadyRead(60'000)) {
            qWarning("no cycle was found: %s", progress.constData());
            break;
        }
        progress += process.readAllStandardError();
    }
    endBySignal(process, SIGINT);
    return outcomeOf(process);
}

inline QString samplePath(const std::string& name) {
    return QString::fromStdString(
        sparkout::samples::sourcePath("tests/data/projects/" + name + ".sparkout"));
}

inline QString examplePath(const char* name) {
    return QString::fromStdString(
        sparkout::samples::sourcePath(std::string("resources/examples/") + name + ".sparkout"));
}

inline std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Exit status 2, and one line that says what is wrong with the command line.
inline bool isUsageError(const ProcessOutcome& outcome) {
    return outcome.status == 2 && lines(outcome.err) == 1
           && outcome.err.starts_with("sparkout-cli: ") && outcome.out.empty();
}

inline std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

} // namespace cli
