// SPDX-License-Identifier: GPL-3.0-or-later
// Ends with 0 where a window could be opened, as Qt itself finds out; otherwise Qt ends it. Before
// the window is started, ./workbench asks it whether DISPLAY leads anywhere.
#include <QGuiApplication>
#include <QScreen>

#include <sys/resource.h>

int main(int argc, char** argv) {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none); // without a display Qt aborts
    const QGuiApplication app(argc, argv);
    return QGuiApplication::screens().isEmpty() ? 1 : 0;
}
