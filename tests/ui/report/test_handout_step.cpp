// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The step that the course hand-out works out: how it is wished for, found, and asked by the
// dialog.
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "tests/ui/support/report_reading.h"
#include "ui/report/exercises.h"
#include "ui/report/format/pages.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/settings.h"
#include "ui/window/dialogs/handout_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

#include <algorithm>
#include <set>

namespace sparkout::test_handout_step {

using namespace handout_bench;

class TestHandoutStep : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void aStepIsReadFromWords_data() {
        addColumns<QString, bool>("words", "good");
        for (const char* good : {"12", "12,nz,z1,e1,r1,k9", "rz2", " k0 , RZ1", "s0,3"}) {
            QTest::newRow(good) << QString::fromLatin1(good) << true;
        }
        for (const char* bad :
             {"", "12,,k1", "12,13", "nz,rz1", "q3", "k-1", "k", "z1.5", "e1 2"}) {
            QTest::newRow(bad) << QString::fromLatin1(bad) << false;
        }
    }

    void aStepIsReadFromWords() {
        QFETCH(QString, words);
        QFETCH(bool, good);
        QCOMPARE(report::readStepWish(words).has_value(), good);
    }

    void ofTheStepsThatFitTheDeepestCutIsTaken() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const Trajectory& trajectory = outcome->trajectory;
        const auto step =
            report::findStep(trajectory, *report::readStepWish(QStringLiteral("rz1,z2,e5")));
        QVERIFY(step);
        double deepest = 0;
        for (const Pass& pass : trajectory.passes) {
            for (int k = 0; k < trajectory.radii; ++k) {
                const double a =
                    trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)].actual_mm;
                const Place& at = pass.place;
                if (at.zone == Zone::rz1 && at.stage == 2 && at.step == Step::e5) {
                    deepest = std::max(deepest, a);
                }
            }
        }
        QVERIFY(deepest > 0);
        QCOMPARE(visitAt(trajectory, *step)->actual_mm, deepest);
        QVERIFY(!report::findStep(trajectory, *report::readStepWish(QStringLiteral("99999"))));
        QVERIFY(!report::findStep(trajectory, *report::readStepWish(QStringLiteral("s1"))));
    }

    void twoCyclesAreComparedInTheNearestStrokeThatBothHave() {
        const auto cycleOf = [](std::initializer_list<int> counts) {
            Trajectory trajectory;
            for (const int count : counts) {
                Pass pass;
                pass.place.zone = Zone::nz;
                pass.place.stage = 1;
                pass.place.cycleCount = count;
                trajectory.passes.push_back(pass);
            }
            return trajectory;
        };
        const Trajectory one = cycleOf({2, 5, 8, 9, 20}), other = cycleOf({2, 5, 8, 20, 21});
        const auto shared = [&](int count) {
            Place place = one.passes.front().place;
            place.cycleCount = count;
            const std::optional<Place> found = sharedPlace(one, other, place);
            return found ? found->cycleCount : -1;
        };
        QCOMPARE(shared(9), 8); // the other cycle has none
        QCOMPARE(shared(8), 8);
        QCOMPARE(shared(2), 2);
        QCOMPARE(shared(30), 20); // 21 is of the other alone
        Place elsewhere = one.passes.front().place;
        elsewhere.stage = 2;
        QVERIFY(!sharedPlace(one, other, elsewhere));
    }

    void theDialogOffersTheStepTheCycleStandsAt() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        CycleCursor cursor;
        cursor.setOutcome(outcome);
        Settings settings = Settings::transient();
        {
            HandoutDialog dialog(outcome, cursor, settings, nullptr);
            const report::StepWish wish = dialog.options().step;
            QCOMPARE(wish.stage, std::optional(1)); // at the end nobody has chosen
            QVERIFY(!wish.count && dialog.options().answers);
            QCOMPARE(dialog.options().views, HandoutOptions().views);
        }
        cursor.toStroke(4);
        cursor.step(CursorUnit::radius, -3);
        HandoutDialog dialog(outcome, cursor, settings, nullptr);
        const auto step = report::findStep(outcome->trajectory, dialog.options().step);
        QVERIFY(step);
        QCOMPARE(step->radius, cursor.radius());
        QCOMPARE(step->pass, cursor.progress().open);
        dialog.findChild<QCheckBox*>(QStringLiteral("view-cycle"))->click();
        dialog.findChild<QCheckBox*>(QStringLiteral("handoutAnswers"))->click();
        dialog.findChild<QPushButton*>(QStringLiteral("makeHandout"))->click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const HandoutDialog again(outcome, cursor, settings, nullptr);
        QCOMPARE(again.options().views, (std::set{HandoutView::feeds, HandoutView::profiles}));
        QVERIFY(!again.options().answers);
    }

    void aCycleThatWasNotRecordedHasNoStepButQuestions() {
        auto outcome = std::make_shared<Outcome>(*fixtures::run(fixtures::traverseProject()));
        outcome->trajectory = {};
        outcome->feeds = {};
        outcome->limits = {};
        const Report made = handout(outcome);
        QVERIFY(formulasOf(made).empty());
        const QString text = reading::textOfHtml(bytesOf(made, Format::html));
        QVERIFY(text.contains(QStringLiteral("too long to be recorded")));
        QVERIFY(text.contains(QStringLiteral("Questions")));
        CycleCursor cursor;
        Settings settings = Settings::transient();
        HandoutDialog dialog(outcome, cursor, settings, nullptr);
        QVERIFY(!dialog.findChild<QComboBox*>(QStringLiteral("handoutStep"))->isEnabled());
    }

private:
    Language m_language;
};

} // namespace sparkout::test_handout_step

SPARKOUT_TEST(test_handout_step, TestHandoutStep)
#include "test_handout_step.moc"
