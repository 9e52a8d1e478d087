// SPDX-License-Identifier: GPL-3.0-or-later
// The window on a set-up of several surfaces, as its user has it.
#include "core/project/part.h"
#include "core/setup/setup_run.h"
#include "core/setup/worn_project.h"
#include "core/study/batch_edits.h"
#include "core/study/new_project.h"
#include "core/study/search.h"
#include "core/study/search_edits.h"
#include "tests/registry.h"
#include "tests/two_stage_projects.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/search_fixtures.h"
#include "tests/ui/support/setup_fixtures.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/compare_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/form/input_marks.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/kept_runs.h"
#include "ui/session/part_runs.h"
#include "ui/session/recovery_store.h"
#include "ui/text/number_text.h"
#include "ui/window/dialogs/part_drawing.h"
#include "ui/window/dialogs/part_strip.h"
#include "ui/window/dialogs/part_window.h"
#include "ui/window/file_commands.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>

namespace sparkout::test_surfaces {

using namespace setup_fixtures;
using on_disk::bytesOf;

/// A window with the stepped shaft in a file of its own.
struct Desk {
    explicit Desk(const Setup& setup = steppedShaft(),
                  const QString& language = QStringLiteral("en"))
        : bench(language) {
        writeSetupFile(setup, path);
        isOpen = bench.open(path);
        calm();
    }
    void calm() {
        QTRY_VERIFY(!bench.window->runs().running() && !runs().running());
        bench.settle();
    }
    void press(const char* action) {
        bench.action(action)->trigger();
        calm();
    }
    /// With what is offered of its drawing.
    void duplicate() {
        const DialogAnswers answers({QStringLiteral("Enter")});
        press("duplicateSurface");
        QVERIFY2(answers.fault().isEmpty(), qPrintable(answers.fault()));
    }
    [[nodiscard]] PartWindow* openWholePart() {
        press("wholePart");
        return bench.window->findChild<PartWindow*>();
    }
    /// Searches all surfaces and takes what was found.
    void optimiseAll() {
        PartWindow* const whole = openWholePart();
        QSignalSpy ended(&whole->study(), &PartStudy::finished);
        for (const char* button : {"searchAll", "takeFound"}) {
            QTest::mouseClick(whole->findChild<QPushButton*>(QString::fromUtf8(button)),
                              Qt::LeftButton);
            QVERIFY(!ended.empty() || ended.wait(120'000));
        }
        calm();
    }
    [[nodiscard]] Document& document() { return bench.window->document(); }
    [[nodiscard]] PartStrip& strip() { return *bench.window->findChild<PartStrip*>(); }
    [[nodiscard]] PartRuns& runs() { return *bench.window->findChild<PartRuns*>(); }
    [[nodiscard]] QTabBar& tabs() { return strip().tabs(); }
    [[nodiscard]] NumberField* field(const char* name) {
        bench.window->inputs().focusPath(name);
        bench.settle();
        return bench.window->findChild<NumberField*>(QString::fromUtf8(name));
    }
    void type(const char* name, const QString& text) {
        NumberField* const number = field(name);
        number->selectAll();
        QTest::keyClicks(number, text);
        QTest::keyClick(number, Qt::Key_Return);
        calm();
    }
    void clickSurface(std::size_t surface) {
        PartDrawing& drawing = strip().drawing();
        const PartOutline::Ground& ground = drawing.outline().surfaces[surface];
        QTest::mouseClick(
            &drawing, Qt::LeftButton, {},
            QPoint(int(drawing.xOf(ground.from_mm + ground.length_mm / 2)), drawing.height() / 2));
        calm();
    }
    [[nodiscard]] QStringList names() {
        QStringList list;
        for (const SurfaceStatePtr& surface : document().state().surfaces) {
            list += QString::fromStdString(surface->name);
        }
        return list;
    }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("shaft.sparkout"));
    Bench bench;
    bool isOpen = false;
};

/// Two surfaces with a small grid each.
Setup searchedSetup() {
    Setup setup = plainSetup(fixtures::searchedShaft());
    setup.surfaces.push_back(setup.surfaces.front());
    setup.surfaces[0].name = "first";
    setup.surfaces[1].name = "second";
    setup.wear.dulling_per_mm2 = 1e-4;
    return setup;
}

/// Three surfaces whose batches all parts of are good; that of the last one takes long.
Setup setupWithBatches() {
    Project project = fixtures::plungeProject(3);
    project.part->tolerance.radial_runout_um.reset();
    project.part->upper_deviation_um = 900;
    project.part->lower_deviation_um = -900;
    project = withUsualBatch(project);
    project.batch->parts = 8;
    Setup setup = plainSetup(project);
    setup.surfaces.front().name = "first";
    setup.surfaces.push_back({"second", project});
    project.batch->parts = 1'000'000;
    setup.surfaces.push_back({"third", project});
    return setup;
}

class TestSurfaces : public QObject {
    Q_OBJECT

private slots:
    void aFileOfSeveralOpensWithItsFirstInFront() {
        Desk desk;
        QVERIFY(desk.isOpen);
        QVERIFY(desk.strip().isVisible());
        QCOMPARE(desk.tabs().count(), 3);
        QCOMPARE(desk.tabs().currentIndex(), 0);
        QCOMPARE(desk.tabs().tabText(1), QStringLiteral("2 Seat"));
        QVERIFY(desk.bench.window->studies().outcome->ran());
        QVERIFY(!desk.document().modified());
    }

