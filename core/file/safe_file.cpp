// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/safe_file.h"

#include "core/sha256.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace sparkout {

namespace {

/// Removes the name. Retries after any error, since a temporary file must not be left.
void removeName(const Folder& folder, const std::string& name) {
    for (int attempt = 0; attempt < 3; ++attempt) {
        const int failed = removeIn(folder, name);
        if (failed == 0 || failed == ENOENT)
            return;
    }
}

std::string hex(std::uint64_t value) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
    return text.data();
}

constexpr std::string_view temporarySuffix = ".tmp";

std::string temporaryName(const std::string& prefix) {
    return prefix + hex(randomNumber()) + std::string(temporarySuffix);
}

bool isTemporaryName(std::string_view name, std::string_view prefix) {
    if (name.size() != prefix.size() + 16 + temporarySuffix.size() || !name.starts_with(prefix)
        || !name.ends_with(temporarySuffix))
        return false;
    const std::string_view random = name.substr(prefix.size(), 16);
    return random.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Removes one leftover: a regular file of ours that no running save has locked.
void removeLeftover(const Folder& folder, const std::string& name) {
    Descriptor file;
    FileFacts opened;
    FileFacts named;
    if (openIn(folder, name, Opening::read, file) == 0 && factsOf(file, opened) == 0
        && opened.kind == FileKind::regular && opened.ofThisUser && lockFile(file) == Locking::taken
        && factsIn(folder, name, named) == 0 && sameFile(opened, named))
        removeName(folder, name);
}

bool forbids(int error) {
    return error == EACCES || error == EPERM || error == EROFS || error == ETXTBSY;
}

} // namespace

TemporaryName::~TemporaryName() {
    if (!m_name.empty())
        removeName(*m_folder, m_name);
}

std::string temporaryPrefix(const std::string& target) {
    // A hash (FNV-1a) represents the target's name, which may have 255 bytes itself.
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : target)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return ".sparkout-" + hex(hash) + "-";
}

int createTemporary(const Folder& folder, const std::string& prefix, std::uint32_t mode,
                    Descriptor& file, std::string& name) {
    for (int attempt = 0; attempt < 16; ++attempt) {
        name = temporaryName(prefix);
        const int failed = createIn(folder, name, mode, file);
        if (failed == EEXIST)
            continue;
        if (failed != 0)
            return failed;
        const bool locked = lockFile(file) != Locking::heldElsewhere;
        FileFacts made;
        const int error = factsOf(file, made);
        if (error == 0 && locked && made.links > 0)
            return 0;
        removeName(folder, name);
        if (error != 0)
            return error;
        // another save was cleaning up at this moment: take another name
    }
    return EEXIST;
}

void removeLeftovers(const Folder& folder, const std::string& prefix) {
    forEachNameIn(folder, [&](const std::string& name) {
        if (isTemporaryName(name, prefix))
            removeLeftover(folder, name);
    });
}

StepOutcome outcomeOf(FileStep step, int error, bool replaced) {
    return error == 0 ? StepOutcome{} : StepFailure{step, error, replaced};
}

StepOutcome openTarget(std::filesystem::path path, SaveTarget& target) {
    // The system would cut the name there.
    if (path.native().find(std::filesystem::path::value_type{}) != std::string::npos)
        return StepFailure{FileStep::inspect, EINVAL};
    Standing standing = Standing::nothing;
    if (const int error = followLinks(path, standing))
        return StepFailure{FileStep::inspect, error};
    if (standing == Standing::other)
        return StepFailure{FileStep::notRegular, 0};
    target.name = utf8(path.filename());
    if (target.name.empty())
        return StepFailure{FileStep::notRegular, 0};
    target.parent = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (const int error = openFolder(target.parent, target.folder))
        return StepFailure{FileStep::open, error};

    const int error = openIn(target.folder, target.name, Opening::readAndWrite, target.old);
    if (error == ENOENT)
        return {};
    if (error != 0)
        return StepFailure{forbids(error) ? FileStep::readOnly : FileStep::open, error};
    if (const int unknown = factsOf(target.old, target.oldFacts))
        return StepFailure{FileStep::inspect, unknown};
    if (target.oldFacts.kind != FileKind::regular)
        return StepFailure{FileStep::notRegular, 0};
    target.exists = true;
    if (!replacesOpenFiles())
        target.old = Descriptor();
    // Checks the mode, too: the system lets root write anything.
    return outcomeOf(FileStep::readOnly, target.oldFacts.writeProtected ? EACCES : 0);
}

