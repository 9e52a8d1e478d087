// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of the view "Constraints": the cuts and limits it draws are the engine's.
#include "core/project/cycle.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/accuracy_limit.h"
#include "core/quality/verdict.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "tests/ui/views/requirements/constraints_bench.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/project_io.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace test_constraints_plot {

using namespace sparkout;
using namespace constraints_bench;

class TestConstraintsPlot : public QObject {
    Q_OBJECT

private slots:
    /// A line where the cycle stands: at the stock that the newest cut of the group has left.
    void aLineMarksTheStockAtTheCyclesMoment() {
        const OutcomePtr outcome = run(limitedProject());
        CycleCursor cycle;
        cycle.setOutcome(outcome);
        ConstraintsView view;
        view.shareCycle(&cycle);
        view.resize(760, 620);
        view.show();
        fixtures::draw(view, outcome);
        QVERIFY(!view.plot()->moment_um()); // all is ground
        const auto group = static_cast<std::size_t>(view.plot()->group());
        const std::vector<LimitedCut>& cuts = outcome->limits.groups[group].cuts;
        double before = HUGE_VAL;
        for (const int stroke : {2, 9, 20, outcome->result.cycleCount - 1}) {
            cycle.toStroke(stroke);
            const double line_um = view.plot()->moment_um().value_or(HUGE_VAL);
            QVERIFY(line_um < before);
            before = line_um;
            const auto here = std::ranges::find_if(cuts, [&](const LimitedCut& cut) {
                return cut.place.cycleCount == stroke
                       && std::abs(cut.stock_mm * 1e3 - line_um) < 1e-9;
            });
            QVERIFY(here != cuts.end());
        }
        cycle.setPosition(0);
        QVERIFY(!view.plot()->moment_um());
    }

    /// In µm, the stock left across and the depth up; a limit that is off has no curve.
    void theChartHasTheCutsAndLimitsOfEachGroup() {
        const OutcomePtr outcome = run(limitedProject());
        std::size_t cuts = 0, limits = 0;
        for (std::size_t g = 0; g < outcome->limits.groups.size(); ++g) {
            const LimitGroup& group = outcome->limits.groups[g];
            const LineChart chart = LimitChart(outcome, static_cast<int>(g), {}).chart(false);
            const auto draws = [&chart](int key, const auto& points) {
                const ChartSeries* const of = chart.find(key);
                const std::vector<XY> drawn = of ? of->points : std::vector<XY>();
                return std::ranges::equal(drawn, points, [](const XY& at, const auto& point) {
                    return std::abs(at.x - point.stock_mm * 1000) < 1e-9
                           && std::abs(at.y - point.depth_mm * 1000) < 1e-9 * std::max(1.0, at.y);
                });
            };
            QVERIFY(draws(LimitChart::actualKey, group.cuts));
            cuts += group.cuts.size();
            QVERIFY(draws(LimitChart::steplessKey, steplessLimit(outcome->limits, group)));
            for (const ConstraintKind kind : depthLimitKinds()) {
                const LimitPoints curve = limitCurve(outcome->limits, group, kind);
                QVERIFY(draws(static_cast<int>(kind), curve));
                limits += curve.empty() ? 0 : 1;
            }
        }
        QVERIFY(cuts > 50 && limits > outcome->limits.groups.size());
    }