    void aSurfaceAloneHasNoStrip() {
        Desk desk(plainSetup(newProject(Operation::traverse)));
        QVERIFY(desk.isOpen);
        QVERIFY(!desk.strip().isVisible());
        const QByteArray before = bytesOf(desk.path);
        desk.duplicate();
        QVERIFY(desk.strip().isVisible());
        QCOMPARE(desk.tabs().count(), 2);
        desk.press("undo");
        QVERIFY(!desk.strip().isVisible());
        QVERIFY(desk.bench.window->files().save());
        QCOMPARE(bytesOf(desk.path), before); // version 1, to the byte
        desk.duplicate();
        desk.press("removeSurface");
        QVERIFY(desk.bench.window->files().save());
        QCOMPARE(bytesOf(desk.path), before);
    }

    /// Names where they have room, else numbers; the drawing is as high as the strip.
    void twentySurfacesFitIntoTheStrip() {
        Setup setup = steppedShaft();
        while (setup.surfaces.size() < limits::surfaces) {
            setup.surfaces.push_back(setup.surfaces.back());
            setup.surfaces.back().name = "place " + std::to_string(setup.surfaces.size());
        }
        Desk desk(setup);
        QCOMPARE(desk.tabs().count(), 20);
        QCOMPARE(desk.tabs().tabText(19), QStringLiteral("20"));
        QVERIFY(desk.tabs().tabToolTip(19).contains(QStringLiteral("place 20")));
        QVERIFY(!desk.bench.action("addSurface")->isEnabled());
        QVERIFY(!desk.bench.action("duplicateSurface")->isEnabled());
        QVERIFY(desk.strip().height() <= 52);
    }

    void anElidedTabKeepsItsNameInItsToolTip() {
        Setup setup = steppedShaft();
        const QString name =
            QStringLiteral("journal of the front bearing beside the thread of the nut");
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            setup.surfaces[i].name = name.toStdString() + ' ' + std::to_string(i);
        }
        Desk desk(setup);
        for (int tab = 0; tab < desk.tabs().count(); ++tab) {
            QVERIFY(desk.tabs().tabText(tab).endsWith(u'…'));
            QVERIFY2(desk.tabs().tabToolTip(tab).contains(name + u' ' + QString::number(tab)),
                     qPrintable(desk.tabs().tabToolTip(tab)));
        }
    }

    void mouseAndKeysChooseASurface() {
        Desk desk;
        desk.clickSurface(2);
        QCOMPARE(desk.document().surface(), std::size_t{2});
        QCOMPARE(desk.tabs().currentIndex(), 2);
        QTest::mouseClick(&desk.tabs(), Qt::LeftButton, {}, desk.tabs().tabRect(1).center());
        desk.calm();
        QCOMPARE(desk.document().surface(), std::size_t{1});
        QCOMPARE(desk.field("/part/diameter_mm")->value().value(), 36.0);
        desk.tabs().setFocus(Qt::TabFocusReason);
        QTest::keyClick(&desk.tabs(), Qt::Key_Left);
        desk.calm();
        QCOMPARE(desk.document().surface(), std::size_t{0});
        QTest::keyClick(desk.bench.window.get(), Qt::Key_PageDown, Qt::ControlModifier);
        desk.calm();
        QCOMPARE(desk.document().surface(), std::size_t{1});
        QVERIFY(!desk.document().modified() && !desk.document().canUndo());
    }

    /// The numbers of the window are those of `sparkout-cli simulate --surface N`.
    void everySurfaceIsRunWithTheWheelAsThoseBeforeLeaveIt() {
        Desk desk;
        const Setup setup = steppedShaft();
        const SetupRun run = runSetup(setup);
        QVERIFY(run.isCompleted(setup));
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            desk.clickSurface(i);
            const SimulationResult& shown = desk.bench.window->studies().outcome->result;
            QCOMPARE(shown.time_s, run.surfaces[i].result.time_s);
            QCOMPARE(shown.project.wheel->dullness, run.surfaces[i].result.project.wheel->dullness);
            QCOMPARE(desk.runs().statuses()[i].time_s, run.surfaces[i].result.time_s);
            QCOMPARE(desk.runs().statuses()[i].holds(), run.surfaces[i].holds());
        }
        QVERIFY(run.surfaces[2].result.project.wheel->dullness
                > setup.surfaces[0].project.wheel->dullness);
        QCOMPARE(desk.runs().time()->piece_min, run.time.piece_min);
    }

