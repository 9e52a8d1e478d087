// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Constraints": what it draws is the engine's, a row leads to its place and its formula.
#include "core/quality/constraint_sheet.h"
#include "core/quality/formula.h"
#include "core/quality/power.h"
#include "tests/registry.h"
#include "tests/ui/view_fixtures.h"
#include "tests/ui/window_bench.h"
#include "ui/session/texts.h"
#include "ui/view_tabs.h"
#include "ui/views/constraints_plot.h"
#include "ui/views/constraints_view.h"
#include "ui/views/copy_table.h"
#include "ui/views/formula_text.h"
#include "ui/views/legend_strip.h"
#include "ui/views/limit_names.h"
#include "ui/views/margin_model.h"
#include "ui/views/plot_tools.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace test_constraints_view {

using namespace sparkout;
using fixtures::plungeProject;
using fixtures::run;
using fixtures::traverseProject;

namespace {

Project limitedProject() {
    Project p = traverseProject();
    p.material.burn_rise_k = 700;
    p.machine.wheel_drive_kw = 4;
    p.part.tolerance.roughness_ra_um = 0.8;
    return p;
}

/// All that is evaluated.
Project fullyLimitedProject() {
    Project p = limitedProject();
    p.machine.work_drive_kw = 1;
    p.wheel.grain_surface_energy_j_m2 = 1800;
    p.wheel.grain_modulus_gpa = 390;
    p.wheel.bond_surface_energy_j_m2 = 400;
    p.wheel.bond_modulus_gpa = 65;
    p.part.tolerance = {4, 6, 5, 8, 0.8};
    return p;
}

Project unlimited(Project p) {
    p.material.burn_rise_k.reset();
    p.machine.wheel_drive_kw.reset();
    p.machine.work_drive_kw.reset();
    return p;
}

/// A formula's text as a text editor gives it back.
QString asShown(const FormulaSheet& sheet) {
    return formulaText(sheet).replace(QChar::Nbsp, u' ');
}

/// A view as it stands in the window, with a run drawn.
struct Shown {
    explicit Shown(const OutcomePtr& outcome) {
        view.resize(760, 620);
        view.show();
        show(outcome);
    }
    void show(const OutcomePtr& outcome) {
        QSignalSpy updated(&view, &View::updated);
        view.setOutcome(outcome);
        QTRY_COMPARE(updated.count(), 1);
        QTest::qWait(20);
    }
    [[nodiscard]] ConstraintsPlot& plot() const { return *view.plot(); }
    template <typename T>
    [[nodiscard]] T& part(const char* name) const {
        return *view.findChild<T*>(QLatin1String(name));
    }
    [[nodiscard]] QString sheet() const {
        return part<QPlainTextEdit>("formulaSheet").toPlainText();
    }
    [[nodiscard]] int rowOf(ConstraintKind kind) const {
        for (int row = 0; row < view.margins()->rowCount(); ++row) {
            if (view.margins()->at(row).kind == kind) {
                return row;
            }
        }
        return -1;
    }
    void click(int row) const {
        auto& table = part<CopyTable>("margins");
        const QModelIndex index = view.margins()->index(row, 0);
        table.scrollTo(index);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(index).center());
    }
    ConstraintsView view;
};

} // namespace

class TestConstraintsView : public QObject {
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
        QSignalSpy updated(&view, &View::updated);
        view.setOutcome(outcome);
        QTRY_COMPARE(updated.count(), 1);
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

    void theCutsDrawnAreTheTrajectorys() {
        const OutcomePtr outcome = run(limitedProject());
        Shown shown(outcome);
        const auto& groups = outcome->limits.groups;
        auto& zones = shown.part<QComboBox>("constraintsZone");
        QCOMPARE(zones.count(), static_cast<int>(groups.size()));
        for (int g = 0; g < zones.count(); ++g) {
            zones.setCurrentIndex(g);
            const LimitGroup& group = groups[static_cast<std::size_t>(g)];
            const auto drawn = shown.plot().actual()->data();
            QCOMPARE(drawn->size(), static_cast<int>(group.cuts.size()));
            // Each is a visit of that zone, with the stock its radius keeps.
            for (int i = 0; i < drawn->size(); i += 7) {
                const double stock_um = drawn->at(i)->key, depth_um = drawn->at(i)->value;
                const bool found =
                    std::ranges::any_of(outcome->trajectory.passes, [&](const Pass& pass) {
                        if (pass.place.zone != group.zone) {
                            return false;
                        }
                        for (int k = 0; k < outcome->trajectory.radii; ++k) {
                            const Visit& v =
                                outcome->trajectory
                                    .visits[pass.firstVisit + static_cast<std::size_t>(k)];
                            if (std::abs(v.actual_mm * 1000 - depth_um) < 1e-9
                                && std::abs((v.radius_mm - outcome->feeds.target_mm) * 1000
                                            - stock_um)
                                       < 1e-9) {
                                return true;
                            }
                        }
                        return false;
                    });
                QVERIFY(found);
            }
        }
    }

