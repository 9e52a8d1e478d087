// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict panel: the shop's numbers, what stays in sight, what a click and a copy give.
#include "core/project/project_file.h"
#include "ui/session/run_controller.h"
#include "ui/views/copy_table.h"
#include "ui/views/names.h"
#include "ui/views/verdict_model.h"
#include "ui/views/verdict_panel.h"
#include "ui/views/verdict_shop.h"
#include "ui/views/verdict_shop_model.h"
#include "ui/views/verdict_why.h"

#include "tests/registry.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <QWheelEvent>
#include <QtTest/qtestspontaneevent.h>
#include <nlohmann/json.hpp>

#include <clocale>
#include <numbers>

namespace test_verdict {

using namespace sparkout;

namespace {

Project traverseProject(int stages = 2) {
    Project p;
    p.part.tolerance.radial_runout_um = 6;
    p.machine.compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
    p.machine.dwell_entry_s = 0.333;
    for (int z = 0; z < stages; ++z) {
        Stage stage;
        stage.radial_feed_mm = 0.004 / (1 + z);
        stage.axial_feed_mm_min = 1800 / (1 + z);
        stage.stock_mm = p.part.stock_mm / stages;
        p.cycle.stages.push_back(stage);
    }
    return p;
}

Project plungeProject(int sections, int stages = 2) {
    Project p = traverseProject();
    p.operation = Operation::plunge;
    p.sections = sections;
    p.part.length_mm = 40;
    p.machine.compliance_mm_per_n = std::vector<double>(static_cast<std::size_t>(sections), 2e-5);
    p.cycle.stages.clear();
    for (int z = 0; z < stages; ++z) {
        Stage stage;
        stage.radial_feed_mm_min = 0.6 / (1 + z);
        stage.stock_mm = p.part.stock_mm / stages;
        p.cycle.stages.push_back(stage);
    }
    return p;
}

OutcomePtr run(const Project& project) {
    return runProject(project, {});
}

/// A panel of a width, with an outcome, as it stands in the window.
struct Bench {
    explicit Bench(const OutcomePtr& outcome, QSize size = {320, 640}) {
        panel.resize(size);
        panel.show();
        show(outcome);
    }
    /// Until what queued calls and layouts leave is as it stays, however busy the machine is.
    void show(const OutcomePtr& outcome) {
        panel.setOutcome(outcome);
        QList<int> before;
        for (int calm = 0, round = 0; calm < 3 && round < 500; ++round) {
            QTest::qWait(10);
            const QWidget* page = area().widget();
            const QList<int> now{
                page->width(),   page->height(),   page->minimumSizeHint().height(),
                table().width(), table().height(), requirements().height()};
            calm = now == before ? calm + 1 : 0;
            before = now;
        }
    }
    [[nodiscard]] ShopModel& model() { return *panel.shop()->model(); }
    [[nodiscard]] CopyTable& table() { return *panel.shop()->table(); }
    [[nodiscard]] CopyTable& requirements() {
        return *panel.findChild<CopyTable*>(QStringLiteral("requirements"));
    }
    [[nodiscard]] QLabel& label(const char* name) {
        return *panel.findChild<QLabel*>(QString::fromLatin1(name));
    }
    [[nodiscard]] QScrollArea& area() { return *panel.findChild<QScrollArea*>(); }
    [[nodiscard]] int row(ShopRow wanted) {
        for (int r = 0; r < model().rowCount(); ++r) {
            if (model().rowAt(r) == wanted) {
                return r;
            }
        }
        return -1;
    }
    [[nodiscard]] QString cell(ShopRow wanted, int column, int role = Qt::DisplayRole) {
        return model().index(row(wanted), column).data(role).toString();
    }
    [[nodiscard]] bool marked(ShopRow wanted, int column) {
        return !model().index(row(wanted), column).data(Qt::DecorationRole).value<QIcon>().isNull();
    }

