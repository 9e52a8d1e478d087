// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The operating system's functions for files, with one interface for POSIX (file_system_posix.cpp)
// and Windows (file_system_windows.cpp). Functions that return an int return 0 or an errno value.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sparkout {

/// Owns an open file: a descriptor of POSIX, a handle of Windows.
class Descriptor {
public:
    using Native = std::intptr_t;
    explicit Descriptor(Native native = -1) : m_native(native) {}
    Descriptor(Descriptor&& other) noexcept : m_native(std::exchange(other.m_native, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(m_native, other.m_native);
        return *this;
    }
    ~Descriptor();
    [[nodiscard]] Native get() const { return m_native; }
    explicit operator bool() const { return m_native != -1; }

private:
    Native m_native;
};

/// A folder for looking up names. Windows has no calls for names in an open folder, so its full
/// path is used there.
struct Folder {
    Descriptor open;
    std::filesystem::path path; ///< only on Windows
    explicit operator bool() const { return open || !path.empty(); }
};

enum class FileKind { regular, link, other };

/// The system's data about a file.
struct FileFacts {
    FileKind kind = FileKind::other;
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::uint64_t links = 1;
    std::int64_t size = 0;
    std::int64_t modified_ns = 0;
    std::int64_t changed_ns = 0; ///< the inode's; setting the modification time changes it
    bool writeProtected = false; ///< by its mode or attribute, for any user
    bool ofThisUser = false;
    std::uint32_t mode = 0; ///< the system's mode or attributes; owner and group
    std::uint32_t user = 0;
    std::uint32_t group = 0;
};
[[nodiscard]] bool sameFile(const FileFacts& a, const FileFacts& b);

/// A path as text: the system's bytes on POSIX, UTF-8 on Windows, which has UTF-16.
[[nodiscard]] std::string utf8(const std::filesystem::path& path);
/// Converts back: the core's texts of paths, and the command line's arguments, are UTF-8.
[[nodiscard]] std::filesystem::path pathFromUtf8(std::string_view text);

// --- by path -----------------------------------------------------------------------------------

enum class Links { followed, notFollowed };
[[nodiscard]] int factsAt(const std::filesystem::path& path, Links links, FileFacts& facts);

/// The kind of object at a path.
enum class Standing { nothing, regular, other };
[[nodiscard]] int followLinks(std::filesystem::path& path, Standing& standing);

[[nodiscard]] int openFolder(const std::filesystem::path& path, Folder& folder);
[[nodiscard]] int openToRead(const std::filesystem::path& path, Descriptor& file);
/// Renames a file within a disk, replacing an existing one.
[[nodiscard]] int renamePath(const std::filesystem::path& from, const std::filesystem::path& to);
[[nodiscard]] int linkPath(const std::filesystem::path& from, const std::filesystem::path& to);
/// Whether the user has the right to write; the file's own protection is writeProtected.
[[nodiscard]] bool mayWriteFile(const std::filesystem::path& path);
[[nodiscard]] bool mayAddFiles(const std::filesystem::path& folder);

// --- by name in a folder -----------------------------------------------------------------------

enum class Opening { read, readAndWrite };
/// A link is not followed, and a pipe not waited for.
[[nodiscard]] int openIn(const Folder& folder, const std::string& name, Opening opening,
                         Descriptor& file);
/// Creates a new file. Its mode is less the umask; on Windows it takes the folder's rights.
[[nodiscard]] int createIn(const Folder& folder, const std::string& name, std::uint32_t mode,
                           Descriptor& file);
/// Links are not followed.
[[nodiscard]] int factsIn(const Folder& folder, const std::string& name, FileFacts& facts);
[[nodiscard]] int removeIn(const Folder& folder, const std::string& name);
/// Whether a file can be replaced while it is open. Windows refuses that: files to be replaced are
/// closed as soon as possible, so that simultaneous saves succeed.
[[nodiscard]] bool replacesOpenFiles();
/// Replaces `to` by `from`. Where open files cannot be replaced, `replaced`, if it is `to`, is
/// closed first.
[[nodiscard]] int renameIn(const Folder& folder, const std::string& from, const std::string& to,
                           Descriptor* replaced = nullptr);
/// Gives `from` a name that must be free.
[[nodiscard]] int renameToFree(const Folder& folder, const std::string& from,
                               const std::string& to);
/// Exchanges two files. Windows cannot.
[[nodiscard]] int exchangeIn(const Folder& folder, const std::string& a, const std::string& b);
void forEachNameIn(const Folder& folder, const std::function<void(const std::string&)>& take);
/// Makes names in a folder durable. Windows does so when renaming.
[[nodiscard]] int syncFolder(const Folder& folder);
[[nodiscard]] std::optional<std::uint64_t> freeBytes(const Folder& folder);

// --- of an open file ---------------------------------------------------------------------------

[[nodiscard]] int factsOf(const Descriptor& file, FileFacts& facts);
/// Reads at a position without changing the current one; at the end `got` is 0.
[[nodiscard]] int readAt(const Descriptor& file, std::uint64_t at, char* block, std::size_t size,
                         std::size_t& got);
/// Reads on from the position.
[[nodiscard]] int readOn(const Descriptor& file, char* block, std::size_t size, std::size_t& got);
[[nodiscard]] int writeAll(const Descriptor& file, std::string_view bytes);
/// Copies owner, group and mode of another file. A group that cannot be kept gets no more rights
/// than others. On Windows: the hidden attribute.
[[nodiscard]] int copyOwnerAndMode(const Descriptor& file, const FileFacts& of);
[[nodiscard]] int syncFile(const Descriptor& file);
/// Closes one of two descriptors, since a network file system may report a failed write in close();
/// the other keeps the lock. On Linux an interrupted close has closed. Windows reports the failure
/// when syncing.
[[nodiscard]] int closeKeepingLock(const Descriptor& file);

/// A lock is released when its program ends in any way.
enum class Locking { taken, heldElsewhere, unknown };
[[nodiscard]] Locking lockFile(const Descriptor& file);
/// Locks a folder against other programs that also lock it; passes the lock's handle to the caller.
[[nodiscard]] Locking lockFolder(const std::filesystem::path& path, Descriptor& lock);

// --- of programs -------------------------------------------------------------------------------

[[nodiscard]] std::uint64_t randomNumber();
/// Whether a program of that number runs on this machine; when in doubt it does.
[[nodiscard]] bool isRunning(std::int64_t process);
/// The file of the running program.
[[nodiscard]] std::filesystem::path ownProgram();

} // namespace sparkout
