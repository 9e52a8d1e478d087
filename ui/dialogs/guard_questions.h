// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
#include "ui/dialogs/file_questions.h"
#include "ui/session/project_io.h"

#include <QString>

#include <functional>
#include <optional>

class QWidget;

namespace sparkout {

class DiskWait;
class GuardedFile;

/// What the user is asked before a guarded file is opened or written, the same for every kind.
class GuardQuestions {
public:
    enum class Opening { write, readOnly, copy };
    enum class Outcome {
        saved,
        elsewhere, ///< the user wants another place
        reload,    ///< the user takes the version on the disk instead
        cancelled,
        failed, ///< see error()
    };

    GuardQuestions(GuardedFile& file, DiskWait& wait, QWidget* window)
        : m_file(file), m_wait(wait), m_window(window) {}

    /// Claims a file that is about to be opened; nothing: the user gave it up.
    [[nodiscard]] std::optional<Opening> wayToOpen(const QString& path);

    /// Writes once all that may speak against it was asked. The claim of what was not written is
    /// dropped, but for a failure, which can be tried again.
    [[nodiscard]] Outcome save(const QString& path, Reloading reloading,
                               const std::function<std::optional<FileError>()>& write);
    /// The same by the guarded file itself.
    [[nodiscard]] Outcome save(const QString& path, Reloading reloading, const MakeContent& make);
    [[nodiscard]] const std::optional<FileError>& error() const { return m_error; }
    void forgetError() { m_error.reset(); } ///< before a path is asked for

private:
    [[nodiscard]] SaveAnswer clearTheWay(const QString& path, Reloading reloading);

    GuardedFile& m_file;
    DiskWait& m_wait;
    QWidget* m_window;
    QString m_linksAccepted; ///< the file whose other names may keep the old text
    std::optional<FileError> m_error;
};

} // namespace sparkout
