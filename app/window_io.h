// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/setup/setup.h"

#include <QByteArray>
#include <QString>

#include <cstdio>
#include <optional>

namespace sparkout {

class Document;

/// Exit status of the program; `exitInterrupted` plus the signal, as a shell tells Ctrl+C.
inline constexpr int exitRefused = 1, exitUsage = 2, exitCannotReachSize = 3,
                     exitNothingFeasible = 5, exitUndecided = 6, exitInterrupted = 128;

void say(std::FILE* stream, const QString& text); ///< a line

/// From now on two notices of Qt about where it runs are not printed: that the platform without a
/// display takes no size hints, and that XDG_RUNTIME_DIR is not set. The rest goes where it went,
/// without characters that steer a terminal.
void passOverPlatformNotices();

/// Says what is wrong with a project; returns the exit status of it.
[[nodiscard]] int refuse(const Issues& issues);

/// Writes a file safely; a failure is said.
[[nodiscard]] bool writeBytes(const QByteArray& bytes, const QString& path);

/// Reads a file of one surface or of several; what is wrong with it is said.
[[nodiscard]] std::optional<Setup> openSetupOrSay(const QString& path);

/// Opens a file with a surface of it in front, by name or number from 1, the first unless given;
/// what is wrong with it is said.
[[nodiscard]] bool openOrSay(Document& document, const QString& path, const QString& surface);

/// The project of a surface, with the wheel as the surfaces before have left it; of a file of
/// several one has to be named. What is wrong is said.
[[nodiscard]] std::optional<Project> projectOrSay(const QString& path, const QString& surface);

} // namespace sparkout