    void theCurvesDrawnAreTheEnginesLimits() {
        const Project project = limitedProject();
        const OutcomePtr outcome = run(project);
        Shown shown(outcome);
        for (const ConstraintKind kind :
             {ConstraintKind::burn, ConstraintKind::wheelPower, ConstraintKind::roughness}) {
            const QCPGraph* graph = shown.plot().limit(kind);
            QVERIFY(graph);
            const LimitGroup& group =
                outcome->limits.groups[static_cast<std::size_t>(shown.plot().group())];
            for (const QCPGraphData& point : *graph->data()) {
                bool met = false;
                for (const LimitedStage& stage : group.stages) {
                    for (const DepthLimit& limit :
                         depthLimits(project, stage.width_mm, point.key / 1000)) {
                        met = met
                              || (limit.kind == kind
                                  && std::abs(limit.depth_mm * 1000 - point.value)
                                         < 1e-9 * point.value);
                    }
                }
                QVERIFY(met);
            }
        }
        QVERIFY(!shown.plot().limit(ConstraintKind::selfSharpening));
        QVERIFY(shown.plot().stepless()->dataCount() > 2);
    }

    void theCycleRunsFromLeftToRight() {
        Shown shown(run(limitedProject()));
        const QCPAxis* axis = shown.plot().stockAxis();
        QVERIFY(axis->coordToPixel(100) < axis->coordToPixel(0));
        const QCPRange before = axis->range();
        shown.view.tools()->navigation().pan(1, 0); // to the right: less stock
        QVERIFY(axis->range().center() < before.center());
    }

    void cutsAboveTheirLimitAreMarked() {
        Project project = limitedProject();
        Shown held(run(project));
        QCOMPARE(held.plot().exceeded()->data()->size(), 0);
        project.material.burn_rise_k = 60;
        const OutcomePtr outcome = run(project);
        Shown shown(outcome);
        const LimitGroup& group =
            outcome->limits.groups[static_cast<std::size_t>(shown.plot().group())];
        const auto above =
            std::ranges::count_if(group.cuts, [](const LimitedCut& c) { return c.usage > 1; });
        QVERIFY(above > 0);
        QCOMPARE(shown.plot().exceeded()->data()->size(), static_cast<int>(above));
        // It starts with the zone that comes nearest, and marks where.
        for (const LimitGroup& other : outcome->limits.groups) {
            QVERIFY(other.worst.usage <= group.worst.usage);
        }
        QCOMPARE(shown.plot().marked().value().depth_mm, group.worst.depth_mm);
    }

    void requirementsAreSortedByWhatTheyUse() {
        const OutcomePtr outcome = run(limitedProject());
        Shown shown(outcome);
        const MarginModel& model = *shown.view.margins();
        QCOMPARE(model.rowCount(), static_cast<int>(worstByKind(outcome->constraints).size()));
        for (int row = 1; row < model.rowCount(); ++row) {
            const ConstraintResult &above = model.at(row - 1), &here = model.at(row);
            const auto setting = [](const ConstraintResult& c) {
                return scopeOf(c.kind) == ConstraintScope::setting;
            };
            QVERIFY(above.holds < here.holds || setting(above) < setting(here)
                    || (above.holds == here.holds && usageOf(above) >= usageOf(here)));
        }
        const ConstraintResult& power = model.at(shown.rowOf(ConstraintKind::wheelPower));
        QCOMPARE(usageOf(power), std::max(power.value / power.limit, 0.0));
        shown.part<QCheckBox>("everyPlace").click();
        QCOMPARE(model.rowCount(), static_cast<int>(outcome->constraints.size()));
    }

