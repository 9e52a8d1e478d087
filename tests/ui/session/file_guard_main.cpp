// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"
#include "tests/ui/support/file_guard_bench.h"

#include <QCoreApplication>

int main(int argc, char** argv) {
#ifndef Q_OS_WIN
    using namespace sparkout;
    using file_guard_bench::smallDisk;
    QTemporaryDir folder;
    if (trouble::mountSmallDisk(folder.path(), 64)) {
        smallDisk = folder.path();
    }
#endif
    int result = 0;
    {
        const QCoreApplication app(argc, argv);
        result = runTest(argc, argv);
    }
#ifndef Q_OS_WIN
    if (!smallDisk.isEmpty()) {
        ::umount(QFile::encodeName(smallDisk).constData());
    }
#endif
    return result;
}
