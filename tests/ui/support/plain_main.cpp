// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"

#include <QApplication>
#include <QStyleFactory>

#include <clocale>

int main(int argc, char** argv) {
    const QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    return runTest(argc, argv);
}
