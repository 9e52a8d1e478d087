// SPDX-License-Identifier: GPL-3.0-or-later
// What the views have of the window of a small laptop.
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/chart/legend.h"
#include "ui/chart/svg_device.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/inputs/stage_table.h"
#include "ui/kit/font_size.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/study/found_table.h"
#include "ui/views/study/state_grid_plot.h"
#include "ui/window/view_tabs.h"

#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <qcustomplot.h>

#include <algorithm>
#include <vector>

namespace sparkout::test_room {

/// The areas of its curves, within the plot.
std::vector<QRect> plotsOf(const FeedsView& view) {
    std::vector<QRect> plots;
    for (const QCPAxisRect* rect : view.plot()->axisRects()) {
        plots.push_back(rect->rect());
    }
    return plots;
}

/// Keeps the present run under that name; the list of runs.
QListView* keepAs(const Bench& bench, const QString& name) {
    bench.action("keepRun")->trigger();
    (void)bench.window->showView(QStringLiteral("compare"));
    auto* list = bench.window->findChild<QListView*>(QStringLiteral("compareRuns"));
    const QModelIndex row = list->model()->index(list->model()->rowCount() - 1, 0);
    list->model()->setData(row, name, Qt::EditRole);
    return list;
}

/// Counts the lines of its captions, none of which is cut off.
int checkedCaptions(const QCustomPlot& plot) {
    int lines = 0;
    for (const QCPLayoutElement* element : plot.plotLayout()->elements(true)) {
        const auto* caption = qobject_cast<const QCPTextElement*>(element);
        for (const QString& line : caption ? caption->text().split(u'\n') : QStringList()) {
            ++lines;
            const int wide = QFontMetrics(caption->font()).horizontalAdvance(line);
            [&] { QVERIFY2(wide <= caption->rect().width(), qPrintable(line)); }();
        }
    }
    return lines;
}

/// Counts the names of its axes across, all of which are within the plot.
int checkedNames(const QCustomPlot& plot) {
    int names = 0;
    for (const QCPAxisRect* rect : plot.axisRects()) {
        const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
        const int middle = rect->center().x();
        const int room = 2 * std::min(middle, plot.width() - middle);
        for (const QString& line :
             axis && axis->visible() ? axis->label().split(u'\n') : QStringList()) {
            names += line.isEmpty() ? 0 : 1;
            const int wide = QFontMetrics(axis->labelFont()).horizontalAdvance(line);
            [&] { QVERIFY2(wide <= room, qPrintable(line)); }();
        }
    }
    return names;
}

/// The names of both axes lie within the plot, across and upright.
void checkAxisNames(const QCustomPlot& plot) {
    for (const QCPAxisRect* rect : plot.axisRects()) {
        QVERIFY(plot.rect().contains(rect->outerRect()));
        for (const QCPAxis::AxisType type : {QCPAxis::atBottom, QCPAxis::atLeft}) {
            const bool isAcross = type == QCPAxis::atBottom;
            const int middle = isAcross ? rect->center().x() : rect->center().y();
            const int all = isAcross ? plot.width() : plot.height();
            const int room = 2 * std::min(middle, all - middle);
            const QCPAxis* axis = rect->axis(type);
            QVERIFY(!axis->label().isEmpty());
            for (const QString& line : axis->label().split(u'\n')) {
                const int wide = QFontMetrics(axis->labelFont()).horizontalAdvance(line);
                QVERIFY2(wide <= room,
                         qPrintable(QStringLiteral("%1: %2 of %3").arg(line).arg(wide).arg(room)));
            }
        }
    }
}

/// A project of the operation with a small coordinate grid.
Project gridProject(bool travels) {
    Project project = exampleProject(travels ? "shaft-30h6-factory" : "plunge-shaft-two-stage");
    project.optimisation = Optimisation{};
    project.optimisation->stages = {1, 2};
    if (travels) {
        project.optimisation->radial_feed_mm = SteppedLevels{0.002, 0.010, 0.002};
        project.optimisation->axial_feed_mm_min = SteppedLevels{1000, 2000, 1000};
    } else {
        project.optimisation->stock_step_mm = 0.01;
        project.optimisation->radial_feed_mm_min = std::vector<double>{0.2, 0.3, 0.5, 0.8, 1.2};
    }
    return project;
}

/// A project of the operation whose feed every limit bounds.
Project boundProject(bool travels) {
    Project project = exampleProject(travels ? "shaft-30h6-factory" : "plunge-accuracy-limit");
    project.part->tolerance = {4, 6, 5, 8, 0.8, {}};
    project.wheel->roughness_factor = 1.5; // calibrated
    project.wheel->grain_surface_energy_j_m2 = 20;
    project.wheel->grain_modulus_gpa = 400;
    project.wheel->bond_surface_energy_j_m2 = 40;
    project.wheel->bond_modulus_gpa = 60;
    project.material->burn_rise_k = 700;
    project.machine->wheel_drive_kw = 4;
    project.machine->work_drive_kw = 1;
    return project;
}

/// Each entry is read in full, and meets none before it.
void checkEntries(const LegendStrip& legend) {
    const auto count = static_cast<int>(legend.entries().size());
    QVERIFY(count > 1);
    for (int i = 0; i < count; ++i) {
        const QString& text = legend.entries()[static_cast<std::size_t>(i)].text;
        const QRect room = legend.entryRect(i).adjusted(27, 0, 0, 0);
        const QRect needed = legend.fontMetrics().boundingRect(QRect(0, 0, room.width(), 1000),
                                                               Qt::TextWordWrap, text);
        QVERIFY2(needed.width() <= room.width() && needed.height() <= room.height(),
                 qPrintable(text));
        QVERIFY(legend.rect().contains(legend.entryRect(i)));
        QVERIFY(i == 0 || !room.intersects(legend.entryRect(i - 1)));
    }
}

class TestRoom : public QObject {
    Q_OBJECT

private slots:
    /// Where the window is too small for nine of them, they are scrolled.
    void thePlotsOfFeedsAreLegibleInLargeType_data() { addLongerLanguages(); }
    void thePlotsOfFeedsAreLegibleInLargeType() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        const auto* view = bench.window->findChild<FeedsView*>();
        const auto* area = view->findChild<QScrollArea*>(QStringLiteral("feedsArea"));
        for (const int percent : {115, 130, 100, 130, 115}) {
            bench.setFontSize(percent);
            QCOMPARE(bench.window->size(), QSize(1366, 768));
            const std::vector<QRect> plots = plotsOf(*view);
            QCOMPARE(plots.size(), 9U);
            const QSize least = percent == usualFontSize ? QSize(180, 95) : QSize(120, 80);
            for (const QRect& plot : plots) {
                qInfo("ROOM plot at %d %% %d × %d", percent, plot.width(), plot.height());
                QVERIFY(plot.width() >= least.width() && plot.height() >= least.height());
                QVERIFY(area->widget()->rect().contains(plot));
            }
            const QSize reached = area->viewport()->size()
                                  + QSize(area->horizontalScrollBar()->maximum(),
                                          area->verticalScrollBar()->maximum());
            QCOMPARE(reached, area->widget()->size());
            QCOMPARE(area->horizontalScrollBar()->maximum(), 0);
        }
        bench.setFontSize(100);
        QCOMPARE(area->widget()->size(), area->viewport()->size()); // nothing left to scroll
    }

