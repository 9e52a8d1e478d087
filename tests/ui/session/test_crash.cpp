// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: measures
// Check 9: windows are killed at random moments while they are edited; what was typed must be
// offered, and no damage of the recovery files may stop a start. The windows are processes of
// their own: this program, started with --edit.
#include "core/project/part.h"
#include "core/study/new_project.h"
#include "tests/ready_made.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/form/number_field.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include "core/file/project_file.h"

#include <QDateTime>
#include <QDebug>
#include <QFileInfo>
#include <QProcess>
#include <QRandomGenerator>
#include <QTreeWidget>

#include <clocale>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace sparkout;
using namespace std::chrono_literals;

namespace {

const bool longTest = qEnvironmentVariableIsSet("SPARKOUT_LONG");
/// The ordinary test runs the same clock five times as fast.
const Autosave::Times times =
    longTest ? Autosave::Times{} : Autosave::Times{std::chrono::milliseconds(400), 6s};
/// What a busy machine may take from an edit to its file.
constexpr qint64 allowance_ms = 1500;
/// A pause after which the last edit must be in its file.
const int pause_ms = int(times.idle.count() + allowance_ms + 500);
const int pace_ms = int(times.idle.count() / 2);
const int together = longTest ? 10 : 5; ///< windows at a time, which share one folder

constexpr EditText editText{"Input", "Diameter"};

/// An edit tells its number by the diameter: 30.001 is the first.
double diameterOf(int edit) {
    return 30 + 0.001 * edit;
}

int editOf(const Project& project) {
    return qRound((project.part->diameter_mm - 30) * 1000);
}

/// A window whose unsaved work is kept in a folder.
struct GuardedWindow {
    explicit GuardedWindow(const QString& state) : window(settings, english(language)) {
        window.files().protect(state, times);
        window.resize(1366, 768);
        window.show();
    }
    static Language& english(Language& language) {
        language.apply(QStringLiteral("en"));
        return language;
    }
    Settings settings = Settings::transient();
    Language language;
    MainWindow window;
};

/// The window that is going to be killed. It edits without a pause, or in bursts with pauses, and
/// tells each edit and its time.
int editUntilKilled(QApplication& app, const QString& state, const QString& file, bool bursts) {
    GuardedWindow guarded(state);
    MainWindow& window = guarded.window;
    if (!window.files().openFile(file)) {
        return 1;
    }
    int number = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &app, [&] {
        const bool pause = bursts && (number + 1) % 5 == 0;
        timer.setInterval(pause ? pause_ms : pace_ms);
        Project project = window.document().project();
        project.part->diameter_mm = diameterOf(++number);
        window.document().edit(project, editText);
        std::printf("%d %lld\n", number, QDateTime::currentMSecsSinceEpoch());
        std::fflush(stdout);
    });
    timer.start(pace_ms);
    return QApplication::exec();
}

/// The window that is going to be killed while a new drawing is typed: it has its diameter and its
/// stock, with keys, when it says so.
int drawUntilKilled(const QString& state) {
    GuardedWindow guarded(state);
    MainWindow& window = guarded.window;
    window.files().startNew(Operation::traverse);
    for (const auto& [path, text] :
         {std::pair("/part/diameter_mm", "40"), std::pair("/part/stock_mm", "0.15")}) {
        auto* field = window.findChild<NumberField*>(QString::fromLatin1(path));
        field->setFocus();
        QTest::keyClicks(field, QString::fromLatin1(text));
        QTest::keyClick(field, Qt::Key_Return);
    }
    std::printf("typed %zu\n", window.document().openInputs().size());
    std::fflush(stdout);
    return QApplication::exec();
}

/// One killed window: what it told.
struct Victim {
    QString file;
    std::unique_ptr<QProcess> process;
    qint64 killAt_ms = 0; ///< after the first edit
    qint64 killed = 0;    ///< time of day
    std::vector<qint64> edits;

    void read() {
        for (const QByteArray& line : process->readAllStandardOutput().split('\n')) {
            if (const auto words = line.split(' '); words.size() == 2) {
                edits.push_back(words[1].toLongLong());
            }
        }
    }
};

/// A folder whose disk is never waited for: just after a build a single fsync can take longer than
/// all the times of this test.
QString inMemory() {
    const QString memory = QStringLiteral("/dev/shm");
    return (QFileInfo(memory).isWritable() ? memory : QDir::tempPath())
           + QStringLiteral("/test_crash-XXXXXX");
}