    VerdictPanel panel;
};

bool isInSight(const QWidget& widget, const QWidget& in) {
    const QRect where(widget.mapTo(&in, QPoint(0, 0)), widget.size());
    return in.rect().contains(where) && widget.visibleRegion().boundingRect() == widget.rect();
}

QPoint middleOfRow(const CopyTable& table, int row) {
    return table.visualRect(table.model()->index(row, 0)).center();
}

/// A press of the right button as the windowing system sends it, which makes the menu event.
QMenu* rightClick(QWidget& on, const QPoint& at) {
    QWidget* window = on.window();
    QTest::mouseClick(window->windowHandle(), Qt::RightButton, Qt::NoModifier,
                      on.mapTo(window, at));
    QTest::qWait(20);
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
}

class Marking : public QTranslator {
public:
    QString translate(const char*, const char* text, const char*, int) const override {
        return QStringLiteral("«") + QString::fromUtf8(text) + QStringLiteral("»");
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace

class TestVerdict : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        std::setlocale(LC_NUMERIC, "C");
        QLocale::setDefault(QLocale::c());
        m_traverse = run(traverseProject());
        m_plunge = run(plungeProject(20));
    }

    // --- the table ------------------------------------------------------------------------------

    void aColumnAStageAndOneForTheCycle() {
        Bench bench(m_traverse);
        const ShopNumbers& shop = m_traverse->shop;
        QCOMPARE(bench.model().columnCount(), 3);
        const auto head = [&](int column) {
            return bench.model().headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        };
        QCOMPARE(head(0) + head(1) + head(2), QStringLiteral("12Cycle"));
        for (int column = 0; column < 3; ++column) {
            const ShopColumn& c = column < 2 ? shop.stages[std::size_t(column)] : shop.cycle;
            const std::pair<ShopRow, double> numbers[] = {
                {ShopRow::time, c.time_s / 60},
                {ShopRow::removalRate, c.removalRate_mm2_s},
                {ShopRow::meanRemovalRate, c.meanRemovalRate_mm2_s},
                {ShopRow::chip, c.equivalentChip_um},
                {ShopRow::aggressiveness, c.aggressiveness},
                {ShopRow::overlap, *c.overlap},
                {ShopRow::energy, *c.energy_j_mm3},
                {ShopRow::peakPower, c.power_w.value / 1000},
                {ShopRow::meanPower, c.meanPower_w / 1000},
                {ShopRow::normalForce, c.normalForce_n.value}};
            QCOMPARE(bench.cell(ShopRow::count, column).toInt(), c.count);
            for (const auto& [row, value] : numbers) {
                const double shown = bench.cell(row, column).toDouble();
                QVERIFY2(std::abs(shown - value) <= std::max(0.005 * value, 0.0005),
                         qPrintable(bench.cell(row, column, Qt::AccessibleTextRole)));
            }
        }
        QCOMPARE(bench.cell(ShopRow::rotationRatio, 0), QString());
        QCOMPARE(bench.cell(ShopRow::rotationRatio, 2).toDouble(), 6.37);
    }

    void plungeHasNoOverlap() {
        Bench bench(m_plunge);
        QCOMPARE(bench.row(ShopRow::overlap), -1);
        QVERIFY(bench.row(ShopRow::energy) > 0);
        const auto first = bench.model().headerData(0, Qt::Vertical, Qt::DisplayRole).toString();
        QCOMPARE(first, QStringLiteral("Revolutions"));
        bench.show(m_traverse);
        QVERIFY(bench.row(ShopRow::overlap) > 0);
    }

    void numbersKeepThreeDigitsAndNeverVanish_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("shown");
        QTest::newRow("nothing") << 0.0 << QStringLiteral("0");
        QTest::newRow("hardly anything") << 0.00004321 << QStringLiteral("0.00004");
        QTest::newRow("small") << 0.024172 << QStringLiteral("0.024");
        QTest::newRow("below one") << 0.7265 << QStringLiteral("0.727");
        QTest::newRow("one") << 1.0 << QStringLiteral("1.00");
        QTest::newRow("tens") << 67.35 << QStringLiteral("67.3");
        QTest::newRow("thousands") << 3281.4 << QStringLiteral("3281");
    }
    void numbersKeepThreeDigitsAndNeverVanish() {
        QFETCH(double, value);
        QFETCH(QString, shown);
        QCOMPARE(shop::number(value), shown);
    }

