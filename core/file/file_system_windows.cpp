// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/file_system.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

// The other Windows headers require it first.
#include <windows.h>

namespace sparkout {

namespace {

constexpr DWORD shareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
/// Opens a link itself, and folders, too.
constexpr DWORD asItStands = FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT;

HANDLE nativeOf(const Descriptor& file) {
    return reinterpret_cast<HANDLE>(file.get());
}

int errnoOf(DWORD error) {
    switch (error) {
    case ERROR_SUCCESS: return 0;
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_NET_NAME: return ENOENT;
    case ERROR_TOO_MANY_OPEN_FILES: return EMFILE;
    case ERROR_ACCESS_DENIED:
    case ERROR_PRIVILEGE_NOT_HELD: return EACCES;
    case ERROR_WRITE_PROTECT: return EROFS;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_USER_MAPPED_FILE: return EBUSY;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL: return ENOSPC;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY: return ENOMEM;
    case ERROR_INVALID_NAME:
    case ERROR_BAD_PATHNAME:
    case ERROR_INVALID_PARAMETER: return EINVAL;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    case ERROR_DIRECTORY: return ENOTDIR;
    case ERROR_NOT_SAME_DEVICE: return EXDEV;
    case ERROR_CANT_RESOLVE_FILENAME: return ELOOP;
    default: return EIO;
    }
}

int failureOf(BOOL succeeded) {
    if (succeeded)
        return 0;
    const int failed = errnoOf(::GetLastError());
    return failed != 0 ? failed : EIO;
}

/// The full path, in the form that may be longer than 260 characters.
std::wstring systemName(const std::filesystem::path& path) {
    const std::wstring& given = path.native();
    std::wstring full(32768, L'\0');
    const DWORD length =
        ::GetFullPathNameW(given.c_str(), static_cast<DWORD>(full.size()), full.data(), nullptr);
    if (length == 0 || length >= full.size())
        return given;
    full.resize(length);
    if (full.starts_with(L"\\\\?\\") || full.starts_with(L"\\\\.\\")) // a device: NUL, CON
        return full;
    if (full.starts_with(L"\\\\"))
        return L"\\\\?\\UNC" + full.substr(1);
    return L"\\\\?\\" + full;
}

std::wstring nameIn(const Folder& folder, const std::string& name) {
    return systemName(folder.path / pathFromUtf8(name));
}

int open(const std::wstring& name, DWORD access, DWORD sharing, DWORD disposition, DWORD flags,
         Descriptor& file) {
    const HANDLE handle =
        ::CreateFileW(name.c_str(), access, sharing, nullptr, disposition, flags, nullptr);
    const int failed = failureOf(handle != INVALID_HANDLE_VALUE);
    file = Descriptor(reinterpret_cast<Descriptor::Native>(handle));
    return failed;
}

std::uint64_t joined(DWORD high, DWORD low) {
    return std::uint64_t{high} << 32 | low;
}

/// Counted from the year 1601 in steps of 100 ns; only differences matter.
std::int64_t nanoseconds(const FILETIME& time) {
    return static_cast<std::int64_t>(joined(time.dwHighDateTime, time.dwLowDateTime) * 100);
}

/// Whether a reparse point is a link; cloud files, for instance, are reparse points, too.
bool isLink(HANDLE file, DWORD attributes) {
    FILE_ATTRIBUTE_TAG_INFO tag{};
    return (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0
           && ::GetFileInformationByHandleEx(file, FileAttributeTagInfo, &tag, sizeof tag)
           && (tag.ReparseTag == IO_REPARSE_TAG_SYMLINK
               || tag.ReparseTag == IO_REPARSE_TAG_MOUNT_POINT);
}

int factsOfHandle(HANDLE file, FileFacts& facts) {
    facts = {};
    if (::GetFileType(file) != FILE_TYPE_DISK)
        return 0; // the console, a pipe, a printer
    BY_HANDLE_FILE_INFORMATION found{};
    if (const int failed = failureOf(::GetFileInformationByHandle(file, &found)))
        return failed;
    const DWORD attributes = found.dwFileAttributes;
    facts.kind = isLink(file, attributes)                  ? FileKind::link
                 : (attributes & FILE_ATTRIBUTE_DIRECTORY) ? FileKind::other
                                                           : FileKind::regular;
    facts.device = found.dwVolumeSerialNumber;
    facts.inode = joined(found.nFileIndexHigh, found.nFileIndexLow);
    facts.links = found.nNumberOfLinks;
    facts.size = static_cast<std::int64_t>(joined(found.nFileSizeHigh, found.nFileSizeLow));
    facts.modified_ns = nanoseconds(found.ftLastWriteTime);
    FILE_BASIC_INFO times{};
    facts.changed_ns = ::GetFileInformationByHandleEx(file, FileBasicInfo, &times, sizeof times)
                           ? times.ChangeTime.QuadPart * 100
                           : facts.modified_ns;
    facts.writeProtected = (attributes & FILE_ATTRIBUTE_READONLY) != 0;
    facts.ofThisUser = true; // without the right to remove it, the call fails
    facts.mode = attributes;
    return 0;
}

int factsOfName(const std::wstring& name, Links links, FileFacts& facts) {
    Descriptor file;
    const DWORD flags = links == Links::followed ? FILE_FLAG_BACKUP_SEMANTICS : asItStands;
    if (const int failed = open(name, FILE_READ_ATTRIBUTES, shareAll, OPEN_EXISTING, flags, file))
        return failed;
    return factsOfHandle(nativeOf(file), facts);
}

/// The position in the file for calls that need one.
OVERLAPPED placeOf(std::uint64_t at) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(at);
    place.OffsetHigh = static_cast<DWORD>(at >> 32);
    return place;
}

int readBlock(const Descriptor& file, OVERLAPPED* place, char* block, std::size_t size,
              std::size_t& got) {
    DWORD read = 0;
    const auto most = static_cast<DWORD>(std::min<std::size_t>(size, 1U << 30));
    const BOOL taken = ::ReadFile(nativeOf(file), block, most, &read, place);
    got = taken ? read : 0;
    return !taken && ::GetLastError() == ERROR_HANDLE_EOF ? 0 : failureOf(taken);
}

/// Replaces like POSIX: also an open file that was opened with permission to delete it. Windows
/// supports this on its own file system since version 1709; others, and Wine 8, refuse the
/// parameter.
bool replaceAsPosix(const std::wstring& from, const std::wstring& to) {
    Descriptor file;
    // Flushes the data, like MOVEFILE_WRITE_THROUGH.
    if (open(from, DELETE | SYNCHRONIZE, shareAll, OPEN_EXISTING,
             asItStands | FILE_FLAG_WRITE_THROUGH, file)
        != 0)
        return false;
    const std::size_t bytes = to.size() * sizeof(wchar_t);
    // The name begins within the structure, whose remainder has room for its end.
    std::vector<std::uint64_t> block((sizeof(FILE_RENAME_INFO) + bytes) / sizeof(std::uint64_t)
                                     + 1);
    FILE_RENAME_INFO info{};
    info.Flags = FILE_RENAME_FLAG_REPLACE_IF_EXISTS | FILE_RENAME_FLAG_POSIX_SEMANTICS;
    info.FileNameLength = static_cast<DWORD>(bytes);
    char* const raw = reinterpret_cast<char*>(block.data());
    std::memcpy(raw, &info, sizeof info);
    std::memcpy(raw + offsetof(FILE_RENAME_INFO, FileName), to.data(), bytes);
    constexpr auto renameInfoEx = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22); // not in mingw
    return ::SetFileInformationByHandle(nativeOf(file), renameInfoEx, raw,
                                        static_cast<DWORD>(block.size() * sizeof(std::uint64_t)))
           != 0;
}

/// MoveFileExW replaces in one step; ReplaceFileW, which would keep more of the old file, leaves a
/// moment without a file.
int moveFile(const std::wstring& from, const std::wstring& to, DWORD flags) {
    constexpr ULONGLONG patience_ms = 2000;
    const ULONGLONG begin_ms = ::GetTickCount64();
    for (;;) {
        if ((flags & MOVEFILE_REPLACE_EXISTING) != 0 && replaceAsPosix(from, to))
            return 0;
        const int failed =
            failureOf(::MoveFileExW(from.c_str(), to.c_str(), flags | MOVEFILE_WRITE_THROUGH));
        if ((failed != EACCES && failed != EBUSY) || ::GetTickCount64() - begin_ms >= patience_ms)
            return failed;
        // Others may hold files open briefly: system searches, virus scanners, another save that
        // reads its file back. Simultaneous saves wait for random times.
        ::Sleep(static_cast<DWORD>(1 + randomNumber() % 20));
    }
}

/// Windows locks prevent others from reading: locks a byte beyond any file.
constexpr std::uint64_t lockedByte = std::uint64_t{1} << 62;

} // namespace

