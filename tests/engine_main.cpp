// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"

#include <QCoreApplication>

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv); // takes the locale of the system
    return runTest(argc, argv);
}
