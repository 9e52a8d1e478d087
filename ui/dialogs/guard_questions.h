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

/// The questions before opening or writing a guarded file of any kind.
class GuardQuestions {
public:
    enum class Opening { write, readOnly, copy };
    enum class Outcome {
        saved,
        elsewhere, ///< the user wants another file
        reload,    ///< the user wants the version on the disk
        cancelled,
        failed, ///< see error()
    };

    GuardQuestions(GuardedFile& file, DiskWait& wait, QWidget* window)
        : m_file(file), m_wait(wait), m_window(window) {}

    /// Claims a file to be opened; empty if the user cancels.
    [[nodiscard]] std::optional<Opening> wayToOpen(const QString& path);

    /// Writes after asking about every obstacle. Drops the claim of a file that was not written,
    /// except after a failure, so that it can be retried.
    [[nodiscard]] Outcome save(const QString& path, Reloading reloading,
                               const std::function<std::optional<FileError>()>& write);
    /// Lets the guarded file make the contents.
    [[nodiscard]] Outcome save(const QString& path, Reloading reloading, const MakeContent& make);
    [[nodiscard]] const std::optional<FileError>& error() const { return m_error; }
    void forgetError() { m_error.reset(); } ///< before a path is requested

private:
    [[nodiscard]] SaveAnswer clearTheWay(const QString& path, Reloading reloading);

    GuardedFile& m_file;
    DiskWait& m_wait;
    QWidget* m_window;
    QString m_linksAccepted; ///< the file whose other names may keep the old text
    std::optional<FileError> m_error;
};

} // namespace sparkout
