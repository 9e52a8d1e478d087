// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: measures
// The window never stands still: a heartbeat of 5 ms beats on while values are dragged and
// projects opened. Prints the worst gap, and the worst that comes back at its time when the same is
// done again: that one is the window's own. Fails only at four times the target, so that a busy
// machine does not turn it red.
#include "core/file/project_file.h"
#include "tests/check_line.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/support/window_bench.h"
#include "tests/ui/window/long_project.h"
#include "tests/whole_project.h"
#include "ui/chart/view.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/views/study/batch_view.h"
#include "ui/window/playback_bar.h"

#include <QAction>
#include <QComboBox>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSlider>
#include <QStyleOption>
#include <QTemporaryDir>
#include <QToolButton>

#include <cmath>

namespace sparkout::test_heartbeat {

constexpr int frame_ms = 16; ///< 60 Hz
const bool longTest = qEnvironmentVariableIsSet("SPARKOUT_LONG");
const int drag_ms = longTest ? 10'000 : 4'000, play_ms = longTest ? 1500 : 700;
constexpr double window_target_ms = 50;
constexpr double limit_ms = 4 * window_target_ms;
constexpr double surfaces_target_ms = 100;            ///< of a part of five surfaces, view by view
constexpr double written_ms = 100, written99_ms = 30; ///< what reliability check 20 asks for

/// The worst gap of the first run that every other one has too, within 150 ms of its time.
double worstThatComesBack_ms(const std::vector<Beats>& runs) {
    double worst_ms = 0;
    for (const Beat& beat : runs.front()) {
        double common_ms = beat.gap_ms;
        for (const Beats& other : runs) {
            double near_ms = 0;
            for (const Beat& its : other) {
                near_ms = std::abs(its.at_ms - beat.at_ms) <= 150 ? std::max(near_ms, its.gap_ms)
                                                                  : near_ms;
            }
            common_ms = std::min(common_ms, near_ms);
        }
        worst_ms = std::max(worst_ms, common_ms);
    }
    return worst_ms;
}

/// Does it up to three times, as long as the worst gap is over the target (`leastOfTries_ms` says
/// why), prints, and gives the window's own worst gap.
double watched_ms(const char* what, const std::function<void()>& act,
                  double target_ms = window_target_ms) {
    std::vector<Beats> runs;
    leastOfTries_ms(target_ms, [&] {
        Heartbeat heart;
        act();
        runs.push_back(heart.stop());
        return worstGap_ms(runs.back());
    });
    Beats sorted = runs.front();
    std::ranges::sort(sorted, {}, &Beat::gap_ms);
    const double own_ms = worstThatComesBack_ms(runs);
    const double of99_ms = sorted[sorted.size() * 99 / 100].gap_ms;
    qInfo("HEARTBEAT %s: worst gap %.1f ms, 99 of 100 below %.1f ms, %zu beats; in all %zu runs at "
          "the same time %.1f ms, target %g ms: %s",
          what, sorted.back().gap_ms, of99_ms, sorted.size(), runs.size(), own_ms, target_ms,
          beside(own_ms, target_ms));
    checkLine(
        "20", own_ms, written_ms, own_ms <= written_ms && of99_ms <= written99_ms,
        QStringLiteral("ms, the worst gap of %1 that comes back; 99 of 100 below %2 ms, asked "
                       "%3")
            .arg(QString::fromUtf8(what))
            .arg(of99_ms, 0, 'f', 1)
            .arg(written99_ms));
    return own_ms;
}

/// A slider a person could drag now, wherever the forms have one.
QSlider* sliderInSight(MainWindow& window) {
    for (auto* slider : window.inputs().findChildren<QSlider*>()) {
        if (slider->isVisible() && slider->isEnabled() && slider->maximum() > slider->minimum()
            && slider->orientation() == Qt::Horizontal) {
            return slider;
        }
    }
    return nullptr;
}

QPoint handleOf(const QSlider& slider) {
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.orientation = slider.orientation();
    option.minimum = slider.minimum();
    option.maximum = slider.maximum();
    option.sliderPosition = slider.sliderPosition();
    option.sliderValue = slider.value();
    return slider.style()
        ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider)
        .center();
}

/// From 0 to 1 and back, every two seconds.
double swing(qint64 time_ms) {
    return 0.5 - 0.5 * std::cos(double(time_ms) * 3.141592653589793e-3);
}

void dragSlider(QSlider& slider) {
    const QPoint start = handleOf(slider);
    QTest::mousePress(&slider, Qt::LeftButton, {}, start);
    RunningTimer clock;
    while (clock.elapsed() < drag_ms) {
        const int x = 4 + int(swing(clock.elapsed()) * (slider.width() - 8));
        QTest::mouseMove(&slider, QPoint(x, start.y()));
        QTest::qWait(frame_ms);
    }
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, handleOf(slider));
}

