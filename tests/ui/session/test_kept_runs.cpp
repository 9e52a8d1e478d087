// SPDX-License-Identifier: GPL-3.0-or-later
// Kept runs of a document: edits that can be undone and are saved; computed again aside.
#include "tests/whole_project.h"
#include "ui/session/kept_runs.h"

#include "core/file/project_file.h"
#include "core/study/new_project.h"
#include "core/study/outcome.h"
#include "tests/registry.h"

#include <QTemporaryDir>

namespace sparkout::test_kept_runs {

constexpr EditText editText{"Input", "Diameter"};

/// A document with the kept runs of it, as the window has them.
struct Desk {
    Desk() { document.startUntitled(newProject(Operation::traverse)); }
    void setStock(double stock_mm) {
        Project project = document.project();
        project.part->stock_mm = stock_mm;
        project.cycle->stages.front().stock_mm += stock_mm - document.project().part->stock_mm;
        document.edit(std::move(project), editText);
    }
    [[nodiscard]] OutcomePtr run() const { return evaluate(document.project(), {}); }
    bool keep() { return kept.keep(*run()) == KeptRuns::Kept::yes; }
    [[nodiscard]] bool settled() {
        return QTest::qWaitFor([this] { return !kept.busy(); }, 20'000);
    }

    Document document;
    KeptRuns kept{document};
};

std::string withoutRuns(Project project) {
    project.runs.clear();
    return writeProject(project);
}

class TestKeptRuns : public QObject {
    Q_OBJECT

private slots:
    void keepingIsAnEditThatHoldsTheInputsAsRun() {
        Desk desk;
        const std::string inputs = withoutRuns(desk.document.project());
        QVERIFY(desk.keep());
        QCOMPARE(desk.kept.count(), 1);
        QVERIFY(desk.document.modified());
        QCOMPARE(withoutRuns(*desk.kept.inputs(0)), inputs);
        QCOMPARE(desk.kept.all()[0].engine_version, desk.run()->result.engineVersion);
        QVERIFY(
            changedSince(*desk.kept.summary(0), summarise(desk.run()->result, desk.run()->accuracy,
                                                          desk.run()->constraints))
                .empty());
        QVERIFY(desk.kept.isChosen(0));
        desk.setStock(0.2);
        QCOMPARE(withoutRuns(*desk.kept.inputs(0)), inputs); // it does not follow
        desk.document.undo();
        desk.document.undo();
        QCOMPARE(desk.kept.count(), 0);
        QVERIFY(!desk.document.modified());
        desk.document.redo();
        QCOMPARE(desk.kept.count(), 1);
    }

    void aGivenNameThatIsTakenGetsANumber() {
        Desk desk;
        const OutcomePtr run = desk.run();
        for (const char* name : {"Worst part", "Worst part (2)", "Worst part (3)"}) {
            QVERIFY(desk.kept.keep(*run, QStringLiteral("Worst part")) == KeptRuns::Kept::yes);
            QCOMPARE(desk.kept.all().back().name, std::string(name));
        }
    }

    void everyRunHasItsOwnName() {
        Desk desk;
        for (int i = 0; i < 3; ++i) {
            QVERIFY(desk.keep());
        }
        QCOMPARE(desk.kept.all()[0].name, std::string("Run 1"));
        QCOMPARE(desk.kept.all()[2].name, std::string("Run 3"));
        desk.kept.remove(0);
        QCOMPARE(desk.kept.count(), 2);
        QVERIFY(desk.keep()); // "Run 3" is taken
        QCOMPARE(desk.kept.all()[2].name, std::string("Run 4"));
        desk.kept.rename(1, QStringLiteral("  dull \n wheel "));
        QCOMPARE(desk.kept.all()[1].name, std::string("dull wheel"));
        desk.kept.rename(1, QStringLiteral("  "));
        QCOMPARE(desk.kept.all()[1].name, std::string("dull wheel"));
        desk.document.undo();
        QCOMPARE(desk.kept.all()[1].name, std::string("Run 3"));
        QVERIFY(desk.kept.isChosen(1)); // a name is no other run
        desk.kept.choose(1, false);
        desk.kept.rename(1, QStringLiteral("aside"));
        QVERIFY(!desk.kept.isChosen(1));
    }

    void refusedInputsGiveNoRunToKeep() {
        Desk desk;
        Project project = desk.document.project();
        project.wheel->width_mm = -5;
        desk.document.edit(project, editText);
        QVERIFY(desk.kept.keep(*desk.run()) == KeptRuns::Kept::refused);
        QCOMPARE(desk.kept.count(), 0);
    }

    void restoringTakesTheInputsBackAndLeavesTheRuns() {
        Desk desk;
        const std::string first = withoutRuns(desk.document.project());
        QVERIFY(desk.keep());
        desk.setStock(0.2);
        const std::string second = withoutRuns(desk.document.project());
        QVERIFY(desk.keep());
        const std::vector<KeptRun> runs = desk.kept.all();
        QVERIFY(desk.kept.restore(0));
        QCOMPARE(withoutRuns(desk.document.project()), first);
        QVERIFY(desk.kept.all() == runs);
        desk.document.undo(); // one step
        QCOMPARE(withoutRuns(desk.document.project()), second);
        QVERIFY(desk.kept.all() == runs);
    }

