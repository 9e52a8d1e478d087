// SPDX-License-Identifier: GPL-3.0-or-later
// Switching the operation and back.
#include "core/study/new_project.h"
#include "core/study/operation.h"
#include "core/study/outcome.h"
#include "tests/ui/support/untitled.h"
#include "tests/whole_project.h"
#include "ui/text/field_text.h"
#include "ui/text/texts.h"

#include "core/file/project_file.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/search/grid.h"
#include "core/search/optimise.h"
#include "core/simulation/simulate.h"

#include "tests/registry.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace sparkout::test_operation_return {

/// What the operation field does.
void switchTo(Document& document, Operation operation) {
    document.edit(withOperation(document.project(), operation, document.lastWith(operation)), {});
}

Operation other(Operation operation) {
    return operation == Operation::plunge ? Operation::traverse : Operation::plunge;
}

/// Whether all that is refused is a length that the wheel cannot traverse.
bool tooShort(const Project& project) {
    Issues errors = validate(project);
    std::erase_if(errors, [](const Issue& issue) { return issue.severity != Severity::error; });
    return !errors.empty() && std::ranges::all_of(errors, [](const Issue& issue) {
        return issue.code == IssueCode::zoneTooShort;
    });
}

class TestOperationReturn : public QObject {
    Q_OBJECT

private slots:
    void theSearchRunsAfterTheSwitch_data() { thereAndBackIsTheProjectItWas_data(); }
    /// Levels of the new operation's feeds within the machine's range, and a search that answers.
    void theSearchRunsAfterTheSwitch() {
        QFETCH(QString, file);
        Document document;
        QVERIFY(document.open(file).opened());
        const Project before = document.project();
        switchTo(document, other(before.operation));
        Project project = document.project();
        if (!before.optimisation) {
            QVERIFY(!project.optimisation); // *Optimise* makes a usual one
            return;
        }
        const bool traverse = project.operation == Operation::traverse;
        const MachineLimits& limits = project.machine->limits;
        const auto within = [](const Levels& levels, const auto& range) {
            const std::vector<double> values = levelValues(levels);
            return !values.empty()
                   && (!range || std::ranges::all_of(values, [&range](double value) {
                          return value >= (*range)[0] * (1 - 1e-9)
                                 && value <= (*range)[1] * (1 + 1e-9);
                      }));
        };
        const Optimisation& asked = *project.optimisation;
        if (traverse) {
            QVERIFY(within(asked.radial_feed_mm, limits.radial_feed_mm));
            QVERIFY(within(asked.axial_feed_mm_min, limits.axial_feed_mm_min));
        } else {
            QVERIFY(within(asked.radial_feed_mm_min, limits.plunge_feed_mm_min));
        }
        if (tooShort(project)) {
            return; // the wheel stays, and with it nothing can be ground
        }
        QVERIFY(Variants(project).fault() == GridFault::none);
        QCOMPARE(asked.stock_step_mm, before.optimisation->stock_step_mm);
        if (!file.contains(QStringLiteral("/examples/"))) {
            return; // parts that nobody grinds
        }
        if (project.part->profile != ProfileForm::measured) {
            project.part->radii_per_section = 4; // in a moment
        }
        const SearchSummary found = optimise(project);
        QVERIFY(found.status == (found.best ? SearchStatus::proved : SearchStatus::infeasible));
        QVERIFY(found.evaluations > 0);
        if (found.best) {
            const Project best = withBest(project, found);
            const auto all = evaluateConstraints(simulate(best));
            QVERIFY(std::ranges::all_of(all, &ConstraintResult::holds));
        }
        qInfo("%s: %s", qPrintable(QFileInfo(file).baseName()),
              found.best ? "found" : "nothing feasible");
    }

