// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
#include "ui/dialogs/guard_questions.h"
#include "ui/tables/sheet.h"

#include <QByteArray>
#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>

class QWidget;

namespace sparkout {

class Settings;

/// What is to be saved, and how the dialog asks for its place.
struct SaveRequest {
    QString title;  ///< of the dialog
    QString name;   ///< proposed, without folder and suffix
    QString suffix; ///< "png"
    QString filter; ///< "Pictures (*.png)"
    /// Called once a place is chosen. What it returns makes the bytes, in a thread of its own; no
    /// bytes: they could not be made.
    std::function<std::function<QByteArray()>()> prepare;
    /// In its place, for what may take long: the bytes are made in a thread of their own, it is
    /// shown how far that is, and it can be stopped.
    std::function<QByteArray(const KeepGoing&)> longWork = {};
    /// In place of both, for more than the memory may hold: it writes the file itself, safely, in a
    /// thread of its own, and says whether it has, or why not. Stopped by what keepGoing says or by
    /// the token, it leaves none.
    std::function<bool(const std::filesystem::path& path, const KeepGoing&, const std::stop_token&,
                       std::optional<FileError>& error)>
        stream = {};
    /// In place of them all, for a kind of file that the window owns: what it shall hold, and who
    /// asks and writes.
    MakeContent content = {};
    GuardQuestions* guard = nullptr;
};

/// Asks for a place, from the last folder on, and writes the bytes there safely. A failure is shown
/// with an offer to choose another place. True once the file is saved: a notice then says where
/// and offers to open it. Without settings the folder is the home folder.
bool saveWithDialog(QWidget* window, Settings* settings, const SaveRequest& request);

/// Words as the name of a file: parts joined, without the characters some system refuses.
[[nodiscard]] QString fileNameOf(const QStringList& parts);

} // namespace sparkout
