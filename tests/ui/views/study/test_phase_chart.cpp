// SPDX-License-Identifier: GPL-3.0-or-later
// Size against stock in the view "Sweep": chosen, given a range and stopped with mouse and keys;
// what is drawn, said and tabulated is what the engine decides and what single cycles come to.
#include "core/phases/phase_decision.h"
#include "core/simulation/simulate.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/chart_plot.h"
#include "ui/form/number_field.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/text/number_text.h"
#include "ui/views/study/phase_chart.h"
#include "ui/views/study/sweep_bars.h"
#include "ui/views/study/sweep_view.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace sparkout::test_phase_chart {

constexpr int patience_ms = 60'000;
constexpr double fine_um = 1e-6;

Project shaft() {
    Project project = exampleProject("shaft-30h6-factory");
    project.gauge->control = Control::gauge;
    return project;
}

/// With a field so narrow that some stocks fail and others hold.
Project narrow() {
    Project project = shaft();
    const PhaseDecision wide = decidePhases(project, usualPhases(project));
    double least_mm = 1, most_mm = -1;
    for (const DecidedPiece& each : wide.pieces) {
        for (const DeviationRange& size : each.low.deviations) {
            least_mm = std::min(least_mm, size.least_mm);
        }
        for (const DeviationRange& size : each.high.deviations) {
            most_mm = std::max(most_mm, size.most_mm);
        }
    }
    project.part->target_diameter_mm = project.part->target_diameter_mm.value_or(
        project.part->diameter_mm
        + (project.part->lower_deviation_um + project.part->upper_deviation_um) / 2000);
    const double length_um = (most_mm - least_mm) * 1000;
    project.part->lower_deviation_um = least_mm * 1000 - length_um;
    project.part->upper_deviation_um = most_mm * 1000 - length_um / 40;
    return project;
}

/// A view with a document, as in the window.
struct Bench {
    explicit Bench(const Project& project) {
        view.resize(760, 620);
        QObject::connect(&document, &Document::changed, &view,
                         [this] { view.setOutcome(evaluate(document.project(), {})); });
        document.startUntitled(project);
        view.show();
        QTest::qWait(20);
        auto& subject = part<QComboBox>("sweepSubject");
        subject.setFocus();
        QTest::keyClick(&subject, Qt::Key_End);
    }
    void edit(const Project& project) { document.edit(project, {"Edit", "Change"}); }
    [[nodiscard]] bool settled() {
        QTest::qWait(20);
        return QTest::qWaitFor([this] { return !view.busy(); }, patience_ms);
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) {
        return *view.findChild<Widget*>(QString::fromLatin1(name));
    }
    void type(const char* field, const QString& text) {
        auto& line = part<NumberField>(field);
        QTest::mouseClick(&line, Qt::LeftButton);
        line.selectAll();
        text.isEmpty() ? QTest::keyClick(&line, Qt::Key_Delete) : QTest::keyClicks(&line, text);
        QTest::keyClick(&line, Qt::Key_Return);
    }
    [[nodiscard]] QString notice() { return part<QLabel>("sweepNotice").text(); }
    [[nodiscard]] const LineChart& chart() const { return view.phases()->chart(); }
    /// Stocks, as hatched.
    [[nodiscard]] std::vector<ChartSpan> failing() const {
        return chart().zones.size() > 1 ? chart().zones[1].ranges : std::vector<ChartSpan>();
    }
    [[nodiscard]] const PhaseDecision& decision() const {
        return view.findChild<PhaseBar*>()->phases()->decision;
    }
    Document document;
    SweepView view;
};

double largestOf(const PieceEnd& end) {
    return std::ranges::max_element(end.deviations, {}, &DeviationRange::most_mm)->most_mm * 1000;
}

double smallestOf(const PieceEnd& end) {
    return std::ranges::min_element(end.deviations, {}, &DeviationRange::least_mm)->least_mm * 1000;
}

/// A curve has two points and a gap for each piece.
void compareCurve(const std::vector<XY>& curve, const std::vector<DecidedPiece>& pieces,
                  double (*sizeOf)(const PieceEnd&)) {
    QCOMPARE(curve.size(), 3 * pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const XY* const at = &curve[3 * i];
        QVERIFY(at[0].x == pieces[i].piece.from_mm && at[1].x == pieces[i].piece.to_mm);
        QVERIFY(std::abs(at[0].y - sizeOf(pieces[i].low)) < fine_um);
        QVERIFY(std::abs(at[1].y - sizeOf(pieces[i].high)) < fine_um);
        QVERIFY(std::isnan(at[2].y));
    }
}

