// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of the cycle for all views of the window: the playback bar and each view move it, all
// others follow.
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/cycle/layers_view.h"
#include "ui/views/part/profiles_plot.h"
#include "ui/views/part/profiles_view.h"
#include "ui/window/playback_bar.h"
#include "ui/window/view_tabs.h"

#include <QComboBox>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>

namespace sparkout::test_shared_cycle {

struct CycleBench : Bench {
    CycleBench() : Bench(QStringLiteral("en")) {}
    [[nodiscard]] bool openFactory() {
        window->showView(QStringLiteral("feeds"));
        return open(examplePath("shaft-30h6-factory"));
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) const {
        return *window->findChild<Widget*>(QLatin1String(name));
    }
    template <typename ViewType>
    [[nodiscard]] ViewType& view() const {
        return *window->findChild<ViewType*>();
    }
    void show(const char* name) {
        QVERIFY(window->showView(QLatin1String(name)));
        settle();
    }
    void press(const char* slider, Qt::Key key) {
        part<QSlider>(slider).setFocus();
        QTest::keyClick(&part<QSlider>(slider), key);
        settle();
    }
    [[nodiscard]] CycleCursor& cycle() const { return window->cursor(); }
};

class TestSharedCycle : public QObject {
    Q_OBJECT

private slots:
    void everyViewFollowsTheBar() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        auto& feeds = *bench.view<FeedsView>().plot();
        QVERIFY(!feeds.moment_s()); // all is done
        bench.press("playSlider", Qt::Key_Home);
        for (int i = 0; i < 7; ++i) {
            bench.press("playSlider", Qt::Key_Right);
        }
        QCOMPARE(bench.cycle().stroke(), 7);
        QVERIFY(std::abs(feeds.moment_s().value_or(0) - feeds.series().strokeEnd_s(7)) < 1e-9);
        bench.show("profiles");
        QCOMPARE(bench.view<ProfilesView>().across()->series().stroke, 7);
        bench.show("layers");
        QCOMPARE(bench.view<LayersView>().plot()->done().count, std::size_t{7});
        bench.press("playSlider", Qt::Key_End);
        QCOMPARE(bench.view<LayersView>().plot()->done().count,
                 bench.view<LayersView>().plot()->series().spans.size());
        bench.show("feeds");
        QVERIFY(!feeds.moment_s());
    }

