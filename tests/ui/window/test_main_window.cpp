// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/support/window_bench.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/inputs/stage_table.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/part/profiles_view.h"
#include "ui/views/requirements/verdict_panel.h"
#include "ui/window/dialogs/examples_dialog.h"
#include "ui/window/file_commands.h"
#include "ui/window/status_line.h"
#include "ui/window/view_tabs.h"

#include "core/file/project_file.h"
#include "core/study/stage_edits.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>

namespace sparkout::test_main_window {

class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void aTypedFeedChangesTheVerdictAndSurvivesSaveAndReopen() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("вал.sparkout"));
        QVERIFY(QFile::copy(examplePath("shaft-30h6-factory"), path));
        OpenBench bench(QStringLiteral("ru"), path);
        const OutcomePtr before = bench.window->studies().outcome;
        auto& table = *bench.window->findChild<StageTable*>();
        table.view().setFocus();
        table.view().setCurrentIndex(table.view().model()->index(1, 0));
        QTest::keyClick(&table.view(), Qt::Key_0);
        auto* editor = table.view().findChild<NumberField*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral(",003"));
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(bench.window->document().project().cycle->stages[1].radial_feed_mm.value(), 0.003);
        QTRY_VERIFY(bench.window->studies().outcome->result.project.cycle->stages[1].radial_feed_mm
                    == 0.003);
        const OutcomePtr after = bench.window->studies().outcome;
        QVERIFY(after->result.time_s < before->result.time_s);
        QVERIFY(bench.window->isWindowModified());
        QVERIFY(bench.window->files().save());
        QVERIFY(!bench.window->isWindowModified());

        OpenBench again(QStringLiteral("en"), path);
        QVERIFY(
            sameProject(again.window->document().project(), bench.window->document().project()));
        const OutcomePtr same = again.window->studies().outcome;
        QCOMPARE(same->result.time_s, after->result.time_s);
        QCOMPARE(same->constraints.size(), after->constraints.size());
        for (std::size_t i = 0; i < same->constraints.size(); ++i) {
            QCOMPARE(same->constraints[i].value, after->constraints[i].value);
        }
    }

    void aMessageStandsAloneAtTheFoot() {
        QStatusBar bar;
        StatusLine line(bar);
        const auto* status = bar.findChild<QLabel*>();
        line.showForAWhile(QStringLiteral("before the window was in sight"));
        bar.show();
        QVERIFY(!status->isVisible());
        bar.clearMessage();
        QVERIFY(status->isVisible());
        line.showForAWhile(QStringLiteral("and after"));
        QVERIFY(!status->isVisible());
    }
    void whatAnotherOperationChangesIsTold() {
        OpenBench bench(QStringLiteral("ru"), examplePath("shaft-30h6-factory"));
        const Part before = *bench.window->document().project().part;
        const double width_mm = bench.window->document().project().wheel->width_mm;
        QVERIFY(before.length_mm > width_mm);
        auto* box = bench.window->findChild<QComboBox*>(QStringLiteral("/operation"));
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        const Project& now = bench.window->document().project();
        QCOMPARE(now.operation, Operation::plunge);
        QCOMPARE(now.wheel->width_mm, width_mm);
        QCOMPARE(now.part->length_mm, width_mm);
        const NoticeBar& notices = bench.window->files().notices();
        const QString told = notices.textOf(QStringLiteral("operation"));
        QVERIFY2(told.contains(inputText("Ground length")), qPrintable(told));
        bench.window->document().undo();
        QVERIFY(!notices.holds(QStringLiteral("operation")));
        QCOMPARE(bench.window->document().project().part->length_mm, before.length_mm);
    }

    void refusedInputsAreListedAndTheMessageLeadsToTheField() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        Project project = bench.window->document().project();
        project.part->radii_per_section = 35;
        bench.window->document().edit(project, {"Input", "Radii per section"});
        QTRY_VERIFY(!bench.window->studies().outcome->ran());
        MessagesPanel& messages = bench.window->messages();
        QCOMPARE(messages.count(), 1);
        QVERIFY(messages.item(0)->text().contains(QStringLiteral("Radii per section")));
        emit messages.itemDoubleClicked(messages.item(0));
        const auto* field =
            bench.window->findChild<QWidget*>(QStringLiteral("/part/radii_per_section"));
        QVERIFY(field->isVisible());
        QCOMPARE(bench.window->focusWidget(), field);
    }

    void theLineBelowStocksThatDoNotAddUpFitsThem() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        Project project = bench.window->document().project();
        project.part->stock_mm += 0.05;
        bench.window->document().edit(project, {"Input", "Stock"});
        MessagesPanel& messages = bench.window->messages();
        const auto line = [&messages] {
            const auto found = messages.findItems(QStringLiteral("Fit the stocks of the stages"),
                                                  Qt::MatchExactly);
            return found.isEmpty() ? nullptr : found.front();
        };
        QTRY_VERIFY(line());
        messages.scrollToItem(line());
        QTest::mouseClick(messages.viewport(), Qt::LeftButton, {},
                          messages.visualItemRect(line()).center());
        QTRY_VERIFY(stocksAddUp(bench.window->document().project()));
        QTRY_VERIFY(!line());
        bench.window->document().undo();
        QVERIFY(!stocksAddUp(bench.window->document().project()));
        QTRY_VERIFY(line());
        messages.setFocus();
        messages.setCurrentItem(line());
        QTest::keyClick(&messages, Qt::Key_Return);
        QTRY_VERIFY(stocksAddUp(bench.window->document().project()));
        bench.window->document().undo();
        QTRY_VERIFY(line());
        messages.offerStockFit(false); // as in a lesson that locks the stages
        QVERIFY(!line());
        QVERIFY(messages.paths().contains(QStringLiteral("/cycle/stages")));
        messages.offerStockFit(true);
        QVERIFY(line());
    }

    void aRefusedTextIsListedAndTheVerdictSaysSo() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        bench.window->inputs().showPage(0);
        auto* field = bench.window->findChild<NumberField*>(QStringLiteral("/part/diameter_mm"));
        typeOver(*field, QStringLiteral("thirty"));
        QTRY_COMPARE(bench.window->messages().item(0)->data(Qt::UserRole).toString(),
                     QStringLiteral("/part/diameter_mm"));
        const auto* notice = bench.window->findChild<QLabel*>(QStringLiteral("refusedFields"));
        QTRY_VERIFY(notice->isVisible());
        QVERIFY(notice->text().startsWith(QStringLiteral("1 field"))
                && notice->text().contains(QStringLiteral("invalid entr")));
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("31"));
        QTRY_VERIFY(!notice->isVisible());
    }

    void aRequirementLeadsToWhereItIsSeen() {
        Bench bench(QStringLiteral("en"));
        Project project = exampleProject("shaft-30h6-factory");
        project.machine->limits.work_speed_rpm = std::vector<double>{100, 101, 1};
        project.machine->wheel_drive_kw = 0.1;
        QSignalSpy shown(bench.window.get(), &MainWindow::outcomeShown);
        bench.window->document().startUntitled(project);
        QTRY_COMPARE(shown.count(), 1);
        auto* panel = bench.window->findChild<VerdictPanel*>();
        auto* feeds = bench.window->findChild<FeedsView*>();
        auto* profiles = bench.window->findChild<ProfilesView*>();
        const auto activate = [&](ConstraintKind kind) {
            for (const ConstraintResult& c : bench.window->studies().outcome->constraints) {
                if (c.kind == kind) {
                    emit panel->requirementActivated(c);
                    return c;
                }
            }
            return ConstraintResult{};
        };
        activate(ConstraintKind::diameterMax);
        QCOMPARE(bench.window->viewTabs().currentView(), profiles);
        QCOMPARE(profiles->stroke(), bench.window->studies().outcome->result.cycleCount);
        const ConstraintResult power = activate(ConstraintKind::wheelPower);
        QVERIFY(power.at);
        QCOMPARE(bench.window->viewTabs().currentView(), feeds);
        QCOMPARE(feeds->findChild<QSpinBox*>(QStringLiteral("stroke"))->value(),
                 power.at->cycleCount);
        const double from_s = feeds->plot()->visibleFrom_s();
        const double to_s = feeds->plot()->visibleTo_s();
        QVERIFY(feeds->plot()->series().strokeAt((from_s + to_s) / 2) == power.at->cycleCount);
        activate(ConstraintKind::rangeWorkSpeed);
        QVERIFY(bench.window->focusWidget());
        QCOMPARE(bench.window->focusWidget()->objectName(),
                 QStringLiteral("/machine/work_speed_rpm"));
    }

    void theComputedComplianceCanBeRead() {
        OpenBench bench(QStringLiteral("en"), examplePath("slender-shaft"));
        bench.window->inputs().showPage(3);
        auto* label = bench.window->findChild<QLabel*>(QStringLiteral("computedCompliance"));
        QVERIFY(label->isVisibleTo(label->parentWidget()));
        for (const SectionResult& section : bench.window->studies().outcome->result.sections) {
            QVERIFY(label->text().contains(Names::significant(section.compliance_mm_per_n)));
        }
        QVERIFY(bench.open(examplePath("shaft-30h6-factory"))); // with given values
        QVERIFY(!label->isVisibleTo(label->parentWidget()));
    }

    /// A starting cycle is first; the program opens it where no file is given.
    void theGalleryHasEveryExampleOnceInItsOrder() {
        QStringList listed = ExamplesDialog::paths(), shipped;
        QCOMPARE(listed.front(), QStringLiteral(":/examples/starting-cycle-35k6.sparkout"));
        for (const QString& name : QDir(QStringLiteral(":/examples")).entryList(QDir::Files)) {
            shipped += QStringLiteral(":/examples/") + name;
        }
        listed.sort();
        shipped.sort();
        QCOMPARE(listed, shipped);
    }

    void theGalleryOpensEveryExampleAsAnUntitledCopy() {
        Document document;
        for (const QString& path : ExamplesDialog::paths()) {
            QVERIFY2(!hasErrors(document.openCopy(ExamplesDialog::textOf(path))), qPrintable(path));
            QVERIFY(document.filePath().isEmpty());
            QVERIFY(!document.modified());
        }
    }

    void anExampleNobodyTouchedHasItsTitlesInTheLanguageOfTheWindow() {
        Bench bench(QStringLiteral("en"));
        Document& document = bench.window->document();
        const auto choose = [&bench](const char* language) {
            bench.window->findChild<QAction*>(QLatin1String(language))->trigger();
        };
        const auto open = [&document](const char* name) {
            QVERIFY(!hasErrors(document.openCopy(
                ExamplesDialog::textOf(QStringLiteral(":/examples/") + QLatin1String(name)))));
        };
        open("wheel-dull.sparkout");
        QCOMPARE(document.project().title, std::string("Dull wheel"));
        choose("russian");
        QCOMPARE(document.project().title, std::string("Затупившийся круг"));
        QVERIFY(bench.window->windowTitle().startsWith(QStringLiteral("Затупившийся круг")));
        QVERIFY(!document.modified() && !document.canUndo());
        Project edited = document.project();
        edited.author = "N. N.";
        document.edit(edited, {"Edit", "Edit"});
        choose("english");
        QCOMPARE(document.project().title,
                 std::string("Затупившийся круг")); // it is the user's now
        document.undo();
        choose("russian");
        choose("english");
        QCOMPARE(document.project().title, std::string("Затупившийся круг"));
        open("spindle.sparkout");
        const std::string name = document.state().surfaces[1]->name;
        choose("russian");
        QVERIFY(document.state().surfaces[1]->name != name);
        choose("english");
        QCOMPARE(document.state().surfaces[1]->name, name);
    }
};

} // namespace sparkout::test_main_window

SPARKOUT_TEST(test_main_window, TestMainWindow)
#include "test_main_window.moc"
