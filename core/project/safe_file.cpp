// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/safe_file.h"

#include "core/project/safe_file_writer.h"
#include "core/project/temporary_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio> // RENAME_EXCHANGE
#include <new>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace sparkout {
namespace {

/// What a step hands back: nothing when it went well.
struct Failure {
    FileStep step;
    int systemError;
    bool replaced = false; ///< see FileError::replaced
};
using Outcome = std::optional<Failure>;

Outcome writeAll(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = uninterrupted([&] { return ::write(fd, bytes.data(), bytes.size()); });
        if (n <= 0)
            return Failure{FileStep::write, n < 0 ? errno : ENOSPC};
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return {};
}

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

/// The file a save replaces: its folder, its name there and, if it exists, the opened old file.
struct Target {
    Descriptor folder;
    std::string name;
    Descriptor old;
    struct stat oldStat {};
};

/// Follows symbolic links of the last component, also to a file that does not exist yet.
Outcome followLinks(std::filesystem::path& path) {
    for (int links = 0; links < 40; ++links) {
        struct stat found {};
        if (::lstat(path.c_str(), &found) != 0)
            return errno == ENOENT ? Outcome{} : Failure{FileStep::inspect, errno};
        if (S_ISREG(found.st_mode))
            return {};
        if (!S_ISLNK(found.st_mode))
            return Failure{FileStep::notRegular, 0};
        std::error_code error;
        const auto next = std::filesystem::read_symlink(path, error);
        if (error)
            return Failure{FileStep::inspect, error.value()};
        path = path.parent_path() / next; // an absolute link replaces the whole path
    }
    return Failure{FileStep::inspect, ELOOP};
}

bool forbids(int error) {
    return error == EACCES || error == EPERM || error == EROFS || error == ETXTBSY;
}

Outcome openTarget(std::filesystem::path path, Target& target) {
    if (path.native().find('\0') != std::string::npos) // the system would cut the name there
        return Failure{FileStep::inspect, EINVAL};
    if (Outcome failed = followLinks(path))
        return failed;
    target.name = path.filename().string();
    if (target.name.empty())
        return Failure{FileStep::notRegular, 0};
    const auto parent = path.has_parent_path() ? path.parent_path().string() : std::string(".");
    target.folder = openAt(AT_FDCWD, parent, O_RDONLY | O_DIRECTORY);
    if (!target.folder)
        return Failure{FileStep::open, errno};

    target.old = openAt(target.folder.get(), target.name, O_RDWR | O_NOFOLLOW | O_NONBLOCK);
    if (!target.old && errno == ENOENT)
        return {};
    if (!target.old)
        return Failure{forbids(errno) ? FileStep::readOnly : FileStep::open, errno};
    if (::fstat(target.old.get(), &target.oldStat) != 0)
        return Failure{FileStep::inspect, errno};
    if (!S_ISREG(target.oldStat.st_mode))
        return Failure{FileStep::notRegular, 0};
    // Asked of the mode too: the system lets root write anything.
    if ((target.oldStat.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
        return Failure{FileStep::readOnly, EACCES};
    return {};
}

/// Gives the temporary file owner, group and mode of the old one. A group that cannot be kept
/// gets no more rights than everybody.
Outcome copyOwnerAndMode(int fd, const struct stat& old) {
    mode_t mode = old.st_mode & 07777;
    struct stat made {};
    if (::fstat(fd, &made) != 0)
        return Failure{FileStep::permissions, errno};
    if ((made.st_uid != old.st_uid || made.st_gid != old.st_gid)
        && ::fchown(fd, old.st_uid, old.st_gid) != 0
        && ::fchown(fd, static_cast<uid_t>(-1), old.st_gid) != 0)
        mode = (mode & ~mode_t{S_IRWXG | S_ISUID | S_ISGID}) | ((mode & S_IRWXO) << 3);
    if (uninterrupted([&] { return ::fchmod(fd, mode); }) != 0)
        return Failure{FileStep::permissions, errno};
    return {};
}

/// Writes, syncs and reads back; `old` is null for a new file.
Outcome fill(int fd, std::string_view bytes, const struct stat* old) {
    if (Outcome failed = writeAll(fd, bytes))
        return failed;
    if (old != nullptr)
        if (Outcome failed = copyOwnerAndMode(fd, *old))
            return failed;
    if (uninterrupted([&] { return ::fsync(fd); }) != 0)
        return Failure{FileStep::sync, errno};
    if (const int error = compareWith(fd, bytes))
        return Failure{FileStep::verify, error};
    return {};
}

/// Copies the old file to NAME.bak by way of a temporary file.
Outcome copyToBackup(const Target& target, const std::string& prefix, const std::string& backup) {
    std::string bytes(static_cast<std::size_t>(target.oldStat.st_size), '\0');
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t n = uninterrupted([&] {
            return ::pread(target.old.get(), bytes.data() + at, bytes.size() - at,
                           static_cast<off_t>(at));
        });
        if (n <= 0)
            return Failure{FileStep::backup, n < 0 ? errno : EIO};
        at += static_cast<std::size_t>(n);
    }
    const int folder = target.folder.get();
    Descriptor copy;
    std::string name;
    if (const int error = createTemporary(folder, prefix, 0600, copy, name))
        return Failure{FileStep::backup, error};
    TemporaryName temporary(folder, name);
    if (Outcome failed = fill(copy.get(), bytes, &target.oldStat))
        return Failure{FileStep::backup, failed->systemError};
    if (::renameat(folder, name.c_str(), folder, backup.c_str()) != 0)
        return Failure{FileStep::backup, errno};
    temporary.release();
    return {};
}

/// Closes one descriptor of two, since close() may be where a network file system reports that
/// a write failed; the other keeps the lock. On Linux an interrupted close has closed.
Outcome closeKeepingLock(Descriptor& file) {
    const int closing = ::fcntl(file.get(), F_DUPFD_CLOEXEC, 0);
    if (closing < 0 || (::close(closing) != 0 && errno != EINTR))
        return Failure{FileStep::close, errno};
    return {};
}

bool sameFile(int a, int b) {
    struct stat first {};
    struct stat second {};
    return ::fstat(a, &first) == 0 && ::fstat(b, &second) == 0 && first.st_dev == second.st_dev
           && first.st_ino == second.st_ino;
}

/// After the rename: makes it durable and reads the new file under its name. Other bytes there
/// are no fault of this save if another one has put its own file in place meanwhile.
Outcome confirm(const Target& target, const Descriptor& written, std::string_view bytes) {
    const int folder = target.folder.get();
    // EINVAL: the file system cannot sync folders.
    if (uninterrupted([&] { return ::fsync(folder); }) != 0 && errno != EINVAL)
        return Failure{FileStep::sync, errno, true};
    const Descriptor file = openAt(folder, target.name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    if (!file)
        return Failure{FileStep::verify, errno, true};
    const int error = compareWith(file.get(), bytes);
    if (error != 0 && (error != EILSEQ || sameFile(file.get(), written.get())))
        return Failure{FileStep::verify, error, true};
    return {};
}

Outcome moveIntoPlace(const Target& target, const std::string& temporary) {
    const int folder = target.folder.get();
    if (::renameat(folder, temporary.c_str(), folder, target.name.c_str()) != 0)
        return Failure{FileStep::rename, errno};
    return {};
}

/// Puts the temporary file in place and keeps the old one as NAME.bak: the two are exchanged and
/// the old one renamed, or exchanged back if that fails. Where files cannot be exchanged the old
/// one is copied first.
Outcome moveIntoPlaceKeepingOld(const Target& target, const std::string& prefix,
                                const std::string& temporary) {
    const int folder = target.folder.get();
    const std::string backup = target.name + ".bak";
    struct stat found {};
    if (::fstatat(folder, backup.c_str(), &found, AT_SYMLINK_NOFOLLOW) == 0) {
        if (!S_ISREG(found.st_mode))
            return Failure{FileStep::backup, EEXIST};
    } else if (errno != ENOENT) {
        return Failure{FileStep::backup, errno};
    }
    const auto exchange = [&] {
        return ::renameat2(folder, temporary.c_str(), folder, target.name.c_str(), RENAME_EXCHANGE);
    };
    if (exchange() == 0) {
        if (::renameat(folder, temporary.c_str(), folder, backup.c_str()) == 0)
            return {};
        const int error = errno;
        return Failure{FileStep::backup, error, exchange() != 0};
    }
    if (Outcome failed = copyToBackup(target, prefix, backup))
        return failed;
    return moveIntoPlace(target, temporary);
}

Outcome save(const Target& target, std::string_view bytes, WriteOptions options) {
    const int folder = target.folder.get();
    const std::string prefix = temporaryPrefix(target.name);
    removeLeftovers(folder, prefix);
    const bool exists = static_cast<bool>(target.old);
    if (exists) // another save shall not take the old file for a leftover while it is exchanged
        (void)::flock(target.old.get(), LOCK_EX | LOCK_NB);

    Descriptor file;
    std::string name;
    // A new file gets its mode from the umask, a replaced one stays private until it is whole.
    if (const int error = createTemporary(folder, prefix, exists ? 0600 : 0666, file, name))
        return Failure{FileStep::create, error};
    TemporaryName temporary(folder, name);
    if (Outcome failed = fill(file.get(), bytes, exists ? &target.oldStat : nullptr))
        return failed;
    if (Outcome failed = closeKeepingLock(file))
        return failed;
    const Outcome failed = exists && options.keepBackup
                               ? moveIntoPlaceKeepingOld(target, prefix, name)
                               : moveIntoPlace(target, name);
    if (failed)
        return failed;
    temporary.release();
    return confirm(target, file, bytes);
}

std::optional<std::uint64_t> freeBytes(const Descriptor& folder) {
    struct statvfs disk {};
    if (!folder || ::fstatvfs(folder.get(), &disk) != 0)
        return {};
    return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

Outcome readAll(const std::filesystem::path& path, std::size_t maxBytes, std::string& bytes) {
    // Asked before opening: opening a device may already do something.
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0)
        return Failure{FileStep::inspect, errno};
    if (!S_ISREG(found.st_mode))
        return Failure{FileStep::notRegular, 0};
    const Descriptor file = openAt(AT_FDCWD, path.string(), O_RDONLY | O_NONBLOCK);
    if (!file)
        return Failure{FileStep::open, errno};
    if (::fstat(file.get(), &found) != 0)
        return Failure{FileStep::inspect, errno};
    if (!S_ISREG(found.st_mode))
        return Failure{FileStep::notRegular, 0};
    if (std::cmp_greater(found.st_size, maxBytes))
        return Failure{FileStep::tooLarge, 0};
    bytes.reserve(static_cast<std::size_t>(found.st_size));
    std::array<char, 65536> block;
    for (;;) {
        const ssize_t n =
            uninterrupted([&] { return ::read(file.get(), block.data(), block.size()); });
        if (n < 0)
            return Failure{FileStep::read, errno};
        if (n == 0)
            return {};
        bytes.append(block.data(), static_cast<std::size_t>(n));
        if (bytes.size() > maxBytes) // it grew meanwhile, or its size was not known
            return Failure{FileStep::tooLarge, 0};
    }
}

} // namespace

std::optional<FileError> writeFileSafely(const std::filesystem::path& path, std::string_view bytes,
                                         WriteOptions options) try {
    Target target;
    Outcome failed = openTarget(path, target);
    if (!failed)
        failed = save(target, bytes, options);
    if (!failed)
        return {};
    return FileError{path.string(), failed->step, failed->systemError, freeBytes(target.folder),
                     failed->replaced};
} catch (const std::bad_alloc&) {
    return FileError{path.string(), FileStep::create, ENOMEM, {}, false};
}

std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                              std::size_t maxBytes) try {
    std::string bytes;
    if (const Outcome failed = readAll(path, maxBytes, bytes))
        return FileError{path.string(), failed->step, failed->systemError, {}, false};
    return bytes;
} catch (const std::bad_alloc&) {
    return FileError{path.string(), FileStep::read, ENOMEM, {}, false};
}

namespace {

constexpr std::size_t blockBytes = 1 << 16;
constexpr std::uint64_t firstSum = 0xcbf29ce484222325U; // FNV-1a

std::uint64_t sumOf(std::string_view bytes, std::uint64_t sum) {
    for (const char c : bytes)
        sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return sum;
}

/// Whether the file holds so many bytes of that sum: 0, EILSEQ if not, or why it cannot be read.
int compareSum(int fd, std::uint64_t length, std::uint64_t wanted) {
    std::string block(blockBytes, '\0');
    std::uint64_t at = 0, sum = firstSum;
    for (;;) {
        const ssize_t n = uninterrupted(
            [&] { return ::pread(fd, block.data(), block.size(), static_cast<off_t>(at)); });
        if (n < 0)
            return errno;
        if (n == 0)
            return at == length && sum == wanted ? 0 : EILSEQ;
        at += static_cast<std::uint64_t>(n);
        sum = sumOf(std::string_view(block).substr(0, static_cast<std::size_t>(n)), sum);
    }
}

} // namespace

struct SafeFileWriter::State {
    std::string path;
    Existing existing;
    Target target;
    Descriptor file;
    std::string name; ///< of the temporary file
    std::optional<TemporaryName> temporary;
    std::string block; ///< not written yet
    std::uint64_t length = 0, sum = firstSum;
    std::optional<FileError> error;