    void tipsGiveFormulaMeaningAndPlace() {
        Bench bench(m_traverse);
        const QString energy = bench.cell(ShopRow::energy, 0, Qt::ToolTipRole);
        QVERIFY(energy.contains(QStringLiteral("20…120")));
        QVERIFY(energy.contains(QStringLiteral("∫P<sub>z</sub>·V<sub>k</sub> dt")));
        QVERIFY(energy.contains(QStringLiteral(" kJ for "))); // what it is made of
        const QString power = bench.cell(ShopRow::peakPower, 0, Qt::ToolTipRole);
        QVERIFY(power.contains(QStringLiteral("RZ1, E1, stage 1, double stroke")));
        for (int row = 0; row < bench.model().rowCount(); ++row) {
            const QString tip =
                bench.model().headerData(row, Qt::Vertical, Qt::ToolTipRole).toString();
            QVERIFY(tip.startsWith(QStringLiteral("<p>"))); // or it would not wrap
        }
    }

    // --- what lies outside its band -------------------------------------------------------------

    void numbersOutsideTheirBandCarryAnIconAndWords() {
        Project p = traverseProject();
        p.wheel.dullness = 0; // the shear alone, 5.6 J/mm³
        p.cycle.stages[1].axial_feed_mm_min = 1.2 * p.wheel.width_mm * p.machine.work_speed_rpm;
        Bench bench(run(p));
        for (int column = 0; column < 3; ++column) {
            QVERIFY(bench.marked(ShopRow::energy, column));
            QVERIFY(bench.cell(ShopRow::energy, column, Qt::AccessibleTextRole)
                        .endsWith(QStringLiteral("5.60; below the usual")));
            QVERIFY(!bench.marked(ShopRow::peakPower, column));
        }
        QVERIFY(!bench.marked(ShopRow::overlap, 0));
        QVERIFY(bench.marked(ShopRow::overlap, 1));
        const QString remarks = bench.label("shopRemarks").text();
        QVERIFY(bench.label("shopRemarks").isVisible());
        QVERIFY(remarks.contains(QStringLiteral("below 20 J/mm³ (stage 1, 2)")));
        QVERIFY(remarks.contains(QStringLiteral("Overlap below 1 (stage 2)")));
        bench.show(m_traverse);
        QVERIFY(!bench.label("shopRemarks").isVisible());
        QVERIFY(!bench.marked(ShopRow::energy, 0));
    }

    void wholeRotationRatioIsMarked() {
        Project p = plungeProject(1);
        p.machine.work_speed_rpm =
            p.machine.wheel_speed_m_s * 60e3 / (std::numbers::pi * p.wheel.diameter_mm) / 8;
        Bench bench(run(p));
        QVERIFY(bench.marked(ShopRow::rotationRatio, 2));
        QVERIFY(!bench.marked(ShopRow::rotationRatio, 0));
        QVERIFY(bench.label("shopRemarks").text().contains(QStringLiteral("8.00 : 1")));
    }

    // --- copying --------------------------------------------------------------------------------

    void ctrlCCopiesTheTableWithItsHead() {
        Bench bench(m_traverse);
        bench.table().setFocus();
        QTest::keyClick(&bench.table(), Qt::Key_C, Qt::ControlModifier);
        checkCopied(bench);
    }

    void theContextMenuCopiesToo() {
        Bench bench(m_traverse, {320, 1400}); // all of it in sight
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        QMenu* menu = rightClick(*bench.table().viewport(), middleOfRow(bench.table(), 2));
        QVERIFY(menu);
        QCOMPARE(menu->actions().size(), 2); // copy, and save as
        QApplication::clipboard()->clear();
        QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Return);
        checkCopied(bench);
        QMenu* other = rightClick(*bench.requirements().viewport(), QPoint(20, 5));
        QVERIFY(other);
        QTest::keyClick(other, Qt::Key_Down);
        QTest::keyClick(other, Qt::Key_Return);
        const QString copied = QApplication::clipboard()->text();
        QVERIFY(copied.startsWith(QStringLiteral("Zone or section\t")));
        QVERIFY(copied.contains(QStringLiteral("\t-")) && !copied.contains(u'−')); // as Excel reads
    }

