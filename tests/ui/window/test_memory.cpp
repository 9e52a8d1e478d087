// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: measures
// Check 23: the window opens, computes, draws and drops projects again and again.
#include "tests/check_line.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/view.h"
#include "ui/window/view_tabs.h"

#include <QAbstractAnimation>
#include <QFile>
#include <QPixmapCache>
#include <QSignalSpy>

#include <algorithm>
#include <limits>
#include <vector>

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
        const auto* const sweep =
            bench.window->findChild<ChartPlot*>(QStringLiteral("sweepCurves"));
        QVERIFY(sweep);
        bool isSwept = false;
        std::vector<double> memory_mb;
        std::vector<qsizetype> objects;
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
            if (round % int(2 * views.size()) == 0 && round >= warmUps) { // the same view, project
                memory_mb.push_back(resident_mb());
                objects.push_back(lastingObjects(*bench.window));
            }
        }
        QVERIFY(isSwept && objects.size() >= 3 && memory_mb.front() > 0);
        // What is made once when it is first needed, as the text of a state that a slow machine
        // alone shows, comes in one of the turns through the views; what is lost grows in each.
        qsizetype least = std::numeric_limits<qsizetype>::max();
        double most_mb = 0;
        for (std::size_t i = 1; i < objects.size(); ++i) {
            least = std::min(least, objects[i] - objects[i - 1]);
            most_mb = std::max(most_mb, memory_mb[i] - memory_mb[i - 1]);
        }
        const double grown_mb = memory_mb.back() - memory_mb.front() - most_mb;
        qInfo("MEMORY %zu turns through the views: %.2f MB resident, %+.2f MB, of them %.2f in one "
              "turn; %lld objects, %+lld, at least %+lld in each turn",
              objects.size() - 1, memory_mb.back(), memory_mb.back() - memory_mb.front(), most_mb,
              objects.back(), objects.back() - objects.front(), least);
        checkLine("23", grown_mb, allowed_mb, grown_mb <= allowed_mb && least <= 0,
                  QStringLiteral("MB more after %1 turns of opening, running and showing, but for "
                                 "the turn with the most; no objects more in each")
                      .arg(objects.size() - 1));
        QVERIFY(least <= 0);
        QVERIFY2(grown_mb <= allowed_mb, qPrintable(QString::number(grown_mb)));
    }
};

} // namespace sparkout::test_memory

SPARKOUT_TEST(test_memory, TestMemory)
#include "test_memory.moc"
