// SPDX-License-Identifier: GPL-3.0-or-later
// The traces of a cycle below the feeds: measured, simulated, difference, over the same times.
#include "tests/registry.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/traced_project.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/kit/font_size.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/cycle/traces_plot.h"
#include "ui/window/view_tabs.h"

#include <QScopeGuard>
#include <QScrollArea>

namespace sparkout::test_traces_plot {

using namespace fixtures;

/// A window with a project in the view of the feeds, its traces compared.
struct Shown {
    explicit Shown(const Project& project, const QString& language = QStringLiteral("en"))
        : bench(language) {
        bench.window->document().startUntitled(project);
        bench.window->showView(QStringLiteral("feeds"));
        view = bench.window->findChild<FeedsView*>();
        wait();
    }
    void wait() {
        (void)QTest::qWaitFor([this] { return !bench.window->runs().running() && !view->busy(); },
                              30'000);
        bench.settle();
        (void)QTest::qWaitFor([this] { return !view->busy(); }, 30'000);
        bench.settle();
    }
    [[nodiscard]] TracesPlot& traces() const { return *view->traces(); }

    Bench bench;
    FeedsView* view;
};

bool hasEntry(const FeedsView& view, int key) {
    return std::ranges::any_of(view.legend()->entries(),
                               [key](const LegendEntry& entry) { return entry.key == key; });
}

double range(const QCPAxisRect* rect, bool upper) {
    const QCPRange range = rect->axis(QCPAxis::atBottom)->range();
    return upper ? range.upper : range.lower;
}

class TestTracesPlot : public QObject {
    Q_OBJECT

private slots:
    void withoutTracesNothingIsThere() {
        Shown shown(traced::plunge());
        QVERIFY(!shown.traces().isVisible());
        QVERIFY(shown.traces().isEmpty());
        QVERIFY(!hasEntry(*shown.view, TracesPlot::measuredKey));
        const auto* area = shown.view->findChild<QScrollArea*>(QStringLiteral("feedsArea"));
        QCOMPARE(shown.view->plot()->size(), area->widget()->size());
    }

    void eachQuantityHasItsCellWithItsRms() {
        Shown shown(traced::project(true, 2));
        TracesPlot& traces = shown.traces();
        QVERIFY(traces.isVisible());
        QCOMPARE(traces.cellCount(), std::size_t{2});
        QVERIFY2(
            traces.chart(0).headings.value(0).contains(QStringLiteral("size at the gauge: RMS "))
                && traces.chart(0).headings.value(0).endsWith(QStringLiteral("µm")),
            qPrintable(traces.chart(0).headings.value(0)));
        QVERIFY2(traces.chart(1).headings.value(0).endsWith(QStringLiteral("kW")),
                 qPrintable(traces.chart(1).headings.value(0)));
        for (const auto key :
             {TracesPlot::measuredKey, TracesPlot::simulatedKey, TracesPlot::differenceKey}) {
            QVERIFY(hasEntry(*shown.view, key));
            QVERIFY(traces.chart(0).find(key)->points.size() > 50);
        }
        // Aligned: the trace's beginning before the cycle is not drawn.
        const auto& measured = traces.chart(0).find(TracesPlot::measuredKey)->points;
        QVERIFY(measured.front().x >= 0);
        const auto last = shown.view->plot()->scale().at(shown.view->plot()->series().end_s);
        QVERIFY(measured.back().x <= last + 1e-9);
    }

    void theTimesAreThoseOfTheFeeds() {
        Shown shown(traced::project(true));
        TracesPlot& traces = shown.traces();
        FeedsPlot& feeds = *shown.view->plot();
        const auto same = [&] {
            for (std::size_t i = 0; i < traces.cellCount(); ++i) {
                if (std::abs(range(&traces.cell(i), false) - range(feeds.cell(0, 0), false)) > 1e-9
                    || std::abs(range(&traces.cell(i), true) - range(feeds.cell(0, 0), true))
                           > 1e-9) {
                    return false;
                }
            }
            return true;
        };
        QVERIFY(same());
        const double before = range(feeds.cell(0, 0), true) - range(feeds.cell(0, 0), false);
        wheel(&feeds, feeds.cell(0, 0)->rect().center(), 240);
        shown.bench.settle();
        const double zoomed = range(feeds.cell(0, 0), true) - range(feeds.cell(0, 0), false);
        QVERIFY(zoomed < 0.95 * before);
        QVERIFY(same());
        wheel(&traces, traces.cell(1).rect().center(), 240);
        shown.bench.settle();
        QVERIFY(range(feeds.cell(0, 0), true) - range(feeds.cell(0, 0), false) < 0.95 * zoomed);
        QVERIFY(same());
        feeds.setFocus();
        QTest::keyClick(&feeds, Qt::Key_Home);
        shown.bench.settle();
        QVERIFY(same());
    }

    void aClickInTheLegendHidesACurve() {
        Shown shown(traced::project());
        LegendStrip& legend = *shown.view->legend();
        const auto& entries = legend.entries();
        const auto found =
            std::ranges::find(entries, int(TracesPlot::differenceKey), &LegendEntry::key);
        QVERIFY(found != entries.end());
        const int index = static_cast<int>(found - entries.begin());
        QVERIFY(shown.traces().shows(TracesPlot::differenceKey));
        const int drawn = shown.traces().graphCount();
        QTest::mouseClick(&legend, Qt::LeftButton, {}, legend.entryRect(index).center());
        QVERIFY(!shown.traces().shows(TracesPlot::differenceKey));
        QCOMPARE(shown.traces().graphCount(), drawn - static_cast<int>(shown.traces().cellCount()));
        QVERIFY(shown.traces().table().header.filter(QStringLiteral("less")).isEmpty());
    }

    void pointerCursorsAndTableTellTheValues() {
        Shown shown(traced::project(true));
        TracesPlot& traces = shown.traces();
        QSignalSpy pointed(&traces, &ViewPlot::pointed);
        hover(&traces, traces.cell(0).rect().center());
        QVERIFY(!pointed.isEmpty());
        const QString text = pointed.last().front().toString();
        QVERIFY2(text.contains(QStringLiteral("measured"))
                     && text.contains(QStringLiteral("simulated")),
                 qPrintable(text));
        shown.view->cursors()->toggle->trigger();
        QVERIFY(traces.cursors()->shown());
        const double place = traces.cell(0).axis(QCPAxis::atBottom)->range().center();
        shown.view->cursors()->moveTo(0, place);
        QCOMPARE(traces.cursors()->at(0), shown.view->cursors()->at(0));
        const ReadCurves curves = shown.view->plot()->readCurves();
        QVERIFY(std::ranges::any_of(curves, [&](const ReadCurve& curve) {
            return curve.group == QStringLiteral("measured") && curve.at(place);
        }));
        const CsvTable table = traces.table();
        QVERIFY(table.rows.size() > 100);
        QCOMPARE(table.rows.front().size(), std::size_t(table.header.size()));
    }

    void anotherInputMovesTheSimulatedCurve() {
        Shown shown(traced::project());
        const QString before = shown.traces().chart(0).headings.value(0);
        Project changed = shown.bench.window->document().project();
        const Project truth = traced::truth();
        changed.machine->compliance_mm_per_n = truth.machine->compliance_mm_per_n;
        changed.wheel->dullness = truth.wheel->dullness;
        shown.bench.window->document().edit(changed, {});
        shown.wait();
        QVERIFY(shown.traces().chart(0).headings.value(0) != before);
        changed.measured.reset();
        shown.bench.window->document().edit(changed, {});
        shown.wait();
        QVERIFY(!shown.traces().isVisible());
    }

    void thePlotsAreLegibleAtAnySize_data() { addLanguagesAndSizes(); }

    void thePlotsAreLegibleAtAnySize() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        applyFontSize(percent);
        Shown shown(traced::project(true), language);
        QTest::qWait(60);
        shown.bench.settle();
        QCOMPARE(shown.bench.window->size(), QSize(1366, 768));
        for (std::size_t i = 0; i < shown.traces().cellCount(); ++i) {
            const QCPAxisRect* rect = &shown.traces().cell(i);
            qInfo("ROOM trace at %d %% %d × %d", percent, rect->width(), rect->height());
            QVERIFY(rect->width() >= 120 && rect->height() >= 80);
        }
        for (const QCPAxisRect* rect : shown.view->plot()->axisRects()) {
            QVERIFY(rect->width() >= 120 && rect->height() >= 80);
        }
        const QStringList narrow = textsWithoutRoom(*shown.view);
        QVERIFY2(narrow.isEmpty(), qPrintable(narrow.join(u'\n')));
        if (language == u"ru") {
            for (std::size_t i = 0; i < shown.traces().cellCount(); ++i) {
                QVERIFY(englishIn(shown.traces().chart(i).headings.value(0)).isEmpty());
            }
            for (const LegendEntry& entry : shown.traces().legendEntries()) {
                QVERIFY(englishIn(entry.text).isEmpty());
            }
        }
        if (const QString to = qEnvironmentVariable("SPARKOUT_PICTURES"); !to.isEmpty()) {
            shown.bench.window->grab().save(
                QStringLiteral("%1/traces-%2-%3.png").arg(to, language).arg(percent));
        }
    }
};

} // namespace sparkout::test_traces_plot

SPARKOUT_TEST(test_traces_plot, TestTracesPlot)
#include "test_traces_plot.moc"