    // --- room -----------------------------------------------------------------------------------

    void threeStagesFitIntoTheUsualWidth() {
        for (const OutcomePtr& outcome : {run(traverseProject(3)), run(plungeProject(4, 3))}) {
            Bench bench(outcome, {320, 400});
            QVERIFY(bench.area().verticalScrollBar()->isVisible()); // the narrow case
            QCOMPARE(bench.panel.width(), 320);
            QVERIFY(!bench.table().horizontalScrollBar()->isVisible());
            QCOMPARE(bench.table().horizontalHeader()->length(), bench.table().viewport()->width());
            checkNothingIsCut(bench);
        }
    }

    void moreStagesScrollSideways() {
        Bench bench(run(plungeProject(4, 9)));
        QCOMPARE(bench.model().columnCount(), 10);
        QScrollBar* bar = bench.table().horizontalScrollBar();
        QVERIFY(bar->isVisible() && bar->maximum() > 0);
        checkNothingIsCut(bench);
        bench.table().setFocus();
        bench.table().setCurrentIndex(bench.model().index(0, 0));
        QTest::keyClick(&bench.table(), Qt::Key_End);
        QVERIFY(bar->value() > 0);
        const QRect last = bench.table().visualRect(bench.model().index(0, 9));
        QVERIFY(bench.table().viewport()->rect().contains(last));
    }

    // 1366×768 leaves the panel some 640 px; lower ones must do as well.
    void timeAndLightStayInSightAndTheEndIsReached_data() {
        QTest::addColumn<int>("sections");
        QTest::addColumn<int>("height");
        QTest::newRow("traverse") << 0 << 400;
        QTest::newRow("plunge, 4 sections") << 4 << 400;
        QTest::newRow("plunge, 20 sections") << 20 << 640;
        QTest::newRow("plunge, 20 sections, low") << 20 << 300;
    }
    void timeAndLightStayInSightAndTheEndIsReached() {
        QFETCH(int, sections);
        QFETCH(int, height);
        Bench bench(sections == 0 ? m_traverse : run(plungeProject(sections)), {320, height});
        QCOMPARE(bench.panel.height(), height); // nothing asks for more
        QScrollBar* bar = bench.area().verticalScrollBar();
        QVERIFY(bar->maximum() > 0);
        for (const int position : {0, bar->maximum() / 2, bar->maximum()}) {
            bar->setValue(position);
            QVERIFY(isInSight(bench.label("time"), bench.panel));
            QVERIFY(isInSight(bench.label("overall"), bench.panel));
        }
        const QWidget& table = bench.table();
        const int end = table.mapTo(bench.area().viewport(), QPoint(0, table.height())).y();
        QVERIFY(end <= bench.area().viewport()->height()); // scrolled down to its last row
        QCOMPARE(bench.requirements().verticalScrollBar()->maximum(), 0);
        QCOMPARE(bench.table().verticalScrollBar()->maximum(), 0);
    }