/// The last edit that had to be kept: idle time and writing were over, or the longest wait was.
int due(const Victim& victim, qint64 killed) {
    const qint64 end = killed - allowance_ms;
    int found = 0;
    for (std::size_t i = 0; i < victim.edits.size(); ++i) {
        const bool last = i + 1 == victim.edits.size();
        const qint64 next = last ? killed : victim.edits[i + 1];
        const bool rested = next - victim.edits[i] > times.idle.count() + allowance_ms;
        const bool old = end - victim.edits[i] > times.latest.count();
        if (rested || old) {
            found = int(i) + 1;
        }
    }
    return found;
}

} // namespace

class TestCrash : public QObject {
    Q_OBJECT

private slots:
    void workIsOfferedAfterEveryKill() {
        const int kills = longTest ? 50 : 5;
        const QTemporaryDir folder(inMemory());
        const QString state = folder.filePath(QStringLiteral("state"));
        int offered = 0;
        int stillThere = 0;
        int lost = 0;
        qint64 worst_ms = 0;
        QRandomGenerator chance(20261121);
        for (int round = 0; round < kills / together; ++round) {
            std::vector<Victim> victims = start(folder, state, round, chance);
            QVERIFY(!victims.empty());
            killAll(victims, state);
            const RecoveryStore store(state);
            for (const Victim& victim : victims) {
                for (int look = 0; look < 2; ++look) { // declined once: it must still be there
                    const auto content = offerOf(store, victim.file);
                    (look == 0 ? offered : stillThere) += content.has_value();
                    if (!content) {
                        qWarning() << "not offered:" << victim.file << victim.edits.size()
                                   << "edits; in the folder:"
                                   << QDir(store.folder()).entryList(QDir::Files | QDir::Hidden);
                    }
                    if (!content || look > 0) {
                        continue;
                    }
                    const int kept = editOf(*content);
                    lost += kept < due(victim, victim.killed);
                    const auto next = std::size_t(kept); // the first edit that is lost
                    if (next < victim.edits.size()) {
                        worst_ms = std::max(worst_ms, victim.killed - victim.edits[next]);
                    }
                }
                QCOMPARE(editOf(loadProject(victim.file).setup->surfaces.front().project),
                         0); // never touched
            }
            for (const RecoveryItem& item : store.left()) {
                store.discard(item.file);
            }
        }
        const bool pass = offered == kills && stillThere == kills && lost == 0
                          && worst_ms <= times.latest.count() + allowance_ms;
        std::printf("CHECK 09 %d %d %s  windows killed at random moments whose work was offered, "
                    "%d after declining; %d times an edit that was due was lost, at most %.1f s "
                    "of work of %.0f s\n",
                    offered, kills, pass ? "PASS" : "FAIL", stillThere, lost,
                    double(worst_ms) * 1e-3, double(times.latest.count()) * 1e-3);
        QVERIFY(pass);
    }

