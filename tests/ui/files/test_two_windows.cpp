// SPDX-License-Identifier: GPL-3.0-or-later
// Check 10: two windows, one file. The other window is a process of its own: this program, started
// with --hold.
#include "core/project/part.h"
#include "core/study/new_project.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include "core/format/project_file.h"

#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <cstdio>
#include <memory>

using namespace sparkout;

namespace {

constexpr EditText editText{"Input", "Diameter"};

QByteArray textWith(double diameter_mm) {
    Project project = newProject(Operation::traverse);
    project.part->diameter_mm = diameter_mm;
    return QByteArray::fromStdString(writeProject(project));
}

/// A protected window with its settings.
struct Window {
    explicit Window(const QString& state) {
        language.apply(QStringLiteral("en"));
        window = std::make_unique<MainWindow>(settings, language);
        window->files().protect(state);
        window->show();
    }
    void edit(double diameter_mm) const {
        Project project = window->document().project();
        project.part->diameter_mm = diameter_mm;
        window->document().edit(project, editText);
    }
    Settings settings = Settings::transient();
    Language language;
    std::unique_ptr<MainWindow> window;
};

/// Opens the file and says so; "save" on the standard input saves a change; the end of it closes.
int holdFile(const QString& state, const QString& file) {
    Window other(state);
    if (!other.window->files().openFile(file)) {
        return 1;
    }
    std::puts("open");
    std::fflush(stdout);
    char line[16];
    while (std::fgets(line, sizeof line, stdin) != nullptr) {
        other.edit(50);
        std::puts(other.window->files().save() ? "saved" : "not saved");
        std::fflush(stdout);
    }
    return other.window->close() ? 0 : 1;
}

/// The folder, the file and the other window of one scene.
struct Scene {
    Scene() { trouble::write(path, textWith(30)); }

    bool startOther() {
        other.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("--hold"), state.path(), path});
        return said("open");
    }
    bool said(const char* what) {
        return other.waitForReadyRead(60'000) && other.readAllStandardOutput().trimmed() == what;
    }
    /// Opens the file here; the answers are for the questions that come.
    bool open(const QStringList& list) {
        DialogAnswers answers(list);
        const bool opened = here.window->files().openFile(path);
        fault = answers.fault();
        question = answers.text();
        return opened && fault.isEmpty();
    }
    bool save(const QStringList& list) {
        DialogAnswers answers(list);
        const bool saved = here.window->files().save();
        fault = answers.fault();
        question = answers.text();
        return saved && fault.isEmpty();
    }
    [[nodiscard]] bool readOnly() const { return here.window->document().readOnly(); }
    [[nodiscard]] QByteArray onDisk() const { return trouble::bytesOf(path); }

    QTemporaryDir state;
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("part.sparkout"));
    QString lock = FileLock::lockPath(path);
    QProcess other;
    Window here{state.path()};
    QString fault;
    QString question;
};

bool secondOpenerIsTold() {
    Scene scene;
    const bool told = scene.startOther() && scene.open({QStringLiteral("readOnly")})
                      && scene.readOnly()
                      && scene.question.contains(QString::number(scene.other.processId()))
                      && scene.question.contains(QSysInfo::machineHostName());
    // Both have edits; the one who may write saves, the other's save goes elsewhere.
    scene.here.edit(40);
    scene.other.write("save\n");
    const bool theirs = scene.said("saved") && scene.onDisk() == textWith(50);
    const bool mine = !scene.save({QStringLiteral("Escape")}) && scene.onDisk() == textWith(50);
    scene.other.closeWriteChannel();
    const bool gone = scene.other.waitForFinished() && !QFileInfo::exists(scene.lock);
    return told && theirs && mine && gone && scene.here.window->document().modified();
}

bool killedHolderStandsInNobodysWay() {
    Scene scene;
    if (!scene.startOther() || !QFileInfo::exists(scene.lock)) {
        return false;
    }
    scene.other.kill();
    scene.other.waitForFinished();
    return QFileInfo::exists(scene.lock) && scene.open({}) && !scene.readOnly();
}