    /// The profiles are those of the very radius the cycle stands at.
    void theProfilesFollowWithinADoubleStroke() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        bench.show("profiles");
        const ProfilesPlot& across = *bench.view<ProfilesView>().across();
        bench.cycle().toStroke(4);
        const std::vector<double> before = across.series().profiles[0].radii_mm;
        for (int i = 0; i < 5; ++i) {
            bench.cycle().step(CursorUnit::radius, 1);
        }
        bench.settle();
        const std::vector<double>& now = across.series().profiles[0].radii_mm;
        QVERIFY(!across.series().strokeDone);
        QCOMPARE(across.series().stroke, 5);
        for (std::size_t k = 0; k < now.size(); ++k) {
            QVERIFY(k < 5 ? now[k] <= before[k] : now[k] == before[k]);
        }
        QVERIFY(now != before);
        QVERIFY(bench.view<ProfilesView>().accessibleDescription().startsWith(
            QStringLiteral("Within double stroke 5 of ")));
    }

    void theProfilesSliderMovesAllOthers() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        bench.show("profiles");
        bench.press("strokeSlider", Qt::Key_Home);
        QVERIFY(bench.cycle().atStart());
        bench.press("strokeSlider", Qt::Key_Right);
        QCOMPARE(bench.cycle().stroke(), 1);
        bench.show("layers");
        QCOMPARE(bench.view<LayersView>().plot()->done().count, std::size_t{1});
    }

    void aClickInTheFeedsMovesTheCycleThere() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        auto& feeds = *bench.view<FeedsView>().plot();
        const QRect cell = feeds.cell(1, 0)->rect();
        const QPoint third(cell.left() + cell.width() / 3, cell.center().y());
        QTest::mouseClick(&feeds, Qt::LeftButton, {}, third);
        bench.settle();
        const double clicked_s = feeds.scale().time_s(
            feeds.cell(1, 0)->axis(QCPAxis::atBottom)->pixelToCoord(third.x()));
        QVERIFY(feeds.moment_s().has_value());
        const double step_s = feeds.series().end_s / double(bench.cycle().count()) * 100;
        QVERIFY(*feeds.moment_s() <= clicked_s && clicked_s - *feeds.moment_s() < step_s);
        const double from_s = feeds.visibleFrom_s();
        fixtures::drag(&feeds, third, third + QPoint(60, 0)); // a drag is none
        QCOMPARE(feeds.visibleFrom_s(), from_s);
        QVERIFY(std::abs(bench.cycle().time_s() - *feeds.moment_s()) < 1e-12);
    }

    /// What is in sight turns like a page: to the next double stroke, stage, or stretch.
    void theFeedsTurnToWhereTheCycleStands() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        auto& feeds = *bench.view<FeedsView>().plot();
        auto& number = *bench.view<FeedsView>().findChild<QSpinBox*>(QStringLiteral("stroke"));
        number.setFocus();
        number.selectAll();
        QTest::keyClicks(&number, QStringLiteral("9"));
        QTest::keyClick(&number, Qt::Key_Return);
        bench.cycle().toStroke(9);
        QCOMPARE(number.value(), 9);
        bench.cycle().step(CursorUnit::step, 1);
        QCOMPARE(number.value(), 10);
        QVERIFY(feeds.visibleFrom_s() >= feeds.series().strokeEnd_s(9) - 1e-9);
        const double to_s = feeds.visibleTo_s();
        feeds.showTimes(to_s - 1, to_s); // a free choice
        bench.cycle().toStroke(30);
        QVERIFY(feeds.visibleFrom_s() <= bench.cycle().time_s()
                && bench.cycle().time_s() <= feeds.visibleTo_s());
    }

    void aNewRunKeepsTheMomentInAllViews() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        bench.cycle().toStroke(12);
        Project project = bench.window->document().project();
        project.material->flow_stress_mpa *= 1.05;
        bench.window->document().edit(std::move(project), {"Input", "Flow stress"});
        QTRY_COMPARE(bench.window->studies().outcome->result.project.material->flow_stress_mpa,
                     bench.window->document().project().material->flow_stress_mpa);
        bench.settle();
        const FeedsPlot& feeds = *bench.view<FeedsView>().plot();
        QVERIFY(std::abs(feeds.moment_s().value_or(0) - feeds.series().strokeEnd_s(12)) < 1e-9);
        bench.show("profiles");
        QCOMPARE(bench.view<ProfilesView>().stroke(), 12);
    }

    /// A view that was not in sight catches up when it is shown.
    void allFollowWhilePlaying() {
        CycleBench bench;
        QVERIFY(bench.openFactory());
        bench.show("layers");
        QTest::keyClick(&bench.part<QComboBox>("playSpeed"), Qt::Key_End);
        QTest::mouseClick(&bench.part<QToolButton>("play"), Qt::LeftButton);
        QVERIFY(bench.view<LayersView>().plot()->done().count < 5);
        QTRY_VERIFY(bench.view<LayersView>().plot()->done().count > 10);
        QTest::mouseClick(&bench.part<QToolButton>("play"), Qt::LeftButton);
        const int stroke = bench.cycle().stroke();
        QTest::qWait(100);
        QCOMPARE(bench.cycle().stroke(), stroke);
        bench.show("feeds");
        const FeedsPlot& feeds = *bench.view<FeedsView>().plot();
        QVERIFY(std::abs(feeds.moment_s().value_or(0) - bench.cycle().time_s()) < 1e-12);
    }
};

} // namespace sparkout::test_shared_cycle

SPARKOUT_TEST(test_shared_cycle, TestSharedCycle)
#include "test_shared_cycle.moc"
