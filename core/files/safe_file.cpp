// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/safe_file.h"

#include "core/files/save_steps.h"
#include "core/files/temporary_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <utility>

namespace sparkout {

namespace {

/// Whether the file holds exactly these bytes: 0, EILSEQ if not, or why it cannot be read.
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

/// Copies the old file to NAME.bak by way of a temporary file.
StepOutcome copyToBackup(SaveTarget& target, const std::string& backup) {
    if (!target.old) {
        int error = openIn(target.folder, target.name, Opening::read, target.old);
        if (error == 0)
            error = factsOf(target.old, target.oldFacts);
        if (error != 0)
            return StepFailure{FileStep::backup, error};
    }
    std::string bytes(static_cast<std::size_t>(target.oldFacts.size), '\0');
    for (std::size_t at = 0; at < bytes.size();) {
        std::size_t n = 0;
        const int error = readAt(target.old, at, bytes.data() + at, bytes.size() - at, n);
        if (error != 0 || n == 0)
            return StepFailure{FileStep::backup, error != 0 ? error : EIO};
        at += n;
    }
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

/// After the rename: reads the new file under its name. Other bytes there are no fault of this save
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

/// Puts the temporary file in place and keeps the old one as NAME.bak: the two are exchanged and
/// the old one renamed, or exchanged back if that fails. Where files cannot be exchanged the old
/// one is copied first.
StepOutcome moveIntoPlaceKeepingOld(SaveTarget& target, const std::string& temporary) {
    const Folder& folder = target.folder;
    const std::string backup = target.name + ".bak";
    FileFacts found;
    const int missing = factsIn(folder, backup, found);
    if (missing == 0 && found.kind != FileKind::regular)
        return StepFailure{FileStep::backup, EEXIST};
    if (missing != 0 && missing != ENOENT)
        return StepFailure{FileStep::backup, missing};
    const auto exchange = [&] { return exchangeIn(folder, temporary, target.name); };
    if (exchange() == 0) {
        const int error = renameIn(folder, temporary, backup);
        return error == 0 ? StepOutcome{} : StepFailure{FileStep::backup, error, exchange() != 0};
    }
    if (StepOutcome failed = copyToBackup(target, backup))
        return failed;
    return moveIntoPlace(target, temporary);
}

StepOutcome save(SaveTarget& target, std::string_view bytes, WriteOptions options) {
    const bool exists = target.exists;
    if (target.old) // another save shall not take the old file for a leftover while it is exchanged
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
    const StepOutcome failed = exists && options.keepBackup ? moveIntoPlaceKeepingOld(target, name)
                                                            : moveIntoPlace(target, name);
    if (failed)
        return failed;
    temporary.release();
    return confirm(target, file, bytes);
}

StepOutcome readAll(const std::filesystem::path& path, std::size_t maxBytes, std::string& bytes) {
    // Asked before opening: opening a device may already do something.
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
                                         WriteOptions options) try {
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

} // namespace sparkout