    /// Where the views are too small for both of their plots, they are scrolled; so are the zones
    /// of a batch.
    void theOtherPlotsAreLegibleInLargeType_data() { addLongerLanguages(); }
    void theOtherPlotsAreLegibleInLargeType() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        for (const int percent : {115, 130}) {
            bench.setFontSize(percent);
            for (const char* name : {"compare", "optimise", "batch", "profiles", "constraints"}) {
                QVERIFY(bench.window->showView(QString::fromLatin1(name)));
                const View* const view = bench.window->viewTabs().currentView();
                QTRY_VERIFY_WITH_TIMEOUT(!view->busy(), 60'000);
                bench.rest();
                int seen = 0;
                for (const auto* plot : view->findChildren<QCustomPlot*>()) {
                    for (const QCPAxisRect* rect : plot->axisRects()) {
                        if (plot->isVisible()) {
                            ++seen;
                            qInfo("ROOM %s at %d %% %d × %d", name, percent, rect->width(),
                                  rect->height());
                            QVERIFY(rect->width() >= 120 && rect->height() >= 80);
                            // With the names of its axes: else they stand on the texts below.
                            const QRect& all = rect->outerRect();
                            QVERIFY2(all.top() >= 0 && all.bottom() <= plot->height(),
                                     qPrintable(QStringLiteral("%1: %2 to %3 of %4")
                                                    .arg(QLatin1String(name))
                                                    .arg(all.top())
                                                    .arg(all.bottom())
                                                    .arg(plot->height())));
                        }
                    }
                }
                QVERIFY2(seen >= (QLatin1String(name) == u"constraints" ? 1 : 2), name);
            }
        }
    }

