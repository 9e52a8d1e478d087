// SPDX-License-Identifier: GPL-3.0-or-later
// A new project: its drawing is yet to be given, and until then nothing is said of it.
#include "core/catalogue/catalogue.h"
#include "core/file/project_file.h"
#include "core/phases/phase_decision.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/new_project.h"
#include "core/study/search_edits.h"
#include "core/study/starting_project.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/chart/plot_view.h"
#include "ui/chart/view_plot.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/inputs/messages_panel.h"
#include "ui/session/cycle_cursor.h"
#include "ui/text/texts.h"
#include "ui/views/cycle/feeds_plot.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/requirements/verdict_panel.h"
#include "ui/window/file_commands.h"
#include "words/issue_words.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QTemporaryDir>

#include <map>
#include <vector>

namespace sparkout::test_new_project {

const std::map<std::string, QString> drawing{{"/part/diameter_mm", QStringLiteral("40")},
                                             {"/part/upper_deviation_um", QStringLiteral("0")},
                                             {"/part/lower_deviation_um", QStringLiteral("-25")},
                                             {"/part/length_mm", QStringLiteral("80")},
                                             {"/part/stock_mm", QStringLiteral("0,15")}};

struct NewBench : Bench {
    explicit NewBench(const char* command = "newTraverse") : Bench(QStringLiteral("en")) {
        if (!open(examplePaths().front())) {
            qFatal("the example cannot be opened");
        }
        action(command)->trigger();
    }
    [[nodiscard]] NumberField& field(const std::string& path) {
        return *window->findChild<NumberField*>(QString::fromStdString(path));
    }
    void type(const std::string& path, const QString& text) {
        NumberField& to = field(path);
        to.setFocus();
        to.selectAll();
        QTest::keyClicks(&to, text);
        QTest::keyClick(&to, Qt::Key_Return);
    }
    [[nodiscard]] QLabel& verdict(const char* part) {
        return *window->findChild<VerdictPanel*>()->findChild<QLabel*>(QString::fromLatin1(part));
    }
    [[nodiscard]] bool incomplete() {
        return QTest::qWaitFor([this] {
            return window->studies().outcome && !window->studies().outcome->ran()
                   && window->studies().outcome->issues.size()
                          == window->document().openInputs().size();
        });
    }
};

class TestNewProject : public QObject {
    Q_OBJECT

private slots:
    void itStartsAtThePartAndAsksForTheDrawing() {
        for (const char* command : {"newTraverse", "newPlunge"}) {
            NewBench bench(command);
            QVERIFY(bench.incomplete());
            QCOMPARE(QApplication::focusWidget(), &bench.field("/part/diameter_mm"));
            for (const std::string& path : drawingInputs()) {
                QVERIFY2(bench.field(path).text().isEmpty(), path.c_str());
                QVERIFY(!bench.field(path).refused());
                QCOMPARE(bench.field(path).remark().mark, Mark::missing);
            }
            QCOMPARE(bench.window->messages().count(), int(drawingInputs().size()));
            QVERIFY(!bench.window->document().modified());
        }
    }

    void theVerdictIsNeutral() {
        NewBench bench;
        QVERIFY(bench.incomplete());
        QTRY_VERIFY(bench.verdict("notice").text().startsWith(QStringLiteral("Not checked")));
        QVERIFY(!bench.verdict("overall").isVisible());
        QVERIFY(bench.verdict("notChecked").text().contains(QStringLiteral("/part/stock_mm")));
    }

    /// Of the project before, with a batch, kept runs and measured parts, nothing is left.
    void noViewShowsTheProjectBefore() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-measured"));
        for (const View* view : bench.window->views()) {
            QVERIFY(bench.window->showView(view->objectName()));
            bench.settle();
        }
        QVERIFY(bench.window->cursor().outcome());
        bench.action("newPlunge")->trigger();
        QTRY_VERIFY(bench.window->studies().outcome && !bench.window->studies().outcome->ran());
        QVERIFY(!bench.window->cursor().outcome());
        for (const View* view : bench.window->views()) {
            QVERIFY(bench.window->showView(view->objectName()));
            bench.settle();
            for (const ViewPlot* plot : view->findChildren<ViewPlot*>()) {
                QVERIFY2(!plot->isVisible(), qPrintable(plot->objectName()));
            }
        }
        for (const auto& [path, text] : drawing) { // and the new one is shown once it is complete
            auto* field = bench.window->findChild<NumberField*>(QString::fromStdString(path));
            field->setFocus();
            field->selectAll();
            const bool isLength = path == "/part/length_mm"; // no longer than the wheel is wide
            QTest::keyClicks(field, isLength ? QStringLiteral("40") : text);
            QTest::keyClick(field, Qt::Key_Return);
        }
        QTRY_VERIFY(bench.window->studies().outcome->ran());
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        QTRY_VERIFY(bench.window->findChild<FeedsView*>()->findChild<FeedsPlot*>()->isVisible());
    }

