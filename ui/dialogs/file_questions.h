// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
#include "ui/files/file_lock.h"

#include <QString>
#include <QStringList>

#include <cstdint>

class QWidget;

/// The questions and messages about files. Each names the file; Escape always means "change
/// nothing", and the default button loses no work.
namespace sparkout {

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

} // namespace sparkout