StepOutcome beginTemporary(const SaveTarget& target, Descriptor& file, std::string& name) {
    const std::string prefix = temporaryPrefix(target.name);
    if (Descriptor turn; lockFolder(target.parent, turn) != Locking::heldElsewhere)
        removeLeftovers(target.folder, prefix);
    return outcomeOf(FileStep::create, createTemporary(target.folder, prefix,
                                                       target.exists ? 0600 : 0666, file, name));
}

StepOutcome moveIntoPlace(SaveTarget& target, const std::string& temporary) {
    return outcomeOf(FileStep::rename,
                     renameIn(target.folder, temporary, target.name, &target.old));
}

StepOutcome openPlaced(const SaveTarget& target, Descriptor& placed) {
    if (const int error = syncFolder(target.folder))
        return StepFailure{FileStep::sync, error, true};
    return outcomeOf(FileStep::verify, openIn(target.folder, target.name, Opening::read, placed),
                     true);
}

bool sameFile(const Descriptor& a, const Descriptor& b) {
    FileFacts first;
    FileFacts second;
    return factsOf(a, first) == 0 && factsOf(b, second) == 0 && sameFile(first, second);
}

FileError errorOf(const StepFailure& failure, const std::filesystem::path& path,
                  const SaveTarget& target) {
    return FileError{utf8(path), failure.step, failure.systemError, freeBytes(target.folder),
                     failure.replaced};
}

namespace {

constexpr std::size_t blockBytes = 1 << 16;
constexpr std::uint64_t firstSum = 0xcbf29ce484222325U; // FNV-1a

std::uint64_t sumOf(std::string_view bytes, std::uint64_t sum) {
    for (const char c : bytes)
        sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return sum;
}

/// Whether the file has this length and checksum: 0, EILSEQ if not, or why it cannot be read.
int compareSum(const Descriptor& file, std::uint64_t length, std::uint64_t wanted) {
    std::string block(blockBytes, '\0');
    std::uint64_t at = 0, sum = firstSum;
    for (;;) {
        std::size_t n = 0;
        if (const int code = readAt(file, at, block.data(), block.size(), n))
            return code;
        if (n == 0)
            return at == length && sum == wanted ? 0 : EILSEQ;
        at += n;
        sum = sumOf(std::string_view(block).substr(0, n), sum);
    }
}

} // namespace

struct SafeFileWriter::State {
    std::filesystem::path path;
    Existing existing;
    SaveTarget target;
    Descriptor file;
    std::string name; ///< name of the temporary file
    std::optional<TemporaryName> temporary;
    std::string block; ///< bytes that are not written yet
    std::uint64_t length = 0, sum = firstSum;
    std::optional<FileError> error;

    bool fail(const StepOutcome& failed) {
        if (failed && !error)
            error = errorOf(*failed, path, target);
        return !error;
    }

    StepOutcome open() {
        if (StepOutcome failed = openTarget(path, target))
            return failed;
        if (target.exists && existing == Existing::refused)
            return StepFailure{FileStep::create, EEXIST};
        if (StepOutcome failed = beginTemporary(target, file, name))
            return failed;
        temporary.emplace(target.folder, name);
        return {};
    }

    StepOutcome flush() {
        const int code = writeAll(file, block);
        length += block.size();
        sum = sumOf(block, sum);
        block.clear();
        return outcomeOf(FileStep::write, code);
    }

    StepOutcome moveIn() {
        if (existing == Existing::refused)
            return outcomeOf(FileStep::rename, renameToFree(target.folder, name, target.name));
        return moveIntoPlace(target, name);
    }

    StepOutcome confirmPlace() {
        Descriptor placed;
        if (StepOutcome failed = openPlaced(target, placed))
            return failed;
        // Read back before the rename; here the identity of the file suffices.
        return sameFile(placed, file) ? StepOutcome{} : StepFailure{FileStep::verify, EILSEQ, true};
    }

