// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/disk_state.h"

#include "core/format/project_file.h"
#include "ui/session/project_io.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sparkout {

namespace {

std::optional<struct stat> statOf(const QString& path) {
    struct stat found {};
    if (::stat(QFile::encodeName(path).constData(), &found) != 0) {
        return {};
    }
    return found;
}

bool hasAccess(const QString& path, int rights) {
    return ::faccessat(AT_FDCWD, QFile::encodeName(path).constData(), rights, AT_EACCESS) == 0;
}

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

} // namespace

std::optional<FileStamp> stampOf(const QString& path) {
    const auto found = statOf(path);
    if (!found) {
        return {};
    }
    return FileStamp{found->st_dev, found->st_ino, found->st_size, nanoseconds(found->st_mtim),
                     nanoseconds(found->st_ctim)};
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
    const auto found = statOf(path);
    return found ? found->st_nlink : 1;
}

bool mayBeWritten(const QString& path) {
    const QString real = realPath(path);
    const auto found = statOf(real);
    // The mode is asked too: the system lets root write anything.
    if (found
        && ((found->st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || !hasAccess(real, W_OK))) {
        return false;
    }
    return hasAccess(QFileInfo(real).absolutePath(), W_OK | X_OK);
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
