// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/safe_file.h"

#include "core/files/save_steps.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio> // RENAME_EXCHANGE
#include <new>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace sparkout {

namespace {

/// Whether the file holds exactly these bytes: 0, EILSEQ if not, or why it cannot be read.
int compareWith(int fd, std::string_view bytes) {
    std::array<char, 65536> block;
    for (std::size_t at = 0;;) {
        const ssize_t n = uninterrupted(
            [&] { return ::pread(fd, block.data(), block.size(), static_cast<off_t>(at)); });
        if (n < 0)
            return errno;
        const auto length = static_cast<std::size_t>(n);
        if (length == 0 && at == bytes.size())
            return 0;
        if (length == 0 || length > bytes.size() - at
            || !std::equal(block.begin(), block.begin() + n, bytes.data() + at))
            return EILSEQ;
        at += length;
    }
}

/// Writes, syncs and reads back; `old` is null for a new file.
StepOutcome fill(int fd, std::string_view bytes, const struct stat* old) {
    if (StepOutcome failed = writeAll(fd, bytes))
        return failed;
    if (old != nullptr)
        if (StepOutcome failed = copyOwnerAndMode(fd, *old))
            return failed;
    if (StepOutcome failed = syncFile(fd))
        return failed;
    if (const int error = compareWith(fd, bytes))
        return StepFailure{FileStep::verify, error};
    return {};
}

/// Copies the old file to NAME.bak by way of a temporary file.
StepOutcome copyToBackup(const SaveTarget& target, const std::string& backup) {
    std::string bytes(static_cast<std::size_t>(target.oldStat.st_size), '\0');
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t n = uninterrupted([&] {
            return ::pread(target.old.get(), bytes.data() + at, bytes.size() - at,
                           static_cast<off_t>(at));
        });
        if (n <= 0)
            return StepFailure{FileStep::backup, n < 0 ? errno : EIO};
        at += static_cast<std::size_t>(n);
    }
    const int folder = target.folder.get();
    Descriptor copy;
    std::string name;
    if (const int error = createTemporary(folder, temporaryPrefix(target.name), 0600, copy, name))
        return StepFailure{FileStep::backup, error};
    TemporaryName temporary(folder, name);
    if (StepOutcome failed = fill(copy.get(), bytes, &target.oldStat))
        return StepFailure{FileStep::backup, failed->systemError};
    if (::renameat(folder, name.c_str(), folder, backup.c_str()) != 0)
        return StepFailure{FileStep::backup, errno};
    temporary.release();
    return {};
}

/// After the rename: reads the new file under its name. Other bytes there are no fault of this save
/// if another one has put its own file in place meanwhile.
StepOutcome confirm(const SaveTarget& target, const Descriptor& written, std::string_view bytes) {
    Descriptor placed;
    if (StepOutcome failed = openPlaced(target, placed))
        return failed;
    const int error = compareWith(placed.get(), bytes);
    if (error != 0 && (error != EILSEQ || sameFile(placed, written)))
        return StepFailure{FileStep::verify, error, true};
    return {};
}

/// Puts the temporary file in place and keeps the old one as NAME.bak: the two are exchanged and
/// the old one renamed, or exchanged back if that fails. Where files cannot be exchanged the old
/// one is copied first.
StepOutcome moveIntoPlaceKeepingOld(const SaveTarget& target, const std::string& temporary) {
    const int folder = target.folder.get();
    const std::string backup = target.name + ".bak";
    struct stat found {};
    if (::fstatat(folder, backup.c_str(), &found, AT_SYMLINK_NOFOLLOW) == 0) {
        if (!S_ISREG(found.st_mode))
            return StepFailure{FileStep::backup, EEXIST};
    } else if (errno != ENOENT) {
        return StepFailure{FileStep::backup, errno};
    }
    const auto exchange = [&] {
        return ::renameat2(folder, temporary.c_str(), folder, target.name.c_str(), RENAME_EXCHANGE);
    };
    if (exchange() == 0) {
        if (::renameat(folder, temporary.c_str(), folder, backup.c_str()) == 0)
            return {};
        const int error = errno;
        return StepFailure{FileStep::backup, error, exchange() != 0};
    }
    if (StepOutcome failed = copyToBackup(target, backup))
        return failed;
    return moveIntoPlace(target, temporary);
}

StepOutcome save(const SaveTarget& target, std::string_view bytes, WriteOptions options) {
    const bool exists = static_cast<bool>(target.old);
    if (exists) // another save shall not take the old file for a leftover while it is exchanged
        (void)::flock(target.old.get(), LOCK_EX | LOCK_NB);

    Descriptor file;
    std::string name;
    if (StepOutcome failed = beginTemporary(target, file, name))
        return failed;
    TemporaryName temporary(target.folder.get(), name);
    if (StepOutcome failed = fill(file.get(), bytes, exists ? &target.oldStat : nullptr))
        return failed;
    if (StepOutcome failed = closeKeepingLock(file))
        return failed;
    const StepOutcome failed = exists && options.keepBackup ? moveIntoPlaceKeepingOld(target, name)
                                                            : moveIntoPlace(target, name);
    if (failed)
        return failed;
    temporary.release();
    return confirm(target, file, bytes);
}

StepOutcome readAll(const std::filesystem::path& path, std::size_t maxBytes, std::string& bytes) {
    // Asked before opening: opening a device may already do something.
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0)
        return StepFailure{FileStep::inspect, errno};
    if (!S_ISREG(found.st_mode))
        return StepFailure{FileStep::notRegular, 0};
    const Descriptor file = openAt(AT_FDCWD, path.string(), O_RDONLY | O_NONBLOCK);
    if (!file)
        return StepFailure{FileStep::open, errno};
    if (::fstat(file.get(), &found) != 0)
        return StepFailure{FileStep::inspect, errno};
    if (!S_ISREG(found.st_mode))
        return StepFailure{FileStep::notRegular, 0};
    if (std::cmp_greater(found.st_size, maxBytes))
        return StepFailure{FileStep::tooLarge, 0};
    bytes.reserve(static_cast<std::size_t>(found.st_size));
    std::array<char, 65536> block;
    for (;;) {
        const ssize_t n =
            uninterrupted([&] { return ::read(file.get(), block.data(), block.size()); });
        if (n < 0)
            return StepFailure{FileStep::read, errno};
        if (n == 0)
            return {};
        bytes.append(block.data(), static_cast<std::size_t>(n));
        if (bytes.size() > maxBytes) // it grew meanwhile, or its size was not known
            return StepFailure{FileStep::tooLarge, 0};
    }
}

} // namespace

std::optional<FileError> writeFileSafely(const std::filesystem::path& path, std::string_view bytes,
                                         WriteOptions options) try {
    SaveTarget target;
    StepOutcome failed = openTarget(path, target);
    if (!failed)
        failed = save(target, bytes, options);
    if (!failed)
        return {};
    return errorOf(*failed, path, target);
} catch (const std::bad_alloc&) {
    return FileError{path.string(), FileStep::create, ENOMEM, {}, false};
}

std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                              std::size_t maxBytes) try {
    std::string bytes;
    if (const StepOutcome failed = readAll(path, maxBytes, bytes))
        return FileError{path.string(), failed->step, failed->systemError, {}, false};
    return bytes;
} catch (const std::bad_alloc&) {
    return FileError{path.string(), FileStep::read, ENOMEM, {}, false};
}

} // namespace sparkout
