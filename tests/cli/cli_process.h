// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QStringList>

#include <algorithm>
#include <string>

/// The program as a process.
namespace cli_process {

struct Outcome {
    int status = -1; ///< exit status, −1 for a signal
    std::string out;
    std::string err;

    std::string text() const { return std::to_string(status) + '\n' + out + err; }
};

inline Outcome outcomeOf(QProcess& process) {
    const int patience_ms = 60'000;
    if (!process.waitForFinished(patience_ms)) {
        process.kill();
        process.waitForFinished();
        return {-2, {}, "it hangs"};
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

inline Outcome run(const QStringList& arguments, const QStringList& environment = {}) {
    QProcess process;
    if (!environment.isEmpty()) {
        process.setEnvironment(environment);
    }
    process.start(SPARKOUT_CLI, arguments);
    return outcomeOf(process);
}

inline std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace cli_process
