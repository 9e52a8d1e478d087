// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"
#include "ui/kit/theme.h"

#include <QApplication>

#include <clocale>

int main(int argc, char** argv) {
    const QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // as the program does
    sparkout::applyTheme(sparkout::Theme::light);
    return runTest(argc, argv);
}