    void noTimeOfTheProjectBeforeIsLeft() {
        OpenBench bench(QStringLiteral("en"), examplePath("setups/spindle"));
        bench.window->inputs().showCycle();
        const auto hasTimes = [&bench] {
            const auto* model = bench.window->inputs()
                                    .findChild<QTableView*>(QStringLiteral("/cycle/stages"))
                                    ->model();
            QString times;
            for (int row = 0; row < model->rowCount(); ++row) {
                times += model->index(row, model->columnCount() - 1).data().toString();
            }
            return times.contains(QRegularExpression(QStringLiteral("[0-9]")));
        };
        const auto* strip = bench.window->findChild<QWidget*>(QStringLiteral("partStrip"));
        QTRY_VERIFY(hasTimes());
        QVERIFY(strip->isVisible());
        bench.action("newPlunge")->trigger();
        QTRY_VERIFY(bench.window->studies().outcome && !bench.window->studies().outcome->ran());
        bench.rest();
        QVERIFY(!hasTimes());
        QVERIFY(!strip->isVisible());
    }

    void everyViewLeadsToWhatIsMissing() {
        NewBench bench;
        QVERIFY(bench.incomplete());
        for (const char* key : {"overview", "feeds", "profiles", "constraints", "compliance",
                                "layers", "batch", "sweep", "optimise", "compare"}) {
            bench.window->inputs().setFocus();
            QVERIFY2(bench.window->showView(QString::fromLatin1(key)), key);
            QLabel* leads = nullptr;
            const auto look = [&] {
                for (auto* label : bench.window->findChildren<QLabel*>()) {
                    if (label->isVisible() && label->objectName().startsWith(QLatin1String(key))
                        && label->text().contains(QStringLiteral("/part/length_mm"))) {
                        leads = label;
                    }
                }
                return leads != nullptr;
            };
            QVERIFY2(QTest::qWaitFor(look), key);
            emit leads->linkActivated(QStringLiteral("/part/length_mm"));
            QCOMPARE(QApplication::focusWidget(), &bench.field("/part/length_mm"));
        }
    }

    void onceTheDrawingIsGivenItIsComputedAndUndoAsksAgain() {
        NewBench bench;
        QVERIFY(bench.incomplete());
        for (const auto& [path, text] : drawing) {
            QVERIFY(!bench.window->document().openInputs().empty());
            bench.type(path, text);
            QVERIFY(!bench.window->document().isOpen(path));
        }
        QTRY_VERIFY(bench.window->studies().outcome->ran());
        QCOMPARE(bench.window->document().project().part->diameter_mm, 40.0);
        QCOMPARE(bench.window->document().project().part->stock_mm, 0.15);
        QTRY_VERIFY(bench.verdict("overall").isVisible());
        bench.window->document().undo();
        QVERIFY(bench.incomplete());
        QCOMPARE(bench.window->document().openInputs().size(), std::size_t(1));
        bench.window->document().redo();
        QTRY_VERIFY(bench.window->studies().outcome->ran());
    }

    // The cycle is the starting one of the drawing, and follows it until something else is changed.
    void aCompleteDrawingHasAStartingCycleThatFollowsIt() {
        NewBench bench("newPlunge");
        QVERIFY(bench.incomplete());
        bench.type("/part/diameter_mm", QStringLiteral("35k6"));
        bench.type("/part/length_mm", QStringLiteral("28"));
        bench.type("/part/stock_mm", QStringLiteral("0.15"));
        Document& document = bench.window->document();
        QVERIFY(document.openInputs().empty());
        const auto startingOf = [](const Project& project) {
            return firstDifference(withStartingCycle(project), project);
        };
        QCOMPARE(startingOf(document.project()), std::string());
        const auto hasUsualSearch = [](const Project& project) {
            return firstDifference(usualSearch(project), project).empty();
        };
        QVERIFY(document.project().optimisation && hasUsualSearch(document.project()));
        QCOMPARE(document.project().cycle->stages.size(), 3u);
        QVERIFY(!document.project().cycle->stages.back().feeds());
        QCOMPARE(document.project().machine->name, std::string("3М151"));
        const auto segments = document.project().part->shaft.segments;
        QCOMPARE(segments.size(), 1u);
        QCOMPARE(segments.front().length_mm, 28.0);
        QTRY_VERIFY(bench.window->studies().outcome->ran());
        QVERIFY(decidePhases(document.project(), usualPhases(document.project())).holds());
        const double before = document.project().cycle->stages.front().stock_mm;
        bench.type("/part/stock_mm", QStringLiteral("0.2"));
        QCOMPARE(startingOf(document.project()), std::string());
        QVERIFY(document.project().cycle->stages.front().stock_mm > before);
        QVERIFY(hasUsualSearch(document.project()));
        Project changed = document.project();
        *changed.cycle->stages.front().radial_feed_mm_min = 0.5; // by hand
        document.edit(changed, {"Edit", "x"});
        bench.type("/part/length_mm", QStringLiteral("20"));
        QCOMPARE(document.project().cycle->stages.front().radial_feed_mm_min, std::optional(0.5));
        auto* const button = bench.window->findChild<QPushButton*>(QStringLiteral("startingCycle"));
        bench.window->inputs().showCycle();
        button->click();
        QCOMPARE(startingOf(document.project()), std::string());
        document.undo();
        QCOMPARE(document.project().cycle->stages.front().radial_feed_mm_min, std::optional(0.5));
    }

