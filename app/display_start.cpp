// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display_start.h"

#include "app/window_io.h"
#include "ui/text/texts.h"

#include <QGuiApplication>

#include <csignal>
#include <cstdio>

#include <unistd.h>

namespace sparkout {

namespace {

#ifdef SIGBUS
constexpr int crashSignals[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};
#else // Windows
constexpr int crashSignals[] = {SIGSEGV, SIGABRT, SIGFPE, SIGILL};
#endif

constexpr char crashWords[] =
    "sparkout: the display cannot be used: its plug-in crashed. Look at DISPLAY and\n"
    "QT_QPA_PLATFORM, or use sparkout-cli, sparkout --picture or sparkout --report.\n";

QString variable(const char* name) {
    return qEnvironmentVariableIsSet(name)
               ? QStringLiteral("%1=%2").arg(QString::fromLatin1(name),
                                             printableText(qEnvironmentVariable(name)))
               : QStringLiteral("%1 is not set").arg(QString::fromLatin1(name));
}

} // namespace

DisplayStart::DisplayStart() : m_before(qInstallMessageHandler(receive)) {
    for (const int signal : crashSignals) {
        std::signal(signal, crash);
    }
}

DisplayStart::~DisplayStart() {
    for (const int signal : crashSignals) {
        std::signal(signal, SIG_DFL);
    }
    qInstallMessageHandler(m_before);
    for (const QString& text : s_told) {
        qWarning("%s", qPrintable(text));
    }
    s_told.clear();
}

void DisplayStart::checkScreen() {
    if (!QGuiApplication::primaryScreen()) {
        end(s_told.isEmpty() ? QStringLiteral("there is no screen") : s_told.last());
    }
}

void DisplayStart::receive(QtMsgType type, const QMessageLogContext& /*context*/,
                           const QString& text) {
    if (type == QtFatalMsg) {
        // If a plug-in finds no display, Qt reports only that it could not be initialised.
        const bool general = text.contains(QStringLiteral("platform plugin could be initialized"));
        end(general && !s_told.isEmpty() ? s_told.last() : text);
    }
    if (type == QtWarningMsg || type == QtCriticalMsg) {
        s_told << text;
    }
}

void DisplayStart::crash(int /*signal*/) {
    (void)!::write(STDERR_FILENO, crashWords, sizeof crashWords - 1);
    ::_exit(exitUsage);
}

/// Exits without destructors, since the application is only partly constructed.
void DisplayStart::end(const QString& reason) {
    say(stderr, QStringLiteral("sparkout: the display cannot be used: %1 (%2, %3). Use "
                               "sparkout-cli, sparkout --picture or sparkout --report.")
                    .arg(printableText(reason.simplified()), variable("DISPLAY"),
                         variable("QT_QPA_PLATFORM")));
    std::fflush(nullptr);
    ::_exit(exitUsage);
}

} // namespace sparkout
