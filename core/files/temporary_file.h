// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Descriptors and temporary names, which saving a file is made of.

#include <cerrno>
#include <string>
#include <utility>

#include <sys/types.h>

namespace sparkout {

/// Repeats a system call that a signal interrupted.
template <class Call>
auto uninterrupted(Call call) {
    auto result = call();
    while (result < 0 && errno == EINTR)
        result = call();
    return result;
}

/// Owns a file descriptor.
class Descriptor {
public:
    explicit Descriptor(int fd = -1) : m_fd(fd) {}
    Descriptor(Descriptor&& other) noexcept : m_fd(std::exchange(other.m_fd, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(m_fd, other.m_fd);
        return *this;
    }
    ~Descriptor();
    [[nodiscard]] int get() const { return m_fd; }
    explicit operator bool() const { return m_fd >= 0; }

private:
    int m_fd;
};

[[nodiscard]] Descriptor openAt(int folder, const std::string& name, int flags, mode_t mode = 0);

/// A name that is removed at the end of the scope unless it was renamed away.
class TemporaryName {
public:
    TemporaryName(int folder, std::string name) : m_folder(folder), m_name(std::move(name)) {}
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;
    ~TemporaryName();
    void release() { m_name.clear(); }

private:
    int m_folder;
    std::string m_name;
};

/// How the temporary names of one target begin, so that the next save finds what a killed one left.
[[nodiscard]] std::string temporaryPrefix(const std::string& target);

/// A new, locked file with an unpredictable name; the lock says "in use" to removeLeftovers().
/// On file systems without locks nothing is ever taken for a leftover. Gives 0 or errno.
[[nodiscard]] int createTemporary(int folder, const std::string& prefix, mode_t mode,
                                  Descriptor& file, std::string& name);

/// Removes the regular files of this user with that prefix that no running save holds locked.
void removeLeftovers(int folder, const std::string& prefix);

} // namespace sparkout
