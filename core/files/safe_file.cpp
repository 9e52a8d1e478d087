// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/safe_file.h"

#include "core/files/save_steps.h"
#include "core/sha256.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <new>
#include <thread>
#include <utility>

namespace sparkout {

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
