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

/// Exit status of the program; `exitInterrupted` plus the signal, as shells report Ctrl+C.
inline constexpr int exitRefused = 1, exitUsage = 2, exitCannotReachSize = 3,
                     exitNothingFeasible = 5, exitUndecided = 6, exitInterrupted = 128;

void say(std::FILE* stream, const QString& text); ///< prints a line

/// Suppresses two notices of Qt about its environment from now on: that the platform without a
/// display takes no size hints, and that XDG_RUNTIME_DIR is not set. Other messages are printed as
/// before, without control characters.
void passOverPlatformNotices();

/// Reports the faults of a project; returns their exit status.
[[nodiscard]] int refuse(const Issues& issues);

/// Writes a file safely; reports a failure.
[[nodiscard]] bool writeBytes(const QByteArray& bytes, const QString& path);

/// Reads a file of one surface or of several; reports faults.
[[nodiscard]] std::optional<Setup> openSetupOrSay(const QString& path);

/// Opens a file with the given surface as the current one, by name or number from 1, the first by
/// default; reports faults.
[[nodiscard]] bool openOrSay(Document& document, const QString& path, const QString& surface);

/// The project of a surface, with the wheel as the earlier surfaces leave it; a file of several
/// needs a name. Reports faults.
[[nodiscard]] std::optional<Project> projectOrSay(const QString& path, const QString& surface);

} // namespace sparkout
