// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/project_io.h"

#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "core/setup/setup_file.h"
#include "ui/text/file_error_text.h"

#include <QCryptographicHash>

#include <cerrno>

namespace sparkout {

namespace {

FileError notConfirmed(const QString& path, int systemError) {
    return {systemText(path), FileStep::verify, systemError, {}, true};
}

} // namespace

std::filesystem::path systemPath(const QString& path) {
    return pathFromUtf8(systemText(path));
}

QByteArray contentHash(std::string_view bytes) {
    return QCryptographicHash::hash(QByteArrayView(bytes.data(), qsizetype(bytes.size())),
                                    QCryptographicHash::Sha256);
}

LoadedProject parseProject(std::string_view text, const std::stop_token& stop) {
    LoadedProject loaded;
    ReadSetup parsed = readSetup(text, stop);
    if (stop.stop_requested()) {
        return loaded;
    }
    loaded.issues = std::move(parsed.issues);
    loaded.setup = std::move(parsed.setup ? parsed.setup : parsed.unfinished);
    loaded.hash = contentHash(text);
    return loaded;
}

LoadedProject loadProject(const QString& path, const std::stop_token& stop) {
    const auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        LoadedProject failed;
        failed.error = *error;
        return failed;
    }
    return parseProject(std::get<std::string>(read), stop);
}

QByteArray inputsText(Setup setup) {
    for (GroundSurface& surface : setup.surfaces) {
        surface.project.runs = {};
    }
    return QByteArray::fromStdString(writeSetup(setup));
}

std::optional<std::string> projectText(const Setup& setup) {
    std::string text = writeSetup(setup);
    const ReadSetup back = readSetup(text);
    const auto& same = back.setup ? back.setup : back.unfinished;
    return same && sameSetup(*same, setup) ? std::optional(std::move(text)) : std::nullopt;
}

SavedContent saveContent(const MakeContent& make, const QString& path,
                         const WriteOptions& options) {
    SavedContent saved;
    const std::optional<std::string> text = make();
    if (!text || text->size() > limits::fileBytes) {
        saved.error = FileError{systemText(path), FileStep::content, 0, {}};
        return saved;
    }
    saved.hash = contentHash(*text);
    saved.error = writeFileSafely(systemPath(path), *text, options);
    if (saved.error) {
        return saved;
    }
    // Checks what the next reader gets, in addition to the writer's own check.
    const auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        saved.error = notConfirmed(path, error->systemError);
    } else if (contentHash(std::get<std::string>(read)) != saved.hash) {
        saved.error = notConfirmed(path, EILSEQ);
    }
    return saved;
}

} // namespace sparkout
