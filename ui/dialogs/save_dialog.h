// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "ui/dialogs/file_questions.h"
#include "ui/table/sheet.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>

class QWidget;

namespace sparkout {

class NoticeBar;

/// Shows where a file was written, and offers to open it or its folder.
class SavedFile {
    Q_DECLARE_TR_FUNCTIONS(SavedFile)

public:
    static constexpr const char* noticeKey = "savedFile";

    /// In the notices of the main window, whatever window saved the file; without one in its status
    /// bar.
    static void show(QWidget* from, const QString& path);

private:
    static void addNotice(NoticeBar& bar, const QString& path);
    static void open(NoticeBar& bar, const QString& path); ///< with the system's program for it
};

class Settings;

/// The contents to save, and the options of the dialog.
struct SaveRequest {
    QString title;  ///< title of the dialog
    QString name;   ///< proposed, without folder and suffix
    QString suffix; ///< "png"
    QString filter; ///< "Pictures (*.png)"
    /// Called after a path is chosen. The returned function makes the bytes on another thread;
    /// empty on failure.
    std::function<std::function<QByteArray()>()> prepare;
    /// Alternative for long work: makes the bytes on another thread with progress and a way to
    /// stop.
    std::function<QByteArray(const KeepGoing&)> longWork = {};
    /// Alternative for files larger than memory: writes the file itself, safely, on another thread,
    /// and returns whether it did, or the reason. When stopped by keepGoing or the token, it leaves
    /// no file.
    std::function<bool(const std::filesystem::path& path, const KeepGoing&, const std::stop_token&,
                       std::optional<FileError>& error)>
        stream = {};
    /// Alternative for a file that the window owns: its contents, and who asks and writes.
    MakeContent content = {};
    GuardQuestions* guard = nullptr;
};

/// Asks for a path, starting in the last folder, and writes the bytes there safely. A failure is
/// shown with an offer to choose another path. True once the file is saved: a notice then names it
/// and offers to open it. Without settings the folder is the home folder.
bool saveWithDialog(QWidget* window, Settings* settings, const SaveRequest& request);

/// A file name from parts, without the characters that some system refuses.
[[nodiscard]] QString fileNameOf(const QStringList& parts);

} // namespace sparkout
