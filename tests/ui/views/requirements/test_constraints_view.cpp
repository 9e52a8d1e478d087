// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The view "Constraints": a row leads to its place and its formula, and what is off to its field.
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/quality/constraints.h"
#include "core/quality/power.h"
#include "core/surface/formula.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "tests/ui/views/requirements/constraints_bench.h"
#include "ui/chart/legend.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/window/view_tabs.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <variant>

namespace test_constraints_view {

using namespace sparkout;
using namespace constraints_bench;

class TestConstraintsView : public QObject {
    Q_OBJECT

private slots:
    void everyLightStandsOnTheFirstLineOfItsText() {
        const Shown shown(run(limitedProject()));
        auto& table = shown.part<CopyTable>("margins");
        const QImage image = table.viewport()->grab().toImage();
        const int line = table.fontMetrics().height();
        int seen = 0;
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            const QRect cell = table.visualRect(table.model()->index(row, 0));
            if (!table.viewport()->rect().contains(cell)) {
                continue;
            }
            const QColor ground = image.pixelColor(cell.left() + 1, cell.top() + 1);
            int top = cell.bottom(), bottom = cell.top();
            for (int y = cell.top() + 1; y < cell.bottom(); ++y) {
                for (int x = cell.left() + 2; x < cell.left() + table.iconSize().width(); ++x) {
                    if (image.pixelColor(x, y) != ground) {
                        top = std::min(top, y);
                        bottom = std::max(bottom, y);
                    }
                }
            }
            const bool isOneLine = cell.height() < 2 * line;
            const double text = isOneLine ? cell.center().y() : cell.top() + line / 2.0;
            QVERIFY2(std::abs((top + bottom) / 2.0 - text) <= 2, qPrintable(QString::number(row)));
            ++seen;
        }
        QVERIFY(seen > 2);
    }

    void requirementsAreSortedByWhatTheyUse() {
        const OutcomePtr outcome = run(limitedProject());
        Shown shown(outcome);
        const MarginModel& model = *shown.view.margins();
        QCOMPARE(model.rowCount(), static_cast<int>(worstByKind(outcome->constraints).size()));
        for (int row = 1; row < model.rowCount(); ++row) {
            const ConstraintResult &above = model.at(row - 1), &here = model.at(row);
            const auto setting = [](const ConstraintResult& c) {
                return requirementOf(c.kind).scope == ConstraintScope::setting;
            };
            QVERIFY(above.holds < here.holds || setting(above) < setting(here)
                    || (above.holds == here.holds && usageOf(above) >= usageOf(here)));
        }
        const ConstraintResult& power = model.at(shown.rowOf(ConstraintKind::wheelPower));
        QCOMPARE(usageOf(power), std::max(power.value / power.limit, 0.0));
        shown.part<QCheckBox>("everyPlace").click();
        QCOMPARE(model.rowCount(), static_cast<int>(outcome->constraints.size()));
    }

    void aSettingIsToldByTheEndsOfItsRange() {
        Project project = limitedProject();
        const double feed = *project.cycle->stages.front().radial_feed_mm;
        project.machine->limits.radial_feed_mm = {feed / 2, feed * 50, 0};
        for (Stage& stage : project.cycle->stages) {
            stage.radial_feed_mm = stage.radial_feed_mm ? std::optional(feed) : std::nullopt;
        }
        const Shown shown(run(project));
        const MarginModel& model = *shown.view.margins();
        const int row = shown.rowOf(ConstraintKind::rangeRadialFeed);
        QVERIFY(row >= 0);
        const ConstraintResult& c = model.at(row);
        QVERIFY(std::abs(c.relativeMargin) < 0.05); // the share of its field: next to nothing
        QCOMPARE(model.index(row, MarginModel::usage).data().toString(), QStringLiteral("2×"));
        QVERIFY(model.index(row, MarginModel::usage)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("2×, range ")));
        const double place = placeInRange(c).value();
        QVERIFY(std::abs(place - std::log(2) / std::log(100)) < 1e-9);
        const QStringList cells = model.asTsv().split(u'\n').at(row + 1).split(u'\t');
        QVERIFY(cells.at(1).isEmpty()); // no share is used up
        QCOMPARE(QLocale().toDouble(cells.at(6)), 2.0);
        QCOMPARE(Names::limit(c).left(1), QStringLiteral("≥"));