    void surfacesAreMovedRenamedDuplicatedAndRemoved() {
        Desk desk;
        const QStringList names = desk.names();
        desk.clickSurface(0);
        desk.press("moveSurfaceRight");
        QCOMPARE(desk.names(), QStringList({names[1], names[0], names[2]}));
        QCOMPARE(desk.document().surface(), std::size_t{1});
        QCOMPARE(desk.tabs().currentIndex(), 1);
        {
            DialogAnswers rename({QStringLiteral("Enter")});
            rename.seen = [&names](QDialog& dialog) {
                auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("newName"));
                const auto* accept = dialog.findChild<QPushButton*>(QStringLiteral("acceptName"));
                for (const QString& refused : {QString(), QStringLiteral("  "), names[1]}) {
                    name->setText(refused);
                    QVERIFY2(!accept->isEnabled(), qPrintable(refused));
                }
                QVERIFY(
                    std::ranges::any_of(dialog.findChildren<QLabel*>(), [](const QLabel* label) {
                        return label->text() == QStringLiteral("Each surface needs its own name.");
                    }));
                name->setText(QStringLiteral("  Cone <b>  "));
                QVERIFY(accept->isEnabled());
            };
            desk.press("renameSurface");
            QVERIFY2(rename.fault().isEmpty(), qPrintable(rename.fault()));
        }
        QCOMPARE(desk.names().at(1), QStringLiteral("Cone <b>"));
        desk.duplicate();
        QCOMPARE(desk.tabs().count(), 4);
        QCOMPARE(desk.document().surface(), std::size_t{2});
        desk.press("removeSurface");
        desk.press("removeSurface");
        QCOMPARE(desk.names(), QStringList({names[1], QStringLiteral("Cone <b>")}));
        while (desk.document().canUndo()) {
            desk.press("undo");
        }
        QCOMPARE(desk.names(), names);
        QVERIFY(!desk.document().modified());
        while (desk.document().canRedo()) {
            desk.press("redo");
        }
        QCOMPARE(desk.names(), QStringList({names[1], QStringLiteral("Cone <b>")}));
    }

    /// What is not ticked is left behind, as of a copy that is added.
    void aDuplicateAsksWhatComesAlong() {
        Setup setup = plainSetup(newProject(Operation::plunge));
        Part& part = *setup.surfaces.front().project.part;
        part.gaps.push_back({.from_deg = 0, .width_deg = 30});
        Desk desk(setup);
        DialogAnswers answers({QStringLiteral("Escape"), QStringLiteral("Enter")});
        answers.seen = [](QDialog& dialog) {
            QCOMPARE(dialog.windowTitle(), QStringLiteral("Duplicate the surface"));
            QVERIFY(!dialog.findChild<QComboBox*>(QStringLiteral("begin"))->isVisible());
            QVERIFY(!dialog.findChild<QListWidget*>(QStringLiteral("places"))->isVisible());
            QVERIFY(textsWithoutRoom(dialog).isEmpty());
            dialog.findChild<QCheckBox*>(QStringLiteral("copyGaps"))->setChecked(true);
            dialog.findChild<QCheckBox*>(QStringLiteral("copyTolerances"))->setChecked(false);
        };
        desk.press("duplicateSurface");
        QCOMPARE(desk.document().surfaceCount(), std::size_t{1});
        desk.press("duplicateSurface");
        QVERIFY2(answers.fault().isEmpty(), qPrintable(answers.fault()));
        QCOMPARE(desk.document().surfaceCount(), std::size_t{2});
        QCOMPARE(desk.document().undoText(), QStringLiteral("Duplicate a surface"));
        const Part made = *desk.document().project().part;
        QCOMPARE(made.gaps.size(), std::size_t{1});
        QVERIFY(part.tolerance.radial_runout_um && !made.tolerance.radial_runout_um);
        QCOMPARE(made.lower_deviation_um, part.lower_deviation_um);
        QVERIFY(desk.document().openInputs().empty());
    }

    void aDuplicateWithoutKeywayAndTolerancesIsMadeAtOnce() {
        Setup setup = plainSetup(newProject(Operation::plunge));
        setup.surfaces.front().project.part->tolerance = {};
        Desk desk(setup);
        const DialogAnswers none({});
        desk.press("duplicateSurface");
        QVERIFY2(none.fault().isEmpty(), qPrintable(none.fault()));
        QCOMPARE(desk.document().surfaceCount(), std::size_t{2});
        const auto& surfaces = desk.document().state().surfaces;
        QVERIFY(sameProject(surfaces[0]->project, surfaces[1]->project));
    }

    void theLastSurfaceStays() {
        Desk desk;
        desk.press("removeSurface");
        desk.press("removeSurface");
        QCOMPARE(desk.tabs().count(), 1);
        QVERIFY(!desk.bench.action("removeSurface")->isEnabled());
        QVERIFY(!desk.strip().isVisible());
    }

    void aSurfaceIsAddedOnAStepOfTheShaft() {
        Setup setup = steppedShaft();
        setup.surfaces.erase(setup.surfaces.begin() + 1);
        Desk desk(setup);
        PartDrawing& drawing = desk.strip().drawing();
        const PartOutline::Step step = drawing.outline().steps[1];
        DialogAnswers answers({QStringLiteral("Enter")});
        QString chosen;
        answers.seen = [&chosen](QDialog& dialog) {
            chosen = dialog.findChild<QListWidget*>()->currentItem()->text();
            QVERIFY(dialog.findChild<PartDrawing*>()->isVisible());
        };
        QTest::mouseDClick(
            &drawing, Qt::LeftButton, {},
            QPoint(int(drawing.xOf(step.from_mm + step.length_mm / 2)), drawing.height() / 2));
        desk.calm();
        QVERIFY2(answers.fault().isEmpty(), qPrintable(answers.fault()));
        QVERIFY(chosen.contains(QStringLiteral("Step 2")));
        QCOMPARE(desk.document().surfaceCount(), std::size_t{3});
        const Part& part = *desk.document().project().part;
        QCOMPARE(part.shaft.ground_from_mm, step.from_mm);
        QCOMPARE(part.length_mm, step.length_mm);
        QCOMPARE(part.diameter_mm, step.diameter_mm);
        // Deviations and stock are yet to be given.
        QVERIFY(!desk.bench.window->studies().outcome->ran());
        QCOMPARE(desk.document().openInputs().size(), std::size_t{3});
        desk.press("undo");
        QCOMPARE(desk.document().surfaceCount(), std::size_t{2});
    }

    void whatIsSharedLooksSoWhileThereAreSeveral() {
        Desk desk;
        const auto marked = [&desk](const char* path) {
            desk.bench.window->inputs().focusPath(path);
            desk.bench.settle();
            const auto* widget =
                desk.bench.window->findChild<NumberField*>(QString::fromUtf8(path));
            return widget->toolTip().contains(SharedMark::text());
        };
        QVERIFY(marked("/wheel/width_mm"));
        QVERIFY(marked("/machine/wheel_speed_m_s"));
        QVERIFY(!marked("/machine/work_speed_rpm"));
        QVERIFY(!marked("/part/diameter_mm"));
        int shown = 0;
        desk.bench.window->inputs().focusPath("/wheel/width_mm");
        desk.bench.settle();
        for (const auto* mark : desk.bench.window->findChildren<SharedMark*>()) {
            shown += mark->isVisible();
        }
        QVERIFY(shown > 2);
        desk.press("removeSurface");
        desk.press("removeSurface");
        QVERIFY(!marked("/wheel/width_mm"));
        for (const auto* mark : desk.bench.window->findChildren<SharedMark*>()) {
            QVERIFY(!mark->isVisible());
        }
    }

    void keptRunsBelongToTheirSurface() {
        Desk desk;
        auto* kept = desk.bench.window->findChild<KeptRuns*>();
        desk.clickSurface(2);
        desk.press("keepRun");
        QCOMPARE(kept->count(), 1);
        desk.clickSurface(0);
        QCOMPARE(kept->count(), 0);
        desk.press("keepRun");
        desk.clickSurface(2);
        QCOMPARE(kept->count(), 1);
        const double diameter_mm = desk.document().project().wheel->diameter_mm;
        QVERIFY(kept->restore(0)); // with the wheel of the set-up, not the worn one
        desk.calm();
        QCOMPARE(desk.document().project().wheel->diameter_mm, diameter_mm);
        QVERIFY(desk.bench.window->files().save());
        const Setup saved = *readSetup(bytesOf(desk.path).toStdString()).setup;
        QCOMPARE(saved.surfaces[0].project.runs.size(), std::size_t{1});
        QCOMPARE(saved.surfaces[1].project.runs.size(), std::size_t{0});
        QCOMPARE(saved.surfaces[2].project.runs.size(), std::size_t{1});
    }

    void keptRunsOfOtherSurfacesAreCompared() {
        Desk desk;
        desk.press("keepRun");
        desk.clickSurface(2);
        const auto* kept = desk.bench.window->findChild<KeptRuns*>();
        QCOMPARE(kept->count(), 0);
        QCOMPARE(kept->listed(), 1);
        QVERIFY(desk.bench.window->showView(QStringLiteral("compare")));
        desk.calm();
        auto* list = desk.bench.window->findChild<QListView*>(QStringLiteral("compareRuns"));
        const auto* plot =
            desk.bench.window->findChild<ComparePlot*>(QStringLiteral("comparePlot"));
        QCOMPARE(list->model()->rowCount(), 2);
        const QModelIndex row = list->model()->index(1, 0);
        const QString name = desk.names()[0];
        QVERIFY(row.data().toString().startsWith(name + QStringLiteral(": ")));
        QVERIFY(!row.data().toString().contains(QStringLiteral("computing")));
        QCOMPARE(row.data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        QCOMPARE(plot->runs().size(), 1u);
        list->setFocus();
        list->setCurrentIndex(row);
        QTest::keyClick(list, Qt::Key_Space);
        QTRY_COMPARE(plot->runs().size(), 2u);
        QVERIFY(plot->runs()[1].name.startsWith(name));
        const auto* table =
            desk.bench.window->findChild<QTableView*>(QStringLiteral("compareTable"));
        QVERIFY(table->isVisible());
        QVERIFY(table->model()
                    ->headerData(2, Qt::Horizontal, Qt::ToolTipRole)
                    .toString()
                    .contains(name.toHtmlEscaped()));
        for (const char* action : {"compareRestore", "compareRename", "compareDelete"}) {
            QVERIFY2(!desk.bench.action(action)->isEnabled(), action);
        }
        QVERIFY(!(row.flags() & Qt::ItemIsEditable));
        desk.press("keepRun");
        QCOMPARE(kept->count(), 1);
        QCOMPARE(kept->listed(), 2);
        QVERIFY(kept->surfaceOf(0).isEmpty());
        QCOMPARE(kept->surfaceOf(1), name);
        QVERIFY(kept->isChosen(0) && kept->isChosen(1));
        desk.clickSurface(0);
        QCOMPARE(kept->surfaceOf(1), desk.names()[2]);
        QVERIFY(kept->isChosen(0) && !kept->isChosen(1));
    }

    /// A refused text stands in a field of its surface: it is not lost without a question.
    void aRefusedTextKeepsItsSurfaceInFront() {
        Desk desk;
        NumberField* const width = desk.field("/part/length_mm");
        width->selectAll();
        QTest::keyClicks(width, QStringLiteral("abc"));
        QTest::keyClick(width, Qt::Key_Tab);
        QTRY_VERIFY(width->refused());
        {
            DialogAnswers stay({QStringLiteral("Escape")});
            QTest::mouseClick(&desk.tabs(), Qt::LeftButton, {}, desk.tabs().tabRect(1).center());
            desk.calm();
            QVERIFY2(stay.fault().isEmpty(), qPrintable(stay.fault()));
            QCOMPARE(desk.document().surface(), std::size_t{0});
            QCOMPARE(desk.tabs().currentIndex(), 0);
        }
        DialogAnswers go({QStringLiteral("discard")});
        desk.press("nextSurface");
        QVERIFY2(go.fault().isEmpty(), qPrintable(go.fault()));
        QCOMPARE(desk.document().surface(), std::size_t{1});
        QVERIFY(!width->refused());
    }

    void faultsOfASurfaceBeforeAreNamedWithIt() {
        Desk desk;
        Project project = desk.document().project();
        project.part->lower_deviation_um = project.part->upper_deviation_um + 1;
        desk.document().edit(project, {"Input", "Diameter"});
        desk.clickSurface(2);
        const OutcomePtr outcome = desk.bench.window->studies().outcome;
        QVERIFY(!outcome->ran());
        QVERIFY(outcome->issues.front().path.starts_with("/surfaces/0/part/"));
        QCOMPARE(desk.runs().statuses()[0].state, SurfaceStatus::State::refused);
        QCOMPARE(desk.runs().statuses()[1].state, SurfaceStatus::State::notRun);
    }

    void unsavedWorkIsRecoveredWithAllSurfaces() {
        const QTemporaryDir state;
        Setup kept;
        {
            Desk desk;
            desk.bench.window->files().protect(state.path());
            desk.clickSurface(1);
            desk.type("/machine/work_speed_rpm", QStringLiteral("150"));
            kept = desk.document().setup();
            desk.bench.window->files().guard().autosave()->flush();
            const QString file = desk.bench.window->files().guard().autosave()->file();
            const RecoveryContent content = readRecovery(bytesOf(file).toStdString());
            QVERIFY(content.setup && sameSetup(*content.setup, kept));
        }
    }

    void theStripKeepsWhatALessonHides() {
        Desk desk;
        PartStrip* const strip = &desk.strip();
        QTRY_VERIFY(strip->tabs().tabToolTip(0).count(u'\n') > 2);
        QVERIFY(!strip->tabs().tabIcon(0).isNull());
        strip->tellResults(false);
        QVERIFY(strip->tabs().tabIcon(0).isNull());
        QCOMPARE(strip->tabs().tabToolTip(0).count(u'\n'), 1); // name and size
        QVERIFY(!strip->findChild<QToolButton*>(QStringLiteral("wholePart"))->isVisible());
        strip->tellResults(true);
        QVERIFY(!strip->tabs().tabIcon(0).isNull());
    }

    void theWholePartIsListedWithItsTimes() {
        Desk desk;
        PartWindow* const whole = desk.openWholePart();
        QVERIFY(whole->isVisible());
        const auto* table = whole->findChild<QTableView*>(QStringLiteral("partTable"));
        QCOMPARE(table->model()->rowCount(), 3);
        const std::vector<SurfaceStatus>& statuses = desk.runs().statuses();
        const TimeUnit unit(std::ranges::max(statuses, {}, &SurfaceStatus::time_s).time_s);
        const CsvTable copy = whole->model().table().asTable();
        QCOMPARE(copy.header[int(PartColumn::time)], unit.titled(QStringLiteral("Cycle")));
        for (std::size_t i = 0; i < statuses.size(); ++i) {
            QCOMPARE(std::get<double>(copy.rows[i][std::size_t(PartColumn::time)]),
                     unit.of(statuses[i].time_s));
        }
        const auto* times = whole->findChild<QLabel*>(QStringLiteral("pieceTime"));
        QVERIFY(!times->text().contains(QStringLiteral("T<sub>1</sub>"))); // nobody entered it
        DialogAnswers answers({QStringLiteral("Enter")});
        answers.seen = [](QDialog& dialog) {
            auto* handling = dialog.findChild<NumberField*>(QStringLiteral("/handling_s"));
            handling->selectAll();
            QTest::keyClicks(handling, QStringLiteral("60"));
        };
        const double before_min = desk.runs().time()->piece_min;
        desk.press("standardTimes");
        QVERIFY2(answers.fault().isEmpty(), qPrintable(answers.fault()));
        QCOMPARE(desk.document().state().times.handling_s, 60.0);
        QCOMPARE(desk.runs().time()->piece_min, before_min + 1);
        QVERIFY(desk.bench.window->files().save());
        QCOMPARE(readSetup(bytesOf(desk.path).toStdString()).setup->times.handling_s, 60.0);
        desk.press("undo");
        QCOMPARE(desk.document().state().times.handling_s, 0.0);
    }

    void theSurfacesAreComparedAsBars() {
        Desk desk;
        PartWindow* const whole = desk.openWholePart();
        auto& bars = *whole->findChild<BarPlot*>(QStringLiteral("surfaceBars"));
        const std::vector<SurfaceStatus>& statuses = desk.runs().statuses();
        QCOMPARE(bars.chart().categories.size(), qsizetype(statuses.size()));
        for (std::size_t i = 0; i < statuses.size(); ++i) {
            const double unit_s = bars.chart().unit == QStringLiteral("s") ? 1 : 60;
            QCOMPARE(bars.chart().value(0, i), statuses[i].time_s / unit_s);
            QCOMPARE(bars.chart().value(1, i) < 0, !statuses[i].judgement.isNominalGood());
        }
        QTRY_VERIFY(!bars.drawing().parts().empty());
        const auto last = std::ranges::find_if(bars.drawing().parts(), [&](const BarPart& part) {
            return part.category == statuses.size() - 1;
        });
        QVERIFY(last != bars.drawing().parts().end());
        QTest::mouseClick(&bars, Qt::LeftButton, {}, last->rect.center().toPoint());
        desk.calm();
        QCOMPARE(desk.tabs().currentIndex(), int(statuses.size()) - 1);
    }

    /// The same as the command line's: each with the wheel as the cycles found before leave it.
    void allAreOptimisedAndTheCyclesFoundAreOneStep() {
        Setup setup = searchedSetup();
        Desk desk(setup);
        PartWindow* const whole = desk.openWholePart();
        QSignalSpy ended(&whole->study(), &PartStudy::finished);
        const QSignalSpy told(&whole->study(), &PartStudy::progressed);
        QTest::mouseClick(whole->findChild<QPushButton*>(QStringLiteral("searchAll")),
                          Qt::LeftButton);
        QVERIFY(ended.wait(120'000));
        for (qint64 before = 0; const QVariantList& progress : told) { // it never goes back
            QCOMPARE(progress[1].toLongLong(), 1000 * qint64(setup.surfaces.size()));
            QVERIFY(progress[0].toLongLong() >= before);
            before = progress[0].toLongLong();
        }
        auto* take = whole->findChild<QPushButton*>(QStringLiteral("takeFound"));
        QVERIFY(take->isEnabled());
        QTest::mouseClick(take, Qt::LeftButton);
        desk.calm();
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            const auto outcome = search(wornProject(setup, i).project, {});
            Project& project = setup.surfaces[i].project;
            project = withFound(std::move(project), *outcome->best());
        }
        QVERIFY(sameSetup(desk.document().setup(), setup));
        QVERIFY(!take->isEnabled()); // it is of the inputs before
        desk.press("undo");
        QVERIFY(sameSetup(desk.document().setup(), searchedSetup()));
    }

    /// The answer holds in every phase of the stock where that is ticked in the view Optimise.
    void whatIsTickedGoesForAllSurfaces() {
        Setup setup = searchedSetup();
        Desk desk(setup);
        auto* phases = desk.bench.window->findChild<QCheckBox*>(QStringLiteral("optimisePhases"));
        QVERIFY(phases);
        phases->setChecked(true);
        desk.optimiseAll();
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            const auto outcome = search(wornProject(setup, i).project, {.phases = true});
            Project& project = setup.surfaces[i].project;
            if (const FoundCycle* answer = outcome->answer()) {
                project = withFound(std::move(project), *answer);
            }
        }
        QVERIFY(sameSetup(desk.document().setup(), setup));
    }

    /// It is searched by a typical one, which comes with the cycle and goes with it.
    void aSurfaceWithoutASearchGetsATypicalOne() {
        StartingDrawing drawing = drawingOf(parseSizeDesignation("35k6").value()).value();
        drawing.length_mm = 28;
        drawing.stock_mm = 0.15;
        Issues issues;
        Project seat =
            drawnProject(drawing, startingEntries({}, drawing, issues).value()).start->project;
        seat.optimisation.reset();
        Setup setup = plainSetup(seat);
        setup.surfaces.push_back(setup.surfaces.front());
        setup.surfaces[0].name = "first";
        setup.surfaces[1].name = "second";
        Desk desk(setup);
        desk.optimiseAll();
        for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
            const Project usual = usualSearch(setup.surfaces[i].project);
            const auto outcome = search(usual, {});
            QVERIFY(outcome->answer());
            QVERIFY(sameProject(desk.document().setup().surfaces[i].project,
                                withFound(usual, *outcome->answer())));
        }
        desk.press("undo");
        QVERIFY(sameSetup(desk.document().setup(), setup));
    }

    void allBatchesAreRunAndCanBeStopped() {
        Setup setup = steppedShaft();
        for (GroundSurface& surface : setup.surfaces) {
            surface.project = withUsualBatch(surface.project);
            surface.project.batch->parts = 8;
        }
        setup.surfaces[1].project.batch.reset();
        Desk desk(setup);
        PartWindow* const whole = desk.openWholePart();
        QSignalSpy ended(&whole->study(), &PartStudy::finished);
        auto* batch = whole->findChild<QPushButton*>(QStringLiteral("batchAll"));
        QTest::mouseClick(batch, Qt::LeftButton);
        QVERIFY(ended.wait(60'000));
        const auto shown = [whole](int row) {
            return whole->model().index(row, static_cast<int>(PartColumn::batch)).data().toString();
        };
        QVERIFY2(shown(0).contains(QStringLiteral("of 8")), qPrintable(shown(0)));
        QCOMPARE(shown(1), QStringLiteral("not set up"));
        QVERIFY(shown(2).contains(QStringLiteral("of 8")));
        desk.clickSurface(0);
        Project project = desk.document().project();
        project.batch->parts = 100'000;
        desk.document().edit(project, {"Input", "Batch"});
        desk.calm();
        QTest::mouseClick(batch, Qt::LeftButton);
        auto* stop = whole->findChild<QPushButton*>(QStringLiteral("stopAll"));
        QTRY_VERIFY(stop->isVisible());
        QTest::qWait(100);
        QTest::mouseClick(stop, Qt::LeftButton);
        QVERIFY(ended.wait(20'000));
        QCOMPARE(ended.back().front().toBool(), true);
    }

    /// The quick ones are run by themselves, also of the surfaces that are not in front; where the
    /// batch takes long, tab and table say that it was not run.
    void batchesOfAllSurfacesAreJudged() {
        Desk desk(setupWithBatches());
        QVERIFY(desk.isOpen);
        const auto judged = [&desk](std::size_t surface) -> const Judgement& {
            return desk.runs().statuses()[surface].judgement;
        };
        constexpr int patience_ms = 60'000;
        for (const std::size_t surface : {std::size_t{0}, std::size_t{1}}) {
            QTRY_VERIFY_WITH_TIMEOUT(judged(surface).state == JudgedState::batchHolds, patience_ms);
            QCOMPARE(judged(surface).batch->parts, std::int64_t{8});
        }
        QCOMPARE(judged(2).state, JudgedState::batchNotRun);
        const QString open = QStringLiteral("batch not run");
        QVERIFY(!desk.tabs().tabToolTip(1).contains(open));
        QVERIFY(desk.tabs().tabToolTip(2).contains(open));
        PartWindow* const whole = desk.openWholePart();
        const auto cell = [whole](int row, PartColumn column) {
            return whole->model().index(row, static_cast<int>(column)).data().toString();
        };
        QCOMPARE(cell(1, PartColumn::batch), QStringLiteral("0 of 8 rejected"));
        QVERIFY(cell(2, PartColumn::batch).isEmpty());
        QVERIFY(cell(2, PartColumn::verdict).contains(open));
        const auto labels = whole->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [&open](const QLabel* label) {
            return label->text().contains(QStringLiteral("third: Fit for every stock; ") + open);
        })); // the surface to report first

        Project edited = desk.document().project();
        edited.wheel->dullness += 0.01; // shared by all
        desk.document().edit(edited, {"Input", "Dullness"});
        QVERIFY(!judged(1).batch);
        QTRY_VERIFY_WITH_TIMEOUT(judged(1).state == JudgedState::batchHolds, patience_ms);
        QCOMPARE(judged(2).state, JudgedState::batchNotRun);
    }

    /// A batch that was run for the whole part counts for the verdict on the same inputs alone.
    void aBatchOfTheWholePartIsJudged() {
        const Setup setup = setupWithBatches();
        Desk desk(setup);
        QVERIFY(desk.isOpen);
        const auto state = [&desk] { return desk.runs().statuses()[2].judgement.state; };
        QTRY_VERIFY(state() == JudgedState::batchNotRun);
        const auto runFor = [&desk](Project project) {
            SurfaceStudy study;
            study.surface = 2;
            BatchOptions few;
            few.range = PartRange{0, 8};
            study.batch = runWholeBatch(project, few);
            desk.runs().takeStudy(std::make_shared<const SurfaceStudy>(std::move(study)));
        };
        Project other = setup.surfaces[2].project;
        other.wheel->dullness += 0.01;
        runFor(other);
        QCOMPARE(state(), JudgedState::batchNotRun);
        runFor(setup.surfaces[2].project);
        QCOMPARE(state(), JudgedState::batchHolds);
    }

    /// A surface that is gone, or another file, while all of it runs.
    void whatRunsIsDroppedWithItsSurface() {
        Desk desk(searchedSetup());
        PartWindow* const whole = desk.openWholePart();
        for (const char* action : {"removeSurface", "undo", "removeSurface"}) {
            QTest::mouseClick(whole->findChild<QPushButton*>(QStringLiteral("searchAll")),
                              Qt::LeftButton);
            desk.bench.action(action)->trigger();
        }
        QVERIFY(desk.bench.open(examplePaths().front()));
        desk.calm();
        QVERIFY(!whole->study().running());
        QCOMPARE(whole->model().rowCount(), 1);
    }

    void russianWordsStandThroughout() {
        Desk desk(steppedShaft(), QStringLiteral("ru"));
        PartWindow* const whole = desk.openWholePart();
        for (const QWidget* part :
             {static_cast<QWidget*>(whole), static_cast<QWidget*>(&desk.strip())}) {
            for (const auto* label : part->findChildren<QLabel*>()) {
                QString text = label->text(); // but for the names of the surfaces
                for (const SurfaceStatePtr& surface :
                     desk.bench.window->document().state().surfaces) {
                    text.remove(QString::fromStdString(surface->name));
                }
                QVERIFY2(englishIn(text).isEmpty(), qPrintable(label->text()));
            }
            for (const auto* button : part->findChildren<QAbstractButton*>()) {
                QVERIFY2(englishIn(button->text()).isEmpty(), qPrintable(button->text()));
            }
        }
        QVERIFY(desk.tabs().accessibleTabName(0).startsWith(QStringLiteral("Поверхность 1")));
        QVERIFY(desk.tabs().accessibleName().startsWith(QStringLiteral("Поверхности детали")));
    }
};

} // namespace sparkout::test_surfaces

SPARKOUT_TEST(test_surfaces, TestSurfaces)
#include "test_surfaces.moc"