    void thereAndBackIsTheProjectItWas_data() {
        QTest::addColumn<QString>("file");
        for (const char* folder : {"/resources/examples", "/tests/data/projects"}) {
            const QDir dir(QStringLiteral(SPARKOUT_SOURCE_DIR) + QString::fromLatin1(folder));
            for (const QString& name : dir.entryList({QStringLiteral("*.sparkout")})) {
                QTest::newRow(qPrintable(name)) << dir.filePath(name);
            }
        }
    }
    void thereAndBackIsTheProjectItWas() {
        QFETCH(QString, file);
        Document document;
        QVERIFY(document.open(file).opened());
        const std::string before = writeProject(document.project());
        const Operation own = document.project().operation;
        switchTo(document, other(own));
        QVERIFY(writeProject(document.project()) != before);
        switchTo(document, own);
        QCOMPARE(writeProject(document.project()), before);
        switchTo(document, other(own)); // and the other way round
        const std::string there = writeProject(document.project());
        switchTo(document, own);
        switchTo(document, other(own));
        QCOMPARE(writeProject(document.project()), there);
    }

    // A shaft longer than the wheel: nobody mounts another wheel for a plunge.
    void aPlungeKeepsTheWheelAndGrindsWhatItCovers() {
        Document document;
        Project shaft = newProject(Operation::traverse);
        shaft.part->length_mm = 300;
        shaft.machine->compliance_mm_per_n = ZoneCompliance{1e-4, 2e-4, 1e-4};
        document.startUntitled(shaft);
        switchTo(document, Operation::plunge);
        const Project& now = document.project();
        QCOMPARE(now.wheel->width_mm, shaft.wheel->width_mm);
        QCOMPARE(now.part->length_mm, shaft.wheel->width_mm);
        QVERIFY(!hasErrors(validate(now)));
        // the sections stand at the headstock's end of the length, where the zone is stiff
        const auto& sections = std::get<std::vector<double>>(now.machine->compliance_mm_per_n);
        const double share = shaft.wheel->width_mm / 300;
        QVERIFY(sections.front() > 1e-4 && sections.back() < 1e-4 + 2e-4 * share);
        const QStringList changes = changesOfOperation(shaft, now);
        QCOMPARE(changes.size(), 3); // and the compliance and the least steps
        QVERIFY2(changes[0].contains(QStringLiteral("300\u00a0mm → ")), qPrintable(changes[0]));
        switchTo(document, Operation::traverse);
        QCOMPARE(document.project().part->length_mm, 300.0);
        QCOMPARE(writeProject(document.project()), writeProject(shaft));
        QVERIFY(changesOfOperation(shaft, document.project()).isEmpty());
    }

    void allItChangesOutsideTheStagesIsTold_data() { thereAndBackIsTheProjectItWas_data(); }
    void allItChangesOutsideTheStagesIsTold() {
        QFETCH(QString, file);
        Document document;
        QVERIFY(document.open(file).opened());
        const Project before = document.project();
        const Project after = withOperation(before, other(before.operation));
        const auto lines = changesOfOperation(before, after);
        Project told = before;
        told.operation = after.operation;
        told.cycle = after.cycle;
        int count = 0;
        const auto take = [&count](auto& member, const auto& now) {
            count += member != now ? 1 : 0;
            member = now;
        };
        take(told.part->length_mm, after.part->length_mm);
        take(told.machine->overrun_entry_mm, after.machine->overrun_entry_mm);
        take(told.machine->overrun_exit_mm, after.machine->overrun_exit_mm);
        take(told.machine->compliance_mm_per_n, after.machine->compliance_mm_per_n);
        take(told.gauge->section, after.gauge->section);
        take(told.gauge->position_mm, after.gauge->position_mm);
        take(told.gauge->compliance_mm_per_n, after.gauge->compliance_mm_per_n);
        take(told.least_steps, after.least_steps);
        take(told.part->zone_stock_mm, after.part->zone_stock_mm);
        take(told.part->zone_runout_mm, after.part->zone_runout_mm);
        take(told.machine->zone_compliance, after.machine->zone_compliance);
        if (told.machine->form) {
            take(told.machine->form->roundness_um, after.machine->form->roundness_um);
            take(told.machine->form->runout_um, after.machine->form->runout_um);
        }
        if (told.batch) {
            take(told.batch->zone_stock_mm, after.batch->zone_stock_mm);
            take(told.batch->zone_runout_mm, after.batch->zone_runout_mm);
            take(told.batch->zone_compliance, after.batch->zone_compliance);
        }
        count +=
            std::ranges::any_of(before.cycle->stages,
                                [&after](const Stage& stage) {
                                    return after.operation->travels && !stage.axial_feed_mm_min;
                                })
                ? 1
                : 0;
        told.optimisation = after.optimisation; // levels for the new feeds, as the stages have them
        QVERIFY2(lines.size() == count, qPrintable(lines.join(u'\n')));
        QCOMPARE(writeProject(told), writeProject(after));
        for (const QString& line : lines) { // of both values something is said
            QVERIFY2(!line.contains(QStringLiteral(":  →")) && !line.endsWith(u' '),
                     qPrintable(line));
        }
    }