    StepOutcome finish() {
        if (StepOutcome failed = flush())
            return failed;
        if (target.exists)
            if (const int code = copyOwnerAndMode(file, target.oldFacts))
                return StepFailure{FileStep::permissions, code};
        if (const int code = syncFile(file))
            return StepFailure{FileStep::sync, code};
        if (const int code = compareSum(file, length, sum))
            return StepFailure{FileStep::verify, code};
        if (const int code = closeKeepingLock(file))
            return StepFailure{FileStep::close, code};
        if (StepOutcome failed = moveIn())
            return failed;
        temporary->release();
        return confirmPlace();
    }
};

SafeFileWriter::SafeFileWriter(const std::filesystem::path& path, Existing existing)
    : m_state(std::make_unique<State>()) {
    m_state->path = path;
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

namespace {

constexpr std::chrono::seconds longestWait{2};
constexpr int mostAside = 1000; ///< damaged versions of one file

/// Whether the file has exactly these bytes: 0, EILSEQ if not, or why it cannot be read.
int compareWith(const Descriptor& file, std::string_view bytes) {
    std::array<char, 65536> block;
    for (std::size_t at = 0;;) {
        std::size_t length = 0;
        if (const int error = readAt(file, at, block.data(), block.size(), length))
            return error;
        if (length == 0 && at == bytes.size())
            return 0;
        if (length == 0 || length > bytes.size() - at
            || !std::equal(block.data(), block.data() + length, bytes.data() + at))
            return EILSEQ;
        at += length;
    }
}

/// Writes, syncs and reads back; `old` is null for a new file.
StepOutcome fill(const Descriptor& file, std::string_view bytes, const FileFacts* old) {
    if (const int error = writeAll(file, bytes))
        return StepFailure{FileStep::write, error};
    if (old != nullptr)
        if (const int error = copyOwnerAndMode(file, *old))
            return StepFailure{FileStep::permissions, error};
    if (const int error = syncFile(file))
        return StepFailure{FileStep::sync, error};
    return outcomeOf(FileStep::verify, compareWith(file, bytes));
}

/// The whole content of an open file.
int readWhole(const Descriptor& file, std::string& bytes) {
    std::array<char, 65536> block;
    for (;;) {
        std::size_t n = 0;
        if (const int error = readAt(file, bytes.size(), block.data(), block.size(), n))
            return error;
        if (n == 0)
            return 0;
        bytes.append(block.data(), n);
    }
}

/// Whether a name in the folder has the contents that the caller expects to replace.
StepOutcome compareWithExpected(const Folder& folder, const std::string& name,
                                const std::optional<std::string>& expected) {
    if (!expected)
        return {};
    Descriptor file;
    const int missing = openIn(folder, name, Opening::read, file);
    if (missing == ENOENT)
        return expected->empty() ? StepOutcome{} : StepFailure{FileStep::changed, 0};
    std::string bytes;
    if (const int error = missing != 0 ? missing : readWhole(file, bytes))
        return StepFailure{FileStep::inspect, error};
    return sha256(bytes) == *expected ? StepOutcome{} : StepFailure{FileStep::changed, 0};
}

/// Waits until no other save of an expected version is comparing and replacing in the folder. If
/// that is unknown, or takes too long, it continues: the exchange is checked again.
void waitForTurn(const SaveTarget& target, Descriptor& turn) {
    const auto end = std::chrono::steady_clock::now() + longestWait;
    while (lockFolder(target.parent, turn) == Locking::heldElsewhere
           && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Copies the old file to NAME.bak through a temporary file.
StepOutcome copyToBackup(SaveTarget& target, const std::string& backup) {
    if (!target.old) {
        int error = openIn(target.folder, target.name, Opening::read, target.old);
        if (error == 0)
            error = factsOf(target.old, target.oldFacts);
        if (error != 0)
            return StepFailure{FileStep::backup, error};
    }
    std::string bytes;
    if (const int error = readWhole(target.old, bytes))
        return StepFailure{FileStep::backup, error};
    Descriptor copy;
    std::string name;
    if (const int error =
            createTemporary(target.folder, temporaryPrefix(target.name), 0600, copy, name))
        return StepFailure{FileStep::backup, error};
    TemporaryName temporary(target.folder, name);
    if (StepOutcome failed = fill(copy, bytes, &target.oldFacts))
        return StepFailure{FileStep::backup, failed->systemError};
    if (const int error = renameIn(target.folder, name, backup))
        return StepFailure{FileStep::backup, error};
    temporary.release();
    return {};
}

/// After the rename: reads the new file under its name. Other bytes are not a failure of this save
/// if another one has put its own file in place meanwhile.
StepOutcome confirm(const SaveTarget& target, const Descriptor& written, std::string_view bytes) {
    Descriptor placed;
    if (StepOutcome failed = openPlaced(target, placed))
        return failed;
    const int error = compareWith(placed, bytes);
    if (error != 0 && (error != EILSEQ || sameFile(placed, written)))
        return StepFailure{FileStep::verify, error, true};
    return {};
}

/// Replaces the old file, which must be the expected one, by the temporary one: exchanges the two,
/// checks the old one and removes it or renames it to NAME.bak, or exchanges them back. Where files
/// cannot be exchanged a backup is copied first.
StepOutcome replaceOld(SaveTarget& target, const std::string& temporary,
                       const WriteOptions& options) {
    const Folder& folder = target.folder;
    const std::string backup = target.name + ".bak";
    const auto exchange = [&] { return exchangeIn(folder, temporary, target.name); };
    const auto putBack = [&](StepFailure failed) {
        failed.replaced = exchange() != 0;
        return failed;
    };
    FileFacts found;
    const int missing = options.keepBackup ? factsIn(folder, backup, found) : ENOENT;
    if (missing == 0 && found.kind != FileKind::regular)
        return StepFailure{FileStep::backup, EEXIST};
    if (missing != 0 && missing != ENOENT)
        return StepFailure{FileStep::backup, missing};
    if (StepOutcome changed = compareWithExpected(folder, target.name, options.expected))
        return changed;
    if (exchange() == 0) {
        if (StepOutcome changed = compareWithExpected(folder, temporary, options.expected))
            return putBack(*changed);
        const int error =
            options.keepBackup ? renameIn(folder, temporary, backup) : removeIn(folder, temporary);
        const FileStep step = options.keepBackup ? FileStep::backup : FileStep::rename;
        return error == 0 ? StepOutcome{} : putBack({step, error});
    }
    if (options.keepBackup)
        if (StepOutcome failed = copyToBackup(target, backup))
            return failed;
    return moveIntoPlace(target, temporary);
}

/// Puts the temporary file in its place without checking the old one.
StepOutcome putInPlace(SaveTarget& target, const std::string& temporary,
                       const WriteOptions& options) {
    if (!target.exists && options.expected) {
        const int error = renameToFree(target.folder, temporary, target.name);
        return error == EEXIST ? StepFailure{FileStep::changed, 0}
                               : outcomeOf(FileStep::rename, error);
    }
    return target.exists && (options.keepBackup || options.expected)
               ? replaceOld(target, temporary, options)
               : moveIntoPlace(target, temporary);
}

StepOutcome save(SaveTarget& target, std::string_view bytes, const WriteOptions& options) {
    const bool exists = target.exists;
    // First, to avoid useless writing.
    if (StepOutcome changed = compareWithExpected(target.folder, target.name, options.expected))
        return changed;
    if (target.old) // another save must not take the exchanged old file for a leftover
        (void)lockFile(target.old);

    Descriptor file;
    std::string name;
    if (StepOutcome failed = beginTemporary(target, file, name))
        return failed;
    TemporaryName temporary(target.folder, name);
    if (StepOutcome failed = fill(file, bytes, exists ? &target.oldFacts : nullptr))
        return failed;
    if (const int error = closeKeepingLock(file))
        return StepFailure{FileStep::close, error};
    {
        Descriptor turn;
        if (options.expected)
            waitForTurn(target, turn);
        if (StepOutcome failed = putInPlace(target, name, options))
            return failed;
        temporary.release();
    }
    return confirm(target, file, bytes);
}

StepOutcome readAll(const std::filesystem::path& path, std::size_t maxBytes, std::string& bytes) {
    // Checked before opening, since opening a device may have effects.
    FileFacts found;
    if (const int error = factsAt(path, Links::followed, found))
        return StepFailure{FileStep::inspect, error};
    if (found.kind != FileKind::regular)
        return StepFailure{FileStep::notRegular, 0};
    Descriptor file;
    if (const int error = openToRead(path, file))
        return StepFailure{FileStep::open, error};
    if (const int error = factsOf(file, found))
        return StepFailure{FileStep::inspect, error};
    if (found.kind != FileKind::regular)
        return StepFailure{FileStep::notRegular, 0};
    if (std::cmp_greater(found.size, maxBytes))
        return StepFailure{FileStep::tooLarge, 0};
    bytes.reserve(static_cast<std::size_t>(found.size));
    std::array<char, 65536> block;
    for (;;) {
        std::size_t n = 0;
        if (const int error = readOn(file, block.data(), block.size(), n))
            return StepFailure{FileStep::read, error};
        if (n == 0)
            return {};
        bytes.append(block.data(), n);
        if (bytes.size() > maxBytes) // it grew meanwhile, or its size was not known
            return StepFailure{FileStep::tooLarge, 0};
    }
}

} // namespace

std::optional<FileError> writeFileSafely(const std::filesystem::path& path, std::string_view bytes,
                                         const WriteOptions& options) try {
    SaveTarget target;
    StepOutcome failed = openTarget(path, target);
    if (!failed)
        failed = save(target, bytes, options);
    if (!failed)
        return {};
    return errorOf(*failed, path, target);
} catch (const std::bad_alloc&) {
    return FileError{utf8(path), FileStep::create, ENOMEM, {}, false};
}

std::variant<std::string, FileError> readFile(const std::filesystem::path& path,
                                              std::size_t maxBytes) try {
    std::string bytes;
    if (const StepOutcome failed = readAll(path, maxBytes, bytes))
        return FileError{utf8(path), failed->step, failed->systemError, {}, false};
    return bytes;
} catch (const std::bad_alloc&) {
    return FileError{utf8(path), FileStep::read, ENOMEM, {}, false};
}

std::variant<std::filesystem::path, FileError> putAside(const std::filesystem::path& path) {
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    Folder opened;
    int error = openFolder(folder, opened);
    const std::string name = utf8(path.filename());
    std::string aside = name + ".damaged";
    for (int number = 2; error == 0; ++number) {
        error = renameToFree(opened, name, aside);
        if (error == 0)
            return path.parent_path() / pathFromUtf8(aside);
        if (error == EEXIST && number <= mostAside) {
            aside = name + ".damaged-" + std::to_string(number);
            error = 0;
        }
    }
    return FileError{utf8(path), FileStep::backup, error, {}, false};
}

const char* fileStepText(FileStep step) {
    switch (step) {
    case FileStep::inspect:
        return SPARKOUT_NOOP("FileError", "the file or folder is not accessible");
    case FileStep::notRegular: return SPARKOUT_NOOP("FileError", "the path does not name a file");
    case FileStep::readOnly: return SPARKOUT_NOOP("FileError", "the file is read-only");
    case FileStep::open: return SPARKOUT_NOOP("FileError", "it cannot be opened");
    case FileStep::create:
        return SPARKOUT_NOOP("FileError", "no file can be created in the folder");
    case FileStep::permissions: return SPARKOUT_NOOP("FileError", "its permissions cannot be set");
    case FileStep::write:
    case FileStep::sync:
    case FileStep::close: return SPARKOUT_NOOP("FileError", "the data could not be written");
    case FileStep::backup: return SPARKOUT_NOOP("FileError", "the previous version cannot be kept");
    case FileStep::rename: return SPARKOUT_NOOP("FileError", "the new file cannot be put in place");
    case FileStep::verify:
        return SPARKOUT_NOOP("FileError",
                             "the data read back from the disk differ from the data written");
    case FileStep::read: return SPARKOUT_NOOP("FileError", "it cannot be read");
    case FileStep::tooLarge: return SPARKOUT_NOOP("FileError", "the file is too large");
    case FileStep::changed:
        return SPARKOUT_NOOP("FileError", "another program has changed it in the meantime");
    case FileStep::content:
        return SPARKOUT_NOOP("FileError", "this program could not read the saved content back");
    }
    return "";
}

} // namespace sparkout
