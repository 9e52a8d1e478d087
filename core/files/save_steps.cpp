// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/save_steps.h"

#include "core/files/temporary_file.h"

#include <cerrno>

namespace sparkout {

namespace {

bool forbids(int error) {
    return error == EACCES || error == EPERM || error == EROFS || error == ETXTBSY;
}

} // namespace

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
