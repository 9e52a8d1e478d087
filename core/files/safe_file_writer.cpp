// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/safe_file_writer.h"

#include "core/files/save_steps.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace sparkout {

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

} // namespace sparkout