    /// The plots of three zones have room beside each other, no bar scrolls them by a few pixels;
    /// and their figures are read in full.
    void theZonesOfABatchHaveRoom_data() {
        addColumns<QString, QString>("language", "name");
        for (const char* language : {"en", "ru"}) {
            for (const char* name : {"shaft-38-74h6", "plunge-shaft-two-stage"}) {
                QTest::addRow("%s %s", language, name)
                    << QString::fromLatin1(language) << QString::fromLatin1(name);
            }
        }
    }
    void theZonesOfABatchHaveRoom() {
        QFETCH(QString, language);
        QFETCH(QString, name);
        Bench bench(language);
        bench.setFontSize(130);
        QVERIFY(bench.open(examplePath(qPrintable(name))));
        QVERIFY(bench.window->showView(QStringLiteral("batch")));
        const View* const view = bench.window->viewTabs().currentView();
        QTRY_VERIFY_WITH_TIMEOUT(!view->busy(), 60'000);
        bench.rest();
        const QStringList cut = textsWithoutRoom(*view);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
        if (name == u"plunge-shaft-two-stage") { // its four sections are scrolled
            return;
        }
        int areas = 0;
        for (const auto* area : view->findChildren<QScrollArea*>()) {
            if (area->isVisible()) {
                ++areas;
                QCOMPARE(area->horizontalScrollBar()->maximum(), 0);
            }
        }
        QCOMPARE(areas, 1);
    }

    /// Of the present run and two kept ones, neither curves nor what differs.
    void nothingOfCompareIsScrolledSideways_data() { addLongerLanguages(); }
    void nothingOfCompareIsScrolledSideways() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        (void)keepAs(bench, language == u"ru" ? QStringLiteral("Заводской")
                                              : QStringLiteral("Factory")); // beside the best one
        Project project = bench.window->document().project();
        project.cycle->stages.front().axial_feed_mm_min = 1800;
        bench.window->document().edit(project, {"Edit", "Axial feed"});
        const auto* table = bench.window->findChild<QTableView*>(QStringLiteral("compareTable"));
        const auto* area = bench.window->findChild<QScrollArea*>(QStringLiteral("compareArea"));
        for (const int percent : {130, 100, 115}) {
            bench.setFontSize(percent);
            QTRY_COMPARE(table->model()->columnCount(), 4);
            bench.rest();
            qInfo("ROOM compared at %d %%: curves %d × %d, name %d of %d", percent,
                  area->viewport()->width(), area->viewport()->height(), table->columnWidth(0),
                  table->viewport()->width());
            QCOMPARE(area->horizontalScrollBar()->maximum(), 0);
            QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
            QVERIFY(table->columnWidth(0) >= atFontSize(130));
            const QStringList cut = textsWithoutRoom(*bench.window->viewTabs().currentView());
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
        }
    }

