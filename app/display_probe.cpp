// SPDX-License-Identifier: GPL-3.0-or-later
// Exits with 0 if Qt can open a window; otherwise Qt aborts the program. ./workbench runs it before
// it starts the window, to find out whether DISPLAY is usable.
#include <QGuiApplication>
#include <QScreen>

#include <sys/resource.h>

int main(int argc, char** argv) {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none); // without a display Qt aborts
    const QGuiApplication app(argc, argv);
    return QGuiApplication::screens().isEmpty() ? 1 : 0;
}
