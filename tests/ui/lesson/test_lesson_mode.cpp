// SPDX-License-Identifier: GPL-3.0-or-later
// A laboratory work in the window, as a student does it: by mouse and keys, to full points.
#include "core/lesson/grading.h"
#include "core/lesson/work.h"
#include "core/project/wheel.h"
#include "tests/registry.h"
#include "tests/ui/lesson/lesson_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/file_trouble.h"
#include "tests/ui/support/text_checks.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/plot_tools.h"
#include "ui/chart/view_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/kit/font_size.h"
#include "ui/kit/pdf_details.h"
#include "ui/lesson/lessons_dialog.h"
#include "ui/lesson/marks_dialog.h"
#include "ui/session/file_lock.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/study/batch_view.h"

#include <QDir>
#include <QMenu>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QTextBrowser>

#include <algorithm>

namespace test_lesson_mode {

using namespace lesson_bench;

class TestLessonMode : public QObject {
    Q_OBJECT

private slots:
    void aStudentDoesTheWorkToFullPoints() {
        Seat student;
        student.begin();
        QVERIFY(student.run().isRunning());
        QVERIFY(student.panel().isVisible());
        const std::size_t steps = student.run().lesson().steps.size();
        for (std::size_t step = 0; step < steps; ++step) {
            student.show(step);
            QCOMPARE(student.run().step(), step);
            student.answer();
            QVERIFY2(student.part<QPushButton>("lessonHandIn")->isEnabled(),
                     qPrintable(QString::number(step + 1)));
            student.handIn();
            const LessonRun::Mark mark = student.run().mark(step);
            const bool isTold = mark == LessonRun::Mark::passed || mark == LessonRun::Mark::teacher;
            QVERIFY2(isTold, qPrintable(QString::number(step + 1) + u' '
                                        + student.part<QLabel>("lessonFound")->text()));
        }
        // What stands on the disk is marked by the engine: all that it can give.
        const Work work = student.onDisk();
        QVERIFY(!brokenSeal(work));
        const GradedWork graded =
            gradeWork(student.out.lesson, {"w", writeWork(work)}, GradeWish());
        QVERIFY(graded.flags.empty());
        QCOMPARE(graded.points + graded.pending, graded.most);
        QCOMPARE(graded.points,
                 student.run().points() + student.out.lesson.steps.front().points); // the choice
    }