    void turningTheWheelOverATableScrollsThePanel() {
        Bench bench(m_plunge);
        for (CopyTable* table : {&bench.requirements(), &bench.table()}) {
            bench.area().verticalScrollBar()->setValue(0);
            QWidget* under = table->viewport();
            const QPointF at(20, 20);
            QWheelEvent event(at, under->mapToGlobal(at), {}, {0, -240}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QSpontaneKeyEvent::setSpontaneous(&event); // or it would not go up to the panel
            qApp->notify(under, &event);
            QVERIFY2(bench.area().verticalScrollBar()->value() > 0,
                     qPrintable(table->objectName()));
        }
    }

    // --- requirements ---------------------------------------------------------------------------

    void aClickOrEnterOnARequirementTellsWhichItIs() {
        Bench bench(m_traverse, {320, 1400});
        QSignalSpy spy(&bench.panel, &VerdictPanel::requirementActivated);
        CopyTable& table = bench.requirements();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middleOfRow(table, 0));
        QCOMPARE(spy.count(), 0); // the name of a zone
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middleOfRow(table, 6));
        QCOMPARE(spy.count(), 1);
        const auto clicked = spy.takeFirst().at(0).value<ConstraintResult>();
        QCOMPARE(clicked.zone, Zone::nz);
        QCOMPARE(clicked.kind, ConstraintKind::diameterMax);
        QTest::keyClick(&table, Qt::Key_Down);
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(spy.count(), 1);
        QCOMPARE(spy.takeFirst().at(0).value<ConstraintResult>().kind,
                 ConstraintKind::radialRunout);
    }

    void whatFailsIsExplainedWithSharesThatAddUp() {
        Project project = traverseProject();
        project.part.upper_deviation_um = 0;
        project.part.lower_deviation_um = -2;
        const OutcomePtr outcome = run(project);
        const ConstraintResult* worst = verdict::worst(*outcome);
        QVERIFY(worst && !worst->holds);
        Bench bench(outcome);
        const QString text = bench.label("why").text();
        QVERIFY2(text.contains(Names::signedMicrometres(worst->value)), qPrintable(text));
        // "…: gauge +a µm; zone +b µm (…); out of round +c µm."
        static const QRegularExpression share(QStringLiteral("([+−-]?[0-9.]+) µm"));
        QList<double> numbers;
        auto found = share.globalMatch(text);
        while (found.hasNext()) {
            numbers << found.next().captured(1).replace(u'−', u'-').toDouble();
        }
        QCOMPARE(numbers.size(), 4);
        QVERIFY(std::abs(numbers[1] + numbers[2] + numbers[3] - numbers[0]) < 0.03); // of 0.01 each
    }

    void aSettingIsSetWhereItsRequirementLeads() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            Project project =
                operation == Operation::traverse ? traverseProject() : plungeProject(3);
            project.machine.limits.radial_feed_mm = std::vector<double>{0, 1, 0.001};
            project.machine.limits.axial_feed_mm_min = std::vector<double>{0, 1e4, 1};
            project.machine.limits.plunge_feed_mm_min = std::vector<double>{0, 10, 0.01};
            project.machine.limits.work_speed_rpm = std::vector<double>{10, 1000, 1};
            const OutcomePtr outcome = run(project);
            QVERIFY(outcome->ran());
            const auto file = nlohmann::json::parse(writeProject(project));
            int settings = 0;
            for (const ConstraintResult& c : outcome->constraints) {
                const std::string path = verdict::inputPath(c);
                QCOMPARE(!path.empty(), scopeOf(c.kind) == ConstraintScope::setting);
                if (path.empty() || c.kind == ConstraintKind::gaugeCommands) {
                    continue; // its value is what the stages need
                }
                const nlohmann::json::json_pointer pointer(path);
                QVERIFY2(file.contains(pointer), path.c_str());
                QCOMPARE(file.at(pointer).get<double>(), c.value);
                ++settings;
            }
            QVERIFY(settings >= 3);
        }
    }

    void aRowThatHoldsIsExplainedWhenChosen() {
        Project project = traverseProject();
        project.part.upper_deviation_um = 100;
        project.part.lower_deviation_um = -100;
        project.part.tolerance.radial_runout_um = 100;
        Bench bench(run(project), {320, 1400});
        QVERIFY(bench.label("why").text().isEmpty());
        CopyTable& table = bench.requirements();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middleOfRow(table, 3));
        const QString text = bench.label("why").text();
        QVERIFY2(text.contains(QStringLiteral("Radial runout")), qPrintable(text));
        QVERIFY(text.contains(Names::micrometres(project.part.initial_runout_mm * 1e3)));
    }

    // --- inputs that are not those of the numbers -----------------------------------------------

    void refusedTextsInTheInputsAreSaid() {
        Bench bench(m_traverse);
        QLabel& notice = bench.label("refusedFields");
        QVERIFY(!notice.isVisible());
        bench.panel.setRefusedFields(2);
        QVERIFY(notice.isVisible() && isInSight(notice, bench.panel));
        QCOMPARE(notice.text(), QStringLiteral("2 fields hold a refused text; the verdict is of "
                                               "the values before it."));
        bench.show(m_plunge); // a newer run of the values before it says nothing else
        QVERIFY(notice.isVisible());
        bench.panel.setRefusedFields(0);
        QVERIFY(!notice.isVisible());
    }

    void refusedInputsGreyTheNumbers() {
        Bench bench(m_traverse);
        auto refused = std::make_shared<Outcome>();
        refused->issues.push_back(
            {IssueCode::outOfRange, Severity::error, "/wheel/width_mm", "5000", "0.5…1000 mm"});
        const QString before = bench.cell(ShopRow::energy, 0);
        bench.show(refused);
        QCOMPARE(bench.cell(ShopRow::energy, 0), before);
        QVERIFY(bench.model().index(0, 0).data(Qt::ForegroundRole).isValid());
        bench.show(m_traverse);
        QVERIFY(!bench.model().index(0, 0).data(Qt::ForegroundRole).isValid());
    }

    void anotherLanguageReachesEveryTextOfTheTable() {
        Project p = traverseProject();
        p.wheel.dullness = 0;
        Bench bench(run(p));
        Marking marking;
        QApplication::installTranslator(&marking);
        QTest::qWait(30);
        const auto isMarked = [](const QString& text) { return text.contains(QChar(0x00AB)); };
        const ShopModel& model = bench.model();
        for (int row = 0; row < model.rowCount(); ++row) {
            QVERIFY(isMarked(model.headerData(row, Qt::Vertical, Qt::DisplayRole).toString()));
            QVERIFY(isMarked(model.headerData(row, Qt::Vertical, Qt::ToolTipRole).toString()));
        }
        QVERIFY(isMarked(model.headerData(2, Qt::Horizontal, Qt::DisplayRole).toString()));
        QVERIFY(isMarked(bench.label("shopRemarks").text()));
        QVERIFY(isMarked(bench.table().accessibleName()));
        QVERIFY(isMarked(bench.table().toolTip()));
        QApplication::removeTranslator(&marking);
        QTest::qWait(30);
        QCOMPARE(bench.table().accessibleName(), QStringLiteral("Shop's numbers by stage"));
    }

