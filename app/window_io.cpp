// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_io.h"

#include "core/files/safe_file.h"
#include "core/format/project_file.h"
#include "core/setup/setup_file.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QFile>

#include <string>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

QtMessageHandler printed = nullptr; ///< Qt's own

void printUnlessOfPlatform(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (!text.contains(QLatin1StringView("propagateSizeHints"))
        && !text.contains(QLatin1StringView("XDG_RUNTIME_DIR not set"))) {
        printed(type, context, text);
    }
}

} // namespace

void passOverPlatformNotices() {
    printed = qInstallMessageHandler(printUnlessOfPlatform);
}

void say(std::FILE* stream, const QString& text) {
    std::fputs((text + u'\n').toLocal8Bit().constData(), stream);
}

int refuse(const Issues& issues) {
    for (const QString& line : FaultsDialog::lines(issues)) {
        say(stderr, QStringLiteral("sparkout: %1").arg(line));
    }
    return exitRefused;
}

bool writeBytes(const QByteArray& bytes, const QString& path) {
    const auto error = writeFileSafely(QFile::encodeName(path).toStdString(),
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

bool openOrSay(Document& document, const QString& path) {
    const OpenResult result = document.open(path);
    if (result.error) {
        say(stderr, QStringLiteral("sparkout: %1").arg(readErrorText(*result.error)));
    } else if (!result.opened()) {
        for (const QString& line : FaultsDialog::lines(result.issues)) {
            say(stderr, QStringLiteral("sparkout: %1").arg(line));
        }
    }
    return result.opened();
}

} // namespace sparkout