    // The wheel follows Ra and machine until another is chosen.
    void theWheelFollowsTheDrawingAndTheMachine() {
        Document document;
        document.startIncomplete(undrawnProject(Operation::plunge), drawingInputs());
        const auto edit = [&document](const auto& change) {
            Project changed = document.project();
            change(changed);
            document.edit(changed, {"Edit", "x"});
            return document.project().wheel->marking;
        };
        const auto ra = [](double ra_um) {
            return [ra_um](Project& project) { project.part->tolerance.roughness_ra_um = ra_um; };
        };
        QCOMPARE(edit([](Project& project) {
                     Part& part = *project.part;
                     part.diameter_mm = 35;
                     part.upper_deviation_um = 18;
                     part.lower_deviation_um = 2;
                     part.length_mm = 28;
                     part.stock_mm = 0.15;
                 }),
                 std::string("600×63×305 25А F60 L 6 V"));
        QCOMPARE(edit(ra(3.2)), std::string("600×63×305 25А F46 K 6 V"));
        QCOMPARE(edit([](Project& project) {
                     applyEntry(*entryMeant(shippedEntries<MachineEntry>(), "3М153"), project);
                 }),
                 std::string("500×50×203 25А F60 L 6 V"));
        const std::string own = "500×50×203 92А F60 L 6 V";
        QCOMPARE(edit([&own](Project& project) {
                     applyEntry(*entryMeant(shippedEntries<WheelEntry>(), own), project);
                 }),
                 own);
        QCOMPARE(edit(ra(0.4)), own);
        QVERIFY(document.followsDrawing());
    }

    /// A shaft that becomes a bore before it is drawn gets wheel and quill of a bore.
    void aNewBoreHasItsWheelAndQuill() {
        Document document;
        document.startIncomplete(undrawnProject(Operation::plunge), drawingInputs());
        const auto edit = [&document](const auto& change) {
            Project changed = document.project();
            change(changed);
            document.edit(changed, {"Edit", "x"});
        };
        edit([](Project& project) { project.part->surface = Surface::internal; });
        edit([](Project& project) {
            applyEntry(*entryMeant(shippedEntries<MachineEntry>(), "3К227"), project);
        });
        edit([](Project& project) {
            Part& part = *project.part;
            part.diameter_mm = 60;
            part.upper_deviation_um = 30;
            part.lower_deviation_um = 0;
            part.length_mm = 30;
            part.stock_mm = 0.15;
        });
        QVERIFY(document.followsDrawing());
        const Issues faults = document.newFaults();
        QVERIFY2(faults.empty(), faults.empty() ? "" : issueSentence(faults.front()).c_str());
        const Project& bore = document.project();
        QCOMPARE(bore.wheel->diameter_mm, 40.0);
        const std::optional<Quill>& quill = bore.part->shaft.quill;
        QVERIFY(quill.has_value() && bore.part->shaft.segments.empty());
        QCOMPARE(quill->length_mm, 45.0);   // 15 mm beyond the bore
        QCOMPARE(quill->diameter_mm, 28.0); // 0.7 of the wheel's
        QVERIFY(evaluate(bore, {})->ran());
    }

