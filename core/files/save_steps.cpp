// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/save_steps.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>

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

} // namespace sparkout