    void axialFeedsThatATraverseSetsAreTold() {
        const Project plunge = newProject(Operation::plunge);
        const Project traverse = withOperation(plunge, Operation::traverse);
        const QStringList lines = changesOfOperation(plunge, traverse);
        QVERIFY2(lines.contains(
                     QStringLiteral("Axial feed: not used → 1800\u00a0mm/min, 300\u00a0mm/min")),
                 qPrintable(lines.join(u'\n')));
        QVERIFY(!changesOfOperation(traverse, withOperation(traverse, Operation::plunge))
                     .join(u'\n')
                     .contains(QStringLiteral("Axial feed")));
    }

    void aNewProjectHoldsItsDrawingInAFewMinutes() {
        for (const Operation operation : {Operation::traverse, Operation::plunge}) {
            const OutcomePtr outcome = evaluate(newProject(operation), {});
            QVERIFY(outcome->ran());
            for (const ConstraintResult& c : outcome->constraints) {
                QVERIFY2(c.holds, requirementOf(c.kind).key);
            }
            QVERIFY2(outcome->result.time_s < 400,
                     qPrintable(QString::number(outcome->result.time_s)));
        }
    }

    // Usually 2 double strokes or 3 revolutions; a number of one's own stays, and comes back.
    void theUsualLeastStepsAreThoseOfTheOperation() {
        QCOMPARE(newProject(Operation::traverse).least_steps, 2);
        QCOMPARE(newProject(Operation::plunge).least_steps, 3);
        for (const int own : {2, 3, 5}) {
            Document document;
            Project project = newProject(Operation::traverse);
            project.least_steps = own;
            document.startUntitled(project);
            switchTo(document, Operation::plunge);
            QCOMPARE(document.project().least_steps, own == 2 ? 3 : own);
            QCOMPARE(document.project().least_overlap, project.least_overlap);
            switchTo(document, Operation::traverse);
            QCOMPARE(document.project().least_steps, own);
        }
        Document document;
        Project project = newProject(Operation::plunge);
        project.least_steps.reset();
        document.startUntitled(project);
        switchTo(document, Operation::traverse);
        QVERIFY(!document.project().least_steps);
    }

    void whatWasChangedMeanwhileStaysAndTheRestComesBack() {
        Untitled document(newProject(Operation::traverse));
        const Project before = document.project();
        switchTo(document, Operation::plunge);
        Project changed = document.project();
        changed.wheel->dullness = 0.2;
        changed.cycle->stages[0].stock_mm = 0.09;
        changed.cycle->stages[0].radial_feed_mm_min = 1.7;
        document.edit(changed, {});
        switchTo(document, Operation::traverse);
        const Project& now = document.project();
        QCOMPARE(now.wheel->dullness, 0.2);
        QCOMPARE(now.cycle->stages[0].stock_mm, 0.09);
        QCOMPARE(now.cycle->stages[0].radial_feed_mm, before.cycle->stages[0].radial_feed_mm);
        QCOMPARE(now.cycle->stages[0].axial_feed_mm_min, before.cycle->stages[0].axial_feed_mm_min);
        QVERIFY(now.machine->compliance_mm_per_n == before.machine->compliance_mm_per_n);
        switchTo(document, Operation::plunge);
        QCOMPARE(document.project().cycle->stages[0].radial_feed_mm_min.value(), 1.7);
    }