    /// A ribbon lies on the least of the limits at each stock, in its colour and with its name.
    void aBandNamesWhatBindsAtEachStock() {
        Project project = fixtures::plungeProject(1);
        project.material->burn_rise_k = 400;
        project.machine->wheel_drive_kw = 4;
        project.machine->limits.plunge_feed_mm_min = std::vector<double>{0.01, 1.5, 0.01};
        const OutcomePtr outcome = run(project);
        const Shown shown(outcome);
        const LimitChart& chart = shown.plot().limits();
        std::vector<ChartSeries> ribbons;
        for (const ChartSeries& of : shown.plot().chart().series) {
            if (of.kind == ChartSeries::Kind::ribbon) {
                ribbons.push_back(of);
            }
        }
        QCOMPARE(ribbons.size(), chart.envelope().size());
        QVERIFY(ribbons.size() > 1);
        const double feed_um = 1000 * *greatestInfeed_mm(project);
        const std::vector<XY> feed = shown.points(LimitChart::machineKey);
        QVERIFY(feed.size() == 2 && feed.front().y == feed_um);
        QStringList names;
        for (std::size_t i = 0; i < ribbons.size(); ++i) {
            const BoundCurve& piece = chart.envelope()[i];
            names << LimitChart::boundName(piece);
            QCOMPARE(ribbons[i].points.size(), piece.points.size());
            const LimitPoint &from = piece.points.front(), &to = piece.points.back();
            const double middle = (from.stock_mm + to.stock_mm) / 2;
            QCOMPARE(chart.boundAt(middle), LimitChart::boundName(piece));
            for (const LimitPoint& point : piece.points) {
                QVERIFY(point.depth_mm * 1000 <= feed_um * (1 + 1e-9));
            }
        }
        QVERIFY(names.contains(QStringLiteral("burn")));
        QVERIFY(names.contains(QStringLiteral("machine's feed")));
        for (std::size_t i = 1; i < ribbons.size(); ++i) { // neighbours differ in name and colour
            QVERIFY(names[static_cast<int>(i)] != names[static_cast<int>(i) - 1]);
            QVERIFY(ribbons[i].colour != ribbons[i - 1].colour);
        }
        for (const ChartSeries& ribbon : ribbons) { // hidden with the limit that it lies on
            const ChartSeries* const limit = shown.plot().chart().find(ribbon.key);
            QVERIFY(limit && limit->isLine() && limit->colour == ribbon.colour);
        }
    }

    /// Its sample is an arrow, so that no entry becomes wider; a screen reader says where it is.
    void aLimitAboveThePlotIsAnArrowInTheLegend() {
        const Shown shown(run(limitedProject()));
        constexpr int burn = static_cast<int>(ConstraintKind::burn);
        const auto entry = [&] {
            const LegendEntries entries = shown.plot().legendEntries();
            return *std::ranges::find(entries, burn, &LegendEntry::key);
        };
        const double least = std::ranges::min(shown.points(burn), {}, &XY::y).y;
        const auto* legend = shown.view.findChild<LegendStrip*>();
        const auto isSaidToBeAbove = [&] {
            return legend->accessibleDescription().contains(entry().text
                                                            + QStringLiteral(" (above the plot)"));
        };
        shown.plot().up().setRange(least / 10, least * 10);
        const LegendEntry within = entry();
        QVERIFY(within.pen != Qt::NoPen);
        QTRY_VERIFY(!isSaidToBeAbove());
        shown.plot().up().setRange(least / 100, least / 10);
        QVERIFY(entry().pen == Qt::NoPen && entry().swatch == Swatch::arrow);
        QCOMPARE(entry().text, within.text);
        QTRY_VERIFY(isSaidToBeAbove());
    }

    /// The examples of the three limits, with the programme and the feeds in mm/min.
    void accuracyAndProgrammeStandBesideTheLimits() {
        const auto read = loadProject(QStringLiteral(
            SPARKOUT_SOURCE_DIR "/resources/examples/plunge-accuracy-limit.sparkout"));
        QVERIFY(read.setup.has_value());
        const OutcomePtr outcome = run(read.setup->surfaces.front().project);
        Shown shown(outcome);
        shown.part<QComboBox>("constraintsZone")
            .setCurrentIndex(static_cast<int>(outcome->limits.groups.size()) - 1);
        const ConstraintsPlot& plot = shown.plot();
        const LimitGroup& group = outcome->limits.groups.back();
        const auto limit =
            accuracyLimit(outcome->result, outcome->limits, group, AccuracyProof::proved);
        QVERIFY(limit.has_value());
        const std::vector<XY> accuracy = shown.points(LimitChart::accuracyKey);
        QCOMPARE(accuracy.size(), limit->curve.size());
        const double lowest_um = accuracy.front().y;
        QVERIFY(std::abs(lowest_um - limit->lastCut_mm * 1000) < 1e-9);
        QVERIFY(shown.points(LimitChart::estimateKey).at(0).y < lowest_um);
        QVERIFY(shown.points(LimitChart::publishedKey).size() > 10);
        QVERIFY(shown.points(LimitChart::programmedKey).size() >= 4);
        QStringList names;
        for (const LegendEntry& entry : plot.legendEntries()) {
            names += entry.text;
        }
        for (const char* name : {"accuracy", "≈ accuracy", "runout (22)", "programmed"}) {
            QVERIFY2(names.contains(QString::fromUtf8(name)), qPrintable(names.join(u'|')));
        }
        // 160 rev/min: 1 µm a revolution is 0.16 mm/min.
        const QCPAxis& perMinute = *plot.cell().axis(QCPAxis::atRight);
        QVERIFY(perMinute.tickLabels());
        QVERIFY(std::abs(perMinute.range().upper - plot.up().range().upper * 0.16) < 1e-9);
        shown.show(run(limitedProject()));
        for (int g = 0; g < shown.part<QComboBox>("constraintsZone").count(); ++g) {
            shown.part<QComboBox>("constraintsZone").setCurrentIndex(g);
            QCOMPARE(perMinute.tickLabels(),
                     plot.up().label().endsWith(QStringLiteral("per revolution")));
        }
    }

