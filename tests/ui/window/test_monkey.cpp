// SPDX-License-Identifier: GPL-3.0-or-later
// The monkey at the window: no crash, no failed assertion, no report of a sanitizer, no warning of
// Qt, and nearly every widget reached (check 22). Two of them, of different seeds, make 5,000
// events together, with SPARKOUT_LONG ten of them 100,000; SPARKOUT_SEED and SPARKOUT_EVENTS
// choose.
#include "core/setup/setup_file.h"
#include "tests/check_line.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/ui/window/monkey.h"
#include "ui/session/document.h"

namespace sparkout::test_monkey {

// Of each of the monkeys.
constexpr int usualEvents = 2'500;
constexpr int longEvents = 10'000;
constexpr int eventsToReachAll = 5'000; ///< fewer miss by chance up to a quarter of the widgets
constexpr double leastReached = 0.9;

int eventCount() {
    const int own = qEnvironmentVariableIntValue("SPARKOUT_EVENTS");
    const bool longRun = qEnvironmentVariableIntValue("SPARKOUT_LONG") != 0;
    return own > 0 ? own : longRun ? longEvents : usualEvents;
}

quint32 seed() {
    const int own = qEnvironmentVariableIntValue("SPARKOUT_SEED");
    return own > 0 ? quint32(own) : 1u;
}

class TestMonkey : public QObject {
    Q_OBJECT

private slots:
    void aUserWithoutAPlanBreaksNothing() {
        const QString log = QStringLiteral(SPARKOUT_BUILD_DIR "/monkey-%1.log").arg(seed());
        qInfo("MONKEY seed %u, %d events, what it does is in %s", seed(), eventCount(),
              qPrintable(log));
        RunningTimer clock;
        Monkey monkey(seed(), eventCount(), log);
        const QString trouble = monkey.run();
        const double reached = 1 - double(monkey.missed().size()) / double(monkey.seen());
        qInfo("MONKEY %d events in %.1f s, %d dialogs, %d restarts, %.1f %% of %lld widgets "
              "reached",
              monkey.done(), double(clock.elapsed()) * 1e-3, monkey.dialogs(), monkey.restarts(),
              reached * 100, static_cast<long long>(monkey.seen()));
        const bool enough = eventCount() >= eventsToReachAll;
        const QString fate = !trouble.isEmpty() ? QStringLiteral("stopped by trouble")
                             : enough           ? QStringLiteral("no crash, report or warning")
                                      : QStringLiteral("no crash, report or warning; of so few "
                                                       "events the share is not judged");
        checkLine("22", reached * 100, leastReached * 100,
                  trouble.isEmpty() && (!enough || reached >= leastReached),
                  QStringLiteral("% of the widgets reached in %1 events of seed %2: %3")
                      .arg(monkey.done())
                      .arg(seed())
                      .arg(fate));
        QVERIFY2(trouble.isEmpty(), qPrintable(trouble));
        if (enough) {
            QVERIFY2(reached >= leastReached, qPrintable(monkey.missed().join(u'\n')));
            QVERIFY(monkey.dialogs() > 0);
        }

        Document& document = monkey.window().document();
        while (document.canRedo()) { // its last keys may have been Undo
            document.redo();
        }
        const Setup last = document.setup(); // which surface is in front belongs to no step
        while (document.canUndo()) {
            document.undo();
        }
        while (document.canRedo()) {
            document.redo();
        }
        QVERIFY(sameSetup(document.setup(), last));
    }
};

} // namespace sparkout::test_monkey

SPARKOUT_TEST(test_monkey, TestMonkey)
#include "test_monkey.moc"