    bool fail(const Outcome& failed) {
        if (failed && !error)
            error = FileError{path, failed->step, failed->systemError, freeBytes(target.folder),
                              failed->replaced};
        return !error;
    }

    Outcome open() {
        if (Outcome failed = openTarget(path, target))
            return failed;
        if (target.old && existing == Existing::refused)
            return Failure{FileStep::create, EEXIST};
        const int folder = target.folder.get();
        const std::string prefix = temporaryPrefix(target.name);
        removeLeftovers(folder, prefix);
        if (const int code = createTemporary(folder, prefix, target.old ? 0600 : 0666, file, name))
            return Failure{FileStep::create, code};
        temporary.emplace(folder, name);
        return {};
    }

    Outcome flush() {
        Outcome failed = writeAll(file.get(), block);
        length += block.size();
        sum = sumOf(block, sum);
        block.clear();
        return failed;
    }

    Outcome moveIn() {
        const int folder = target.folder.get();
        const unsigned int flags = existing == Existing::refused ? RENAME_NOREPLACE : 0;
        if (::renameat2(folder, name.c_str(), folder, target.name.c_str(), flags) == 0)
            return {};
        if (errno != EINVAL && errno != ENOSYS)
            return Failure{FileStep::rename, errno};
        // The file system does not know the flag.
        if (existing == Existing::refused
            && ::faccessat(folder, target.name.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0)
            return Failure{FileStep::rename, EEXIST};
        return moveIntoPlace(target, name);
    }

    Outcome confirmPlace() {
        const int folder = target.folder.get();
        if (uninterrupted([&] { return ::fsync(folder); }) != 0 && errno != EINVAL)
            return Failure{FileStep::sync, errno, true};
        const Descriptor placed = openAt(folder, target.name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
        if (!placed)
            return Failure{FileStep::verify, errno, true};
        // Read back before the rename; here it is enough that it is this file.
        return sameFile(placed.get(), file.get()) ? Outcome{}
                                                  : Failure{FileStep::verify, EILSEQ, true};
    }

    Outcome finish() {
        if (Outcome failed = flush())
            return failed;
        if (target.old)
            if (Outcome failed = copyOwnerAndMode(file.get(), target.oldStat))
                return failed;
        if (uninterrupted([&] { return ::fsync(file.get()); }) != 0)
            return Failure{FileStep::sync, errno};
        if (const int code = compareSum(file.get(), length, sum))
            return Failure{FileStep::verify, code};
        if (Outcome failed = closeKeepingLock(file))
            return failed;
        if (Outcome failed = moveIn())
            return failed;
        temporary->release();
        return confirmPlace();
    }
};

SafeFileWriter::SafeFileWriter(const std::filesystem::path& path, Existing existing)
    : m_state(std::make_unique<State>()) {
    m_state->path = path.string();
    m_state->existing = existing;
    m_state->fail(m_state->open());
}

SafeFileWriter::~SafeFileWriter() = default;

bool SafeFileWriter::write(std::string_view bytes) {
    if (m_state->error)
        return false;
    m_state->block += bytes;
    return m_state->block.size() < blockBytes || m_state->fail(m_state->flush());
}

bool SafeFileWriter::finish() {
    return !m_state->error && m_state->fail(m_state->finish());
}

const std::optional<FileError>& SafeFileWriter::error() const {
    return m_state->error;
}

} // namespace sparkout
