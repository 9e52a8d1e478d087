// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: measures
// Check 23: the window opens, computes, draws and drops projects again and again.
#include "tests/check_line.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/plot/view.h"
#include "ui/views/sweep/sweep_curves.h"
#include "ui/window/view_tabs.h"

#include <QAbstractAnimation>
#include <QFile>
#include <QPixmapCache>
#include <QSignalSpy>

#include <malloc.h>
#include <unistd.h>

namespace sparkout::test_memory {

/// Resident memory of this process [MB], after the free parts of the heap were given back.
double resident_mb() {
    QPixmapCache::clear();
    malloc_trim(0);
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) {
        return -1;
    }
    return file.readAll().split(' ').value(1).toDouble() * double(sysconf(_SC_PAGESIZE)) / 1048576;
}

/// Of the window, without what glides or fades for a moment.
qsizetype lastingObjects(const MainWindow& window) {
    const auto all = window.findChildren<QObject*>();
    return std::ranges::count_if(
        all, [](const QObject* each) { return !qobject_cast<const QAbstractAnimation*>(each); });
}

class TestMemory : public QObject {
    Q_OBJECT

private slots:
    void openingRunningAndClosingKeepsNothing() {
        const bool longTest = qEnvironmentVariableIsSet("SPARKOUT_LONG");
        const int rounds = longTest ? 2240 : 140, warmUps = longTest ? 200 : 60;
        constexpr double allowed_mb = 2;
        Bench bench(QStringLiteral("en"));
        const QStringList examples = examplePaths();
        std::vector<Project> projects;
        for (const QString& path : {examples.first(), examples.last()}) {
            QVERIFY(bench.open(path));
            projects.push_back(bench.window->document().project());
        }
        QSignalSpy shown(bench.window.get(), &MainWindow::outcomeShown);
        const auto* const sweep = bench.window->findChild<SweepCurves*>();
        QVERIFY(sweep);
        bool isSwept = false;
        double before_mb = 0;
        qsizetype objects = 0;
        for (int round = 0; round <= rounds; ++round) {
            const auto& views = bench.window->views();
            bench.window->viewTabs().showView(views[std::size_t(round / 2) % views.size()]);
            shown.clear();
            bench.window->document().startUntitled(projects[std::size_t(round) % 2]);
            QTRY_VERIFY(!shown.isEmpty());
            QCoreApplication::processEvents();    // the view draws
            if (!isSwept && sweep->isVisible()) { // on a quick machine the next round would stop it
                QTRY_VERIFY(sweep->graphCount() > 0);
                isSwept = true;
            }
            if (round % int(2 * views.size()) == 0 && round >= warmUps && objects == 0) {
                before_mb = resident_mb();
                objects = lastingObjects(*bench.window);
            }
            if (round == rounds - rounds % int(2 * views.size())) { // the same view and project
                const double after_mb = resident_mb();
                qInfo("MEMORY %d rounds after %d: %.2f MB resident, %+.2f MB; %lld objects, %+lld",
                      round - warmUps, warmUps, after_mb, after_mb - before_mb, objects,
                      lastingObjects(*bench.window) - objects);
                checkLine("23", after_mb - before_mb, allowed_mb,
                          after_mb - before_mb <= allowed_mb
                              && lastingObjects(*bench.window) <= objects,
                          QStringLiteral("MB more after %1 rounds of opening, running and showing, "
                                         "as many objects as before")
                              .arg(round - warmUps));
                QVERIFY(isSwept && objects > 0 && before_mb > 0);
                QVERIFY(lastingObjects(*bench.window) <= objects);
                QVERIFY2(after_mb - before_mb <= allowed_mb, qPrintable(QString::number(after_mb)));
            }
        }
    }
};

} // namespace sparkout::test_memory

SPARKOUT_TEST(test_memory, TestMemory)
#include "test_memory.moc"