Descriptor::~Descriptor() {
    if (*this)
        ::CloseHandle(nativeOf(*this));
}

std::string utf8(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

std::filesystem::path pathFromUtf8(std::string_view text) {
    return {std::u8string(text.begin(), text.end())};
}

bool sameFile(const FileFacts& a, const FileFacts& b) {
    // Wine does not know the volume of an open file that was renamed.
    const bool sameVolume = a.device == b.device || a.device == 0 || b.device == 0;
    return sameVolume && a.inode == b.inode;
}

int factsAt(const std::filesystem::path& path, Links links, FileFacts& facts) {
    return factsOfName(systemName(path), links, facts);
}

int followLinks(std::filesystem::path& path, Standing& standing) {
    standing = Standing::nothing;
    FileFacts found;
    int failed = factsAt(path, Links::notFollowed, found);
    if (failed == ENOENT)
        return 0;
    if (failed == 0 && found.kind == FileKind::link) {
        Descriptor file;
        failed = open(systemName(path), FILE_READ_ATTRIBUTES, shareAll, OPEN_EXISTING,
                      FILE_FLAG_BACKUP_SEMANTICS, file);
        std::wstring full(32768, L'\0');
        if (failed == 0) {
            const DWORD length = ::GetFinalPathNameByHandleW(nativeOf(file), full.data(),
                                                             static_cast<DWORD>(full.size()), 0);
            failed = failureOf(length > 0 && length < full.size());
            full.resize(failed == 0 ? length : 0);
        }
        if (failed == 0) {
            path = full;
            failed = factsOfHandle(nativeOf(file), found);
        }
    }
    if (failed == 0)
        standing = found.kind == FileKind::regular ? Standing::regular : Standing::other;
    return failed;
}

int openFolder(const std::filesystem::path& path, Folder& folder) {
    FileFacts found;
    if (const int failed = factsAt(path, Links::followed, found))
        return failed;
    if ((found.mode & FILE_ATTRIBUTE_DIRECTORY) == 0)
        return ENOTDIR;
    folder.path = systemName(path);
    return 0;
}

int openToRead(const std::filesystem::path& path, Descriptor& file) {
    return open(systemName(path), GENERIC_READ, shareAll, OPEN_EXISTING, 0, file);
}

int renamePath(const std::filesystem::path& from, const std::filesystem::path& to) {
    return moveFile(systemName(from), systemName(to), MOVEFILE_REPLACE_EXISTING);
}

int linkPath(const std::filesystem::path& from, const std::filesystem::path& to) {
    return failureOf(::CreateHardLinkW(systemName(to).c_str(), systemName(from).c_str(), nullptr));
}

bool mayWriteFile(const std::filesystem::path& path) {
    Descriptor file;
    return open(systemName(path), GENERIC_WRITE, shareAll, OPEN_EXISTING, 0, file) == 0;
}

bool mayAddFiles(const std::filesystem::path& folder) {
    Descriptor file;
    return open(systemName(folder), FILE_ADD_FILE, shareAll, OPEN_EXISTING,
                FILE_FLAG_BACKUP_SEMANTICS, file)
           == 0;
}

int openIn(const Folder& folder, const std::string& name, Opening opening, Descriptor& file) {
    const DWORD access = opening == Opening::read ? GENERIC_READ : GENERIC_READ | GENERIC_WRITE;
    return open(nameIn(folder, name), access, shareAll, OPEN_EXISTING, FILE_FLAG_OPEN_REPARSE_POINT,
                file);
}

int createIn(const Folder& folder, const std::string& name, std::uint32_t /*mode*/,
             Descriptor& file) {
    return open(nameIn(folder, name), GENERIC_READ | GENERIC_WRITE, shareAll, CREATE_NEW,
                FILE_ATTRIBUTE_NORMAL, file);
}

int factsIn(const Folder& folder, const std::string& name, FileFacts& facts) {
    return factsOfName(nameIn(folder, name), Links::notFollowed, facts);
}

int removeIn(const Folder& folder, const std::string& name) {
    return failureOf(::DeleteFileW(nameIn(folder, name).c_str()));
}

bool replacesOpenFiles() {
    return false;
}

int renameIn(const Folder& folder, const std::string& from, const std::string& to,
             Descriptor* replaced) {
    if (replaced != nullptr) {
        const Descriptor closed = std::move(*replaced);
    }
    return moveFile(nameIn(folder, from), nameIn(folder, to), MOVEFILE_REPLACE_EXISTING);
}

int renameToFree(const Folder& folder, const std::string& from, const std::string& to) {
    return moveFile(nameIn(folder, from), nameIn(folder, to), 0);
}

int exchangeIn(const Folder& /*folder*/, const std::string& /*a*/, const std::string& /*b*/) {
    return ENOSYS;
}

void forEachNameIn(const Folder& folder, const std::function<void(const std::string&)>& take) {
    WIN32_FIND_DATAW entry{};
    const HANDLE search = ::FindFirstFileW((folder.path.native() + L"\\*").c_str(), &entry);
    if (search == INVALID_HANDLE_VALUE)
        return;
    do {
        take(utf8(std::filesystem::path(entry.cFileName)));
    } while (::FindNextFileW(search, &entry));
    ::FindClose(search);
}

int syncFolder(const Folder& /*folder*/) {
    return 0; // MOVEFILE_WRITE_THROUGH
}

std::optional<std::uint64_t> freeBytes(const Folder& folder) {
    ULARGE_INTEGER free{};
    if (!folder || !::GetDiskFreeSpaceExW(folder.path.c_str(), &free, nullptr, nullptr))
        return {};
    return free.QuadPart;
}

int factsOf(const Descriptor& file, FileFacts& facts) {
    return factsOfHandle(nativeOf(file), facts);
}

int readAt(const Descriptor& file, std::uint64_t at, char* block, std::size_t size,
           std::size_t& got) {
    OVERLAPPED place = placeOf(at);
    return readBlock(file, &place, block, size, got);
}

int readOn(const Descriptor& file, char* block, std::size_t size, std::size_t& got) {
    return readBlock(file, nullptr, block, size, got);
}

int writeAll(const Descriptor& file, std::string_view bytes) {
    while (!bytes.empty()) {
        DWORD written = 0;
        const auto most = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), 1U << 26));
        if (!::WriteFile(nativeOf(file), bytes.data(), most, &written, nullptr))
            return failureOf(FALSE);
        if (written == 0)
            return ENOSPC;
        bytes.remove_prefix(written);
    }
    return 0;
}

