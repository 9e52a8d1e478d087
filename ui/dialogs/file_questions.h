// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "core/issue.h"
#include "ui/session/file_lock.h"
#include "ui/session/project_io.h"

#include <QDialog>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <optional>

class QWidget;

/// The questions and messages about files. Each names the file; Escape always means "change
/// nothing", and the default button loses no work.

namespace sparkout {

/// The faults of a refused or opened file: every fault with its place in words, its path in the
/// file and its sentence.
class FaultsDialog : public QDialog {
    Q_OBJECT

public:
    enum class File { refused, opened };

    FaultsDialog(const QString& file, const Issues& issues, QWidget* parent = nullptr,
                 File state = File::refused);

    /// One line for each fault, for the list and the clipboard.
    [[nodiscard]] static QStringList lines(const Issues& issues);
};

/// Whether a disk is being waited for: the window stays responsive meanwhile, and a command that
/// must not run then checks busy().
class DiskWait {
public:
    [[nodiscard]] bool busy() const { return m_busy; }
    void during(const std::function<void()>& work); ///< work that keeps the window alive itself
    void aside(const std::function<void()>& work);  ///< without freezing the window

private:
    bool m_busy = false;
};

class Document;

void showFailure(QWidget* window, const QString& title, const QString& text);
[[nodiscard]] bool mayReplace(QWidget* window, const QString& path);

enum class UnsavedAnswer { save, discard, cancel };
/// `refused`: refused texts in fields, one per line; no file will contain them.
[[nodiscard]] UnsavedAnswer askUnsaved(QWidget* window, const Document& document,
                                       const QStringList& refused);
/// Asks before losing texts that cannot be saved, if nothing else is unsaved.
[[nodiscard]] bool mayLoseRefused(QWidget* window, const QStringList& refused);

enum class LockedAnswer { readOnly, copy, takeOver, cancel };
[[nodiscard]] LockedAnswer askLocked(QWidget* window, const QString& path,
                                     const LockHolder& holder);

enum class SaveAnswer { proceed, elsewhere, reload, cancel };
enum class Outside { changed, removed };
/// Whether the version on the disk can replace the one in the window, which Undo then restores.
enum class Reloading { offered, notOffered };
/// The file differs from the last known contents, or is gone.
[[nodiscard]] SaveAnswer askChangedOutside(QWidget* window, const QString& path, Outside what,
                                           Reloading reloading);
/// Somebody else has opened the file to be written.
[[nodiscard]] SaveAnswer askSaveLocked(QWidget* window, const QString& path,
                                       const LockHolder& holder);
/// The other names of the file will keep the old text.
[[nodiscard]] SaveAnswer askHardLinks(QWidget* window, const QString& path, std::uint64_t links);

enum class FailureAnswer { again, elsewhere, cancel };
[[nodiscard]] FailureAnswer askSaveFailed(QWidget* window, const FileError& error);

/// The holder of a file: user, host, program and time, as far as known.
[[nodiscard]] QString holderText(const LockHolder& holder);
/// A text about who else has a file open.
[[nodiscard]] QString inUseText(const QString& path, const LockHolder& holder);
/// A text about a file that cannot be locked, because another object has the lock's name.
[[nodiscard]] QString strangeLockText(const QString& strange);

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