    /// A roughness that is a guess holds by no green mark unless all of its range does.
    void aGuessedRoughnessIsGreenOnlyByItsWholeRange() {
        Project project = limitedProject();
        project.part->tolerance.roughness_ra_um = 50;
        const auto light = [](const Shown& shown) {
            const int row = shown.rowOf(ConstraintKind::roughness);
            return static_cast<Light>(
                shown.view.margins()->index(row, 0).data(MarginModel::lightRole).toInt());
        };
        QVERIFY(light(Shown(run(project))) == Light::holds);
        project.wheel->roughness_factor = 1;
        QVERIFY(light(Shown(run(project))) == Light::holds);
        const std::vector<ConstraintResult> all = run(project)->constraints;
        const auto rough =
            std::ranges::find(all, ConstraintKind::roughness, &ConstraintResult::kind);
        project.part->tolerance.roughness_ra_um = (rough->value + *rough->mostValue) / 2;
        QVERIFY(light(Shown(run(project))) == Light::undecided);
    }

    // The numbers of an uncalibrated Ra are micrometres by the thousand.
    void aRoughnessThatIsNotCalibratedIsNamedInWordsAlone() {
        Project project = limitedProject();
        Shown shown(run(project));
        const QString words =
            QStringLiteral("Roughness is not limiting while it is not calibrated");
        const QString name = QStringLiteral("Ra, last cut");
        const auto named = [&] { // in the legend, in the table, under the mouse
            QString text;
            for (const LegendEntry& entry : shown.plot().legendEntries()) {
                text += entry.text + u'|';
            }
            text += shown.plot().table().header.join(u'|');
            QSignalSpy pointed(&shown.plot(), &ConstraintsPlot::pointed);
            fixtures::hover(&shown.plot(), QRectF(shown.plot().axisRect()->rect()).center());
            return text + pointed.value(0).value(0).toString();
        };
        QCOMPARE(named().count(name), 3);
        QVERIFY(!shown.part<QLabel>("limitsOff").text().contains(words));
        project.wheel->roughness_factor = 1;
        shown.show(run(project));
        QCOMPARE(named().count(name), 0);
        QVERIFY(named().contains(QStringLiteral("burn")));
        QVERIFY(shown.part<QLabel>("limitsOff").isVisible());
        QVERIFY(shown.part<QLabel>("limitsOff").text().contains(words));
        project.part->tolerance.roughness_ra_um.reset();
        shown.show(run(project));
        QVERIFY(!shown.part<QLabel>("limitsOff").text().contains(words));
    }

    void anEditAndItsUndoLeadToTheSameAxes() {
        const OutcomePtr first = run(limitedProject());
        Project edited = limitedProject();
        edited.cycle->stages.front().radial_feed_mm =
            *edited.cycle->stages.front().radial_feed_mm * 3;
        edited.part->stock_mm *= 1.5;
        const OutcomePtr second = run(edited);
        Shown shown(first);
        shown.plot().setRun(first, shown.plot().group());
        const QCPAxis &stock = shown.plot().across(), &feeds = shown.plot().up();
        const QCPRange stockBefore = stock.range(), feedsBefore = feeds.range();
        shown.show(second);
        QVERIFY(feeds.range() != feedsBefore);
        shown.show(first);
        QCOMPARE(stock.range(), stockBefore);
        QCOMPARE(feeds.range(), feedsBefore);
    }

