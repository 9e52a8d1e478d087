// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/safe_file_writer.h"

#include "core/files/save_steps.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio> // RENAME_NOREPLACE
#include <optional>
#include <string>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace sparkout {

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
    SaveTarget target;
    Descriptor file;
    std::string name; ///< of the temporary file
    std::optional<TemporaryName> temporary;
    std::string block; ///< not written yet
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
        if (target.old && existing == Existing::refused)
            return StepFailure{FileStep::create, EEXIST};
        if (StepOutcome failed = beginTemporary(target, file, name))
            return failed;
        temporary.emplace(target.folder.get(), name);
        return {};
    }

    StepOutcome flush() {
        StepOutcome failed = writeAll(file.get(), block);
        length += block.size();
        sum = sumOf(block, sum);
        block.clear();
        return failed;
    }

    StepOutcome moveIn() {
        const int folder = target.folder.get();
        const unsigned int flags = existing == Existing::refused ? RENAME_NOREPLACE : 0;
        if (::renameat2(folder, name.c_str(), folder, target.name.c_str(), flags) == 0)
            return {};
        if (errno != EINVAL && errno != ENOSYS)
            return StepFailure{FileStep::rename, errno};
        // The file system does not know the flag.
        if (existing == Existing::refused
            && ::faccessat(folder, target.name.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0)
            return StepFailure{FileStep::rename, EEXIST};
        return moveIntoPlace(target, name);
    }

    StepOutcome confirmPlace() {
        Descriptor placed;
        if (StepOutcome failed = openPlaced(target, placed))
            return failed;
        // Read back before the rename; here it is enough that it is this file.
        return sameFile(placed, file) ? StepOutcome{} : StepFailure{FileStep::verify, EILSEQ, true};
    }

    StepOutcome finish() {
        if (StepOutcome failed = flush())
            return failed;
        if (target.old)
            if (StepOutcome failed = copyOwnerAndMode(file.get(), target.oldStat))
                return failed;
        if (StepOutcome failed = syncFile(file.get()))
            return failed;
        if (const int code = compareSum(file.get(), length, sum))
            return StepFailure{FileStep::verify, code};
        if (StepOutcome failed = closeKeepingLock(file))
            return failed;
        if (StepOutcome failed = moveIn())
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