    /// Legends, captions and the names of axes, none of them elided or cut off.
    void whatIsDrawnBesideCurvesHasRoom_data() { addLongerLanguages(); }
    void whatIsDrawnBesideCurvesHasRoom() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        keepAs(bench,
               QStringLiteral("Radial feed 0.004, axial feed 1400, the second stage as it was"));
        const QStringList captioned{QStringLiteral("feeds"), QStringLiteral("profiles"),
                                    QStringLiteral("optimise"), QStringLiteral("compare")};
        int captions = 0, names = 0;
        for (const int percent : {130, 100}) {
            bench.setFontSize(percent);
            for (const char* name : {"feeds", "profiles", "constraints", "compliance", "layers",
                                     "optimise", "compare"}) {
                QVERIFY(bench.window->showView(QString::fromLatin1(name)));
                bench.rest();
                for (const auto* plot :
                     bench.window->viewTabs().currentView()->findChildren<QCustomPlot*>()) {
                    if (plot->isVisible()) {
                        captions +=
                            captioned.contains(QLatin1String(name)) ? checkedCaptions(*plot) : 0;
                        names += checkedNames(*plot);
                    }
                }
            }
            for (const char* name : {"feeds", "profiles", "constraints", "compare"}) {
                QVERIFY(bench.window->showView(QString::fromLatin1(name)));
                bench.rest();
                checkEntries(*bench.window->findChild<LegendStrip*>(QLatin1String(name)
                                                                    + QStringLiteral("Legend")));
            }
        }
        QVERIFY(captions > 20);
        QVERIFY2(names >= 8, qPrintable(QString::number(names)));
    }

    /// With every limit; a legend of fewer entries in their order takes no more lines.
    void theLegendOfConstraintsTakesTwoLines_data() {
        addColumns<QString, bool>("language", "travels");
        for (const char* language : {"en", "ru"}) {
            for (const bool travels : {true, false}) {
                QTest::addRow("%s %s", language, travels ? "traverse" : "plunge")
                    << QString::fromLatin1(language) << travels;
            }
        }
    }
    void theLegendOfConstraintsTakesTwoLines() {
        QFETCH(QString, language);
        QFETCH(bool, travels);
        Bench bench(language);
        bench.window->document().startUntitled(boundProject(travels));
        QVERIFY(bench.window->showView(QStringLiteral("constraints")));
        const auto* legend =
            bench.window->findChild<LegendStrip*>(QStringLiteral("constraintsLegend"));
        // Feed, programme, stepless limit, machine's feed, five limits of the cut, the estimate of
        // accuracy and the published runout; the proof of accuracy is of plunges alone.
        const std::size_t all = travels ? 11 : 12;
        QTRY_COMPARE_WITH_TIMEOUT(legend->entries().size(), all, 20'000);
        bench.rest();
        QCOMPARE(bench.window->size(), QSize(1366, 768));
        const int lines = legend->height() / (legend->fontMetrics().height() + 2);
        QVERIFY2(lines > 0 && lines <= 2,
                 qPrintable(QStringLiteral("%1 in %2").arg(lines).arg(legend->width())));
        checkEntries(*legend);
    }

    void theAxesOfTheStateGridAreWhole_data() {
        addColumns<QString, bool>("language", "travels");
        QTest::newRow("en traverse") << QStringLiteral("en") << true;
        QTest::newRow("ru traverse") << QStringLiteral("ru") << true;
        QTest::newRow("ru plunge") << QStringLiteral("ru") << false;
    }
    void theAxesOfTheStateGridAreWhole() {
        QFETCH(QString, language);
        QFETCH(bool, travels);
        Bench bench(language);
        bench.window->document().startUntitled(gridProject(travels));
        QVERIFY(bench.window->showView(QStringLiteral("optimise")));
        auto* content = bench.window->findChild<QComboBox*>(QStringLiteral("optimiseContent"));
        content->setFocus();
        QTest::keyClick(content, Qt::Key_End); // the coordinate grid is the last page
        const auto* plot = bench.window->findChild<StateGridPlot*>();
        QTRY_VERIFY_WITH_TIMEOUT(plot->isVisible() && plot->outcome(), 60'000);
        bench.rest();
        QCOMPARE(bench.window->size(), QSize(1366, 768));
        checkAxisNames(*plot);
    }

    /// In the window's usual size the answer is read in full and so are the cycles found, in a
    /// larger type but for the end of a long one. In a low window rather the answer is scrolled
    /// than the curves.
    void theAnswerOfASearchHasRoom_data() { addLongerLanguages(); }
    void theAnswerOfASearchHasRoom() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        QVERIFY(bench.window->showView(QStringLiteral("optimise")));
        bench.rest();
        QTest::mouseClick(bench.window->findChild<QPushButton*>(QStringLiteral("optimiseRun")),
                          Qt::LeftButton);
        auto* answer = bench.window->findChild<QTableView*>(QStringLiteral("optimiseAnswer"));
        QTRY_VERIFY_WITH_TIMEOUT(answer->isVisible(), 60'000);
        bench.rest();
        QCOMPARE(bench.window->size(), QSize(1366, 768));
        QTRY_COMPARE(answer->verticalScrollBar()->maximum(), 0);
        QTRY_COMPARE(answer->horizontalScrollBar()->maximum(), 0);
        const QAbstractItemView& rows = *answer;
        const QAbstractItemModel& model = *answer->model();
        QVERIFY(model.rowCount() >= 3);
        for (int row = 0; row < model.rowCount(); ++row) {
            QVERIFY(answer->rowHeight(row) >= rows.sizeHintForRow(row));
            for (int column = 0; column + 1 < model.columnCount(); ++column) {
                const QModelIndex cell = model.index(row, column);
                QVERIFY2(answer->columnWidth(column) >= answer->sizeHintForIndex(cell).width(),
                         qPrintable(cell.data().toString()));
            }
        }
        const auto* found = bench.window->findChild<QTableView*>(QStringLiteral("optimiseFound"));
        const auto column = static_cast<int>(FoundColumn::cycle);
        for (const int percent : fontSizes) {
            bench.setFontSize(percent);
            const int left = found->columnViewportPosition(column),
                      room = found->viewport()->width();
            QVERIFY(left + found->columnWidth(column) <= room
                    || (percent == 130 && 3 * left < room));
            QVERIFY(found->columnWidth(column)
                    >= found->sizeHintForIndex(found->model()->index(0, column)).width());
        }
        bench.setFontSize(usualFontSize);
        constexpr QSize low(1366, 740);
        bench.window->resize(low);
        bench.rest();
        QCOMPARE(bench.window->size(), low);
        int seen = 0;
        for (const auto* area :
             bench.window->viewTabs().currentView()->findChildren<QScrollArea*>()) {
            if (area->isVisible()) {
                ++seen;
                QTRY_COMPARE(area->verticalScrollBar()->maximum(), 0);
            }
        }
        QCOMPARE(seen, 1);
    }

    void theNameOfARunIsWrapped() {
        OpenBench bench(QStringLiteral("ru"), examplePath("shaft-30h6-factory"));
        bench.setFontSize(130);
        const QString name = QStringLiteral("Припуск 0,11, вторая ступень прежняя, круг новый");
        const QListView* const list = keepAs(bench, name);
        bench.rest();
        const QModelIndex row = list->model()->index(list->model()->rowCount() - 1, 0);
        const int line = list->fontMetrics().lineSpacing();
        QVERIFY(row.data(Qt::DisplayRole).toString().startsWith(name));
        QVERIFY(list->fontMetrics().horizontalAdvance(name) > list->viewport()->width());
        QVERIFY(list->visualRect(row).width() <= list->viewport()->width());
        QVERIFY(list->visualRect(row).height() >= 4 * line); // three of the name, one of the time
        QVERIFY(row.data(Qt::ToolTipRole).toString().contains(name));
    }

    void theRequirementsOfConstraintsHaveRoom_data() { addLongerLanguages(); }
    void theRequirementsOfConstraintsHaveRoom() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        QVERIFY(bench.window->showView(QStringLiteral("constraints")));
        auto* table = bench.window->findChild<QTableView*>(QStringLiteral("margins"));
        QVERIFY(table);
        for (const int percent : fontSizes) {
            bench.setFontSize(percent);
            QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
            const QFontMetrics metrics(table->font());
            const auto* sheet =
                bench.window->findChild<QAbstractScrollArea*>(QStringLiteral("formulaSheet"));
            const int hidden = sheet->verticalScrollBar()->maximum();
            QVERIFY2(hidden == 0 || hidden >= metrics.height(), // no bar for less than a line
                     qPrintable(QString::number(hidden)));
            const int room = table->columnWidth(0) - table->iconSize().width() - 8;
            for (int row = 0; row < table->model()->rowCount(); ++row) {
                const QString name = table->model()->index(row, 0).data().toString();
                for (const QString& word : name.split(u' ')) {
                    QVERIFY2(metrics.horizontalAdvance(word) <= room,
                             qPrintable(QStringLiteral("%1 at %2 %").arg(word).arg(percent)));
                }
            }
        }
    }

    /// Also when the program starts so.
    void theToolsAreAllShownWhateverTheType_data() { addLongerLanguages(); }
    void theToolsAreAllShownWhateverTheType() {
        QFETCH(QString, language);
        for (const int percent : fontSizes) {
            applyFontSize(percent);
            Bench bench(language);
            bench.rest();
            auto* bar = bench.window->findChild<QToolBar*>(QStringLiteral("toolBar"));
            QVERIFY(bar);
            for (const QAction* action : bar->actions()) {
                const QWidget* button = bar->widgetForAction(const_cast<QAction*>(action));
                QVERIFY2(!action->isVisible() || (button && button->isVisible()),
                         qPrintable(QStringLiteral("%1 at %2 %").arg(action->text()).arg(percent)));
            }
        }
    }

    /// Longer than any hint: the values of a pass with their spread.
    void theValuesUnderThePointerHaveRoomInLargeType_data() { addLongerLanguages(); }
    void theValuesUnderThePointerHaveRoomInLargeType() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        auto* view = bench.window->findChild<FeedsView*>();
        const auto* values = view->findChild<QLabel*>(QStringLiteral("feedsValues"));
        for (const int percent : fontSizes) {
            bench.setFontSize(percent);
            for (const QRect& plot : plotsOf(*view)) {
                QTest::mouseMove(view->plot(), plot.center() + QPoint(9, 4));
                QTest::mouseMove(view->plot(), plot.center());
                qInfo("ROOM values at %d %%: %d of %d", percent,
                      values->heightForWidth(values->width()), values->height());
                QVERIFY(values->text().size() > 70);
                QVERIFY(values->heightForWidth(values->width()) <= values->height());
            }
        }
    }

    /// Beside or below its mark, in whatever type.
    void aLongFeedWithAWarningIsReadInFull_data() { addLongerLanguages(); }
    void aLongFeedWithAWarningIsReadInFull() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("shaft-30h6-factory"));
        Document& document = bench.window->document();
        Project project = document.project();
        project.cycle->stages.front().axial_feed_mm_min = 12500;
        document.edit(project, {"Edit", "Axial feed"});
        bench.window->findChild<InputsPanel*>()->showCycle();
        const auto* view = bench.window->findChild<StageTable*>()->findChild<QTableView*>();
        for (const int percent : fontSizes) {
            bench.setFontSize(percent);
            const QModelIndex cell = view->model()->index(0, 1);
            QVERIFY(view->isVisible() && !cell.data(Qt::DecorationRole).isNull());
            const QString text = cell.data(Qt::DisplayRole).toString();
            QVERIFY(text.endsWith(u"500"));
            SvgDevice device(view->viewport()->size(), 96, {});
            QPainter painter(&device);
            view->viewport()->render(&painter);
            painter.end();
            const QString drawn = QString::fromUtf8(device.document());
            QVERIFY2(drawn.contains(u'>' + text + u'<'), qPrintable(QString::number(percent)));
            QVERIFY(!drawn.contains(u'…'));
        }
    }

    void theInputsOfSeveralSurfacesHaveRoom_data() { addLongerLanguages(); }
    void theInputsOfSeveralSurfacesHaveRoom() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePath("setups/spindle"));
        InputsPanel& inputs = bench.window->inputs();
        for (const int percent : {100, 130}) {
            bench.setFontSize(percent);
            for (const int page : {2, 3}) { // wheel, machine
                inputs.showPage(page);
                bench.rest();
                const QStringList cut = textsWithoutRoom(inputs);
                QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
            }
        }
    }

    void playbackStandsWhereThereIsAMoment() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        const auto* bar = bench.window->findChild<QWidget*>(QStringLiteral("playback"));
        const auto* place = bench.window->findChild<QWidget*>(QStringLiteral("playPlace"));
        for (const auto& [view, moment] : {std::pair{"feeds", true},
                                           {"profiles", true},
                                           {"layers", true},
                                           {"compliance", false},
                                           {"batch", false},
                                           {"sweep", false},
                                           {"optimise", false}}) {
            QVERIFY(bench.window->showView(QString::fromLatin1(view)));
            bench.rest();
            QVERIFY2(bar->isVisible() == moment && place->isVisible() == moment, view);
        }
        for (View* view : bench.window->views()) {
            if (view->objectName() == u"profiles") {
                bench.window->viewTabs().detach(view); // whatever tab is in front
            }
        }
        bench.rest();
        QVERIFY(bar->isVisible());
    }

    /// Not before there is a cycle, nor where the one before is of another document.
    void anEmptyDrawingHasNothingToPlay() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        bench.rest();
        const auto* bar = bench.window->findChild<QWidget*>(QStringLiteral("playback"));
        QVERIFY(bar->isVisible());
        Document& document = bench.window->document();
        Project project = document.project();
        project.part->length_mm = 1; // refused: the curves of the run before stay, and its moment
        document.edit(project, {"Edit", "Length"});
        const auto says = [&bench](const char* text) {
            const QList<QLabel*> labels = bench.window->statusBar()->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [text](const QLabel* label) {
                return label->text().contains(QLatin1StringView(text));
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(says("the last good run"), 20'000);
        QVERIFY(bar->isVisible());
        document.startUntitled(project);
        QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), 20'000);
        QVERIFY(says("Not computed: 1 fault in the inputs."));
        QVERIFY(!says("the last good run"));
    }

    void messagesTakeRoomOnlyWhenSomethingIsSaid() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        bench.rest();
        const QDockWidget& messages = bench.dock("messages");
        auto* button = bench.window->findChild<QToolButton*>(QStringLiteral("messagesButton"));
        QVERIFY(!messages.isVisible());
        QCOMPARE(button->text(), QStringLiteral("No messages"));
        Document& document = bench.window->document();
        Project project = document.project();
        project.wheel->dullness = 0.4; // unusual
        document.edit(project, {"Edit", "Dullness"});
        QTRY_VERIFY(messages.isVisible());
        QCOMPARE(button->text(), QStringLiteral("1 message"));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(!messages.isVisible());
        bench.action("russian")->trigger(); // nothing new is said
        bench.rest();
        QVERIFY(!messages.isVisible());
        QCOMPARE(button->text(), QStringLiteral("1 сообщение"));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(messages.isVisible());
        document.undo();
        QTRY_VERIFY(!messages.isVisible());
    }

    void theStepThatMendsIsNoMessageOfItsOwn() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        bench.rest();
        Project project = bench.window->document().project();
        project.cycle->stages.front().stock_mm += 0.01;
        bench.window->document().edit(project, {"Edit", "Stock"});
        auto* button = bench.window->findChild<QToolButton*>(QStringLiteral("messagesButton"));
        QTRY_COMPARE(button->text(), QStringLiteral("1 message"));
        QVERIFY(bench.window->messages().count() > 1); // with the step
    }

    /// The strip of the part does not take the room of the panels, whatever the type.
    void thePartStripLeavesTheVerdictItsWidth_data() { addLongerLanguages(); }
    void thePartStripLeavesTheVerdictItsWidth() {
        QFETCH(QString, language);
        Bench bench(language);
        for (const int percent : fontSizes) {
            bench.setFontSize(percent);
            QVERIFY(bench.open(examplePath("shaft-30h6-factory")));
            bench.rest();
            const int width = bench.dock("verdict").width();
            QVERIFY(bench.open(examplePath("setups/spindle")));
            bench.rest();
            const auto* strip = bench.window->findChild<QWidget*>(QStringLiteral("partStrip"));
            QVERIFY(strip->isVisible());
            qInfo("ROOM strip at %d %% at least %d of %d, verdict %d", percent,
                  strip->minimumSizeHint().width(), strip->width(), bench.dock("verdict").width());
            QCOMPARE(bench.dock("verdict").width(), width);
        }
    }

    /// Type and language are changed in a wide window that then is a small one again.
    void theVerdictHasItsWidthAgainInTheSmallWindow() {
        OpenBench bench(QStringLiteral("en"), examplePath("setups/spindle"));
        for (const char* language : {"english", "russian"}) {
            bench.action(language)->trigger();
            for (const int percent : {100, 115, 130}) {
                bench.setFontSize(percent);
                for (const QSize size : {QSize(1366, 768), QSize(1920, 1080)}) {
                    bench.window->resize(size);
                    for (const View* view : bench.window->views()) {
                        QVERIFY(bench.window->showView(view->objectName()));
                        bench.settle();
                        qInfo("ROOM verdict %s %d %% %d %s: %d of %d", language, percent,
                              size.width(), qPrintable(view->objectName()),
                              bench.dock("verdict").width(), bench.window->width());
                        QVERIFY(bench.dock("verdict").width() >= atFontSize(303) - 1);
                    }
                }
            }
        }
    }
};

} // namespace sparkout::test_room

SPARKOUT_TEST(test_room, TestRoom)
#include "test_room.moc"
