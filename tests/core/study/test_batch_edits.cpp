// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of a batch that move along with the inputs that they replace.
#include "core/study/batch_edits.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

#include <vector>

namespace sparkout::test_batch_edits {

using Values = std::vector<double>;
using Kinds = std::vector<FactorKind>;

/// A shaft whose stock of 0.15 mm and other inputs scatter.
Project shaft() {
    return fixtures::shaftBatch(50);
}

const Factor& stockLaw(const Project& project) {
    return *project.batch->factors.stock_mm;
}

/// The project with another stock, as an edit leads to it from the project before.
Project withStockEdited(const Project& before, double stock_mm) {
    Project changed = before;
    changed.part->stock_mm = stock_mm;
    (void)moveLaws(changed, before, before);
    return changed;
}

class TestBatchEdits : public QObject {
    Q_OBJECT

private slots:
    void stockLawKeepsItsDistanceAndOthersTheirRatio() {
        const Project before = shaft();
        Project after = before;
        after.part->stock_mm = 0.2;
        after.wheel->dullness *= 2;
        QCOMPARE(moveLaws(after, before, before), (Kinds{FactorKind::stock, FactorKind::dullness}));
        QCOMPARE(*stockLaw(after).uniform, (Values{0.18, 0.22}));
        QCOMPARE(*after.batch->factors.dullness->uniform, (Values{0.03, 0.06}));
        QCOMPARE(*after.batch->factors.initial_runout_mm->uniform, (Values{0.01, 0.03}));
    }

    void lawAsideFromTheInputStaysAside() {
        Project before = shaft();
        Factor law = fixtures::normal(0.16, 0.005);
        law.within = Values{0.15, 0.18};
        before.batch->factors.stock_mm = law;
        const Factor moved = stockLaw(withStockEdited(before, 0.2));
        QCOMPARE(*moved.normal, (Values{0.21, 0.005}));
        QCOMPARE(*moved.within, (Values{0.2, 0.23}));
    }

    void everyFormMoves() {
        Project before = shaft();
        before.batch->factors.stock_mm = fixtures::triangular(0.12, 0.15, 0.17);
        QCOMPARE(*stockLaw(withStockEdited(before, 0.1)).triangular, (Values{0.07, 0.1, 0.12}));
        before.batch->factors.stock_mm = fixtures::measured({0.16, 0.14, 0.15});
        QCOMPARE(*stockLaw(withStockEdited(before, 0.1)).measured, (Values{0.11, 0.09, 0.1}));
    }

    void temperatureOfThePartShifts() {
        Project before = shaft();
        before.batch->factors.part_warmer_k = fixtures::normal(0, 2);
        Project after = before;
        after.gauge->part_warmer_k = 3;
        QCOMPARE(moveLaws(after, before, before), Kinds{FactorKind::partWarmer});
        QCOMPARE(*after.batch->factors.part_warmer_k->normal, (Values{3, 2}));
    }

    void stockThatWouldBeNegativeKeepsItsRatio() {
        QCOMPARE(*stockLaw(withStockEdited(shaft(), 0.015)).uniform, (Values{0.013, 0.017}));
    }

    void lawThatTheEditChangesStays() {
        const Project before = shaft();
        Project after = before;
        after.part->stock_mm = 0.2;
        after.batch->factors.stock_mm = fixtures::uniform(0.1, 0.3);
        QVERIFY(moveLaws(after, before, before).empty());
        QCOMPARE(*stockLaw(after).uniform, (Values{0.1, 0.3}));
    }

    void lawWhoseValuesWouldBeRefusedStays() {
        const Project before = shaft();
        Project after = before;
        after.wheel->dullness = 0.9; // 1.5 times that is not allowed
        QVERIFY(moveLaws(after, before, before).empty());
        QCOMPARE(*after.batch->factors.dullness->uniform, (Values{0.015, 0.03}));
    }

    void factorThatMultipliesItsInputStays() {
        Project before = shaft();
        before.batch->factors.compliance = fixtures::uniform(0.9, 1.1);
        Project after = before;
        after.machine->compliance_mm_per_n = ZoneCompliance{1e-4, 1e-4, 1e-4};
        QVERIFY(moveLaws(after, before, before).empty());
        QCOMPARE(*after.batch->factors.compliance->uniform, (Values{0.9, 1.1}));
    }

    /// Of edits that are joined, the law moves from the first input to the last.
    void joinedEditsMoveTheLawOnce() {
        const Project base = shaft();
        const Project present = withStockEdited(base, 0.002); // typed on the way
        Project changed = present;
        changed.part->stock_mm = 0.25;
        QCOMPARE(moveLaws(changed, present, base), Kinds{FactorKind::stock});
        QCOMPARE(*stockLaw(changed).uniform, (Values{0.23, 0.27}));
        changed = present;
        changed.part->stock_mm = base.part->stock_mm;
        QCOMPARE(moveLaws(changed, present, base), Kinds{FactorKind::stock});
        QCOMPARE(*stockLaw(changed).uniform, *stockLaw(base).uniform);
    }
};

} // namespace sparkout::test_batch_edits

SPARKOUT_TEST(test_batch_edits, TestBatchEdits)
#include "test_batch_edits.moc"
