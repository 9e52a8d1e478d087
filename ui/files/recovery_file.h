// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The recovery file: one line of JSON about the contents, then the project text. The line has the
/// SHA-256 of the text and of the names of open inputs, so that damage is detected.
namespace sparkout {

/// The data of a document besides its project.
struct RecoveryHeader {
    QString title;
    QString path; ///< path of the user's file; empty: never saved
    QDateTime when;
    QByteArray diskHash; ///< hash of the user's file when last read or written; may be empty
    bool readOnly = false;
    bool modified = true;            ///< false: the edits had been undone again
    std::vector<std::string> open{}; ///< missing inputs, for which the project has substitutes
};

struct RecoveryContent {
    RecoveryHeader header;
    std::optional<Setup> setup; ///< absent: the file is damaged
};

/// The header, and whether the text after it is undamaged.
struct RecoveryGlance {
    RecoveryHeader header;
    bool whole = false;
};

[[nodiscard]] std::string recoveryText(const RecoveryHeader& header, const Setup& setup);

/// The readable part: for a damaged file perhaps the header, perhaps nothing.
[[nodiscard]] RecoveryContent readRecovery(std::string_view text);
/// Much quicker, without reading the project.
[[nodiscard]] RecoveryGlance glanceAtRecovery(std::string_view text);

} // namespace sparkout
