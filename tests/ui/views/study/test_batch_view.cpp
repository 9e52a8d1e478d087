// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The view "Batch": its figures are the engine's, a stop keeps what was done, the newest wins, the
// worst part is reproduced by its inputs.
#include "core/batch/batch_run.h"
#include "core/quality/constraints.h"
#include "core/simulation/simulate.h"
#include "core/study/batch_edits.h"
#include "core/study/outcome.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/chart_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/session/project_io.h"
#include "ui/text/judgement_text.h"
#include "ui/views/study/batch_charts.h"
#include "ui/views/study/batch_text.h"
#include "ui/views/study/batch_view.h"
#include "ui/views/study/sensitivity_plot.h"
#include "ui/window/view_tabs.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>

#include <atomic>
#include <string_view>

namespace sparkout::test_batch_view {

constexpr int patience_ms = 60'000;
constexpr int endless = 1'000'000; ///< parts: a minute or so, too many to run by itself

OutcomePtr run(const Project& project) {
    return evaluate(project, {});
}

/// A shipped project with a batch.
QString shippedBatch() {
    const QStringList paths = examplePaths();
    return *std::ranges::find_if(paths, [](const QString& path) {
        return nameOf(path) == QStringLiteral("shaft-30h6-factory");
    });
}

/// A view as it stands in the window.
struct Bench {
    explicit Bench(const Project& project) {
        view.resize(700, 520);
        view.show();
        view.setOutcome(run(project));
        QTest::qWait(20);
    }
    /// Waits until a batch is shown and none runs.
    [[nodiscard]] bool settled() {
        return QTest::qWaitFor([this] { return view.batch() && !view.busy(); }, patience_ms);
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) {
        return *view.findChild<Widget*>(QString::fromLatin1(name));
    }
    void click(const char* button) {
        QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton);
    }
    void choose(const char* characteristic) {
        auto& box = part<QComboBox>("batchCharacteristic");
        box.setCurrentIndex(box.findData(QString::fromLatin1(characteristic)));
    }
    BatchView view;
};

struct SettledBench : Bench {
    explicit SettledBench(const Project& project) : Bench(project) { QVERIFY(settled()); }
};

/// A cell of the figures on the screen.
QString cell(Bench& bench, const char* key, int column) {
    const auto& model =
        dynamic_cast<const ValueModel&>(*bench.part<CopyTable>("batchFigures").model());
    const auto row = std::ranges::find_if(model.table().rows, [key](const ValueHead& head) {
        return std::string_view(head.key) == key;
    });
    return model.index(static_cast<int>(row - model.table().rows.begin()), column)
        .data()
        .toString();
}