    void aPartThatTheMachineDoesNotTakeIsRefusedUntilAnotherTakesIt() {
        NewBench bench("newPlunge");
        QVERIFY(bench.incomplete());
        bench.type("/part/diameter_mm", QStringLiteral("300h8"));
        bench.type("/part/length_mm", QStringLiteral("40"));
        bench.type("/part/stock_mm", QStringLiteral("0.3"));
        Document& document = bench.window->document();
        QVERIFY(document.openInputs().empty());
        QTRY_VERIFY(bench.window->studies().outcome && !bench.window->studies().outcome->ran()
                    && bench.window->studies().outcome->issues.size() == 2);
        QCOMPARE(bench.window->studies().outcome->issues.front().path,
                 std::string("/part/diameter_mm"));
        const Issue& offer = bench.window->studies().outcome->issues.back();
        QCOMPARE(offer.path, std::string("/machine/name"));
        QVERIFY(issueText(offer).contains(QStringLiteral("3М174")));
        Project larger = document.project();
        applyEntry(*entryMeant(shippedEntries<MachineEntry>(), "3М174"), larger);
        document.edit(larger, {"Edit", "x"});
        QTRY_VERIFY(bench.window->studies().outcome->ran());
    }

    void onceSavedAPartThatTheMachineDoesNotTakeIsComputedWithAWarning() {
        NewBench bench("newPlunge");
        QVERIFY(bench.incomplete());
        bench.type("/part/diameter_mm", QStringLiteral("300h8"));
        bench.type("/part/length_mm", QStringLiteral("40"));
        bench.type("/part/stock_mm", QStringLiteral("0.3"));
        const auto severities = [&bench] {
            std::vector<Severity> found;
            for (const Issue& issue : bench.window->studies().outcome->issues) {
                if (issue.path == "/part/diameter_mm") {
                    found.push_back(issue.severity);
                }
            }
            return found;
        };
        QTRY_VERIFY(!bench.window->runs().running()
                    && severities() == std::vector{Severity::error});
        const QTemporaryDir folder;
        QVERIFY(!bench.window->document().saveAs(folder.filePath(QStringLiteral("a.sparkout"))));
        QTRY_VERIFY(bench.window->studies().outcome->ran()
                    && severities() == std::vector{Severity::warning});
        QVERIFY(!bench.window->document().modified());
    }

    void theCyclePageStatesWhatLimitsTheRoughDepth() {
        NewBench bench("newPlunge");
        bench.type("/part/diameter_mm", QStringLiteral("35k6"));
        bench.type("/part/length_mm", QStringLiteral("28"));
        bench.type("/part/stock_mm", QStringLiteral("0.15"));
        auto* const follows = bench.window->findChild<QLabel*>(QStringLiteral("followsDrawing"));
        QTRY_VERIFY(follows->text().contains(QStringLiteral("Its rough depth of cut")));
    }

    void aNumberThatIsDeletedAgainIsAskedForAgain() {
        NewBench bench;
        NumberField& field = bench.field("/part/diameter_mm");
        field.setFocus();
        QTest::keyClicks(&field, QStringLiteral("40"));
        QVERIFY(!bench.window->document().isOpen("/part/diameter_mm"));
        QTest::keyClick(&field, Qt::Key_Backspace);
        QTest::keyClick(&field, Qt::Key_Backspace);
        QVERIFY(bench.window->document().isOpen("/part/diameter_mm"));
        QVERIFY(!bench.window->document().modified()); // as if nothing had been typed
        QVERIFY(bench.incomplete());
        QVERIFY(field.text().isEmpty());
    }

    void anotherOperationLeavesTheDrawingOpen() {
        NewBench bench;
        Project plunge = bench.window->document().project();
        plunge.operation = Operation::plunge;
        plunge.part->length_mm = 20;
        bench.window->document().edit(plunge, {"Input", "Operation"});
        QCOMPARE(bench.window->document().openInputs().size(), drawingInputs().size());
        QVERIFY(bench.incomplete());
    }

    void aReportIsRefusedEvenWhileItIsComputed() {
        NewBench bench;
        QVERIFY(bench.incomplete());
        Project project = bench.window->document().project();
        project.wheel->dullness = 0.03;
        bench.window->document().edit(project, {"Edit", "Dullness"});
        QVERIFY(bench.window->runs().running());
        const DialogAnswers answers({QStringLiteral("Enter")});
        bench.action("pdf-card")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY2(answers.text().startsWith(QStringLiteral("There is no result of these inputs")),
                 qPrintable(answers.text()));
    }

    void savingSaysWhyNot() {
        NewBench bench;
        {
            const DialogAnswers answers({QStringLiteral("Escape")});
            QVERIFY(!bench.window->files().save());
            QCOMPARE(answers.fault(), QString());
            QVERIFY(answers.text().contains(QStringLiteral("Diameter")));
        }
        bench.type("/part/diameter_mm", QStringLiteral("40"));
        const DialogAnswers again({QStringLiteral("Escape")});
        QVERIFY(!bench.window->files().saveAs());
        QCOMPARE(again.fault(), QString());
        QVERIFY(!again.text().contains(QStringLiteral("Diameter")));
    }
};

} // namespace sparkout::test_new_project

SPARKOUT_TEST(test_new_project, TestNewProject)
#include "test_new_project.moc"
