// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/file_system.h"

#include <cerrno>
#include <csignal>
#include <cstdio> // RENAME_EXCHANGE
#include <limits>
#include <memory>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace sparkout {

namespace {

/// Repeats a system call that a signal interrupted.
template <class Call>
auto uninterrupted(Call call) {
    auto result = call();
    while (result < 0 && errno == EINTR)
        result = call();
    return result;
}

int nativeOf(const Descriptor& file) {
    return static_cast<int>(file.get());
}

int failureOf(bool failed) {
    return failed ? errno : 0;
}

int openAt(int folder, const char* name, int flags, mode_t mode, Descriptor& file) {
    file = Descriptor(
        uninterrupted([&] { return ::openat(folder, name, flags | O_CLOEXEC | O_NOCTTY, mode); }));
    return failureOf(!file);
}

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

FileFacts factsFrom(const struct stat& found) {
    FileFacts facts;
    facts.kind = S_ISREG(found.st_mode)   ? FileKind::regular
                 : S_ISLNK(found.st_mode) ? FileKind::link
                                          : FileKind::other;
    facts.device = found.st_dev;
    facts.inode = found.st_ino;
    facts.links = found.st_nlink;
    facts.size = found.st_size;
    facts.modified_ns = nanoseconds(found.st_mtim);
    facts.changed_ns = nanoseconds(found.st_ctim);
    facts.writeProtected = (found.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
    facts.ofThisUser = found.st_uid == ::geteuid();
    facts.mode = found.st_mode & 07777;
    facts.user = found.st_uid;
    facts.group = found.st_gid;
    return facts;
}

bool hasAccess(const std::filesystem::path& path, int rights) {
    return ::faccessat(AT_FDCWD, path.c_str(), rights, AT_EACCESS) == 0;
}

Locking lockNow(int fd) {
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0)
        return Locking::taken;
    return errno == EWOULDBLOCK ? Locking::heldElsewhere : Locking::unknown;
}

} // namespace

Descriptor::~Descriptor() {
    if (*this)
        ::close(nativeOf(*this));
}

std::string utf8(const std::filesystem::path& path) {
    return path.string();
}

std::filesystem::path pathFromUtf8(std::string_view text) {
    return {text};
}

bool sameFile(const FileFacts& a, const FileFacts& b) {
    return a.device == b.device && a.inode == b.inode;
}

int factsAt(const std::filesystem::path& path, Links links, FileFacts& facts) {
    struct stat found {};
    const int failed =
        links == Links::followed ? ::stat(path.c_str(), &found) : ::lstat(path.c_str(), &found);
    if (failed != 0)
        return errno;
    facts = factsFrom(found);
    return 0;
}

int followLinks(std::filesystem::path& path, Standing& standing) {
    for (int links = 0; links < 40; ++links) {
        FileFacts found;
        const int failed = factsAt(path, Links::notFollowed, found);
        standing = Standing::nothing;
        if (failed != 0)
            return failed == ENOENT ? 0 : failed;
        standing = found.kind == FileKind::regular ? Standing::regular : Standing::other;
        if (found.kind != FileKind::link)
            return 0;
        std::error_code error;
        const auto next = std::filesystem::read_symlink(path, error);
        if (error)
            return error.value();
        path = path.parent_path() / next; // an absolute link replaces the whole path
    }
    return ELOOP;
}

int openFolder(const std::filesystem::path& path, Folder& folder) {
    return openAt(AT_FDCWD, path.c_str(), O_RDONLY | O_DIRECTORY, 0, folder.open);
}

int openToRead(const std::filesystem::path& path, Descriptor& file) {
    return openAt(AT_FDCWD, path.c_str(), O_RDONLY | O_NONBLOCK, 0, file);
}

int renamePath(const std::filesystem::path& from, const std::filesystem::path& to) {
    return failureOf(std::rename(from.c_str(), to.c_str()) != 0);
}

int linkPath(const std::filesystem::path& from, const std::filesystem::path& to) {
    return failureOf(::link(from.c_str(), to.c_str()) != 0);
}

bool mayWriteFile(const std::filesystem::path& path) {
    return hasAccess(path, W_OK);
}

bool mayAddFiles(const std::filesystem::path& folder) {
    return hasAccess(folder, W_OK | X_OK);
}

int openIn(const Folder& folder, const std::string& name, Opening opening, Descriptor& file) {
    const int access = opening == Opening::read ? O_RDONLY : O_RDWR;
    return openAt(nativeOf(folder.open), name.c_str(), access | O_NOFOLLOW | O_NONBLOCK, 0, file);
}

int createIn(const Folder& folder, const std::string& name, std::uint32_t mode, Descriptor& file) {
    return openAt(nativeOf(folder.open), name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, mode,
                  file);
}

int factsIn(const Folder& folder, const std::string& name, FileFacts& facts) {
    struct stat found {};
    if (::fstatat(nativeOf(folder.open), name.c_str(), &found, AT_SYMLINK_NOFOLLOW) != 0)
        return errno;
    facts = factsFrom(found);
    return 0;
}