    void aRowLeadsToItsPlaceAndItsFormula() {
        const OutcomePtr outcome = run(limitedProject());
        Shown shown(outcome);
        QSignalSpy chosen(&shown.view, &ConstraintsView::requirementChosen);
        for (const ConstraintKind kind :
             {ConstraintKind::burn, ConstraintKind::wheelPower, ConstraintKind::roughness}) {
            shown.click(shown.rowOf(kind));
            const ConstraintResult constraint = shown.view.margins()->at(shown.rowOf(kind));
            const LimitedCut cut =
                limitedCutOf(outcome->result, outcome->trajectory, constraint).value();
            QVERIFY(shown.plot().marked());
            QCOMPARE(shown.plot().marked()->depth_mm, cut.depth_mm);
            QCOMPARE(shown.plot().group(), limitGroupAt(outcome->limits, cut.place));
            const FormulaSheet sheet =
                constraintSheet(outcome->result, outcome->accuracy, constraint).value();
            QVERIFY(shown.sheet().contains(asShown(sheet)));
        }
        QCOMPARE(chosen.count(), 3);
        QSignalSpy entered(&shown.view, &ConstraintsView::requirementEntered);
        shown.part<QPushButton>("showWhere").click();
        QTest::keyClick(&shown.part<CopyTable>("margins"), Qt::Key_Return);
        QCOMPARE(entered.count(), 2);
    }