    void aDrawingThatIsNotCompleteIsOfferedToo() {
        const QTemporaryDir folder(inMemory());
        const QString state = folder.filePath(QStringLiteral("state"));
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--draw"), state});
        QByteArray said;
        QTRY_VERIFY_WITH_TIMEOUT((said += process.readAllStandardOutput()).contains('\n'), 60'000);
        QCOMPARE(said, QByteArray("typed 3\n"));
        QTest::qWait(pause_ms);
        process.kill();
        QVERIFY(process.waitForFinished());

        GuardedWindow guarded(state);
        MainWindow& window = guarded.window;
        DialogAnswers answers({QStringLiteral("recover")});
        window.files().start({});
        QVERIFY2(answers.fault().isEmpty(), qPrintable(answers.fault()));
        const auto shown = [&window](const char* path) {
            return window.findChild<NumberField*>(QString::fromLatin1(path))->text();
        };
        QCOMPARE(shown("/part/diameter_mm"), QStringLiteral("40"));
        QCOMPARE(shown("/part/stock_mm"), QStringLiteral("0.15"));
        const std::vector<std::string> open{"/part/upper_deviation_um", "/part/lower_deviation_um",
                                            "/part/length_mm"};
        QCOMPARE(window.document().openInputs(), open);
        for (const std::string& path : open) {
            QCOMPARE(shown(path.c_str()), QString());
        }
        QVERIFY(window.document().modified());
        // The deviations of a known diameter are typed as its field: 40h6.
        QCOMPARE(window.focusWidget(), window.findChild<QWidget*>(QStringLiteral("sizeField")));
    }

    void damagedRecoveryFilesStopNoStart() {
        const QTemporaryDir folder;
        const QString state = folder.filePath(QStringLiteral("state"));
        const QString file = folder.filePath(QStringLiteral("a.sparkout"));
        trouble::write(file,
                       QByteArray::fromStdString(writeProject(newProject(Operation::plunge))));
        const RecoveryStore store(state);
        QVERIFY(makePrivateFolder(store.folder()));
        RecoveryHeader header;
        header.title = QStringLiteral("good");
        const QByteArray good = QByteArray::fromStdString(
            recoveryText(header, plainSetup(newProject(Operation::traverse))));
        QRandomGenerator chance(9);
        int started = 0;
        constexpr int cases = 10;
        for (int i = 0; i < cases; ++i) {
            QByteArray bad = good;
            switch (i) {
            case 0: bad.clear(); break;
            case 1: bad.fill('\0'); break;
            case 2: bad = bad.left(bad.indexOf('\n')); break;
            case 3: bad = QByteArray(40 << 20, '['); break;
            case 4: bad = QByteArray(1 << 20, '[') + '\n' + good; break;
            default:
                for (int flip = 0; flip < 20; ++flip) {
                    bad[chance.bounded(bad.size())] = char(chance.bounded(256));
                }
            }
            trouble::write(store.folder() + QStringLiteral("/%1.recovery").arg(i), bad);
            GuardedWindow guarded(state);
            MainWindow& window = guarded.window;
            DialogAnswers answers({QStringLiteral("later")});
            int listed = 0;
            answers.seen = [&](QDialog& dialog) {
                listed = dialog.findChild<QTreeWidget*>()->topLevelItemCount();
            };
            window.files().start(file);
            const bool fine =
                answers.fault().isEmpty() && listed == i + 1 && window.document().filePath() == file
                && QFileInfo::exists(store.folder() + QStringLiteral("/%1.recovery").arg(i));
            started += fine;
            QVERIFY2(fine, qPrintable(answers.fault() + QString::number(listed)));
        }
        std::printf("CHECK 09b %d %d %s  starts with up to %d damaged recovery files\n", started,
                    cases, started == cases ? "PASS" : "FAIL", cases);
    }

private:
    static std::vector<Victim> start(const QTemporaryDir& folder, const QString& state, int round,
                                     QRandomGenerator& chance) {
        std::vector<Victim> victims;
        for (int i = 0; i < together; ++i) {
            Victim victim;
            victim.file = folder.filePath(QStringLiteral("%1-%2.sparkout").arg(round).arg(i));
            trouble::write(victim.file, QByteArray::fromStdString(
                                            writeProject(newProject(Operation::traverse))));
            victim.process = std::make_unique<QProcess>();
            const bool bursts = i % 2 == 1;
            victim.process->setProcessChannelMode(QProcess::ForwardedErrorChannel);
            victim.process->start(QCoreApplication::applicationFilePath(),
                                  {QStringLiteral("--edit"), state, victim.file,
                                   bursts ? QStringLiteral("bursts") : QStringLiteral("always")});
            // Long enough that something is due: a pause is over, or the longest wait.
            const auto latest = int(times.latest.count());
            victim.killAt_ms = bursts ? 5 * pace_ms + pause_ms + chance.bounded(latest)
                                      : latest + allowance_ms + chance.bounded(latest / 2);
            victims.push_back(std::move(victim));
        }
        return victims;
    }

    void killAll(std::vector<Victim>& victims, const QString& state) {
        const RecoveryStore store(state);
        std::size_t dead = 0;
        RunningTimer patience;
        while (dead < victims.size() && patience.elapsed() < 120'000) {
            QTest::qWait(20);
            for (Victim& victim : victims) {
                if (victim.killed != 0) {
                    continue;
                }
                victim.read();
                const qint64 now = QDateTime::currentMSecsSinceEpoch();
                // On a busy machine edits and files come late; a kill before any was due, and late
                // for long enough, would prove nothing.
                if (!victim.edits.empty() && now - victim.edits.front() >= victim.killAt_ms
                    && due(victim, now - allowance_ms) > 0) {
                    victim.killed = now;
                    victim.process->kill();
                    victim.process->waitForFinished();
                    victim.read();
                    ++dead;
                }
            }
        }
        QCOMPARE(dead, victims.size());
    }

    static std::optional<Project> offerOf(const RecoveryStore& store, const QString& file) {
        for (const RecoveryItem& item : store.left()) {
            if (item.state == RecoveryItem::State::ready && item.header.path == file) {
                const auto setup = readRecovery(trouble::bytesOf(item.file).toStdString()).setup;
                return setup ? std::optional(setup->surfaces.front().project) : std::nullopt;
            }
        }
        return {};
    }
};

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QStringList words = QCoreApplication::arguments();
    if (words.value(1) == u"--draw") {
        return drawUntilKilled(words.value(2));
    }
    if (words.value(1) == u"--edit") {
        return editUntilKilled(app, words.value(2), words.value(3), words.value(4) == u"bursts");
    }
    TestCrash test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_crash.moc"