int removeIn(const Folder& folder, const std::string& name) {
    return failureOf(::unlinkat(nativeOf(folder.open), name.c_str(), 0) != 0);
}

bool replacesOpenFiles() {
    return true;
}

int renameIn(const Folder& folder, const std::string& from, const std::string& to,
             Descriptor* /*replaced*/) {
    const int fd = nativeOf(folder.open);
    return failureOf(::renameat(fd, from.c_str(), fd, to.c_str()) != 0);
}

int renameToFree(const Folder& folder, const std::string& from, const std::string& to) {
    const int fd = nativeOf(folder.open);
    if (::renameat2(fd, from.c_str(), fd, to.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS)
        return errno;
    // The file system does not know the flag.
    if (::faccessat(fd, to.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0)
        return EEXIST;
    return renameIn(folder, from, to);
}

int exchangeIn(const Folder& folder, const std::string& a, const std::string& b) {
    const int fd = nativeOf(folder.open);
    return failureOf(::renameat2(fd, a.c_str(), fd, b.c_str(), RENAME_EXCHANGE) != 0);
}

void forEachNameIn(const Folder& folder, const std::function<void(const std::string&)>& take) {
    // A separate descriptor, since reading moves the position; fdopendir takes ownership.
    const int fd = ::openat(nativeOf(folder.open), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* const opened = fd >= 0 ? ::fdopendir(fd) : nullptr;
    if (opened == nullptr) {
        if (fd >= 0)
            ::close(fd);
        return;
    }
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(opened, ::closedir);
    while (const dirent* entry = ::readdir(entries.get()))
        take(entry->d_name);
}

int syncFolder(const Folder& folder) {
    // EINVAL: the file system cannot sync folders.
    const bool failed =
        uninterrupted([&] { return ::fsync(nativeOf(folder.open)); }) != 0 && errno != EINVAL;
    return failureOf(failed);
}

std::optional<std::uint64_t> freeBytes(const Folder& folder) {
    struct statvfs disk {};
    if (!folder || ::fstatvfs(nativeOf(folder.open), &disk) != 0)
        return {};
    return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

int factsOf(const Descriptor& file, FileFacts& facts) {
    struct stat found {};
    if (::fstat(nativeOf(file), &found) != 0)
        return errno;
    facts = factsFrom(found);
    return 0;
}

int readAt(const Descriptor& file, std::uint64_t at, char* block, std::size_t size,
           std::size_t& got) {
    const ssize_t n =
        uninterrupted([&] { return ::pread(nativeOf(file), block, size, static_cast<off_t>(at)); });
    got = n < 0 ? 0 : static_cast<std::size_t>(n);
    return failureOf(n < 0);
}

int readOn(const Descriptor& file, char* block, std::size_t size, std::size_t& got) {
    const ssize_t n = uninterrupted([&] { return ::read(nativeOf(file), block, size); });
    got = n < 0 ? 0 : static_cast<std::size_t>(n);
    return failureOf(n < 0);
}

int writeAll(const Descriptor& file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n =
            uninterrupted([&] { return ::write(nativeOf(file), bytes.data(), bytes.size()); });
        if (n <= 0)
            return n < 0 ? errno : ENOSPC;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

int copyOwnerAndMode(const Descriptor& file, const FileFacts& of) {
    const int fd = nativeOf(file);
    mode_t mode = of.mode;
    struct stat made {};
    if (::fstat(fd, &made) != 0)
        return errno;
    if ((made.st_uid != of.user || made.st_gid != of.group) && ::fchown(fd, of.user, of.group) != 0
        && ::fchown(fd, static_cast<uid_t>(-1), of.group) != 0)
        mode = (mode & ~mode_t{S_IRWXG | S_ISUID | S_ISGID}) | ((mode & S_IRWXO) << 3);
    return failureOf(uninterrupted([&] { return ::fchmod(fd, mode); }) != 0);
}

int syncFile(const Descriptor& file) {
    return failureOf(uninterrupted([&] { return ::fsync(nativeOf(file)); }) != 0);
}

int closeKeepingLock(const Descriptor& file) {
    const int closing = ::fcntl(nativeOf(file), F_DUPFD_CLOEXEC, 0);
    return failureOf(closing < 0 || (::close(closing) != 0 && errno != EINTR));
}

Locking lockFile(const Descriptor& file) {
    return lockNow(nativeOf(file));
}

Locking lockFolder(const std::filesystem::path& path, Descriptor& lock) {
    if (openAt(AT_FDCWD, path.c_str(), O_RDONLY | O_DIRECTORY, 0, lock) != 0)
        return Locking::unknown;
    return lockNow(nativeOf(lock));
}

std::uint64_t randomNumber() {
    std::uint64_t random = 0;
    if (uninterrupted([&] { return ::getrandom(&random, sizeof random, 0); }) < 0)
        random = static_cast<std::uint64_t>(::getpid());
    return random;
}

bool isRunning(std::int64_t process) {
    const bool surelyNot = process > 0 && process <= std::numeric_limits<pid_t>::max()
                           && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
    return !surelyNot;
}

std::filesystem::path ownProgram() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

} // namespace sparkout
