// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/portable_folder.h"

#include "app/window_io.h"
#include "core/file/file_system.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFont>
#include <QFontDatabase>

namespace sparkout {

namespace {

/// The folder of the program, found without an application object, which does not exist yet.
QString programFolder() {
    return QFileInfo(fromSystemText(utf8(ownProgram()))).absolutePath();
}

QString ownFolder() {
    return programFolder() + QStringLiteral("/settings");
}

} // namespace

void PortableFolder::useItsFonts() {
#ifdef Q_OS_WIN
    // the name of the font without a display
    QFont::insertSubstitution(QStringLiteral("monospace"), QStringLiteral("DejaVu Sans Mono"));
#else
    const QString fonts = programFolder() + QStringLiteral("/fonts/fonts.conf");
    if (qEnvironmentVariableIsEmpty("FONTCONFIG_FILE") && QFileInfo::exists(fonts)) {
        qputenv("FONTCONFIG_FILE", QFile::encodeName(fonts));
    }
#endif
}

void PortableFolder::addItsFonts() {
#ifdef Q_OS_WIN
    const QDir fonts(programFolder() + QStringLiteral("/fonts"));
    if (QApplication::platformName() != u"offscreen") { // it finds them by qt.conf
        for (const QString& name : fonts.entryList({QStringLiteral("*.ttf")}, QDir::Files)) {
            QFontDatabase::addApplicationFont(fonts.filePath(name));
        }
    }
    // Used without a display, and where the system has no window font of its own but only a generic
    // name.
    QFont usual = QApplication::font();
    if (!QFontDatabase::hasFamily(usual.family())
        || usual.family().startsWith(QStringLiteral("MS Shell Dlg"))) {
        usual.setFamily(QStringLiteral("DejaVu Sans"));
        usual.setPointSize(9);
        QApplication::setFont(usual);
    }
#endif
}

QString PortableFolder::settingsFile() {
    return ownFolder() + QStringLiteral("/settings.json");
}

QString PortableFolder::stateFolder() {
    return ownFolder() + QStringLiteral("/state");
}

bool PortableFolder::make() {
    if (QDir().mkpath(ownFolder()) && QFileInfo(ownFolder()).isWritable()) {
        return true;
    }
    say(stderr, QStringLiteral("sparkout: --portable: %1 cannot be written")
                    .arg(printableText(ownFolder())));
    return false;
}

} // namespace sparkout