private:
    static void checkCopied(Bench& bench) {
        const QString text = QApplication::clipboard()->text();
        const QStringList lines = text.trimmed().split(u'\n');
        QCOMPARE(lines.size(), 1 + bench.model().rowCount());
        QCOMPARE(lines[0], QStringLiteral("Quantity\tStage 1\tStage 2\tWhole cycle\tOutside the "
                                          "usual"));
        for (const QString& line : text.chopped(1).split(u'\n')) {
            QCOMPARE(line.count(u'\t'), 4);
        }
        const int power = bench.row(ShopRow::meanPower);
        QVERIFY(lines[1 + power].startsWith(
            QStringLiteral("Power mean, kW\t%1\t").arg(bench.cell(ShopRow::meanPower, 0))));
    }

    /// Every number, mark and name has the room it needs.
    static void checkNothingIsCut(Bench& bench) {
        CopyTable& table = bench.table();
        const QFontMetrics metrics = table.fontMetrics();
        for (int row = 0; row < bench.model().rowCount(); ++row) {
            for (int column = 0; column < bench.model().columnCount(); ++column) {
                const QModelIndex index = bench.model().index(row, column);
                const bool mark = bench.model().isOutside(row, column);
                QVERIFY(metrics.horizontalAdvance(index.data().toString()) + (mark ? 10 : 0)
                        < table.columnWidth(column));
            }
            const QString name =
                bench.model().headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
            QVERIFY(metrics.horizontalAdvance(name) < table.verticalHeader()->width());
            QVERIFY(table.rowHeight(row) >= metrics.height());
        }
    }

    OutcomePtr m_traverse, m_plunge;
};

} // namespace test_verdict

SPARKOUT_TEST(test_verdict, TestVerdict)
#include "test_verdict.moc"