    void whatTheUserZoomedStaysOverAnEditAndItsUndo() {
        const OutcomePtr first = run(limitedProject());
        Project edited = limitedProject();
        edited.part->stock_mm *= 1.5;
        const OutcomePtr second = run(edited);
        Shown shown(first);
        shown.view.tools()->navigation().zoom(0.5);
        const QCPRange stock = shown.plot().across().range();
        const QCPRange feeds = shown.plot().up().range();
        for (const OutcomePtr& outcome : {second, first, second}) {
            shown.show(outcome);
            QCOMPARE(shown.plot().across().range(), stock);
            QCOMPARE(shown.plot().up().range(), feeds);
        }
        shown.view.forget(); // another document
        shown.show(first);
        QVERIFY(shown.plot().across().range() != stock);
    }

    void theCycleRunsFromLeftToRight() {
        Shown shown(run(limitedProject()));
        const QCPAxis& axis = shown.plot().across();
        QVERIFY(axis.coordToPixel(100) < axis.coordToPixel(0));
        const QCPRange before = axis.range();
        shown.view.tools()->navigation().pan(1, 0); // to the right: less stock
        QVERIFY(axis.range().center() < before.center());
    }

    void cutsAboveTheirLimitAreMarked() {
        Project project = limitedProject();
        Shown held(run(project));
        QVERIFY(held.exceeded().empty());
        project.material->burn_rise_k = 60;
        const OutcomePtr outcome = run(project);
        Shown shown(outcome);
        const LimitGroup& group =
            outcome->limits.groups[static_cast<std::size_t>(shown.plot().group())];
        const auto above =
            std::ranges::count_if(group.cuts, [](const LimitedCut& c) { return c.usage > 1; });
        QVERIFY(above > 0);
        QCOMPARE(shown.exceeded().size(), static_cast<std::size_t>(above));
        // It starts with the zone that comes nearest, and marks where.
        for (const LimitGroup& other : outcome->limits.groups) {
            QVERIFY(other.worst.usage <= group.worst.usage);
        }
        QCOMPARE(shown.plot().limits().marked().value().depth_mm, group.worst.depth_mm);
    }

    void cutsThatOutgrowThePlotBringItAlong() {
        Project project = unlimited(plungeProject(1));
        Shown shown(run(project));
        const auto feeds = [&] { return shown.plot().up().range(); };
        const auto highest = [&] { return std::ranges::max(shown.actual(), {}, &XY::y).y; };
        const auto feedTimes = [&project](double times) {
            for (Stage& stage : project.cycle->stages) {
                *stage.radial_feed_mm_min *= times;
            }
            return run(project);
        };
        const QCPRange first = feeds();
        shown.show(feedTimes(4));
        QVERIFY(highest() > first.upper);
        QVERIFY(feeds().upper >= highest());
        shown.view.tools()->navigation().zoom(0.5); // by hand: that stays
        const QCPRange zoomed = feeds();
        shown.show(feedTimes(4));
        QVERIFY(highest() > zoomed.upper);
        QCOMPARE(feeds(), zoomed);
    }

    void theAxisNamesWhatACutIs() {
        Shown shown(run(limitedProject()));
        auto& zones = shown.part<QComboBox>("constraintsZone");
        for (int g = 0; g < zones.count(); ++g) {
            zones.setCurrentIndex(g);
            const bool standing = zones.itemText(g).contains(QStringLiteral("standing"));
            QVERIFY2(shown.plot().up().label().endsWith(standing ? QStringLiteral("per revolution")
                                                                 : QStringLiteral("per pass")),
                     qPrintable(zones.itemText(g)));
        }
    }

    void aChosenZoneWithoutCutsStaysChosen() {
        const OutcomePtr outcome = run(limitedProject());
        auto bare = std::make_shared<Outcome>(*outcome);
        const int last = static_cast<int>(bare->limits.groups.size()) - 1;
        bare->limits.groups.back().cuts.clear();
        bare->limits.groups.back().worst = {};
        Shown shown(bare);
        QVERIFY(shown.plot().group() != last);
        shown.part<QComboBox>("constraintsZone").setCurrentIndex(last);
        shown.show(std::make_shared<Outcome>(*bare));
        QCOMPARE(shown.plot().group(), last);
        shown.show(outcome);
        QCOMPARE(shown.plot().group(), last);
    }

