// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
#include "ui/files/file_lock.h"

#include <QString>
#include <QStringList>

#include <cstdint>

class QWidget;

/// The questions and messages about files. Each names the file; Escape always means "change
/// nothing", and the button that Enter takes loses no work.
namespace sparkout {

class Document;

void showFailure(QWidget* window, const QString& title, const QString& text);
[[nodiscard]] bool mayReplace(QWidget* window, const QString& path);

enum class UnsavedAnswer { save, discard, cancel };
/// `refused`: what stands in fields that did not take it, a line each; no file will hold it.
[[nodiscard]] UnsavedAnswer askUnsaved(QWidget* window, const Document& document,
                                       const QStringList& refused);
/// The same where there is nothing to save but texts that cannot be saved.
[[nodiscard]] bool mayLoseRefused(QWidget* window, const QStringList& refused);

enum class LockedAnswer { readOnly, copy, takeOver, cancel };
[[nodiscard]] LockedAnswer askLocked(QWidget* window, const QString& path,
                                     const LockHolder& holder);

enum class SaveAnswer { proceed, elsewhere, reload, cancel };
enum class Outside { changed, removed };
/// Whether the version on the disk can be taken in place of the one in the window, which Undo then
/// gives back.
enum class Reloading { offered, notOffered };
/// The file has another content than the window knows, or is gone.
[[nodiscard]] SaveAnswer askChangedOutside(QWidget* window, const QString& path, Outside what,
                                           Reloading reloading);
/// Somebody else has the file open that is about to be written.
[[nodiscard]] SaveAnswer askSaveLocked(QWidget* window, const QString& path,
                                       const LockHolder& holder);
/// The other names of the file will keep the old text.
[[nodiscard]] SaveAnswer askHardLinks(QWidget* window, const QString& path, std::uint64_t links);

enum class FailureAnswer { again, elsewhere, cancel };
[[nodiscard]] FailureAnswer askSaveFailed(QWidget* window, const FileError& error);

/// Who has the file open: user, host, program and since when, as far as known.
[[nodiscard]] QString holderText(const LockHolder& holder);
/// That somebody else has a file open, and who.
[[nodiscard]] QString inUseText(const QString& path, const LockHolder& holder);
/// Says that a file cannot be locked, because something else stands at the lock's name.
[[nodiscard]] QString strangeLockText(const QString& strange);

} // namespace sparkout