class TestPhaseChart : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void whatIsDrawnIsWhatTheEngineDecides() {
        const Project project = narrow();
        Bench bench(project);
        QVERIFY(bench.settled());
        ChartPlot& plot = *bench.view.phases();
        QVERIFY(plot.isVisible());
        QVERIFY(!bench.part<QComboBox>("sweep1Input").isVisible());
        const StockRange usual = usualPhases(project);
        const PhaseDecision& drawn = bench.decision();
        QVERIFY(std::abs(drawn.range.from_mm - usual.from_mm) < 1e-6);
        QVERIFY(std::abs(drawn.range.to_mm - usual.to_mm) < 1e-6);
        const PhaseDecision decided = decidePhases(project, drawn.range);
        QVERIFY(decided.pieces.size() > 1);
        compareCurve(plot.chart().find(PhaseChart::largestKey)->points, decided.pieces, largestOf);
        compareCurve(plot.chart().find(PhaseChart::smallestKey)->points, decided.pieces,
                     smallestOf);
        QVERIFY(!decided.failing.empty());
        for (const FailingStocks& each : decided.failing) { // neighbours as one
            QVERIFY(std::ranges::any_of(bench.failing(), [&each](const ChartSpan& hatched) {
                return hatched.low <= each.stocks.from_mm && each.stocks.to_mm <= hatched.high;
            }));
        }
        for (const ChartSpan& hatched : bench.failing()) {
            const auto fails = [&](double stock_mm) {
                return std::ranges::any_of(decided.failing, [&](const FailingStocks& each) {
                    return each.stocks.from_mm <= stock_mm && stock_mm <= each.stocks.to_mm;
                });
            };
            QVERIFY(fails(hatched.low) && fails((hatched.low + hatched.high) / 2)
                    && fails(hatched.high));
            QVERIFY(hatched.low == drawn.range.from_mm || !fails(hatched.low - 1e-7));
            QVERIFY(hatched.high == drawn.range.to_mm || !fails(hatched.high + 1e-7));
        }
        QCOMPARE(plot.chart().rules.at(0).at, project.part->stock_mm);
        QVERIFY2(bench.notice().startsWith(
                     QStringLiteral("The cycle is unfit for stocks per side from ")),
                 qPrintable(bench.notice()));
        QVERIFY(bench.notice().contains(QStringLiteral("maximum diameter")));
        const CsvTable table = plot.table();
        QCOMPARE(table.rows.size(), decided.pieces.size());
        QCOMPARE(table.header.size(), qsizetype(6 + project.cycle->stages.size()));
        const TimeUnit unit(std::ranges::max(decided.pieces, {}, &DecidedPiece::time_s).time_s);
        const std::size_t time = 2 + project.cycle->stages.size();
        QCOMPARE(table.header[qsizetype(time)], unit.titled(QStringLiteral("Time")));
        for (std::size_t i = 0; i < decided.pieces.size(); ++i) {
            QCOMPARE(std::get<double>(table.rows[i][0]), decided.pieces[i].piece.from_mm);
            QCOMPARE(std::get<double>(table.rows[i][2]), double(decided.pieces[i].piece.counts[0]));
            QCOMPARE(std::get<double>(table.rows[i][time]), unit.of(decided.pieces[i].time_s));
            QCOMPARE(std::get<QString>(table.rows[i].back()) == QStringLiteral("fit"),
                     decided.pieces[i].holdsWhole());
        }
    }

    /// Of a uniform stock the length that fails over the length of the distribution.
    void theShareOfTheBatchIsStated() {
        Project project = narrow();
        Factors factors;
        const StockRange range = usualPhases(project);
        const double beyond_mm = (range.to_mm - range.from_mm) / 2;
        factors.stock_mm = Factor{};
        factors.stock_mm->uniform = std::vector{range.from_mm - beyond_mm, range.to_mm + beyond_mm};
        project.batch = Batch{};
        project.batch->factors = factors;
        Bench bench(project);
        QVERIFY(bench.settled());
        double failing_mm = 0;
        for (const ChartSpan& each : bench.failing()) {
            failing_mm += each.size();
        }
        QVERIFY(failing_mm > 0);
        const QString failing = QString::number(100 * failing_mm / (4 * beyond_mm), 'g', 3);
        QVERIFY2(
            bench.notice().contains(QStringLiteral("Rejected by stock alone: %1\u00a0%. The stock "
                                                   "of 50\u00a0% lies outside the range.")
                                        .arg(failing)),
            qPrintable(bench.notice() + failing));
        project.batch.reset();
        bench.edit(project);
        QVERIFY(bench.settled());
        QVERIFY(!bench.notice().contains(QStringLiteral("batch")));
    }

    void theEndsOfTheRangeAreTyped() {
        Bench bench(shaft());
        QVERIFY(bench.settled());
        const StockRange usual = bench.decision().range;
        const auto typed = QLocale().toString(usual.from_mm + 0.001, 'f', 4);
        bench.type("phasesFrom", typed);
        QVERIFY(bench.settled());
        QCOMPARE(bench.decision().range.from_mm, QLocale().toDouble(typed));
        QCOMPARE(bench.decision().range.to_mm, usual.to_mm);
        bench.type("phasesTo", typed); // one stock is a range, too
        QVERIFY(bench.settled());
        QCOMPARE(bench.decision().range.to_mm, bench.decision().range.from_mm);
        QVERIFY(!bench.decision().pieces.empty());
        bench.type("phasesFrom", QStringLiteral("-1")); // a blank has no such stock
        QVERIFY(bench.part<NumberField>("phasesFrom").refused());
        QTest::keyClick(&bench.part<NumberField>("phasesFrom"), Qt::Key_Escape);
        bench.type("phasesFrom", QLocale().toString(usual.to_mm, 'f', 4));
        QVERIFY(bench.settled());
        QVERIFY2(
            bench.notice().startsWith(QStringLiteral("The upper end of the range must lie above")),
            qPrintable(bench.notice()));
        QVERIFY(!bench.part<QPushButton>("phasesRun").isEnabled());
        QVERIFY(!bench.view.phases()->isVisible());
        bench.type("phasesFrom", {});
        bench.type("phasesTo", {});
        QVERIFY(bench.settled());
        QCOMPARE(bench.decision().range, usual);
        QCOMPARE(bench.part<NumberField>("phasesFrom").value(), std::optional(usual.from_mm));
    }

    void itFollowsTheProject() {
        const Project project = shaft();
        Bench bench(project);
        QVERIFY(bench.settled());
        Project other = project;
        other.part->stock_mm += 0.01;
        bench.edit(other);
        QVERIFY(bench.settled());
        QCOMPARE(bench.chart().rules.at(0).at, other.part->stock_mm);
        QVERIFY(std::abs(bench.decision().range.from_mm - usualPhases(other).from_mm) < 1e-6);
        bench.edit(narrow());
        QVERIFY(bench.settled());
        QVERIFY(!bench.failing().empty());
        const ChartSpan failing = bench.failing().front();
        const ChartPlot& plot = *bench.view.phases();
        fixtures::hover(bench.view.phases(),
                        {plot.across().coordToPixel((failing.low + failing.high) / 2),
                         static_cast<double>(plot.cell().center().y())});
        const QString values = bench.part<QLabel>("sweepValues").text();
        QVERIFY2(values.startsWith(QStringLiteral("Stock 0."))
                     && values.contains(QStringLiteral("unfit: maximum diameter")),
                 qPrintable(values));
    }

    void underPositionControlItSaysWhyNot() {
        Project project = shaft();
        Bench bench(project);
        QVERIFY(bench.settled());
        project.gauge->control = Control::position;
        project.gauge->datum_mm.reset();
        bench.edit(project);
        QVERIFY(bench.settled());
        QVERIFY2(bench.notice().startsWith(QStringLiteral("Under position control")),
                 qPrintable(bench.notice()));
        QVERIFY(!bench.view.phases()->isVisible());
        QVERIFY(!bench.part<QPushButton>("phasesRun").isEnabled());
        QVERIFY(!bench.part<NumberField>("phasesFrom").isEnabled());
        bench.document.undo();
        QVERIFY(bench.settled());
        QVERIFY(bench.view.phases()->isVisible());
        project = shaft();
        project.part->stock_mm = -1;
        bench.edit(project);
        QVERIFY(bench.settled());
        QVERIFY2(bench.notice().startsWith(QStringLiteral("The inputs are refused; the stocks")),
                 qPrintable(bench.notice()));
        QVERIFY(bench.view.phases()->isDimmed());
    }

    void aLongRunIsStopped() {
        Bench bench(shaft());
        QVERIFY(bench.settled());
        Project slow = shaft();
        slow.part->radii_per_section = 360;
        for (Stage& stage : slow.cycle->stages) {
            stage.radial_feed_mm = *stage.radial_feed_mm / 10;
        }
        bench.edit(slow);
        QTRY_VERIFY(bench.view.busy());
        bench.type("phasesTo", QStringLiteral("0.6"));
        QVERIFY(bench.view.busy());
        QTest::mouseClick(&bench.part<QPushButton>("phasesStop"), Qt::LeftButton);
        QVERIFY(bench.settled());
        QVERIFY2(
            bench.notice().startsWith(QStringLiteral("These results are for the inputs before")),
            qPrintable(bench.notice()));
        QVERIFY(bench.view.phases()->isDimmed());
        QTest::mouseClick(&bench.part<QPushButton>("phasesRun"), Qt::LeftButton);
        QVERIFY(bench.view.busy());
        bench.document.undo(); // drops it
        bench.type("phasesTo", {});
        QVERIFY(bench.settled());
        QVERIFY(!bench.view.phases()->isDimmed());
    }

    void theSweepComesBack() {
        Bench bench(shaft());
        QVERIFY(bench.settled());
        auto& subject = bench.part<QComboBox>("sweepSubject");
        QTest::keyClick(&subject, Qt::Key_Home);
        QVERIFY(bench.part<QComboBox>("sweep1Input").isVisible());
        QVERIFY(!bench.part<QPushButton>("phasesRun").isVisible());
        QTest::mouseClick(&bench.part<QPushButton>("sweepAdd"), Qt::LeftButton);
        QVERIFY(!bench.view.phases()->isVisible());
    }
};

} // namespace sparkout::test_phase_chart

SPARKOUT_TEST(test_phase_chart, TestPhaseChart)
#include "test_phase_chart.moc"