    void nothingIsKnownBeforeAPredictionIsGiven() {
        Seat student;
        student.begin();
        student.show(1);
        QVERIFY(student.desk().isCovered());
        QVERIFY(!student.window.runs().running());
        QVERIFY(!student.window.studies().outcome->ran()); // nobody in the window has a result
        QVERIFY(!student.window.cursor().outcome());
        QVERIFY(student.window.findChild<QLabel*>(QStringLiteral("lessonCover"))->isVisible());
        for (const View* view : student.window.views()) {
            QVERIFY2(!view->isVisible(), qPrintable(view->objectName()));
        }
        for (const char* dock : {"verdict", "messages", "step"}) {
            QVERIFY2(
                !student.window.findChild<QDockWidget*>(QString::fromLatin1(dock))->isVisible(),
                dock);
        }
        for (const char* command :
             {"keepRun", "wholePart", "exportResults", "preview-card", "show-feeds", "detach"}) {
            if (const QAction* action = student.bench.action(command)) {
                QVERIFY2(!action->isEnabled(), command);
            }
        }
        const auto* stages =
            student.window.inputs().findChild<QTableView*>(QStringLiteral("/cycle/stages"));
        const int last = stages->model()->columnCount() - 1; // tells the time of a stage
        QVERIFY(!stages->model()->index(0, last).data().toString().contains(
            QRegularExpression(QStringLiteral("[0-9]"))));
        // Nor can an input be changed, by whatever way.
        const Project before = student.window.document().project();
        Project changed = before;
        changed.cycle->stages.front().radial_feed_mm = 0.001;
        student.window.document().edit(changed, {"Edit", "x"});
        QVERIFY(sameProject(student.window.document().project(), before));
        // It is given once, and its result stands beside it.
        student.answer();
        student.handIn();
        QVERIFY(!student.desk().isCovered());
        QVERIFY(QTest::qWaitFor([&] { return student.window.studies().outcome->ran(); }, 30'000));
        QCOMPARE(student.run().mark(1), LessonRun::Mark::passed);
        QVERIFY(student.part<QLabel>("resultNumber")->isVisible());
        QVERIFY(!student.part<QWidget>("predictedNumber")->isEnabled());
        QVERIFY(!student.part<QPushButton>("lessonHandIn")->isVisible());
        QCOMPARE(student.onDisk().entries.back().event, WorkEvent::prediction);
        // Other predictions of this set-up are open: until they are given no view tells what they
        // ask.
        for (const std::size_t step : {2u, 3u}) {
            QVERIFY(!student.bench.action("show-feeds")->isVisible());
            student.show(0); // nor in the step before, which asks for no prediction
            QVERIFY(!student.desk().isCovered());
            QVERIFY(!student.bench.action("show-feeds")->isEnabled());
            student.window.showView(QStringLiteral("feeds"));
            QVERIFY(student.window.viewTabs().currentWidget()->objectName() != u"feeds");
            QVERIFY(!student.bench.action("exportResults")->isEnabled());
            QVERIFY(student.part<QLabel>("lessonNote")->isVisible());
            student.show(step);
            student.answer();
            student.handIn();
        }
        // The moment that the step shows.
        QCOMPARE(student.window.viewTabs().currentWidget()->objectName(), QStringLiteral("feeds"));
        QCOMPARE(student.window.cursor().stroke(), 20);
    }

    void whatAStepHidesIsReallyGone() {
        Seat student;
        student.begin({1, 2, 3});
        student.show(4); // hides optimise, sweep, remedies, verdict, overview and profiles
        student.answer();
        student.handIn();
        ViewTabs& tabs = student.window.viewTabs();
        for (int key = Qt::Key_0; key <= Qt::Key_9; ++key) { // every shortcut of a view
            QTest::keyClick(&student.window, Qt::Key(key), Qt::ControlModifier);
            QTest::keyClick(&student.window, Qt::Key(key), Qt::ControlModifier | Qt::AltModifier);
            QVERIFY(tabs.currentView());
            const QString shown = tabs.currentView()->objectName();
            QVERIFY2(!QStringList({QStringLiteral("optimise"), QStringLiteral("sweep"),
                                   QStringLiteral("overview"), QStringLiteral("profiles")})
                          .contains(shown),
                     qPrintable(shown));
        }
        for (const char* name : {"optimise", "sweep", "overview", "profiles"}) {
            const QString view = QString::fromLatin1(name);
            student.window.showView(view);
            QVERIFY(tabs.currentView()->objectName() != view);
            QAction* const show = student.bench.action(qPrintable(QStringLiteral("show-") + view));
            QVERIFY(!show->isVisible() && !show->isEnabled());
            show->trigger();
            QVERIFY(tabs.currentView()->objectName() != view);
        }
        // The verdict by no means: its entry, the reset of the layout, a report or an export.
        auto* verdict = student.window.findChild<QDockWidget*>(QStringLiteral("verdict"));
        QVERIFY(!verdict->toggleViewAction()->isVisible());
        student.bench.action("resetLayout")->trigger();
        student.settle();
        QVERIFY(!verdict->isVisible());
        verdict->show();
        student.settle();
        QVERIFY(!verdict->isVisible());
        int reports = 0;
        for (const QAction* action : student.window.findChildren<QAction*>()) {
            const QString name = action->objectName();
            if (name.endsWith(QStringLiteral("-lab-report"))
                || name.endsWith(QStringLiteral("-worksheet"))) {
                continue; // of the whole work, with nothing that it does not show
            }
            if (name.startsWith(QStringLiteral("pdf-")) || name.startsWith(QStringLiteral("print-"))
                || name.startsWith(QStringLiteral("preview-"))
                || name.startsWith(QStringLiteral("html-"))
                || name.startsWith(QStringLiteral("odt-")) || name == u"exportResults") {
                ++reports;
                QVERIFY2(!action->isEnabled() && !action->isVisible(), qPrintable(name));
            }
        }
        QVERIFY(reports > 5);
        // The language is changed, the document follows: it stays so.
        student.window.document().undo();
        student.bench.action("resetLayout")->trigger();
        QVERIFY(!verdict->isVisible());
        // Another step brings back what it does not hide; the end of the lesson all.
        student.show(0);
        QVERIFY(verdict->toggleViewAction()->isVisible());
        QVERIFY(student.bench.action("exportResults")->isEnabled());
        student.desk().leave();
        student.settle();
        QVERIFY(!student.run().isRunning());
        QVERIFY(student.bench.action("show-optimise")->isEnabled());
        QVERIFY(student.window.showView(QStringLiteral("optimise")));
        QCOMPARE(tabs.currentView()->objectName(), QStringLiteral("optimise"));
        QVERIFY(!student.panel().isVisible());
    }

    void theStudentPrintsReportAndWorksheet() {
        const Bench idle(QStringLiteral("en"));
        QVERIFY(!idle.action("markdown-lab-report")->isEnabled());
        Seat student;
        QVariantMap title = student.bench.settings.titlePage();
        title[QStringLiteral("university")] = QStringLiteral("University of the test");
        student.bench.settings.setTitlePage(title);
        student.begin();
        int written = 0;
        const auto paper = [&](const char* command) {
            const QString path = student.folder.filePath(QStringLiteral("%1.md").arg(++written));
            DialogAnswers answers({QStringLiteral("file:") + path});
            student.bench.action(command)->trigger();
            if (!answers.fault().isEmpty()) {
                return answers.fault();
            }
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
        };
        const QString name = QString::fromStdString(student.run().work().name);
        // With predictions to come it has no results, also while one is awaited.
        student.show(1);
        QVERIFY(student.desk().isCovered());
        const QString before = paper("markdown-lab-report");
        QVERIFY2(before.contains(name) && before.contains(QStringLiteral("University of the test")),
                 qPrintable(before.left(500)));
        const QString open = QStringLiteral("printed once every prediction is handed in");
        QVERIFY(before.contains(open));
        student.begin({1, 2, 3, 4});
        const QString after = paper("markdown-lab-report");
        QVERIFY2(!after.contains(open) && after.size() > before.size() + 500,
                 qPrintable(after.left(500)));
        const QString sheet = paper("markdown-worksheet");
        QVERIFY2(sheet.contains(name), qPrintable(sheet.left(500)));
        student.desk().leave();
        QVERIFY(!student.bench.action("markdown-lab-report")->isEnabled());
    }

    /// Work 5: its fifth step reads what its third and fourth ask to predict.
    void whatIsReadWaitsForThePredictionsBeforeIt() {
        Seat student(QStringLiteral("en"), Theme::light,
                     QStringLiteral(SPARKOUT_SOURCE_DIR
                                    "/resources/lessons/05-out-of-round.sparkout-lesson"));
        student.begin();
        const auto tells = HiddenThings::telling(*student.run().lesson().steps[4].goal.asked());
        const auto hidden = [&] {
            return std::ranges::count_if(
                tells, [&](Hideable each) { return student.desk().hidden().isHidden(each); });
        };
        for (const std::size_t step : {2u, 3u}) {
            student.show(4);
            QCOMPARE(hidden(), std::ptrdiff_t(tells.size()));
            student.show(step);
            student.answer();
            student.handIn();
        }
        student.show(4);
        QCOMPARE(hidden(), std::ptrdiff_t(0)); // it can be read
    }

    /// Work 9: its first steps read the mean and s, from which the next ones ask to work out the
    /// interval, Pp and Ppk: till then the view shows the former alone.
    void aBatchIsReadWithoutTheIndicesToPredict() {
        Seat student(
            QStringLiteral("en"), Theme::light,
            QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons/09-batch.sparkout-lesson"));
        student.begin();
        auto* view = student.window.findChild<BatchView*>();
        const auto* table = view->findChild<QTableView*>(QStringLiteral("batchFigures"));
        const auto shows = [table](std::string_view key) {
            const auto& model = dynamic_cast<const ValueModel&>(*table->model());
            const auto row = std::ranges::find_if(
                model.table().rows, [key](const ValueHead& head) { return head.key == key; });
            return model.table().cells[std::size_t(row - model.table().rows.begin())][1].text
                   != u"–";
        };
        const auto tellsIndices = [&] {
            return shows("mean_interval_95") && shows("pp") && shows("ppk")
                   && view->histograms()->chart(1).headings.value(0).contains(
                       QStringLiteral("Ppk"));
        };
        const auto run = [&] { return view->batch() && !view->busy() && !view->stale(); };
        QVERIFY(QTest::qWaitFor(run, 30'000));
        QVERIFY(student.bench.action("show-batch")->isVisible());
        QVERIFY(!student.bench.action("show-overview")->isVisible());
        QVERIFY(!student.bench.action("exportResults")->isEnabled());
        QVERIFY(shows("mean") && shows("standard_deviation"));
        for (const char* row : {"mean_interval_95", "pp", "ppk"}) {
            QVERIFY(!shows(row));
        }
        const auto everyText = [&] {
            QString text = view->histograms()->chart(1).headings.join(u' ');
            for (const QLabel* label : view->findChildren<QLabel*>()) {
                text += label->text() + label->accessibleDescription();
            }
            return text + view->histograms()->accessibleDescription();
        };
        QVERIFY(!everyText().contains(QStringLiteral("Ppk")));
        for (const std::size_t step : {2u, 3u, 4u}) {
            student.show(step);
            student.answer();
            student.handIn();
        }
        student.show(1);
        QVERIFY(QTest::qWaitFor(run, 30'000));
        QVERIFY(tellsIndices() && everyText().contains(QStringLiteral("Ppk")));
    }

    /// Whatever view was in front: without measured parts theirs is empty.
    void aLessonOpensOnAViewWithContent() {
        Seat student;
        QVERIFY(student.window.showView(QStringLiteral("measured")));
        student.begin();
        student.show(0);
        QVERIFY(!student.desk().isCovered());
        const View* front = student.window.viewTabs().currentView();
        QVERIFY(front->isVisible() && front->objectName() != u"measured");
        const auto plots = front->findChildren<ViewPlot*>();
        QVERIFY2(std::ranges::any_of(plots, [](const ViewPlot* plot) { return plot->isVisible(); }),
                 qPrintable(front->objectName()));
    }

    /// It would give away what a step hides.
    void aDrawingDoesNotCarryTheProject() {
        Seat student;
        student.begin();
        student.show(0);
        QVERIFY(student.window.showView(QStringLiteral("feeds")));
        student.settle();
        const QString path = student.folder.filePath(QStringLiteral("drawing.pdf"));
        const DialogAnswers answers({QStringLiteral("file:") + path});
        const auto tools = student.window.findChildren<PlotTools*>();
        const auto drawn = std::ranges::find_if(
            tools, [](const PlotTools* each) { return each->pdf->isEnabled(); });
        QVERIFY(drawn != tools.end());
        (*drawn)->pdf->trigger();
        QCOMPARE(answers.fault(), QString());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("%PDF-"));
        QVERIFY(!attachmentOf(bytes, QStringLiteral(".sparkout"), 10'000'000));
    }

    void everyViewCanBeHiddenByItsName() {
        const Bench bench(QStringLiteral("en"));
        std::set<Hideable> named;
        for (const View* view : bench.window->views()) {
            const auto thing = viewNamed(view->objectName().toStdString());
            QVERIFY2(thing, qPrintable(view->objectName()));
            named.insert(*thing);
        }
        for (int i = 0; i < int(Hideable::count_); ++i) {
            QVERIFY(!isView(Hideable(i)) || named.contains(Hideable(i)));
        }
        // Nor do views have buttons for commands that are away.
        HiddenThings& hidden = bench.window->lesson().hidden();
        const auto* calibrate =
            bench.window->findChild<QPushButton*>(QStringLiteral("measuredCalibrate"));
        hidden.hide({Hideable::calibrate});
        QVERIFY(calibrate->isHidden());
        hidden.hide({});
        QVERIFY(!calibrate->isHidden());
    }

    void lockedInputsAreNotChangedByAnyMeans() {
        Seat student;
        student.begin();
        student.show(5); // the radial feed of the last stage alone is free
        Document& document = student.window.document();
        auto* table =
            student.window.inputs().findChild<QTableView*>(QStringLiteral("/cycle/stages"));
        const auto cell = [&](const char* path) {
            student.window.inputs().focusPath(path);
            return table->currentIndex();
        };
        QVERIFY(cell("/cycle/stages/1/radial_feed_mm").flags() & Qt::ItemIsEditable);
        QVERIFY(!(cell("/cycle/stages/0/radial_feed_mm").flags() & Qt::ItemIsEditable));
        QVERIFY(table->currentIndex()
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("Locked in this step")));
        const std::size_t stages = document.project().cycle->stages.size();
        for (const int key : {Qt::Key_Insert, Qt::Key_Delete, Qt::Key_F2, Qt::Key_5}) {
            QTest::keyClick(table, Qt::Key(key));
            QTest::keyClick(table, Qt::Key(key), Qt::ControlModifier);
        }
        QCOMPARE(document.project().cycle->stages.size(), stages);
        QVERIFY(!document.canUndo());
        // A field of a form says why, and takes no key.
        student.window.inputs().focusPath("/wheel/dullness");
        auto* dullness =
            student.window.inputs().findChild<NumberField*>(QStringLiteral("/wheel/dullness"));
        QVERIFY(!dullness->isEnabled());
        QVERIFY(dullness->toolTip().contains(QStringLiteral("Locked in this step")));
        QTest::keyClicks(dullness, QStringLiteral("0.03"));
        QVERIFY(!document.canUndo());
        // Nor is it by a way around the forms.
        Project changed = document.project();
        changed.wheel->dullness = 0.033;
        const Project before = document.project();
        document.edit(changed, {"Edit", "x"});
        QVERIFY(sameProject(document.project(), before));
        student.bench.action("addSurface")->trigger();
        QCOMPARE(document.surfaceCount(), std::size_t(1));
        // The free one is, and undone.
        student.typeStage(1, "radial_feed_mm", 0.0011);
        QCOMPARE(*document.project().cycle->stages[1].radial_feed_mm, 0.0011);
        student.bench.action("undo")->trigger();
        QCOMPARE(*document.project().cycle->stages[1].radial_feed_mm,
                 *before.cycle->stages[1].radial_feed_mm);
    }

    void aSparkOutIsTypedWhereItAloneIsFree() {
        Seat student(QStringLiteral("en"), Theme::light,
                     QStringLiteral(SPARKOUT_SOURCE_DIR
                                    "/resources/lessons/05-out-of-round.sparkout-lesson"));
        student.begin();
        student.show(7);
        QCOMPARE(accessTo(student.run().current(), "/cycle/stages/1/spark_out"), Access::free);
        student.typeStage(1, "spark_out", 15);
        QCOMPARE(student.window.document().project().cycle->stages.back().spark_out.count, 15);
    }

    void hintsAreTakenForTheirPrice() {
        Seat student;
        student.begin();
        student.show(1);
        auto* hint = student.part<QPushButton>("lessonHint");
        QVERIFY(hint->text().contains(QStringLiteral("0.5")));
        student.click(*hint);
        QVERIFY(hint->text().contains(QStringLiteral("2 of 2")));
        student.click(*hint);
        QVERIFY(!hint->isVisible());
        student.answer();
        student.handIn();
        QCOMPARE(student.run().pointsOf(1), 1.0); // of two
        QCOMPARE(student.onDisk().entries.size(), std::size_t(3));
    }

    void aWrongAnswerIsTriedAgainAndCounted() {
        Seat student;
        student.begin();
        student.show(5);
        student.handIn(); // as it stands
        QCOMPARE(student.run().mark(5), LessonRun::Mark::failed);
        QVERIFY(
            student.part<QLabel>("lessonFound")->text().startsWith(QStringLiteral("Not passed")));
        student.answer();
        student.handIn();
        QCOMPARE(student.run().mark(5), LessonRun::Mark::passed);
        QVERIFY(student.part<QLabel>("lessonAttempts")->text().contains(u'2'));
        QCOMPARE(student.run().pointsOf(5), 3.0);
    }

    void aWorkGoesOnWhereItWasLeft() {
        Seat student;
        student.begin();
        student.show(1);
        student.answer();
        student.handIn();
        student.show(5);
        student.typeStage(1, "radial_feed_mm", 0.0011);
        QTest::qWait(1200); // a pause, after which it is kept
        student.run().flush();
        // Nobody else writes the work meanwhile.
        {
            Bench second(QStringLiteral("en"));
            second.window->lesson().protect(student.folder.path());
            DialogAnswers answers({QStringLiteral("Escape")});
            second.window->files().openInstead(student.file());
            QCOMPARE(answers.fault(), QString());
            QVERIFY(answers.text().contains(QStringLiteral("is open already")));
            QVERIFY(!second.window->lesson().isRunning());
        }
        // As after a crash: what was on the disk before the window went is what there is.
        const QString drafts = student.folder.filePath(QStringLiteral("lessons"));
        const QString draft = QDir(drafts).filePath(QDir(drafts).entryList(QDir::Files).value(0));
        const std::string before = std::get<std::string>(readFile(draft.toStdString(), 1u << 24));
        student.bench.window.reset();
        QVERIFY(!writeFileSafely(draft.toStdString(), before));
        Bench other(QStringLiteral("en"));
        other.window->lesson().protect(student.folder.path());
        other.window->files().openInstead(student.file());
        QVERIFY(QTest::qWaitFor([&] { return other.window->lesson().isRunning(); }, 30'000));
        LessonRun& run = other.window->lesson().run();
        QCOMPARE(run.step(), std::size_t(5));
        QCOMPARE(*other.window->document().project().cycle->stages[1].radial_feed_mm, 0.0011);
        QVERIFY(QTest::qWaitFor([&] { return run.mark(1) == LessonRun::Mark::passed; }, 30'000));
        QVERIFY(!other.window->document().modified()); // no project that could be lost
        // Steps that were answered stand as they were, prediction and result side by side.
        other.window->lesson().showStep(1);
        QVERIFY(!other.window->lesson().isCovered());
    }

    /// A sync client puts another version of the open work in place; that both versions are kept is
    /// test_two_windows'.
    void aWorkThatSomebodyChangedIsSavedElsewhereOrSaidNotToBe() {
        Seat student;
        student.begin();
        const QByteArray foreign = trouble::bytesOf(student.file()) + '\n';
        trouble::write(student.file(), foreign);
        const auto notice = [&] {
            return student.window.files().notices().holds(QStringLiteral("lesson-not-saved"));
        };
        {
            const DialogAnswers asked({QStringLiteral("Escape")});
            student.show(0);
            student.answer();
            student.handIn();
            QCOMPARE(asked.fault(), QString());
            QVERIFY(!student.run().isSaved() && notice());
        }
        const QString other = student.folder.filePath(QStringLiteral("other.sparkout-work"));
        const DialogAnswers asked({QStringLiteral("elsewhere"), QStringLiteral("file:") + other});
        student.desk().save();
        QCOMPARE(asked.fault(), QString());
        QVERIFY(student.run().isSaved() && !notice());
        QCOMPARE(student.run().file(), other);
        QCOMPARE(trouble::bytesOf(student.file()), foreign);
    }

    void aLockedWorkCanBeReadAndCopied_data() {
        QTest::addColumn<QString>("answer");
        for (const char* answer : {"readOnly", "copy"}) {
            addRow(answer, QString::fromLatin1(answer));
        }
    }

    /// What is handed in goes where it may; a read-only work asks where.
    void aLockedWorkCanBeReadAndCopied() {
        QFETCH(QString, answer);
        Seat student;
        const QString lockFile = FileLock::lockPath(student.file());
        const QByteArray lock = "1\nsparkout\nanother-host\n\n\n";
        trouble::write(lockFile, lock);
        const bool isCopy = answer == u"copy";
        const QString other = student.folder.filePath(QStringLiteral("other.sparkout-work"));
        const QString chosen = QStringLiteral("file:") + other;
        {
            const DialogAnswers answers(isCopy ? QStringList{answer, chosen} : QStringList{answer});
            student.begin();
            QCOMPARE(answers.fault(), QString());
        }
        QCOMPARE(student.desk().isReadOnly(), !isCopy);
        QCOMPARE(student.window.windowTitle().contains(QStringLiteral("read-only")), !isCopy);
        const QByteArray before = trouble::bytesOf(student.file());
        const DialogAnswers answers(isCopy ? QStringList() : QStringList{chosen});
        student.show(0);
        student.answer();
        student.handIn();
        QCOMPARE(answers.fault(), QString());
        QVERIFY(student.run().isSaved() && !student.desk().isReadOnly());
        QCOMPARE(student.run().file(), other);
        QCOMPARE(trouble::bytesOf(student.file()), before);
        QCOMPARE(trouble::bytesOf(lockFile), lock);
    }

    void keptRunsAreOfTheWork() {
        Seat student;
        student.begin();
        student.show(0);
        student.bench.action("keepRun")->trigger();
        student.settle();
        const Work work = student.onDisk();
        QCOMPARE(work.entries.size(), std::size_t(1));
        QCOMPARE(work.entries.back().event, WorkEvent::run);
        student.show(5);
        QCOMPARE(student.window.document().project().runs.size(), std::size_t(1));
    }

    void hiddenInputsAreNotShownByAnyMeans() {
        Seat student;
        Lesson lesson = student.out.lesson;
        lesson.steps[0].inputs = {{"/wheel", Access::hidden},
                                  {"/machine/work_speed_rpm", Access::hidden},
                                  {"/cycle/stages/1/stock_mm", Access::hidden}};
        student.out = samples::giveOut(lesson, 1, 1);
        student.begin();
        student.show(0);
        InputsPanel& inputs = student.window.inputs();
        QVERIFY(!inputs.pages().empty()); // which builds those that have not been shown
        for (int key = Qt::Key_1; key <= Qt::Key_8; ++key) { // every page there is
            QTest::keyClick(&student.window, Qt::Key(key), Qt::AltModifier);
            student.bench.settle();
            for (const char* path :
                 {"/wheel/dullness", "/wheel/diameter_mm", "/machine/work_speed_rpm"}) {
                const auto* field = inputs.findChild<QWidget*>(QString::fromLatin1(path));
                QVERIFY2(field && !field->isVisible(), path);
            }
        }
        inputs.focusPath("/wheel/dullness");
        QVERIFY(!inputs.findChild<QWidget*>(QStringLiteral("/wheel/dullness"))->isVisible());
        const auto* stages = inputs.findChild<QTableView*>(QStringLiteral("/cycle/stages"));
        inputs.focusPath("/cycle/stages/1/stock_mm");
        QCOMPARE(stages->currentIndex().data().toString(), QStringLiteral("—"));
        // Reports, exports and formulas would state them.
        QVERIFY(!student.bench.action("exportResults")->isEnabled());
        QVERIFY(!student.bench.action("preview-card")
                || !student.bench.action("preview-card")->isEnabled());
        QVERIFY(!student.bench.action("show-compare")->isVisible());
        student.show(5); // another step has them again
        inputs.focusPath("/wheel/dullness");
        QVERIFY(inputs.findChild<QWidget*>(QStringLiteral("/wheel/dullness"))->isVisible());
    }

    void aStudentsFileHoldsNoAnswerAndNoSeed() {
        Seat student;
        student.begin();
        student.show(0);
        student.answer();
        student.handIn();
        const std::string text = writeWork(student.onDisk());
        for (const char* secret : {"\"right\"", "seed", "\"variants\"", "best_min"}) {
            QVERIFY2(text.find(secret) == std::string::npos, secret);
        }
    }

    void aLessonAsksOnceWhoDoesIt() {
        Seat student;
        const QString file = student.folder.filePath(QStringLiteral("new.sparkout-work"));
        DialogAnswers answers({QStringLiteral("Enter"), QStringLiteral("file:") + file});
        answers.seen = [](QDialog& dialog) {
            if (auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("studentName"))) {
                name->setFocus();
                QTest::keyClicks(name, QStringLiteral("Ivanov I."));
                QTest::keyClicks(dialog.findChild<QLineEdit*>(QStringLiteral("studentGroup")),
                                 QStringLiteral("TM-31"));
                dialog.findChild<QSpinBox*>(QStringLiteral("studentVariant"))->setValue(3);
            }
        };
        student.window.files().openInstead(shippedLesson());
        QCOMPARE(answers.fault(), QString());
        QVERIFY(student.run().isRunning());
        student.run().flush();
        const ReadWork read =
            readWork(std::get<std::string>(readFile(file.toStdString(), 1u << 24)));
        QVERIFY(read.work);
        QCOMPARE(read.work->name, std::string("Ivanov I."));
        QCOMPARE(read.work->group, std::string("TM-31"));
        QCOMPARE(read.work->variant, 3);
        QVERIFY(!brokenSeal(*read.work));
    }

    void aLessonOfTheListAsksForWhatIsOpen() {
        const Seat student;
        const DialogAnswers answers({QStringLiteral("Enter")});
        int asked = 0;
        student.desk().choose([&] {
            ++asked;
            return false;
        });
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(asked, 1);
        QVERIFY(!student.run().isRunning());
    }

    void anotherDocumentEndsTheLesson() {
        Seat student;
        student.begin();
        QVERIFY(student.bench.open(examplePaths().first()));
        QVERIFY(!student.run().isRunning());
        QVERIFY(student.bench.action("show-optimise")->isEnabled());
        Project changed = student.window.document().project();
        changed.wheel->dullness += 0.001;
        student.window.document().edit(changed, {"Edit", "x"});
        QVERIFY(student.window.document().modified());
    }

    void everyStepHasRoomInBothLanguagesAndAnyType_data() {
        addColumns<QString, int, Theme>("language", "percent", "theme");
        for (const char* language : {"en", "ru"}) {
            for (const int percent : {100, 130}) {
                QTest::addRow("%s %d", language, percent)
                    << QString::fromUtf8(language) << percent << Theme::light;
            }
        }
        QTest::addRow("en dark") << QStringLiteral("en") << 100 << Theme::dark;
        QTest::addRow("ru contrast") << QStringLiteral("ru") << 115 << Theme::contrast;
    }

    void everyStepHasRoomInBothLanguagesAndAnyType() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        QFETCH(Theme, theme);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        applyFontSize(percent);
        Seat student(language, theme);
        student.begin();
        QCOMPARE(student.window.size(), QSize(1366, 768));
        auto* tabs = student.panel().findChild<QTabWidget*>();
        tabs->setCurrentIndex(1);
        student.settle();
        const QString theory = student.part<QTextBrowser>("lessonTheory")->toPlainText();
        QVERIFY(theory.contains(language == u"ru" ? QStringLiteral("упругая система")
                                                  : QStringLiteral("elastic system")));
        tabs->setCurrentIndex(0);
        for (std::size_t step = 0; step < student.run().lesson().steps.size(); ++step) {
            student.show(step);
            for (const bool isAnswered : {false, true}) {
                if (isAnswered) {
                    student.answer();
                    student.handIn();
                }
                const QStringList cut = textsWithoutRoom(
                    *student.window.findChild<QDockWidget*>(QStringLiteral("lesson")));
                QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
            }
            if (language == u"ru") {
                for (const ShownText& shown : textsOf(student.panel())) {
                    QString text = shown.text;
                    text.remove(QRegularExpression(QStringLiteral("<style>.*</style>|a+ b+")));
                    QVERIFY2(englishIn(text).isEmpty(), qPrintable(text));
                }
            }
        }
    }

    void everyShippedWorkHasRoom_data() {
        addColumns<QString, QString>("language", "path");
        const QDir folder(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons"));
        for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
            for (const char* language : {"ru", "en"}) {
                QTest::addRow("%s %s", language, qPrintable(name.left(2)))
                    << QString::fromUtf8(language) << folder.filePath(name);
            }
        }
    }

    /// Every step as it is found and, where it asks for a prediction, once that is given.
    void everyShippedWorkHasRoom() {
        if (!qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
            QSKIP("with SPARKOUT_LONG alone");
        }
        QFETCH(QString, language);
        QFETCH(QString, path);
        const bool isRussian = language == u"ru";
        static const QRegularExpression cyrillic(QStringLiteral("[А-Яа-яЁё]"));
        Seat student(language, Theme::light, path);
        student.begin();
        for (std::size_t step = 0; step < student.run().lesson().steps.size(); ++step) {
            student.show(step);
            for (const bool isAnswered : {false, true}) {
                if (isAnswered) {
                    if (!student.desk().isCovered()) {
                        break;
                    }
                    student.answer();
                    student.handIn();
                }
                const QStringList cut = textsWithoutRoom(
                    *student.window.findChild<QDockWidget*>(QStringLiteral("lesson")));
                QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
                for (const ShownText& shown : textsOf(student.panel())) {
                    QString text = shown.text;
                    text.remove(QRegularExpression(QStringLiteral("<style>.*</style>|Студент 1")))
                        .remove(QStringLiteral("ТМ-31"));
                    const bool isForeign =
                        isRussian ? !englishIn(text).isEmpty() : text.contains(cyrillic);
                    QVERIFY2(!isForeign, qPrintable(text));
                }
            }
        }
    }

    void theDialogsHaveRoom_data() {
        addColumns<QString, int>("language", "percent");
        for (const char* language : {"en", "ru"}) {
            for (const int percent : {100, 130}) {
                QTest::addRow("%s %d", language, percent) << QString::fromUtf8(language) << percent;
            }
        }
    }

    void theDialogsHaveRoom() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        applyFontSize(percent);
        Seat student(language);
        LessonsDialog lessons({});
        StudentDialog begin(student.out.lesson, QStringLiteral("Иванов"), {}, nullptr);
        MarksDialog marks(student.bench.settings, nullptr);
        const samples::GivenOut out = samples::giveOut(student.out.lesson, 2, 3);
        for (std::size_t i = 0; i < out.works.size(); ++i) {
            const QString path = student.folder.filePath(QStringLiteral("%1.sparkout-work").arg(i));
            QVERIFY(!writeFileSafely(path.toStdString(), writeWork(samples::solved(out, i, {2}))));
        }
        marks.add({shippedLesson(), student.folder.path()});
        QSignalSpy marked(&marks, &MarksDialog::marked);
        marks.mark();
        QVERIFY(marked.wait(60'000));
        QVERIFY(!lessons.chosen().isEmpty());
        for (QDialog* dialog : std::initializer_list<QDialog*>{&lessons, &begin, &marks}) {
            dialog->show();
            student.settle();
            const QStringList cut = textsWithoutRoom(*dialog);
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
            QVERIFY(dialog->width() <= 1366 && dialog->height() <= 728);
        }
    }
};

} // namespace test_lesson_mode

SPARKOUT_TEST(test_lesson_mode, TestLessonMode)
#include "test_lesson_mode.moc"