        ConstraintResult end = c; // at the upper end exactly
        end.value = end.limit = feed * 50;
        end.otherEnd = feed / 2;
        end.isLeast = false;
        end.margin = end.relativeMargin = 0;
        QCOMPARE(Names::limit(end).left(1), QStringLiteral("≤"));
        QCOMPARE(Names::margin(end), QStringLiteral("1×"));
        end.value *= 1.004;
        end.holds = false;
        QCOMPARE(Names::margin(end), QStringLiteral("%1×").arg(QLocale().toString(0.996)));
        QCOMPARE(placeInRange(end).value(), 1.0);
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
            QCOMPARE(shown.plot().limits().marked().value().depth_mm, cut.depth_mm);
            QCOMPARE(shown.plot().group(), limitGroupAt(outcome->limits, cut.place));
            const FormulaSheet sheet =
                constraintSheet(outcome->result, outcome->accuracy, constraint).value();
            QVERIFY(bare(shown.sheet()).contains(bare(formulaText(sheet))));
            QVERIFY(!shown.sheet().contains(u'_')); // indices are below the line
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
        project.machine->wheel_speed_m_s *= 1.2;
        const OutcomePtr outcome = run(project);
        shown.show(outcome);
        QVERIFY(shown.sheet() != before);
        const FormulaSheet sheet =
            constraintSheet(outcome->result, outcome->accuracy,
                            shown.view.margins()->at(shown.rowOf(ConstraintKind::wheelPower)))
                .value();
        QVERIFY(bare(shown.sheet()).contains(bare(formulaText(sheet))));
        QVERIFY(!shown.sheet().contains(u'_')); // indices are below the line
    }

    void whatIsOffLeadsToItsField() {
        Shown shown(run(unlimited(traverseProject())));
        QVERIFY(shown.part<QLabel>("constraintsNotice").isVisible());
        QVERIFY(!shown.actual().empty());
        QVERIFY(shown.points(LimitChart::steplessKey).empty());
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
        project.machine->compliance_mm_per_n = std::monostate{};
        project.machine->stiffness_n_um.emplace();
        project.part->shaft.ground_from_mm = 20;
        project.part->shaft.segments = {{80, project.part->diameter_mm}};
        project.sections_coupled = true;
        Shown shown(run(project));
        auto& notice = shown.part<QLabel>("constraintsNotice");
        QVERIFY(notice.text().startsWith(QStringLiteral("No limit of the feed is active")));
        project.machine->wheel_drive_kw = 4;
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

    void emptyStatesSayWhatToDo() {
        ConstraintsView view;
        view.show();
        auto& notice = *view.findChild<QLabel*>(QStringLiteral("constraintsNotice"));
        QVERIFY(notice.isVisible() && !notice.text().isEmpty());
        QVERIFY(!view.plot()->isVisible());
        Shown shown(run(limitedProject()));
        const std::size_t cuts = shown.actual().size();
        shown.show(fixtures::refused());
        QVERIFY(shown.part<QLabel>("constraintsNotice").isVisible());
        QCOMPARE(shown.actual().size(), cuts); // the last good run's
        auto unrecorded = std::make_shared<Outcome>(*run(limitedProject()));
        unrecorded->trajectory = {};
        unrecorded->limits = makeLimitSeries(unrecorded->result, {});
        shown.show(unrecorded);
        QVERIFY(!shown.plot().isVisible());
        QVERIFY(shown.part<CopyTable>("margins").isVisible());
        shown.click(shown.rowOf(ConstraintKind::burn));
        QVERIFY(!shown.plot().limits().marked());
    }

    void mouseLegendAndTable() {
        Shown shown(run(limitedProject()));
        fixtures::hover(&shown.plot(), shown.plot().pixelOf(shown.actual()[3]));
        QVERIFY(shown.part<QLabel>("constraintsValues").text().contains(QStringLiteral("%")));
        auto* legend = shown.view.findChild<LegendStrip*>();
        for (std::size_t i = 0; i < legend->entries().size(); ++i) {
            if (legend->entries()[i].key == static_cast<int>(ConstraintKind::burn)) {
                QTest::mouseClick(legend, Qt::LeftButton, {},
                                  legend->entryRect(static_cast<int>(i)).center());
            }
        }
        QVERIFY(!shown.plot().shows(static_cast<int>(ConstraintKind::burn)));
        const CsvTable table = shown.plot().table();
        QCOMPARE(table.rows.size(), shown.actual().size());
        for (const auto& row : table.rows) {
            QCOMPARE(static_cast<qsizetype>(row.size()), table.header.size());
        }
        shown.part<CopyTable>("margins").setFocus();
        QTest::keyClick(&shown.part<CopyTable>("margins"), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text().count(u'\n'),
                 shown.view.margins()->rowCount() + 1);
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