void dragFeed(Document& document) {
    RunningTimer clock;
    while (clock.elapsed() < drag_ms) {
        Project project = document.project();
        project.cycle->stages.front().radial_feed_mm = 0.003 + 0.004 * swing(clock.elapsed());
        document.edit(std::move(project), {"Input", "Radial feed"}, QStringLiteral("drag"));
        QTest::qWait(frame_ms);
    }
    document.endMerge();
}

int pagesOf(const QString& pdf) {
    QProcess process;
    process.start(QStringLiteral("pdfinfo"), {pdf});
    process.waitForFinished();
    static const QRegularExpression line(QStringLiteral("Pages: +(\\d+)"));
    return line.match(QString::fromUtf8(process.readAll())).captured(1).toInt();
}

QString exampleWithMostVisits() {
    QString most;
    long long visits = -1;
    for (const QString& path : examplePaths()) {
        Document document;
        const bool opened = document.open(path).opened();
        const OutcomePtr outcome = opened ? evaluate(document.project(), {}) : nullptr;
        if (outcome && outcome->result.visits > visits) {
            visits = outcome->result.visits;
            most = path;
        }
    }
    return most;
}

class TestHeartbeat : public QObject {
    Q_OBJECT

private slots:
    void aValueIsDraggedForTenSeconds() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        QSlider* slider = nullptr;
        for (int page = static_cast<int>(bench.window->inputs().pages().size());
             !slider && page-- > 0;) {
            bench.window->inputs().showPage(page);
            bench.settle();
            slider = sliderInSight(*bench.window);
        }
        QSignalSpy shown(bench.window.get(), &MainWindow::outcomeShown);
        const Project before = bench.window->document().project();
        const double worst_ms = watched_ms(slider ? "dragging a slider" : "dragging a feed", [&] {
            slider ? dragSlider(*slider) : dragFeed(bench.window->document());
            bench.window->document().undo(); // the whole drag is one step
            QVERIFY(sameProject(bench.window->document().project(), before));
        });
        QTRY_VERIFY(!bench.window->runs().running());
        qInfo("HEARTBEAT outcomes shown meanwhile: %d", int(shown.count()));
        QVERIFY(shown.count() > 20); // the curves followed
        QVERIFY(worst_ms <= limit_ms);
    }

    void theLargestExampleIsOpened() {
        const QString path = exampleWithMostVisits();
        QVERIFY(!path.isEmpty());
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QByteArray what = "opening " + nameOf(path).toUtf8();
        const double worst_ms = watched_ms(what.constData(), [&] {
            for (int time = 0; time < 5; ++time) {
                QVERIFY(bench.open(path));
                QTest::qWait(100);
            }
        });
        QVERIFY(worst_ms <= limit_ms);
    }

    /// The largest example, by radius at the highest speed, in every view that follows.
    void theCycleIsPlayed() {
        OpenBench bench(QStringLiteral("en"), exampleWithMostVisits());
        auto* const unit = bench.window->findChild<QComboBox*>(QStringLiteral("playUnit"));
        auto* const speed = bench.window->findChild<QComboBox*>(QStringLiteral("playSpeed"));
        auto* const play = bench.window->findChild<QToolButton*>(QStringLiteral("play"));
        QTest::keyClick(speed, Qt::Key_End);
        for (const char* view : {"feeds", "profiles", "constraints", "layers", "compare"}) {
            QVERIFY(bench.window->showView(QLatin1String(view)));
            for (const Qt::Key last : {Qt::Key_Home, Qt::Key_End}) { // by stage … by radius
                QTest::keyClick(unit, last);
                QTest::keyClick(unit, last == Qt::Key_Home ? Qt::Key_Down : Qt::Key_End);
                const QByteArray what = QByteArray("playing the view ") + view;
                const double worst_ms = watched_ms(what.constData(), [&] {
                    bench.window->cursor().setPosition(0);
                    QTest::mouseClick(play, Qt::LeftButton);
                    QTest::qWait(play_ms);
                    bench.window->findChild<PlaybackBar*>()->setPlaying(false);
                    QVERIFY(bench.window->cursor().position() > 10);
                });
                QVERIFY(worst_ms <= limit_ms);
            }
        }
    }

    /// A hundred thousand parts in the long tests.
    void aLargeBatchIsRunAndShown() {
        const int parts = longTest ? 100'000 : 20'000;
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        QVERIFY(bench.window->showView(QStringLiteral("batch")));
        auto* const view = bench.window->findChild<BatchView*>();
        QTRY_VERIFY_WITH_TIMEOUT(!view->busy(), 60'000);
        Project project = bench.window->document().project();
        project.batch->parts = parts;
        bench.window->document().edit(project, {"Input", "Parts"});
        QTest::qWait(300);
        auto* const start = view->findChild<QPushButton*>(QStringLiteral("batchRun"));
        const QByteArray what = "a batch of " + QByteArray::number(parts) + " parts";
        const double worst_ms = watched_ms(what.constData(), [&] {
            QTest::mouseClick(start, Qt::LeftButton);
            QVERIFY(view->busy());
            QTRY_VERIFY_WITH_TIMEOUT(!view->busy() && !view->stale(), 300'000);
            QTest::qWait(300); // histograms and figures are drawn
            QCOMPARE(int(view->batch()->summary.parts), parts);
        });
        QVERIFY(worst_ms <= limit_ms);
    }

    /// A passport of a batch with as many measured blanks as fill the pages, 200 in the long tests.
    void aLongReportIsMade() {
        const int wanted = longTest ? 200 : 20;
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("passport.pdf"));
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        bench.window->document().startUntitled(
            projectOfPages(bench.window->document().project(), wanted));
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.window->studies().outcome && bench.window->studies().outcome->ran(), 60'000);
        QTest::qWait(300);
        const QByteArray what = "a report of " + QByteArray::number(wanted) + " pages";
        const double worst_ms = watched_ms(what.constData(), [&] {
            QFile::remove(path); // of an attempt before
            const DialogAnswers answers({QStringLiteral("file:") + path});
            bench.action("pdf-passport")->trigger();
            QCOMPARE(answers.fault(), QString());
        });
        const int pages = pagesOf(path);
        qInfo("HEARTBEAT the report has %d pages", pages);
        QVERIFY(pages >= wanted);
        QVERIFY(worst_ms <= limit_ms);
    }

    void everyViewIsShownAndTheWindowResized() {
        OpenBench bench(QStringLiteral("en"), exampleWithMostVisits());
        for (const View* view : bench.window->views()) { // once, as they are made when first shown
            QVERIFY(bench.window->showView(view->objectName()));
            bench.settle();
        }
        const double worst_ms = watched_ms("showing every view and resizing", [&] {
            for (const View* view : bench.window->views()) {
                QVERIFY(bench.window->showView(view->objectName()));
                QTest::qWait(100);
                for (const QSize size : {QSize(1024, 700), QSize(1366, 768)}) {
                    bench.window->resize(size);
                    QTest::qWait(60);
                }
            }
        });
        QVERIFY(worst_ms <= limit_ms);
    }

    /// Every view of each of five surfaces: each in its turn, then each surface in each view.
    void everyViewOfEverySurfaceIsShown() {
        OpenBench bench(QStringLiteral("en"),
                        QStringLiteral(SPARKOUT_SOURCE_DIR
                                       "/tests/data/setups/five-surfaces-by-hand.sparkout"));
        const std::size_t surfaces = bench.window->document().surfaceCount();
        QCOMPARE(surfaces, std::size_t(5));
        const int pause_ms = longTest ? 100 : 20;
        QSignalSpy shown(bench.window.get(), &MainWindow::outcomeShown);
        const double worst_ms = watched_ms(
            "showing every view of five surfaces",
            [&] {
                for (const View* view : bench.window->views()) {
                    QVERIFY(bench.window->showView(view->objectName()));
                    QTest::qWait(pause_ms);
                    for (std::size_t surface = 0; surface < surfaces; ++surface) {
                        shown.clear();
                        bench.window->document().showSurface(surface);
                        QTRY_VERIFY(surfaces == 1 || !shown.isEmpty() || surface == 0);
                        QTest::qWait(pause_ms);
                    }
                }
            },
            surfaces_target_ms);
        QVERIFY(worst_ms <= 4 * surfaces_target_ms);
    }

    void aProjectOfMillionsOfVisitsIsRun_data() {
        QTest::addColumn<int>("sections");
        QTest::newRow("all recorded and drawn") << 1;
        QTest::newRow("too many to draw") << 30;
    }

    void aProjectOfMillionsOfVisitsIsRun() {
        QFETCH(int, sections);
        Bench bench(QStringLiteral("en"));
        const double worst_ms = watched_ms("running millions of visits", [&] {
            QVERIFY(bench.open(examplePaths().front()));
            QSignalSpy shown(bench.window.get(), &MainWindow::outcomeShown);
            bench.window->document().startUntitled(longProject(sections));
            QTRY_VERIFY_WITH_TIMEOUT(shown.count() > 0, 60'000);
            QTest::qWait(200);
            QVERIFY(bench.window->studies().outcome->ran());
        });
        qInfo("HEARTBEAT %lld visits in %.0f ms",
              static_cast<long long>(bench.window->studies().outcome->result.visits),
              bench.window->runs().lastRun_ms());
        QVERIFY(bench.window->studies().outcome->result.visits > 1'000'000);
        QVERIFY(worst_ms <= limit_ms);
    }
};

} // namespace sparkout::test_heartbeat

SPARKOUT_TEST(test_heartbeat, TestHeartbeat)
#include "test_heartbeat.moc"
