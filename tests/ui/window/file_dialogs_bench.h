// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/project_file.h"
#include "core/project/part.h"
#include "core/study/new_project.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/diameters.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <chrono>
#include <memory>

/// The window with a project of its own, whose questions about files are answered.
namespace sparkout::file_dialogs_bench {

using namespace std::chrono_literals;

/// A protected window with a project in a folder of its own.
struct Bench {
    explicit Bench(const QString& code = QStringLiteral("en"), const QString& stateFolder = {}) {
        language.apply(code);
        window = std::make_unique<MainWindow>(settings, language);
        window->files().protect(stateFolder.isEmpty() ? state.path() : stateFolder, {20ms, 200ms});
        window->resize(1366, 768);
        window->show();
        trouble::write(path, textWith(30));
    }
    [[nodiscard]] bool open() { return window->files().openFile(path); }
    void edit(double diameter_mm) { setDiameter(document(), diameter_mm); }
    [[nodiscard]] Document& document() { return window->document(); }
    [[nodiscard]] double diameter() { return document().project().part->diameter_mm; }
    [[nodiscard]] QPushButton* noticeButton(const char* key, int index) {
        auto* row = window->findChild<QWidget*>(QStringLiteral("notice ") + QString::fromUtf8(key));
        return row ? row->findChildren<QPushButton*>().value(index) : nullptr;
    }

    QTemporaryDir folder;
    QTemporaryDir state;
    QString path = folder.filePath(QStringLiteral("вал <b>.sparkout"));
    QString lock = FileLock::lockPath(path);
    QString other = folder.filePath(QStringLiteral("other.sparkout"));
    Settings settings = Settings::transient();
    Language language;
    std::unique_ptr<MainWindow> window;
};

struct OpenBench : Bench {
    OpenBench() { QVERIFY(open()); }
};

/// With a change that is not saved.
struct EditedBench : OpenBench {
    EditedBench() { edit(31); }
};

} // namespace sparkout::file_dialogs_bench

#define ANSWERED(answers) QVERIFY2((answers).fault().isEmpty(), qPrintable((answers).fault()))
