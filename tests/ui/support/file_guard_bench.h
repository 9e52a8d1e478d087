// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/project_file.h"
#include "core/project/part.h"
#include "core/study/new_project.h"
#include "tests/ui/support/diameters.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/session/document.h"
#include "ui/session/file_guard.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

/// The guard of a file, and what it guards it from.
namespace sparkout::file_guard_bench {

using State = FileLock::State;
using Access = FileGuard::Access;

inline QString smallDisk; ///< a file system of 64 KB; empty: not allowed here

/// A document that guards its file, in a folder of its own.
struct Bench {
    Bench() {
        guard.protect(state.path());
        trouble::write(path, textWith(30));
    }
    void open() {
        access = guard.claim(path);
        LoadedProject loaded = loadProject(path);
        QVERIFY(loaded.setup);
        document.take(*loaded.setup, path, loaded.hash, access != Access::write);
    }
    QTemporaryDir state;
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("вал.sparkout"));
    QString lock = FileLock::lockPath(path);
    Document document;
    FileGuard guard{document};
    Access access = Access::conflict;
};

struct OpenBench : Bench {
    OpenBench() { open(); }
};

/// With a change that is not saved.
struct EditedBench : OpenBench {
    EditedBench() { setDiameter(document, 31); }
};

} // namespace sparkout::file_guard_bench