    void aComplianceEnteredMeanwhileIsCarriedOver() {
        Untitled document(newProject(Operation::traverse));
        switchTo(document, Operation::plunge);
        Project stiff = document.project();
        for (double& value : std::get<std::vector<double>>(stiff.machine->compliance_mm_per_n)) {
            value = 5e-5;
        }
        document.edit(stiff, {});
        switchTo(document, Operation::traverse);
        const auto zones =
            std::get<ZoneCompliance>(document.project().machine->compliance_mm_per_n);
        QCOMPARE(zones, (ZoneCompliance{5e-5, 5e-5, 5e-5}));
    }

    void aLongerPartMeanwhileStillLeavesAProjectThatRuns() {
        Untitled document(newProject(Operation::plunge));
        switchTo(document, Operation::traverse);
        Project longer = document.project();
        longer.part->length_mm = 300;
        document.edit(longer, {});
        switchTo(document, Operation::plunge);
        QVERIFY(!hasErrors(validate(document.project())));
        Project shorter = document.project();
        shorter.part->length_mm = 8;
        document.edit(shorter, {});
        const double width = shorter.wheel->width_mm;
        switchTo(document, Operation::traverse);
        QVERIFY(tooShort(document.project()));
        QCOMPARE(document.project().wheel->width_mm, width);
    }

    // A traverse takes no other wheel: longer overruns where they do, else a refusal that names
    // wheels which would.
    void aTraverseKeepsTheWheel() {
        Project plunge = newProject(Operation::plunge);
        plunge.wheel->width_mm = 40;
        for (const auto& [length, isPossible] :
             {std::pair(40.0, false), std::pair(39.0, false), std::pair(12.0, false)}) {
            plunge.part->length_mm = length;
            const Project made = withOperation(plunge, Operation::traverse);
            QCOMPARE(made.wheel->width_mm, 40.0);
            QCOMPARE(!tooShort(made), isPossible);
        }
        Project back = withOperation(plunge, Operation::traverse);
        back.part->length_mm = 50; // as long as neither is possible with this wheel and overruns
        back = fitted(back, Operation::traverse);
        QVERIFY(!hasErrors(validate(back)));
        QCOMPARE(back.machine->overrun_entry_mm, 20.0);
        back.part->length_mm = 39;
        const Issues refused = validate(back);
        const auto found = std::ranges::find(refused, IssueCode::zoneTooShort, &Issue::code);
        QVERIFY(found != refused.end());
        const QString text = issueText(*found);
        QVERIFY2(text.contains(QStringLiteral("to plunge 40, 50, 63")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("to traverse 25 mm")), qPrintable(text));
    }

    void aStageAddedMeanwhileLeavesTheOthersTheirFeeds() {
        Untitled document(newProject(Operation::traverse));
        const auto before = document.project().cycle->stages;
        switchTo(document, Operation::plunge);
        Project more = document.project();
        Stage added = more.cycle->stages[0];
        added.radial_feed_mm_min = 0.9;
        more.cycle->stages.insert(more.cycle->stages.begin(), added);
        document.edit(more, {});
        switchTo(document, Operation::traverse);
        const auto& now = document.project().cycle->stages;
        QCOMPARE(now.size(), 3u);
        QVERIFY(now[0].radial_feed_mm && now[0].axial_feed_mm_min);
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(now[i + 1].radial_feed_mm, before[i].radial_feed_mm);
            QCOMPARE(now[i + 1].axial_feed_mm_min, before[i].axial_feed_mm_min);
        }
    }

    void nothingIsRememberedOfAnotherDocument() {
        Untitled document(newProject(Operation::traverse));
        switchTo(document, Operation::plunge);
        document.startUntitled(newProject(Operation::plunge));
        QVERIFY(!document.lastWith(Operation::traverse));
    }
};

} // namespace sparkout::test_operation_return

SPARKOUT_TEST(test_operation_return, TestOperationReturn)
#include "test_operation_return.moc"