int copyOwnerAndMode(const Descriptor& file, const FileFacts& of) {
    constexpr DWORD kept = FILE_ATTRIBUTE_HIDDEN | FILE_ATTRIBUTE_SYSTEM | FILE_ATTRIBUTE_ARCHIVE
                           | FILE_ATTRIBUTE_NOT_CONTENT_INDEXED;
    FILE_BASIC_INFO basic{}; // times of 0 are not changed
    basic.FileAttributes = (of.mode & kept) != 0 ? of.mode & kept : FILE_ATTRIBUTE_NORMAL;
    return failureOf(
        ::SetFileInformationByHandle(nativeOf(file), FileBasicInfo, &basic, sizeof basic));
}

int syncFile(const Descriptor& file) {
    return failureOf(::FlushFileBuffers(nativeOf(file)));
}

int closeKeepingLock(const Descriptor& /*file*/) {
    return 0;
}

Locking lockFile(const Descriptor& file) {
    OVERLAPPED place = placeOf(lockedByte);
    if (::LockFileEx(nativeOf(file), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0,
                     &place))
        return Locking::taken;
    const DWORD error = ::GetLastError();
    return error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING ? Locking::heldElsewhere
                                                                      : Locking::unknown;
}

/// Folders have no locks: a hidden file in it, open exclusively and deleted with its program,
/// serves as the lock.
Locking lockFolder(const std::filesystem::path& path, Descriptor& lock) {
    const int failed = open(systemName(path / L".folder.lock"), GENERIC_WRITE, 0, OPEN_ALWAYS,
                            FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, lock);
    if (failed == 0)
        return Locking::taken;
    return failed == EBUSY ? Locking::heldElsewhere : Locking::unknown;
}

std::uint64_t randomNumber() {
    std::random_device source; // of the system
    return joined(source(), source());
}

bool isRunning(std::int64_t process) {
    if (process <= 0 || process > std::numeric_limits<DWORD>::max())
        return true;
    const HANDLE found = ::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process));
    if (found == nullptr)
        return ::GetLastError() != ERROR_INVALID_PARAMETER;
    const bool ended = ::WaitForSingleObject(found, 0) == WAIT_OBJECT_0;
    ::CloseHandle(found);
    return !ended;
}

std::filesystem::path ownProgram() {
    std::wstring name(32768, L'\0');
    name.resize(::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return name;
}

} // namespace sparkout
