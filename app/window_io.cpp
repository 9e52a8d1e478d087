// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_io.h"

#include "app/console.h"
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/printable.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "ui/dialogs/file_questions.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QStringList>

#include <string>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

QtMessageHandler printed = nullptr; ///< Qt's own message handler

void printUnlessOfPlatform(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (!text.contains(QLatin1StringView("propagateSizeHints"))
        && !text.contains(QLatin1StringView("XDG_RUNTIME_DIR not set"))) {
        printed(type, context, QString::fromStdString(printableLines(text.toStdString())));
    }
}

QString surfaceNames(const Document& document) {
    QStringList names;
    for (const SurfaceStatePtr& surface : document.state().surfaces) {
        names += QStringLiteral("%1 %2")
                     .arg(names.size() + 1)
                     .arg(printableText(QString::fromStdString(surface->name)))
                     .trimmed();
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

void passOverPlatformNotices() {
    printed = qInstallMessageHandler(printUnlessOfPlatform);
}

void say(std::FILE* stream, const QString& text) {
    cli::printText(stream, systemText(text + u'\n'));
}

int refuse(const Issues& issues) {
    for (const QString& line : FaultsDialog::lines(issues)) {
        say(stderr, QStringLiteral("sparkout: %1").arg(printableText(line)));
    }
    return exitRefused;
}

bool writeBytes(const QByteArray& bytes, const QString& path) {
    const auto error = writeFileSafely(systemPath(path),
                                       {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    if (error) {
        say(stderr, QStringLiteral("sparkout: %1").arg(saveErrorText(*error)));
    }
    return !error;
}

std::optional<Setup> openSetupOrSay(const QString& path) {
    auto content = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&content)) {
        say(stderr, QStringLiteral("sparkout: %1").arg(readErrorText(*error)));
        return {};
    }
    ReadSetup read = readSetup(std::get<std::string>(content));
    if (!read.setup) {
        (void)refuse(read.issues);
    }
    return std::move(read.setup);
}

bool openOrSay(Document& document, const QString& path, const QString& surface) {
    const OpenResult result = document.open(path);
    if (result.error) {
        say(stderr, QStringLiteral("sparkout: %1").arg(readErrorText(*result.error)));
    } else if (!result.opened()) {
        (void)refuse(result.issues);
    }
    if (!result.opened() || surface.isEmpty()) {
        return result.opened();
    }
    const auto found = document.setup().find(surface.toStdString());
    if (found) {
        document.showSurface(*found);
    } else {
        say(stderr, QStringLiteral("sparkout: unknown surface “%1”; the file has: %2")
                        .arg(printableText(surface), surfaceNames(document)));
    }
    return found.has_value();
}

std::optional<Project> projectOrSay(const QString& path, const QString& surface) {
    Document document;
    if (!openOrSay(document, path, surface)) {
        return std::nullopt;
    }
    if (surface.isEmpty() && document.surfaceCount() > 1) {
        say(stderr,
            QStringLiteral("sparkout: the file holds several surfaces; name one with --surface: %1")
                .arg(surfaceNames(document)));
        return std::nullopt;
    }
    const Setup upTo = document.upToPresent();
    WornProject worn = wornProject(upTo, upTo.surfaces.size() - 1);
    if (!worn.issues.empty()) {
        (void)refuse(worn.issues);
        return std::nullopt;
    }
    return std::move(worn.project);
}

} // namespace sparkout
