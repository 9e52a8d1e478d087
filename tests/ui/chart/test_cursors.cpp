// SPDX-License-Identifier: GPL-3.0-or-later
// The two cursors of a plot: what they read is the engine's, at places dragged, stepped or typed.
#include "core/process/system_compliance.h"
#include "core/quality/limit_series.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/plot_cursors.h"
#include "ui/chart/plot_tools.h"
#include "ui/chart/quantity_colour.h"
#include "ui/dialogs/copy_table.h"
#include "ui/form/number_field.h"
#include "ui/session/project_io.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/part/compliance_curves.h"
#include "ui/views/part/compliance_plot.h"
#include "ui/views/part/compliance_view.h"
#include "ui/views/requirements/constraints_plot.h"
#include "ui/views/requirements/constraints_view.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>

#include <clocale>
#include <cmath>

namespace sparkout::test_cursors {

using namespace fixtures;

void settle() {
    for (int i = 0; i < 4; ++i) {
        QTest::qWait(5);
        QCoreApplication::sendPostedEvents();
    }
}

template <typename Shown>
void show(Shown& view, const OutcomePtr& outcome) {
    view.resize(900, 760);
    view.show();
    view.setOutcome(outcome);
    settle();
    view.cursors()->toggle->trigger();
    settle();
}

/// A view of the feeds with its cursors on.
struct Feeds {
    FeedsView view;
    explicit Feeds(const OutcomePtr& outcome) { show(view, outcome); }
    [[nodiscard]] CursorStrip& strip() const { return *view.findChild<CursorStrip*>(); }
    [[nodiscard]] NumberField& field(std::size_t cursor) const { return *strip().field(cursor); }
    [[nodiscard]] double at(std::size_t cursor) const { return *view.cursors()->at(cursor); }
    [[nodiscard]] QPoint pixel(double x) const {
        const QCPAxisRect* rect = view.plot()->cell(1, 1);
        return {qRound(rect->axis(QCPAxis::atBottom)->coordToPixel(x)), rect->center().y()};
    }
    /// As a user does it: over what stands there.
    void type(std::size_t cursor, const QString& text) {
        field(cursor).setFocus();
        field(cursor).selectAll();
        QTest::keyClicks(&field(cursor), text);
        QTest::keyClick(&field(cursor), Qt::Key_Return);
        settle();
    }
    [[nodiscard]] QString cell(const QString& row, int column) const {
        const CursorModel& model = *strip().model();
        for (int i = 0; i < model.rowCount(); ++i) {
            if (model.index(i, 0).data().toString() == row) {
                return model.index(i, column).data().toString();
            }
        }
        return QStringLiteral("no such row");
    }
    [[nodiscard]] QCPRange sight() const {
        return view.plot()->cell(0, 0)->axis(QCPAxis::atBottom)->range();
    }
};

/// The point of a zone at a time, as the engine gives it; null between its passes.
const FeedPoint* enginePoint(const FeedColumn& zone, double time_s) {
    for (const FeedPoint& p : zone.strokes) {
        if (p.start_s <= time_s && time_s < p.end_s) {
            return &p;
        }
    }
    return nullptr;
}

class TestCursors : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
        m_run = run(traverseProject());
        QVERIFY(m_run->ran());
    }

    void aTypedPlaceReadsTheEnginesValuesThere_data() {
        addColumns<QString, double>("typed", "minutes");
        QTest::newRow("decimal point") << "0.7123" << 0.7123;
        QTest::newRow("decimal comma") << "0,7123" << 0.7123;
        QTest::newRow("early") << "0.05" << 0.05;
        QTest::newRow("late") << "1.5" << 1.5;
    }

    void aTypedPlaceReadsTheEnginesValuesThere() {
        QFETCH(QString, typed);
        QFETCH(double, minutes);
        Feeds feeds(m_run);
        feeds.type(0, typed);
        QCOMPARE(feeds.at(0), minutes);
        const FeedSeries& series = m_run->feeds;
        QVERIFY(minutes * 60 < series.end_s);
        int ground = 0;
        for (int zone = 0; zone < 3; ++zone) {
            const FeedPoint* p = enginePoint(series.columns[std::size_t(zone)], minutes * 60);
            const auto shown = [&](Quantity quantity) {
                return feeds.cell(quantityWithUnit(quantity), 1 + 3 * zone);
            };
            QCOMPARE(shown(Quantity::actual), Names::micrometres(p ? p->actual_um.mean : 0));
            QCOMPARE(shown(Quantity::force), Names::significant(p ? p->force_n.mean : 0));
            if (p) {
                ++ground;
                QCOMPARE(shown(Quantity::left), Names::signedMicrometres(p->left_um.mean));
                // An accumulated feed grows evenly over a point.
                const double share = (minutes * 60 - p->start_s) / (p->end_s - p->start_s);
                const double sum = p->actualSum_um.mean - (1 - share) * p->actual_um.mean;
                const double read = QLocale().toDouble(shown(Quantity::actualSum));
                QVERIFY2(std::abs(read - sum) < 0.05, qPrintable(shown(Quantity::actualSum)));
            }
        }
        QVERIFY(ground > 0);
    }

    void aRefusedTextStaysAndSaysWhy() {
        Feeds feeds(m_run);
        feeds.type(0, QStringLiteral("0.5"));
        for (const char* text : {"half", "1000", "-1"}) {
            feeds.type(0, QLatin1String(text));
            QCOMPARE(feeds.field(0).text(), QLatin1String(text));
            QVERIFY(feeds.field(0).refused());
            QCOMPARE(feeds.at(0), 0.5);
            bool told = false;
            for (const QLabel* label : feeds.strip().findChildren<QLabel*>()) {
                told = told
                       || (label->isVisible() && label->text().contains(feeds.field(0).refusal())
                           && !feeds.field(0).refusal().isEmpty());
            }
            QVERIFY(told);
        }
        feeds.type(0, QStringLiteral("0.6"));
        QVERIFY(!feeds.field(0).refused());
        QCOMPARE(feeds.at(0), 0.6);
    }

    void theMouseDragsACursorAndNothingElse() {
        Feeds feeds(m_run);
        feeds.type(0, QStringLiteral("0.5"));
        feeds.type(1, QStringLiteral("1"));
        const QCPRange sight = feeds.sight();
        int clicks = 0;
        connect(feeds.view.plot(), &FeedsPlot::timeClicked, this, [&clicks] { ++clicks; });
        drag(feeds.view.plot(), feeds.pixel(0.5), feeds.pixel(0.8));
        settle();
        const double pixel = sight.size() / feeds.view.plot()->cell(1, 1)->width();
        QVERIFY(std::abs(feeds.at(0) - 0.8) <= pixel);
        QCOMPARE(feeds.at(1), 1.0);
        QCOMPARE(feeds.field(0).text(), showNumber(feeds.at(0), QLocale()));
        QVERIFY(feeds.field(0).text().size() < 8); // no more digits than a pixel tells
        QCOMPARE(feeds.sight(), sight);
        QVERIFY(!feeds.view.tools()->navigation().canGoBack());
        QCOMPARE(clicks, 0);
        // Out of the cycle it cannot be dragged; beside a cursor the plot is.
        drag(feeds.view.plot(), feeds.pixel(1), feeds.pixel(1) + QPoint(5000, 0));
        QVERIFY(std::abs(feeds.at(1) - m_run->feeds.end_s / 60) < 1e-9);
        feeds.view.plot()->showTimes(0, 60);
        drag(feeds.view.plot(), feeds.pixel(0.6), feeds.pixel(0.5));
        QVERIFY(feeds.sight().lower > 0.05);
    }

    void keysMoveThem() {
        Feeds feeds(m_run);
        feeds.type(0, QStringLiteral("0.5"));
        feeds.type(1, QStringLiteral("1"));
        const QCPRange sight = feeds.sight();
        const double step = sight.size() / 100, pixel = step / 2;
        QTest::keyClick(feeds.view.plot(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(feeds.at(0) - 0.5 - step) < pixel);
        QCOMPARE(feeds.at(1), 1.0);
        QTest::keyClick(feeds.view.plot(), Qt::Key_Left, Qt::ShiftModifier | Qt::ControlModifier);
        QVERIFY(std::abs(feeds.at(1) - 1 + step) < pixel);
        QCOMPARE(feeds.sight(), sight);
        QTest::keyClick(&feeds.field(0), Qt::Key_Up); // the last digit, as in every field
        settle();
        QVERIFY(feeds.at(0) > 0.5 + step / 2);
        feeds.view.plot()->setFocus();
        QTest::keyClick(feeds.view.plot(), Qt::Key_C);
        QVERIFY(!feeds.view.cursors()->shown() && !feeds.strip().isVisible());
        QTest::keyClick(feeds.view.plot(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(feeds.sight() != sight || feeds.at(0) < 1); // the plot's own keys again
    }

    void placesSurviveARecomputeAndAnotherUnit() {
        Feeds feeds(m_run);
        feeds.type(0, QStringLiteral("0.3"));
        feeds.type(1, QStringLiteral("1.1"));
        auto* axis = feeds.view.findChild<QComboBox*>(QStringLiteral("axis"));
        const auto choose = [&](CycleAxis unit) {
            axis->setCurrentIndex(axis->findData(static_cast<int>(unit)));
            settle();
        };
        choose(CycleAxis::strokes);
        QVERIFY(std::abs(feeds.view.plot()->scale().time_s(feeds.at(1)) - 66) < 1e-9);
        choose(CycleAxis::time);
        QCOMPARE(feeds.field(0).text(), QStringLiteral("0.3"));
        Project other = traverseProject();
        other.part->stock_mm += 0.02;
        feeds.view.setOutcome(run(other));
        settle();
        QCOMPARE(feeds.at(0), 0.3);
        QCOMPARE(feeds.field(1).text(), QStringLiteral("1.1"));
        // A cycle that ends before a cursor leaves it where it is, and says so.
        Project shorter = traverseProject();
        for (Stage& stage : shorter.cycle->stages) {
            stage.radial_feed_mm = 0.02;
            stage.axial_feed_mm_min = 3000;
        }
        const OutcomePtr brief = run(shorter);
        QVERIFY(brief->ran() && brief->feeds.end_s < 66);
        feeds.view.setOutcome(brief);
        settle();
        QVERIFY(feeds.field(1).refused());
        QCOMPARE(feeds.field(0).text(), QStringLiteral("18")); // a short cycle is in seconds
        QCOMPARE(feeds.field(1).text(), QStringLiteral("66"));
        QCOMPARE(feeds.view.plot()->timeLabel(), QStringLiteral("Time, s"));
        QCOMPARE(feeds.cell(quantityWithUnit(Quantity::actual), 2), QStringLiteral("–"));
    }

    void theTableIsOfTheShownCurvesAndGoesToASpreadsheet() {
        Feeds feeds(m_run);
        feeds.type(0, QStringLiteral("0.4"));
        feeds.type(1, QStringLiteral("1.2"));
        const CsvTable table = feeds.strip().model()->table();
        QCOMPARE(table.header.size(), 1 + 3 * 3);
        QCOMPARE(table.rows.size(), std::size_t(1 + 8)); // the places, and all quantities
        for (const auto& row : table.rows) {
            for (std::size_t zone = 0; zone < 3; ++zone) {
                const double a = std::get<double>(row[1 + 3 * zone]);
                const double b = std::get<double>(row[2 + 3 * zone]);
                QVERIFY(std::abs(std::get<double>(row[3 + 3 * zone]) - (b - a)) < 1e-9);
            }
        }
        QCOMPARE(std::get<double>(table.rows[0][3]), 0.8);
        auto* view = feeds.strip().findChild<CopyTable*>();
        QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), tabSeparated(table, QLocale()));
        feeds.view.plot()->toggleCurve(static_cast<int>(Quantity::force));
        feeds.view.plot()->replot();
        settle();
        QCOMPARE(feeds.cell(quantityWithUnit(Quantity::force), 1), QStringLiteral("no such row"));
    }

    void picturesHoldThemOnlyWhileShown() {
        Feeds feeds(m_run);
        const auto picture = [&] {
            feeds.view.tools()->copyPicture->trigger();
            return QApplication::clipboard()->image();
        };
        QAction& toggle = *feeds.view.cursors()->toggle;
        toggle.setChecked(false);
        settle();
        const QSize view = feeds.view.size();
        const int height = feeds.view.plot()->height();
        const QImage without = picture();
        toggle.setChecked(true);
        settle();
        feeds.view.resize(view.width(), view.height() + height - feeds.view.plot()->height());
        settle();
        feeds.view.plot()->replot(QCustomPlot::rpImmediateRefresh);
        const QImage with = picture();
        QCOMPARE(with.size(), without.size());
        QVERIFY(with != without);
        toggle.setChecked(false);
        feeds.view.resize(view);
        settle();
        feeds.view.plot()->replot(QCustomPlot::rpImmediateRefresh);
        QCOMPARE(picture(), without);
    }

    void limitsAreReadAsTheEngineGivesThem() {
        Project project = traverseProject();
        project.material->burn_rise_k = 700;
        project.machine->wheel_drive_kw = 4;
        const OutcomePtr outcome = run(project);
        ConstraintsView view;
        show(view, outcome);
        const LimitGroup& group =
            outcome->limits.groups[static_cast<std::size_t>(view.plot()->group())];
        const LimitedCut& cut = group.cuts[group.cuts.size() / 2];
        const ReadCurves curves = view.plot()->readCurves();
        const double x = cut.stock_mm * 1000;
        QVERIFY(std::abs(*curves.front().at(x) - cut.depth_mm * 1000) < 1e-6);
        int limits = 0;
        for (const DepthLimit& limit : depthLimits(project, cut.width_mm, cut.stock_mm)) {
            const QString name = QStringLiteral("limit: %1, µm").arg(LimitNames::limit(limit.kind));
            const auto curve = std::ranges::find(curves, name, &ReadCurve::name);
            if (curve != curves.end() && limit.kind != ConstraintKind::roughness) {
                ++limits;
                const double read = *curve->at(x), is = limit.depth_mm * 1000;
                QVERIFY2(std::abs(read - is) < 0.01 * is, qPrintable(QString::number(read / is)));
            }
        }
        QCOMPARE(limits, 2);
    }

    void complianceIsReadAtAPlaceOfThePart() {
        const Project project = exampleProject("slender-shaft");
        const OutcomePtr outcome = run(project);
        QVERIFY(outcome->ran());
        ComplianceView view;
        show(view, outcome);
        const auto places = complianceAlong(project, 7); // other ones than are drawn
        QVERIFY(!places.empty());
        const ReadCurves curves = view.plot()->readCurves();
        for (const CompliantPlace& place : places) {
            const double is = sumOf(place.parts) * nmPerMm;
            const auto read = curves.front().at(place.position_mm);
            QVERIFY(read && std::abs(*read - is) < 1e-3 * is);
        }
    }

    void linesAreReadAsTheyAreDrawn() {
        const std::vector<XY> line{{0, 1}, {2, 3}, {2, 7}, {4, 7}};
        QVERIFY(!valueAt(line, -0.1) && !valueAt(line, 4.1));
        QCOMPARE(*valueAt(line, 1), 2.0);
        QCOMPARE(*valueAt(line, 2), 7.0); // where it steps, what it steps to
        QCOMPARE(*valueAt(line, 4), 7.0);
        QCustomPlot plot;
        QCPGraph* graph = plot.addGraph();
        graph->setData({0, 2}, {1, 100}, true);
        QCOMPARE(*valueAt(*graph, 1), 50.5);
        plot.yAxis->setScaleType(QCPAxis::stLogarithmic);
        QVERIFY(std::abs(*valueAt(*graph, 1) - 10) < 1e-9);
        QVERIFY(std::abs(*valueAt({{0, 1}, {2, 100}}, 1, true) - 10) < 1e-9);
        const std::vector<XY> back{{3, 1}, {1, 100}, {2, 100}};
        QCOMPARE(*lastValueAt(back, 1.5), 100.0); // passed twice: the last time
        QCOMPARE(*lastValueAt(back, 2.5), 25.75);
        QVERIFY(std::abs(*lastValueAt(back, 2.5, true) - std::sqrt(std::sqrt(100.0))) < 1e-9);
        QVERIFY(!lastValueAt(back, 3.1));
    }

    void textsHaveRoomInEveryViewWithCursors_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << "en";
        QTest::newRow("Russian") << "ru";
    }

    void textsHaveRoomInEveryViewWithCursors() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        int views = 0;
        for (View* view : bench.window->views()) {
            bench.window->viewTabs().showView(view);
            bench.settle();
            for (auto* strip : view->findChildren<CursorStrip*>()) {
                ++views;
                view->findChild<QAction*>(QStringLiteral("cursors"))->trigger();
                bench.settle();
                settle();
                QVERIFY(strip->isVisible());
                QVERIFY(strip->model()->rowCount() > 1 || view->objectName() == u"compliance");
            }
            const QStringList without = textsWithoutRoom(*bench.window);
            QVERIFY2(without.isEmpty(), qPrintable(without.join(u'\n')));
            QVERIFY2(bench.window->size() == QSize(1366, 768), qPrintable(view->objectName()));
        }
        QCOMPARE(views, 5);
    }

private:
    OutcomePtr m_run;
};

} // namespace sparkout::test_cursors

SPARKOUT_TEST(test_cursors, TestCursors)
#include "test_cursors.moc"