    void aLogarithmicAxisShowsTheSparkingOut() {
        Project project = limitedProject();
        Stage spark = project.cycle->stages.back();
        spark.spark_out = {SparkOut::Mode::count, 10};
        spark.stock_mm = 0;
        project.cycle->stages.push_back(spark);
        Shown shown(run(project));
        const auto sight = [&] { return shown.plot().up().range(); };
        const auto reaches = [&](const QCPRange& range) { // the least of the limits
            return range.contains(
                std::ranges::min(shown.points(LimitChart::steplessKey), {}, &XY::y).y);
        };
        QCOMPARE(shown.plot().up().scaleType(), QCPAxis::stLogarithmic);
        QVERIFY(sight().lower > 0 && reaches(sight()));
        shown.part<QCheckBox>("logarithmic").click();
        QVERIFY(sight().lower == 0 && reaches(sight()));
        shown.part<QCheckBox>("logarithmic").click();
        QVERIFY(sight().lower > 0 && reaches(sight()));
    }

    /// In every group of the examples, as wide as in a small and in a large window.
    void theCallOutStandsBesideTheCurves() {
        int tried = 0;
        for (const char* name :
             {"shaft-30h6-factory", "shaft-30h6-optimal", "slender-shaft", "plunge-accuracy-limit",
              "plunge-roughness-limit", "wheel-dull", "internal-plunge", "through-bore"}) {
            const auto read = loadProject(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/")
                                          + QLatin1String(name) + QStringLiteral(".sparkout"));
            QVERIFY(read.setup.has_value());
            Shown shown(run(read.setup->surfaces.front().project));
            for (const QSize size : {QSize(560, 560), QSize(1100, 800)}) {
                shown.view.resize(size);
                auto& zones = shown.part<QComboBox>("constraintsZone");
                for (int g = 0; g < zones.count(); ++g) {
                    zones.setCurrentIndex(g);
                    ConstraintsPlot& plot = shown.plot();
                    plot.replot(QCustomPlot::rpImmediateRefresh);
                    const QRectF box = plot.callOut();
                    QCOMPARE(box.isNull(), plot.limits().markText().isEmpty());
                    if (box.isNull()) {
                        continue;
                    }
                    ++tried;
                    QVERIFY2(QRectF(plot.cell().rect()).contains(box), name);
                    for (const XY& cut : shown.actual()) {
                        QVERIFY2(!box.contains(plot.pixelOf(cut)), name);
                    }
                }
            }
        }
        QVERIFY(tried > 30);
    }

    void everySectionCanBeChosen() {
        Project project = plungeProject(6);
        project.material->burn_rise_k = 700;
        Shown shown(run(project));
        auto& zones = shown.part<QComboBox>("constraintsZone");
        QCOMPARE(zones.count(), 6);
        zones.setCurrentIndex(4);
        QCOMPARE(shown.plot().group(), 4);
        project.cycle->stages[0].radial_feed_mm_min = 0.4;
        shown.show(run(project)); // the choice stays
        QCOMPARE(shown.plot().group(), 4);
        QCOMPARE(zones.currentIndex(), 4);
    }

    void theValuesUnderTheMouseFit() {
        for (const char* language : {"en", "ru"}) {
            Bench bench{QLatin1String(language)};
            bench.window->document().startUntitled(fullyLimitedProject());
            QVERIFY(bench.window->showView(QStringLiteral("constraints")));
            bench.settle();
            const auto* values =
                bench.window->findChild<QLabel*>(QStringLiteral("constraintsValues"));
            auto* plot = bench.window->findChild<ConstraintsView*>()->plot();
            QVERIFY(values->isVisible());
            for (const XY& cut : plot->chart().find(LimitChart::actualKey)->points) {
                fixtures::hover(plot, plot->pixelOf(cut));
                QVERIFY(values->text().contains(u'%'));
                QVERIFY2(values->heightForWidth(values->width()) <= values->height(),
                         qPrintable(values->text()));
            }
        }
    }
};

} // namespace test_constraints_plot

SPARKOUT_TEST(test_constraints_plot, TestConstraintsPlot)
#include "test_constraints_plot.moc"