class TestBatchView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void aQuickBatchRunsByItselfAndShowsTheFiguresOfTheEngine() {
        const Project project = fixtures::shaftBatch(50);
        SettledBench bench(project);
        const BatchSummary engine = summarise(runBatch(project));
        for (const char* name : {"diameter", "radial_runout", "time"}) {
            bench.choose(name);
            const std::vector<std::size_t> places = placesOf(engine, name);
            const QAbstractItemModel* model = bench.part<CopyTable>("batchFigures").model();
            QCOMPARE(model->columnCount(), static_cast<int>(places.size()));
            QCOMPARE(bench.view.histograms()->cellCount(), places.size());
            for (int column = 0; column < model->columnCount(); ++column) {
                const CharacteristicSummary& of =
                    engine.characteristics[places[static_cast<std::size_t>(column)]];
                const auto value = [&of](double v) {
                    return BatchText::value(v, of.characteristic);
                };
                QCOMPARE(cell(bench, "min", column), value(of.least.value));
                QCOMPARE(cell(bench, "max", column), value(of.most.value));
                QCOMPARE(cell(bench, "mean", column), value(of.moments.mean));
                QCOMPARE(cell(bench, "standard_deviation", column), value(of.moments.deviation));
                QCOMPARE(cell(bench, "ppk", column), BatchText::capability(of.ppk));
            }
        }
    }

    void lowerBoundNextToItsLimitHasMoreDigits() {
        Estimate ppk;
        ppk.value = 1.26;
        ppk.interval = {0.997, 1.53};
        QCOMPARE(BatchText::capability(ppk), QStringLiteral("1.26 (1.00…1.53)"));
        QCOMPARE(BatchText::capability(ppk, 1.0), QStringLiteral("1.260 (0.997…1.530)"));
        QCOMPARE(BatchText::capability(ppk, 1.33), QStringLiteral("1.26 (1.00…1.53)"));
    }

    void aPercentileIsToldOfEnoughValuesAlone() {
        CharacteristicSummary of;
        of.characteristic.resolution = 0.01;
        const Percentile low{0.00135, -5, {}}, middle{0.5, 1, {}}, high{0.99865, 7, {}};
        for (const auto& [count, extremes] : {std::pair(740, false), std::pair(741, true)}) {
            of.count = count;
            QCOMPARE(BatchText::percentile(low, of) != QStringLiteral("–"), extremes);
            QCOMPARE(BatchText::percentile(high, of) != QStringLiteral("–"), extremes);
            QCOMPARE(BatchText::percentile(middle, of), QStringLiteral("1.00"));
        }
        QCOMPARE(BatchText::percentile(high, of), QStringLiteral("7.00"));
    }

    void theCopiedTableHasEveryCharacteristicWithAllItsDigits() {
        const Project project = fixtures::shaftBatch(50);
        SettledBench bench(project);
        auto& table = bench.part<CopyTable>("batchFigures");
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QGuiApplication::clipboard()->text().trimmed().split(u'\n');
        const BatchSummary engine = summarise(runBatch(project));
        QCOMPARE(lines.size(), static_cast<qsizetype>(engine.characteristics.size()) + 1);
        const QStringList heads = lines.first().split(u'\t');
        const qsizetype mean = heads.indexOf(QStringLiteral("Mean"));
        const qsizetype low = heads.indexOf(QStringLiteral("Percentile 0.135 %"));
        QVERIFY(low >= 0);
        for (std::size_t i = 0; i < engine.characteristics.size(); ++i) {
            const QStringList cells = lines[static_cast<qsizetype>(i) + 1].split(u'\t');
            QCOMPARE(cells[mean].toDouble(), engine.characteristics[i].moments.mean);
            QVERIFY(cells[low].isEmpty()); // of 50 parts it would be the minimum
        }
    }

    void aLongBatchWaitsForRunAndAStopKeepsWhatWasDone() {
        Bench bench(fixtures::shaftBatch(endless));
        QVERIFY(!bench.view.busy() && !bench.view.batch());
        QVERIFY(bench.part<QLabel>("batchNotice").isVisible());
        bench.click("batchRun");
        QVERIFY(bench.view.busy());
        QTest::qWait(300);
        bench.click("batchStop");
        QVERIFY(bench.settled());
        const BatchSummary& kept = bench.view.batch()->summary;
        QVERIFY(kept.parts > 0 && kept.parts < endless);
        QVERIFY(bench.part<QLabel>("batchState").text().contains(QString::number(kept.parts)));
        QVERIFY(bench.part<QPushButton>("batchRun").isEnabled());
        QVERIFY(!bench.part<QPushButton>("batchStop").isEnabled());
    }

    void afterAnEditTheBatchIsMarkedAndTheNewestWins() {
        SettledBench bench(fixtures::shaftBatch(50));
        Project edited = fixtures::shaftBatch(endless);
        edited.batch->seed = 7;
        bench.view.setOutcome(run(edited));
        QTest::qWait(20);
        QVERIFY(bench.view.stale());
        QVERIFY(bench.part<QLabel>("batchNotice").isVisible());
        QVERIFY(!bench.part<QPushButton>("batchWorst").isEnabled());
        bench.click("batchRun");
        Project newest = fixtures::shaftBatch(40);
        bench.view.setOutcome(run(newest));
        QTest::qWait(20);
        QVERIFY(bench.settled());
        QCOMPARE(bench.view.batch()->summary.parts, std::int64_t{40});
        QVERIFY(!bench.view.stale());
        QVERIFY(!bench.part<QLabel>("batchNotice").isVisible());
    }

    void theWorstPartIsTakenOfTheSameProjectAlone() {
        Project project = fixtures::shaftBatch(50);
        project.title = "Mine";
        SettledBench bench(project);
        Project taken = project;
        QSignalSpy edits(&bench.view, &BatchView::editWanted);
        bool refused = false;
        connect(&bench.view, &BatchView::runWanted, this,
                [&taken, &refused](const auto& inputs, const QString&) {
                    Project other = taken;
                    other.part->stock_mm *= 1.5;
                    refused = !inputs(other);
                    taken = inputs(taken).value_or(Project{});
                });
        bench.click("batchWorst");
        QVERIFY(refused);           // of a project edited meanwhile no part is a part of this batch
        QCOMPARE(edits.count(), 0); // the project stays as it is
        QCOMPARE(QString::fromStdString(taken.title), QStringLiteral("Mine"));
        QVERIFY(taken.batch.has_value() && !sameBatch(taken, project));
        // Its numbers are short, so it is the same part to what can be seen of it.
        QCOMPARE(QString::number(taken.part->stock_mm, 'g', 6).toDouble(), taken.part->stock_mm);
        QCOMPARE(QString::number(taken.wheel->dullness, 'g', 6).toDouble(), taken.wheel->dullness);
        PartOutcome alone;
        measure(run(taken)->result, characteristicsOf(taken), alone);
        const BatchResult& result = bench.view.batch()->result;
        const auto row =
            std::ranges::find(result.statistics.rows, result.statistics.worst.part, &PartRow::part);
        QVERIFY(row != result.statistics.rows.end());
        QCOMPARE(alone.values.size(), row->values.size());
        for (std::size_t i = 0; i < alone.values.size(); ++i) {
            QVERIFY(std::abs(alone.values[i] - row->values[i]) < 0.005);
        }
        QVERIFY(std::abs(alone.margin - result.statistics.worst.value) < 1e-3);
    }

    // A surface with strips left uncut is drawn as if it were whole: each view says so.
    void uncutStripsAreMarkedOverTheirPlots() {
        sparkout::Bench bench(QStringLiteral("en"));
        Project project = fixtures::shaftBatch(20);
        const QString mark = QStringLiteral("Strips stay uncut");
        const auto show = [&bench](const Project& shown) {
            QSignalSpy drawn(bench.window.get(), &MainWindow::outcomeShown);
            bench.window->document().edit(shown, {"Input", "Axial feed"});
            QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, patience_ms);
        };
        const auto marked = [&](const char* view, const char* notice) {
            if (!bench.window->showView(QString::fromUtf8(view))) {
                return -1;
            }
            View* const shown = bench.window->viewTabs().currentView();
            auto* const label = shown->findChild<QLabel*>(QString::fromUtf8(notice));
            if (auto* batch = qobject_cast<BatchView*>(shown)) {
                (void)QTest::qWaitFor([&] { return batch->batch() && !batch->stale(); },
                                      patience_ms);
            }
            QTest::qWait(50);
            return int(label->isVisible() && label->text().contains(mark));
        };
        const auto count = [&] {
            return marked("profiles", "profilesNotice") + marked("layers", "layersNotice")
                   + marked("batch", "batchNotice");
        };
        show(project);
        QCOMPARE(count(), 0);
        for (Stage& stage : project.cycle->stages) {
            stage.axial_feed_mm_min =
                1.25 * project.wheel->width_mm * project.machine->work_speed_rpm;
        }
        show(project);
        QCOMPARE(count(), 3);
        auto* label = bench.window->findChild<QLabel*>(QStringLiteral("batchNotice"));
        QVERIFY(label->text().contains(QStringLiteral("0.8")));
        QVERIFY(bench.window->findChild<BatchView*>()->histograms()->isVisible());
    }

    void aWorstPartThatTakesItsTimeIsShownAndCanBeStopped() {
        const auto held = std::make_shared<std::atomic<bool>>(false);
        sparkout::Bench window(QStringLiteral("en"), Theme::light,
                               [held](const Project& project, const std::stop_token& stop) {
                                   while (*held && !stop.stop_requested()) {
                                       QThread::msleep(5);
                                   }
                                   return evaluate(project, stop);
                               });
        QVERIFY(window.open(shippedBatch()));
        QVERIFY(window.window->showView(QStringLiteral("batch")));
        auto* worst = window.window->findChild<QPushButton*>(QStringLiteral("batchWorst"));
        QTRY_VERIFY_WITH_TIMEOUT(worst->isEnabled(), patience_ms);
        const auto runs = [&window]() -> const std::vector<KeptRun>& {
            return window.window->document().project().runs;
        };
        const std::size_t before = runs().size();
        const double stock_mm = window.window->document().project().part->stock_mm;
        const auto notice = [&window] {
            return window.window->findChild<QWidget*>(QStringLiteral("notice run-aside"));
        };
        *held = true;
        QTest::mouseClick(worst, Qt::LeftButton);
        QTRY_VERIFY(notice() && notice()->isVisible());
        QVERIFY(notice()->findChild<QLabel*>() != nullptr);
        QTest::mouseClick(notice()->findChildren<QPushButton*>().constFirst(), Qt::LeftButton);
        QTRY_VERIFY(!notice());
        QTest::qWait(50);
        QCOMPARE(runs().size(), before);
        QTest::mouseClick(worst, Qt::LeftButton);
        QTRY_VERIFY(notice());
        *held = false;
        QTRY_COMPARE_WITH_TIMEOUT(runs().size(), before + 1, patience_ms);
        QTRY_VERIFY(!notice());
        QCOMPARE(window.window->document().project().part->stock_mm, stock_mm);
        QCOMPARE(window.window->viewTabs().currentView()->objectName(), QStringLiteral("compare"));
        const std::string name = runs().back().name;
        QVERIFY(name.starts_with("Worst part"));
        QVERIFY(window.window->showView(QStringLiteral("batch")));
        QTRY_VERIFY_WITH_TIMEOUT(worst->isEnabled(), patience_ms);
        QTest::mouseClick(worst, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(runs().size(), before + 2, patience_ms);
        QCOMPARE(runs().back().name, name + " (2)");
    }

    /// No share that is more than nothing reads as nothing, none short of all as all.
    void sharesAreShownWithTheDigitsTheyNeed() {
        const QString none = BatchText::share({0, 0.0, Interval{0.0, 0.000369}});
        QVERIFY2(none.contains(QStringLiteral("0…0.04")), qPrintable(none));
        const QString most = BatchText::share({9999, 0.9999, Interval{0.9994, 1.0}});
        QVERIFY2(most.contains(QStringLiteral("99.99")), qPrintable(most));
        QVERIFY2(most.contains(QStringLiteral("99.94…100")), qPrintable(most));
        const QString some = BatchText::share({30, 0.03, Interval{0.021, 0.25}});
        QVERIFY2(some.contains(QStringLiteral("2.1…25")), qPrintable(some));
    }

    void rejectsAreShownByCauseTheMostFrequentFirst() {
        Project project = fixtures::shaftBatch(60);
        project.part->tolerance.roundness_um = 1e-6;
        project.part->tolerance.radial_runout_um = 1e-6;
        SettledBench bench(project);
        bench.part<QComboBox>("batchContent").setCurrentIndex(3);
        ChartPlot& plot = bench.part<ChartPlot>("batchPareto");
        const std::vector<RejectCause>& causes = bench.view.batch()->summary.causes;
        QVERIFY(plot.isVisible() && !causes.empty());
        const std::vector<XY>& bars = plot.chart().find(BatchCharts::partsKey)->points;
        const std::vector<XY>& sums = plot.chart().find(BatchCharts::sumKey)->points;
        QCOMPARE(bars.size(), causes.size());
        QVERIFY(plot.chart().across.names->contains(QStringLiteral("Roundness")));
        double sum = 0, last = HUGE_VAL;
        for (std::size_t i = 0; i < causes.size(); ++i) {
            QCOMPARE(bars[i].y, static_cast<double>(causes[i].count));
            QVERIFY(bars[i].y <= last);
            last = bars[i].y;
            sum += last;
        }
        QCOMPARE(sums.back().y, 100.0);
        QVERIFY(std::abs(sums[0].y - 100 * static_cast<double>(causes[0].count) / sum) < 1e-9);
        QVERIFY(plot.up().range().contains(bars[0].y)); // the longest bar is in sight
        plot.replot();
        fixtures::hover(&plot, plot.pixelOf(bars[0]) - QPointF(2, 0));
        QVERIFY(
            bench.part<QLabel>("batchValues").text().startsWith(plot.chart().across.names->at(0)));
    }

    void aMovedRangeIsKeptForTheSameCharacteristic() {
        SettledBench bench(fixtures::shaftBatch(50));
        const ChartPlot& plot = *bench.view.histograms();
        const QCPRange moved(-12, -4);
        plot.across().setRange(moved);
        bench.view.tellIndices(false); // the same batch again
        QCOMPARE(plot.across().range(), moved);
        bench.choose("radial_runout");
        QVERIFY(plot.across().range() != moved);
    }

    void textsBelowNarrowCellsDoNotMeet() {
        SettledBench bench(fixtures::shaftBatch(50));
        ChartPlot& plot = *bench.view.histograms();
        QFont font = bench.view.font();
        font.setPointSizeF(font.pointSizeF() * 1.3);
        bench.view.setFont(font);
        for (const int width : {1600, 450}) {
            bench.view.resize(width, 640);
            QTest::qWait(20);
            plot.replot();
            QVERIFY(plot.caption()->text().contains(u','));
            QVERIFY(QFontMetrics(plot.caption()->font()).horizontalAdvance(plot.caption()->text())
                    <= plot.width());
            for (std::size_t i = 0; i < plot.cellCount(); ++i) {
                const QCPAxis& axis = plot.across(i);
                int taken = 0;
                for (const QString& tick : axis.tickVectorLabels()) {
                    taken += QFontMetrics(axis.tickLabelFont()).horizontalAdvance(tick + u' ');
                }
                QVERIFY2(taken <= axis.axisRect()->width(),
                         qPrintable(axis.tickVectorLabels().join(u' ')));
            }
        }
    }

    void theTextOnTheRunIsReadInANarrowViewAndInLargeType() {
        SettledBench bench(fixtures::shaftBatch(50));
        QFont font = bench.view.font();
        font.setPointSizeF(font.pointSizeF() * 1.3);
        bench.view.setFont(font);
        bench.view.resize(450, 640);
        const auto& state = bench.part<QLabel>("batchState");
        const auto& worst = bench.part<QPushButton>("batchWorst");
        QTRY_VERIFY(state.width() >= 30 * state.fontMetrics().averageCharWidth());
        QTRY_VERIFY(state.height() >= state.heightForWidth(state.width()));
        QVERIFY(!state.geometry().intersects(worst.geometry()));
        QVERIFY(state.parentWidget()->rect().contains(state.geometry()));
        bench.view.resize(1400, 640); // beside the buttons again
        QTRY_VERIFY(state.geometry().left() > worst.geometry().right());
        QVERIFY(state.geometry().top() <= worst.geometry().bottom());
    }

    void withoutABatchAUsualOneIsOffered() {
        Project project = fixtures::shaftBatch(50);
        project.batch.reset();
        Bench bench(project);
        QVERIFY(!bench.view.batch());
        QVERIFY(bench.part<QLabel>("batchNotice").isVisible());
        Project taken = project;
        connect(&bench.view, &BatchView::editWanted, this,
                [&taken](const auto& edit, const EditText&) { taken = edit(taken); });
        bench.click("batchAdd");
        QVERIFY(taken.batch.has_value());
        bench.view.setOutcome(run(taken));
        QTest::qWait(20);
        QVERIFY(bench.settled());
        QCOMPARE(bench.view.batch()->summary.parts, std::int64_t{50});
    }

    void whatNothingDecidesIsSaidBesideTheVerdict() {
        Project project = fixtures::shaftBatch(50);
        project.part->tolerance.roundness_um = 5; // of a machine that is not known
        SettledBench bench(project);
        const std::vector<Undecided> open =
            undecided(project, evaluateConstraints(simulate(project)));
        QCOMPARE(open.size(), std::size_t{1});
        const QString said = bench.part<QLabel>("batchState").text();
        QVERIFY2(
            said.contains(
                QStringLiteral("Not decided: %1.").arg(JudgementText::lines(open).join(QString()))),
            qPrintable(said));
    }

    void aBatchThatCannotBeRunSaysWhy() {
        Project project = fixtures::shaftBatch(50);
        project.batch->factors.dullness = fixtures::uniform(0.03, 0.01);
        Bench bench(project);
        auto& notice = bench.part<QLabel>("batchNotice");
        QTRY_VERIFY(notice.text().contains(QStringLiteral("0.03")));
        QVERIFY(!bench.view.batch());
    }

    void cornersTellExtremesAndCountsOnly() {
        Project project = fixtures::shaftBatch(50);
        project.batch->scenarios = Scenarios::corners;
        SettledBench bench(project);
        QCOMPARE(bench.view.batch()->summary.parts, std::int64_t{8});
        QVERIFY(cell(bench, "max", 0) != QStringLiteral("–"));
        for (const char* row :
             {"mean", "standard_deviation", "ppk", "median", "normality_probability"}) {
            QCOMPARE(cell(bench, row, 0), QStringLiteral("–"));
        }
    }

    void theWeightsAreTheRankRegressionOfTheEngineThenItsSobolIndices() {
        const Project project = fixtures::shaftBatch(50);
        SettledBench bench(project);
        bench.part<QComboBox>("batchContent").setCurrentIndex(1);
        const BatchResult result = runBatch(project);
        const std::vector<std::size_t> places = placesOf(summarise(result), "diameter");
        const auto regressions = rankRegressions(result);
        const SensitivityPlot& plot = *bench.view.sensitivity();
        QVERIFY(!plot.empty());
        for (std::size_t place = 0; place < places.size(); ++place) {
            for (std::size_t f = 0; f < 3; ++f) {
                QCOMPARE(plot.weight(place, f), regressions[places[place]]->coefficients[f]);
            }
        }
        bench.part<QComboBox>("batchWeights").setCurrentIndex(1);
        QVERIFY(bench.view.busy());
        QVERIFY(bench.settled());
        QVERIFY(bench.view.indices() != nullptr);
        const auto engine = sobolIndices(project, 256);
        QCOMPARE(bench.view.indices()->simulations, engine->simulations);
        for (std::size_t place = 0; place < places.size(); ++place) {
            for (std::size_t f = 0; f < 3; ++f) {
                QCOMPARE(plot.weight(place, f), engine->byCharacteristic[places[place]][f].total);
            }
        }
    }

    void everyKeptPartIsAPointOfTheScatter() {
        const Project project = fixtures::shaftBatch(50);
        SettledBench bench(project);
        bench.part<QComboBox>("batchContent").setCurrentIndex(2);
        const ChartPlot& plot = *bench.view.scatter(); // stock against the first diameter
        std::vector<XY> parts;
        for (const int key : {BatchCharts::goodKey, BatchCharts::outsideKey}) {
            if (const ChartSeries* of = plot.chart().find(key)) {
                parts.insert(parts.end(), of->points.begin(), of->points.end());
            }
        }
        QCOMPARE(parts.size(), std::size_t{50});
        QCOMPARE(plot.chart().find(BatchCharts::worstKey)->points.size(), std::size_t{1});
        const BatchOutcome& batch = *bench.view.batch();
        const ScenarioSource source(project);
        const PartRow& row = batch.result.statistics.rows.front();
        const double stock = source.values(row.part)[0], diameter = row.values[0];
        QVERIFY(std::ranges::any_of(
            parts, [&](const XY& point) { return point.x == stock && point.y == diameter; }));
        QCOMPARE(plot.table().rows.size(), std::size_t{50});
    }

    /// A usual batch of every shipped example can be run.
    void everyExampleCanHaveAUsualBatch() {
        for (const char* name :
             {"internal-plunge", "plunge-shaft-two-stage", "shaft-30h6-factory", "shaft-38-74h6",
              "slender-shaft", "spark-out-until-size", "wheel-dull", "wheel-sharp"}) {
            const Project usual = withUsualBatch(exampleProject(name));
            QVERIFY2(checkBatch(usual).empty(), name);
            QVERIFY2(givenFactors(usual).size() >= 2, name);
        }
    }
};

} // namespace sparkout::test_batch_view

SPARKOUT_TEST(test_batch_view, TestBatchView)
#include "test_batch_view.moc"