    void aFormulaCanBeChecked() {
        RoundnessZone zone;
        zone.outer_mm = 15.000004;
        zone.inner_mm = 15;
        const auto restore = qScopeGuard([own = QLocale()] { QLocale::setDefault(own); });
        QLocale::setDefault(QLocale::C);
        const QString text = formulaText(roundnessSheet(zone));
        QVERIFY2(text.contains(QStringLiteral("15.000004 − 15 = 4·10⁻⁶")), qPrintable(text));
        // Each step: symbols, the numbers in their places, the result with its unit.
        const FormulaSheet sheet = wheelPowerSheet(limitedProject(), 10, 0.004);
        const QStringList lines = formulaText(sheet).split(u'\n');
        QCOMPARE(lines.size(), static_cast<qsizetype>(sheet.steps.size()) + 1);
        for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
            const FormulaStep& step = sheet.steps[i];
            const QString& line = lines[static_cast<qsizetype>(i) + 1];
            QVERIFY2(line.startsWith(QString::fromUtf8(step.result.symbol) + u' '),
                     qPrintable(line));
            QVERIFY2(line.contains(QStringLiteral(" = ")), qPrintable(line));
            QVERIFY2(line.endsWith(unitText(step.result.unit)), qPrintable(line));
        }
    }

    void theChoiceOutlivesANewRun() {
        Project project = limitedProject();
        Shown shown(run(project));
        shown.click(shown.rowOf(ConstraintKind::wheelPower));
        const QString before = shown.sheet();
        project.machine.wheel_speed_m_s *= 1.2;
        const OutcomePtr outcome = run(project);
        shown.show(outcome);
        QVERIFY(shown.sheet() != before);
        const FormulaSheet sheet =
            constraintSheet(outcome->result, outcome->accuracy,
                            shown.view.margins()->at(shown.rowOf(ConstraintKind::wheelPower)))
                .value();
        QVERIFY(shown.sheet().contains(asShown(sheet)));
    }

    void whatIsOffLeadsToItsField() {
        Shown shown(run(unlimited(traverseProject())));
        QVERIFY(shown.part<QLabel>("constraintsNotice").isVisible());
        QVERIFY(shown.plot().hasCuts());
        QCOMPARE(shown.plot().stepless()->dataCount(), 0);
        auto& off = shown.part<QLabel>("limitsOff");
        QVERIFY(off.isVisible());
        QSignalSpy asked(&shown.view, &ConstraintsView::pathAsked);
        for (const OffLimit& limit : LimitNames::off(unlimited(traverseProject()))) {
            const QString path = QString::fromStdString(limit.path);
            QVERIFY(off.text().contains(path));
            emit off.linkActivated(path);
            QCOMPARE(asked.takeFirst().first().value<std::string>(), limit.path);
        }
        shown.show(run(limitedProject()));
        QVERIFY(!shown.part<QLabel>("constraintsNotice").isVisible());
        QVERIFY(!off.text().contains(QStringLiteral("burn_rise_k")));
    }

    // Power binds all of the length together, so it is no limit of one section.
    void coupledSectionsShareThePower() {
        Project project = unlimited(plungeProject(3));
        const auto zone = [](const Shown& shown) {
            return shown.part<QComboBox>("constraintsZone").itemText(0);
        };
        project.machine.compliance_mm_per_n = std::monostate{};
        project.machine.stiffness_n_um.emplace();
        project.part.shaft.ground_from_mm = 20;
        project.part.shaft.segments = {{80, project.part.diameter_mm}};
        project.sections_coupled = true;
        Shown shown(run(project));
        auto& notice = shown.part<QLabel>("constraintsNotice");
        QVERIFY(notice.text().startsWith(QStringLiteral("No limit of the feed is on")));
        project.machine.wheel_drive_kw = 4;
        shown.show(run(project));
        QVERIFY(shown.rowOf(ConstraintKind::wheelPower) >= 0);
        QVERIFY2(notice.text().startsWith(QStringLiteral("Coupled sections share")),
                 qPrintable(notice.text()));
        QVERIFY(!zone(shown).contains(u'%'));
        project.sections_coupled = false;
        shown.show(run(project));
        QVERIFY(!notice.isVisible());
        QVERIFY(zone(shown).contains(u'%'));
    }

    void cutsThatOutgrowThePlotBringItAlong() {
        Project project = unlimited(plungeProject(1));
        Shown shown(run(project));
        const auto feeds = [&] { return shown.plot().feedAxis()->range(); };
        const auto highest = [&] {
            bool found = false;
            return shown.plot().actual()->getValueRange(found).upper;
        };
        const auto feedTimes = [&project](double times) {
            for (Stage& stage : project.cycle.stages) {
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
            QVERIFY2(shown.plot().feedAxis()->label().endsWith(
                         standing ? QStringLiteral("per revolution") : QStringLiteral("per pass")),
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

    void emptyStatesSayWhatToDo() {
        ConstraintsView view;
        view.show();
        auto& notice = *view.findChild<QLabel*>(QStringLiteral("constraintsNotice"));
        QVERIFY(notice.isVisible() && !notice.text().isEmpty());
        QVERIFY(!view.plot()->isVisible());
        Shown shown(run(limitedProject()));
        const auto cuts = shown.plot().actual()->data()->size();
        shown.show(fixtures::refused());
        QVERIFY(shown.part<QLabel>("constraintsNotice").isVisible());
        QCOMPARE(shown.plot().actual()->data()->size(), cuts); // the last good run's
        auto unrecorded = std::make_shared<Outcome>(*run(limitedProject()));
        unrecorded->trajectory = {};
        unrecorded->limits = makeLimitSeries(unrecorded->result, {});
        shown.show(unrecorded);
        QVERIFY(!shown.plot().isVisible());
        QVERIFY(shown.part<CopyTable>("margins").isVisible());
        shown.click(shown.rowOf(ConstraintKind::burn));
        QVERIFY(!shown.plot().marked());
    }

    void aLogarithmicAxisShowsTheSparkingOut() {
        Project project = limitedProject();
        Stage spark = project.cycle.stages.back();
        spark.spark_out = {SparkOut::Mode::count, 10};
        spark.stock_mm = 0;
        project.cycle.stages.push_back(spark);
        Shown shown(run(project));
        const auto sight = [&] { return shown.plot().feedAxis()->range(); };
        const auto reaches = [&](const QCPRange& range) { // the least of the limits
            bool found = false;
            return range.contains(shown.plot().stepless()->getValueRange(found).lower);
        };
        QCOMPARE(shown.plot().feedAxis()->scaleType(), QCPAxis::stLogarithmic);
        QVERIFY(sight().lower > 0 && reaches(sight()));
        shown.part<QCheckBox>("logarithmic").click();
        QVERIFY(sight().lower == 0 && reaches(sight()));
        shown.part<QCheckBox>("logarithmic").click();
        QVERIFY(sight().lower > 0 && reaches(sight()));
    }

    void mouseLegendAndTable() {
        Shown shown(run(limitedProject()));
        const auto& point = *shown.plot().actual()->data()->at(3);
        fixtures::hover(&shown.plot(), QPointF(shown.plot().stockAxis()->coordToPixel(point.key),
                                               shown.plot().feedAxis()->coordToPixel(point.value)));
        QVERIFY(shown.part<QLabel>("constraintsValues").text().contains(QStringLiteral("%")));
        auto* legend = shown.view.findChild<LegendStrip*>();
        for (std::size_t i = 0; i < legend->entries().size(); ++i) {
            if (legend->entries()[i].key == static_cast<int>(ConstraintKind::burn)) {
                QTest::mouseClick(legend, Qt::LeftButton, {},
                                  legend->entryRect(static_cast<int>(i)).center());
            }
        }
        QVERIFY(!shown.plot().limit(ConstraintKind::burn)->visible());
        const CsvTable table = shown.plot().table();
        QCOMPARE(table.rows.size(),
                 static_cast<std::size_t>(shown.plot().actual()->data()->size()));
        for (const auto& row : table.rows) {
            QCOMPARE(static_cast<qsizetype>(row.size()), table.header.size());
        }
        shown.part<CopyTable>("margins").setFocus();
        QTest::keyClick(&shown.part<CopyTable>("margins"), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text().count(u'\n'),
                 shown.view.margins()->rowCount() + 1);
    }

    void everySectionCanBeChosen() {
        Project project = plungeProject(6);
        project.material.burn_rise_k = 700;
        Shown shown(run(project));
        auto& zones = shown.part<QComboBox>("constraintsZone");
        QCOMPARE(zones.count(), 6);
        zones.setCurrentIndex(4);
        QCOMPARE(shown.plot().group(), 4);
        project.cycle.stages[0].radial_feed_mm_min = 0.4;
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
            for (const QCPCurveData& cut : *plot->actual()->data()) {
                fixtures::hover(plot, QPointF(plot->stockAxis()->coordToPixel(cut.key),
                                              plot->feedAxis()->coordToPixel(cut.value)));
                QVERIFY(values->text().contains(u'%'));
                QVERIFY2(values->heightForWidth(values->width()) <= values->height(),
                         qPrintable(values->text()));
            }
        }
    }

    void formulasSpeakRussian() {
        const OutcomePtr outcome = run(fullyLimitedProject());
        Bench bench(QStringLiteral("ru"));
        int sheets = 0;
        for (const ConstraintResult& c : worstByKind(outcome->constraints)) {
            const auto sheet = constraintSheet(outcome->result, outcome->accuracy, c);
            if (!sheet) {
                continue;
            }
            ++sheets;
            QVERIFY2(QCoreApplication::translate("Formula", sheet->name)
                         != QString::fromUtf8(sheet->name),
                     sheet->name);
            for (const FormulaStep& step : sheet->steps) {
                const char* unit = step.result.unit;
                QVERIFY2(!unit || !*unit || unitText(unit) != QString::fromUtf8(unit), unit);
                QVERIFY2(std::string_view(step.text).find(" = ") != std::string_view::npos,
                         step.text);
            }
        }
        QVERIFY(sheets >= 8);
    }

    void inTheWindowARowGoesWhereTheVerdictGoes() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().first()));
        QVERIFY(bench.window->showView(QStringLiteral("constraints")));
        bench.settle();
        auto* view = bench.window->findChild<ConstraintsView*>();
        auto* table = view->findChild<CopyTable*>(QStringLiteral("margins"));
        const MarginModel& model = *view->margins();
        for (int row = 0; row < model.rowCount(); ++row) {
            if (model.at(row).kind == ConstraintKind::burn) {
                table->setCurrentIndex(model.index(row, 0));
            }
        }
        QCOMPARE(bench.window->viewTabs().currentView()->objectName(),
                 QStringLiteral("constraints"));
        QTest::keyClick(table, Qt::Key_Return);
        bench.settle();
        QCOMPARE(bench.window->viewTabs().currentView()->objectName(), QStringLiteral("feeds"));
    }
};

} // namespace test_constraints_view

SPARKOUT_TEST(test_constraints_view, TestConstraintsView)
#include "test_constraints_view.moc"
