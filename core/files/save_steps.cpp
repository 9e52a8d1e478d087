// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/save_steps.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace sparkout {

namespace {

/// Follows symbolic links of the last component, also to a file that does not exist yet.
StepOutcome followLinks(std::filesystem::path& path) {
    for (int links = 0; links < 40; ++links) {
        struct stat found {};
        if (::lstat(path.c_str(), &found) != 0)
            return errno == ENOENT ? StepOutcome{} : StepFailure{FileStep::inspect, errno};
        if (S_ISREG(found.st_mode))
            return {};
        if (!S_ISLNK(found.st_mode))
            return StepFailure{FileStep::notRegular, 0};
        std::error_code error;
        const auto next = std::filesystem::read_symlink(path, error);
        if (error)
            return StepFailure{FileStep::inspect, error.value()};
        path = path.parent_path() / next; // an absolute link replaces the whole path
    }
    return StepFailure{FileStep::inspect, ELOOP};
}

bool forbids(int error) {
    return error == EACCES || error == EPERM || error == EROFS || error == ETXTBSY;
}

std::optional<std::uint64_t> freeBytes(const Descriptor& folder) {
    struct statvfs disk {};
    if (!folder || ::fstatvfs(folder.get(), &disk) != 0)
        return {};
    return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

} // namespace

StepOutcome openTarget(std::filesystem::path path, SaveTarget& target) {
    if (path.native().find('\0') != std::string::npos) // the system would cut the name there
        return StepFailure{FileStep::inspect, EINVAL};
    if (StepOutcome failed = followLinks(path))
        return failed;
    target.name = path.filename().string();
    if (target.name.empty())
        return StepFailure{FileStep::notRegular, 0};
    const auto parent = path.has_parent_path() ? path.parent_path().string() : std::string(".");
    target.folder = openAt(AT_FDCWD, parent, O_RDONLY | O_DIRECTORY);
    if (!target.folder)
        return StepFailure{FileStep::open, errno};

    target.old = openAt(target.folder.get(), target.name, O_RDWR | O_NOFOLLOW | O_NONBLOCK);
    if (!target.old && errno == ENOENT)
        return {};
    if (!target.old)
        return StepFailure{forbids(errno) ? FileStep::readOnly : FileStep::open, errno};
    if (::fstat(target.old.get(), &target.oldStat) != 0)
        return StepFailure{FileStep::inspect, errno};
    if (!S_ISREG(target.oldStat.st_mode))
        return StepFailure{FileStep::notRegular, 0};
    // Asked of the mode too: the system lets root write anything.
    if ((target.oldStat.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
        return StepFailure{FileStep::readOnly, EACCES};
    return {};
}

StepOutcome beginTemporary(const SaveTarget& target, Descriptor& file, std::string& name) {
    const int folder = target.folder.get();
    const std::string prefix = temporaryPrefix(target.name);
    removeLeftovers(folder, prefix);
    if (const int error = createTemporary(folder, prefix, target.old ? 0600 : 0666, file, name))
        return StepFailure{FileStep::create, error};
    return {};
}

StepOutcome writeAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = uninterrupted([&] { return ::write(fd, bytes.data(), bytes.size()); });
        if (n <= 0)
            return StepFailure{FileStep::write, n < 0 ? errno : ENOSPC};
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return {};
}

StepOutcome copyOwnerAndMode(int fd, const struct stat& old) {
    mode_t mode = old.st_mode & 07777;
    struct stat made {};
    if (::fstat(fd, &made) != 0)
        return StepFailure{FileStep::permissions, errno};
    if ((made.st_uid != old.st_uid || made.st_gid != old.st_gid)
        && ::fchown(fd, old.st_uid, old.st_gid) != 0
        && ::fchown(fd, static_cast<uid_t>(-1), old.st_gid) != 0)
        mode = (mode & ~mode_t{S_IRWXG | S_ISUID | S_ISGID}) | ((mode & S_IRWXO) << 3);
    if (uninterrupted([&] { return ::fchmod(fd, mode); }) != 0)
        return StepFailure{FileStep::permissions, errno};
    return {};
}

StepOutcome syncFile(int fd) {
    if (uninterrupted([&] { return ::fsync(fd); }) != 0)
        return StepFailure{FileStep::sync, errno};
    return {};
}

StepOutcome closeKeepingLock(Descriptor& file) {
    const int closing = ::fcntl(file.get(), F_DUPFD_CLOEXEC, 0);
    if (closing < 0 || (::close(closing) != 0 && errno != EINTR))
        return StepFailure{FileStep::close, errno};
    return {};
}

StepOutcome moveIntoPlace(const SaveTarget& target, const std::string& temporary) {
    const int folder = target.folder.get();
    if (::renameat(folder, temporary.c_str(), folder, target.name.c_str()) != 0)
        return StepFailure{FileStep::rename, errno};
    return {};
}

StepOutcome openPlaced(const SaveTarget& target, Descriptor& placed) {
    const int folder = target.folder.get();
    // EINVAL: the file system cannot sync folders.
    if (uninterrupted([&] { return ::fsync(folder); }) != 0 && errno != EINVAL)
        return StepFailure{FileStep::sync, errno, true};
    placed = openAt(folder, target.name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    if (!placed)
        return StepFailure{FileStep::verify, errno, true};
    return {};
}

bool sameFile(const Descriptor& a, const Descriptor& b) {
    struct stat first {};
    struct stat second {};
    return ::fstat(a.get(), &first) == 0 && ::fstat(b.get(), &second) == 0
           && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

FileError errorOf(const StepFailure& failure, const std::filesystem::path& path,
                  const SaveTarget& target) {
    return FileError{path.string(), failure.step, failure.systemError, freeBytes(target.folder),
                     failure.replaced};
}

} // namespace sparkout
