// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/disk_state.h"

#include "core/files/file_system.h"
#include "core/format/project_file.h"
#include "ui/session/project_io.h"

#include <QDir>
#include <QFileInfo>

#include <cerrno>

namespace sparkout {

namespace {

std::optional<FileFacts> factsOf(const QString& path) {
    FileFacts found;
    if (factsAt(systemPath(path), Links::followed, found) != 0) {
        return {};
    }
    return found;
}

} // namespace

std::optional<FileStamp> stampOf(const QString& path) {
    const auto found = factsOf(path);
    if (!found) {
        return {};
    }
    return FileStamp{found->device, found->inode, found->size, found->modified_ns,
                     found->changed_ns};
}

DiskState diskState(const QString& path) {
    DiskState state;
    const auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        state.kind =
            error->systemError == ENOENT ? DiskState::Kind::missing : DiskState::Kind::unreadable;
        return state;
    }
    state.kind = DiskState::Kind::file;
    state.hash = contentHash(std::get<std::string>(read));
    state.links = linkCount(path);
    return state;
}

std::uint64_t linkCount(const QString& path) {
    const auto found = factsOf(path);
    return found ? found->links : 1;
}

bool mayBeWritten(const QString& path) {
    const QString real = realPath(path);
    const auto found = factsOf(real);
    // Checks the mode, too: the system lets root write anything.
    if (found && (found->writeProtected || !mayWriteFile(systemPath(real)))) {
        return false;
    }
    return mayAddFiles(systemPath(QFileInfo(real).absolutePath()));
}

QString realPath(const QString& path) {
    const QFileInfo info(path);
    if (const QString real = info.canonicalFilePath(); !real.isEmpty()) {
        return real;
    }
    const QString folder = QFileInfo(info.absolutePath()).canonicalFilePath();
    return folder.isEmpty() ? info.absoluteFilePath() : QDir(folder).filePath(info.fileName());
}

} // namespace sparkout