bool foreignHostIsRespected() {
    Scene scene;
    const QByteArray foreign = "1\nsparkout\nanother-host\n\n\n";
    trouble::write(scene.lock, foreign);
    QFile file(scene.lock);
    const bool old =
        file.open(QIODevice::ReadWrite)
        && file.setFileTime(QDateTime::currentDateTime().addDays(-30), QFile::FileModificationTime);
    file.close();
    return old && scene.open({QStringLiteral("readOnly")}) && scene.readOnly()
           && scene.question.contains(QStringLiteral("another-host"))
           && trouble::bytesOf(scene.lock) == foreign;
}

bool garbageIsTakenOverOnRequest() {
    Scene scene;
    trouble::write(scene.lock, "\x01garbage");
    const bool stays = !scene.open({QStringLiteral("Escape")})
                       && trouble::bytesOf(scene.lock) == QByteArray("\x01garbage");
    return stays && scene.open({QStringLiteral("takeOver")}) && !scene.readOnly()
           && scene.here.window->files().guard().claim(scene.path) == FileGuard::Access::write;
}

bool readOnlyFolderIsOpenedForReading() {
    Scene scene;
    trouble::setMode(scene.folder.path(), 0555);
    bool opened = false;
    {
        const trouble::Unprivileged user;
        opened = scene.open({}) && scene.readOnly();
    }
    trouble::setMode(scene.folder.path(), 0755);
    scene.here.edit(40);
    return opened && !scene.save({QStringLiteral("Escape")}) && scene.onDisk() == textWith(30)
           && trouble::entries(scene.folder.path()) == QStringList{QStringLiteral("part.sparkout")};
}

bool changeOnTheDiskIsNotLost() {
    Scene scene;
    // The other window takes the file over and saves; this one must ask before it writes.
    if (!scene.open({})) {
        return false;
    }
    scene.here.edit(40);
    trouble::write(scene.path, textWith(50));
    const bool asked = !scene.save({QStringLiteral("Escape")}) && scene.onDisk() == textWith(50)
                       && scene.question.contains(QStringLiteral("changed by another program"));
    const bool both = scene.save({QStringLiteral("proceed")}) && scene.onDisk() == textWith(40)
                      && trouble::bytesOf(scene.path + QStringLiteral(".bak")) == textWith(50);
    return asked && both;
}

} // namespace

class TestTwoWindows : public QObject {
    Q_OBJECT

private slots:
    void noUpdateIsLost() {
        struct Case {
            const char* name;
            bool (*holds)();
        };
        const Case cases[] = {
            {"second opener", secondOpenerIsTold},
            {"killed holder", killedHolderStandsInNobodysWay},
            {"foreign host", foreignHostIsRespected},
            {"garbage lock", garbageIsTakenOverOnRequest},
            {"read-only folder", readOnlyFolderIsOpenedForReading},
            {"changed on disk", changeOnTheDiskIsNotLost},
        };
        const int repeats = qEnvironmentVariableIsSet("SPARKOUT_LONG") ? 20 : 2;
        int held = 0;
        QByteArray failed;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            for (const Case& one : cases) {
                const bool holds = one.holds();
                held += holds;
                if (!holds) {
                    failed += QByteArray(" ") + one.name + ';';
                }
            }
        }
        const int all = repeats * int(std::size(cases));
        std::printf("CHECK 10 %d %d %s  scenes of two windows and one file, %d repeats of %d;%s\n",
                    held, all, held == all ? "PASS" : "FAIL", repeats, int(std::size(cases)),
                    failed.constData());
        QVERIFY2(held == all, failed.constData());
    }
};

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QStringList words = QCoreApplication::arguments();
    if (words.value(1) == u"--hold") {
        return holdFile(words.value(2), words.value(3));
    }
    TestTwoWindows test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_two_windows.moc"
