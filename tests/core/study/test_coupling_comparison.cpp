// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The same cycle with coupled and with independent sections [MODEL-6].
#include "core/study/gauge_placement.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

namespace sparkout::test_coupling_comparison {

Project onShaft(int sections) {
    Project p = fixtures::plunge();
    fixtures::putOnSlenderShaft(p);
    p.sections = sections;
    return p;
}

double largest(const CouplingComparison& both) {
    double most = 0;
    for (const double difference : both.differences_mm) {
        most = std::max(most, std::abs(difference));
    }
    return most;
}

class TestCouplingComparison : public QObject {
    Q_OBJECT

private slots:
    /// In a bore G is the same number everywhere: with one section it is its diagonal, and equal
    /// sections together give what each gives under the force of the whole width.
    void whereGIsItsDiagonalThereIsNoDifference() {
        for (const int sections : {1, 4}) {
            Project bore = samples::project("internal-plunge");
            bore.machine->compliance_mm_per_n = std::monostate{};
            bore.sections = sections;
            bore.gauge->section.reset();
            QVERIFY(couplingOf(bore) == CouplingAnswer::comparable);
            const CouplingComparison both = compareCoupling(bore);
            QVERIFY(both.coupled.status == RunStatus::completed);
            QCOMPARE(both.differences_mm.size(), static_cast<std::size_t>(sections));
            QVERIFY2(largest(both) < 1e-9, qPrintable(QString::number(largest(both))));
        }
    }

    void theTwoAreTheEnginesOwnRuns() {
        for (const bool coupled : {false, true}) {
            Project project = onShaft(5);
            project.sections_coupled = coupled; // what it says does not matter
            const CouplingComparison both = compareCoupling(project);
            const SimulationResult run = simulateUnchecked(project);
            const SimulationResult& same = coupled ? both.coupled : both.independent;
            QCOMPARE(same.time_s, run.time_s);
            for (std::size_t i = 0; i < run.sections.size(); ++i) {
                QVERIFY(same.sections[i].radii_mm == run.sections[i].radii_mm);
                const double difference =
                    meanDiameterDeviation(both.coupled.sections[i], *project.part)
                    - meanDiameterDeviation(both.independent.sections[i], *project.part);
                QCOMPARE(both.differences_mm[i], difference);
            }
        }
    }

    void onASlenderShaftTheyDiffer() {
        QVERIFY(largest(compareCoupling(onShaft(5))) > 1e-6); // a thousand times the above
    }

    void whatCannotBeComparedIsTold() {
        Project project = onShaft(3);
        project.operation = Operation::traverse;
        QVERIFY(couplingOf(project) == CouplingAnswer::traverse);
        project.operation = Operation::plunge;
        project.machine->compliance_mm_per_n = std::vector<double>(3, 1e-5);
        QVERIFY(couplingOf(project) == CouplingAnswer::givenCompliance);
    }

    void aStopRequestEndsIt() {
        const StoppedSource stop;
        QVERIFY(compareCoupling(onShaft(5), stop.get_token()).stopped());
    }
};

} // namespace sparkout::test_coupling_comparison

SPARKOUT_TEST(test_coupling_comparison, TestCouplingComparison)
#include "test_coupling_comparison.moc"
