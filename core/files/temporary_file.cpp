// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/temporary_file.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sparkout {
namespace {

/// Removes the name. Tried again on any error: a temporary file must not stay behind.
void removeName(int folder, const std::string& name) {
    for (int attempt = 0; attempt < 3; ++attempt)
        if (::unlinkat(folder, name.c_str(), 0) == 0 || errno == ENOENT)
            return;
}

std::string hex(std::uint64_t value) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
    return text.data();
}

constexpr std::string_view temporarySuffix = ".tmp";

std::string temporaryName(const std::string& prefix) {
    std::uint64_t random = 0;
    if (uninterrupted([&] { return ::getrandom(&random, sizeof random, 0); }) < 0)
        random = static_cast<std::uint64_t>(::getpid());
    return prefix + hex(random) + std::string(temporarySuffix);
}

bool isTemporaryName(std::string_view name, std::string_view prefix) {
    if (name.size() != prefix.size() + 16 + temporarySuffix.size() || !name.starts_with(prefix)
        || !name.ends_with(temporarySuffix))
        return false;
    const std::string_view random = name.substr(prefix.size(), 16);
    return random.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool sameFile(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// Removes one leftover: a regular file of ours that no running save holds locked.
void removeLeftover(int folder, const std::string& name) {
    const Descriptor file = openAt(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    struct stat opened {};
    struct stat named {};
    if (file && ::fstat(file.get(), &opened) == 0 && S_ISREG(opened.st_mode)
        && opened.st_uid == ::geteuid() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0
        && ::fstatat(folder, name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0
        && sameFile(opened, named))
        removeName(folder, name);
}

} // namespace

Descriptor::~Descriptor() {
    if (m_fd >= 0)
        ::close(m_fd);
}

Descriptor openAt(int folder, const std::string& name, int flags, mode_t mode) {
    return Descriptor(uninterrupted(
        [&] { return ::openat(folder, name.c_str(), flags | O_CLOEXEC | O_NOCTTY, mode); }));
}

TemporaryName::~TemporaryName() {
    if (!m_name.empty())
        removeName(m_folder, m_name);
}

std::string temporaryPrefix(const std::string& target) {
    // A hash (FNV-1a) stands for the target's name, since that may be 255 bytes long itself.
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : target)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return ".sparkout-" + hex(hash) + "-";
}

int createTemporary(int folder, const std::string& prefix, mode_t mode, Descriptor& file,
                    std::string& name) {
    for (int attempt = 0; attempt < 16; ++attempt) {
        name = temporaryName(prefix);
        file = openAt(folder, name, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, mode);
        if (!file && errno == EEXIST)
            continue;
        if (!file)
            return errno;
        const bool locked = ::flock(file.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
        struct stat made {};
        const int error = ::fstat(file.get(), &made) == 0 ? 0 : errno;
        if (error == 0 && locked && made.st_nlink > 0)
            return 0;
        removeName(folder, name);
        if (error != 0)
            return error;
        // else another save was cleaning up at this very moment: take another name
    }
    return EEXIST;
}

void removeLeftovers(int folder, const std::string& prefix) {
    // A descriptor of its own: reading moves the position. fdopendir takes it over.
    const int fd = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* const opened = fd >= 0 ? ::fdopendir(fd) : nullptr;
    if (opened == nullptr) {
        if (fd >= 0)
            ::close(fd);
        return;
    }
    const std::unique_ptr<DIR, int (*)(DIR*)> entries(opened, ::closedir);
    while (const dirent* entry = ::readdir(entries.get()))
        if (isTemporaryName(entry->d_name, prefix))
            removeLeftover(folder, entry->d_name);
}

} // namespace sparkout