    void restoringKeepsWhatWasMeasured() {
        Desk desk;
        QVERIFY(desk.keep());
        Project project = desk.document.project();
        project.measured.emplace().parts.emplace_back().part = "7";
        desk.document.edit(std::move(project), editText);
        desk.setStock(0.2);
        QVERIFY(desk.kept.restore(0));
        const Project& restored = desk.document.project();
        QVERIFY(restored.measured && restored.measured->parts.front().part == "7");
    }

    void aSavedProjectOpensWithItsRunsAndTheNewestIsChosen() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("runs.sparkout"));
        Desk desk;
        QVERIFY(desk.keep());
        desk.setStock(0.2);
        QVERIFY(desk.keep());
        QVERIFY(!desk.document.saveAs(path));
        Desk other;
        QVERIFY(other.document.open(path).opened());
        QVERIFY(other.kept.all() == desk.kept.all());
        QVERIFY(!other.kept.isChosen(0) && other.kept.isChosen(1));
        QVERIFY(other.settled());
        QVERIFY(!other.kept.isChanged(0) && !other.kept.isChanged(1));
    }

    void aRunIsComputedAgainAsideWithItsOwnFeeds() {
        Desk desk;
        QVERIFY(desk.keep());
        const OutcomePtr first = desk.run();
        desk.setStock(0.2);
        QVERIFY(!desk.kept.recalled(0)); // nothing waits for it
        QVERIFY(desk.settled());
        const RecalledRun& recalled = *desk.kept.recalled(0);
        QVERIFY(changedSince({*recalled.summary, {}},
                             summarise(first->result, first->accuracy, first->constraints))
                    .empty());
        QCOMPARE(recalled.feeds->columns.size(), first->feeds.columns.size());
        for (std::size_t j = 0; j < recalled.feeds->columns.size(); ++j) {
            const FeedPoints& now = recalled.feeds->columns[j].strokes;
            const FeedPoints& then = first->feeds.columns[j].strokes;
            QCOMPARE(now.size(), then.size());
            for (std::size_t i = 0; i < now.size(); ++i) {
                QCOMPARE(now[i].end_s, then[i].end_s);
                QCOMPARE(now[i].actualSum_um.mean, then[i].actualSum_um.mean);
            }
        }
        desk.kept.choose(0, false);
        QVERIFY(!desk.kept.recalled(0)->feeds);
        QVERIFY(desk.kept.recalled(0)->summary);
        desk.kept.choose(0, true);
        QVERIFY(desk.settled());
        QVERIFY(desk.kept.recalled(0)->feeds);
    }

    void aRunThatComesOutDifferentlyIsFound() {
        Desk desk;
        QVERIFY(desk.keep());
        QVERIFY(desk.keep());
        Project project = desk.document.project();
        ReadSummary summary = *desk.kept.summary(1);
        summary.summary.zones[0].roundness_um += 0.5;
        project.runs[1] =
            keptRun(desk.run()->result, summary.summary, "older", project.runs[1].when);
        project.runs[1].engine_version = "0.0.1";
        desk.document.startUntitled(project);
        QVERIFY(desk.settled());
        QVERIFY(!desk.kept.isChanged(0));
        QVERIFY(desk.kept.isChanged(1));
    }

    void aRunWhoseSummaryCannotBeReadCountsAsChanged() {
        Desk desk;
        QVERIFY(desk.keep());
        QVERIFY(desk.keep());
        Project project = desk.document.project();
        project.runs[0].summary.text = "[]";
        desk.document.startUntitled(project);
        QVERIFY(!desk.kept.summary(0));
        QVERIFY(desk.settled());
        QVERIFY(desk.kept.isChanged(0));
        QVERIFY(!desk.kept.isChanged(1));
    }

    void inputsThatAreNoneAreToldNotRun() {
        Desk desk;
        Project project = desk.document.project();
        project.runs = {{"broken", "2026-01-01T00:00:00Z", "0.0.1", {"{}"}, {"{}"}}};
        desk.document.startUntitled(project);
        QVERIFY(desk.settled());
        QVERIFY(hasErrors(desk.kept.recalled(0)->issues));
        QVERIFY(!desk.kept.inputs(0));
        QVERIFY(!desk.kept.restore(0));
        QVERIFY(!desk.document.modified());
    }

    void moreThanAFileHoldsIsNotKept() {
        Desk desk;
        QVERIFY(desk.keep());
        Project project = desk.document.project();
        project.runs.resize(1000, project.runs[0]);
        desk.document.startUntitled(project);
        QVERIFY(desk.kept.keep(*desk.run()) == KeptRuns::Kept::full);
        QCOMPARE(desk.kept.count(), 1000);
    }

    void aDocumentClosedWhileRunsAreComputedEndsThem() {
        auto document = std::make_unique<Document>();
        document->startUntitled(newProject(Operation::traverse));
        auto kept = std::make_unique<KeptRuns>(*document);
        for (int i = 0; i < 3; ++i) {
            const OutcomePtr outcome = evaluate(document->project(), {});
            QVERIFY(kept->keep(*outcome) == KeptRuns::Kept::yes);
        }
        document.reset(); // as in the window: the document goes first
        kept.reset();
    }
};

} // namespace sparkout::test_kept_runs

SPARKOUT_TEST(test_kept_runs, TestKeptRuns)
#include "test_kept_runs.moc"
