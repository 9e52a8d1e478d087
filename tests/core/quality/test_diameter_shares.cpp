// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/diameter_shares.h"

#include "core/project/validate.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_diameter_shares {

/// Radii of some 15 mm differ by their last bits: 2·15 mm·ε in µm, a few times.
constexpr double rounding_um = 8 * 30 * fixtures::epsilon * 1e3;

class TestDiameterShares : public QObject {
    Q_OBJECT

private slots:
    void sharesAddUpInEveryExample() {
        int sections = 0;
        for (const std::string& name : samples::names()) {
            const Project project = samples::project(name);
            if (hasErrors(validate(project))) {
                continue;
            }
            const SimulationResult result = simulateUnchecked(project);
            for (std::size_t i = 0; i < result.sections.size(); ++i) {
                const SectionResult& section = result.sections[i];
                const double scale = std::max(1.0, project.part->diameter_mm / 30);
                const DiameterShares low = diameterShares(result, i, DiameterEnd::smallest);
                const DiameterShares high = diameterShares(result, i, DiameterEnd::largest);
                QVERIFY(std::abs(low.deviation_um() - section.diameterDeviationMin_mm * 1e3)
                        <= rounding_um * scale);
                QVERIFY(std::abs(high.deviation_um() - section.diameterDeviationMax_mm * 1e3)
                        <= rounding_um * scale);
                QVERIFY(low.form_um <= rounding_um * scale && high.form_um >= -rounding_um * scale);
                QCOMPARE(low.section_um, high.section_um);
                ++sections;
            }
        }
        QVERIFY(sections >= 10);
    }

    void sectionsOfOneComplianceAreWhereTheGaugeReadsTheirMean() {
        Project project = fixtures::plunge();
        project.gauge->rule = GaugeRule::mean;
        project.sections = 3;
        project.machine->compliance_mm_per_n = std::vector<double>{2e-5, 2e-5, 2e-5};
        project.gauge->section = 1;
        const SimulationResult result = simulateUnchecked(project);
        QCOMPARE(result.status, RunStatus::completed);
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            const DiameterShares shares = diameterShares(result, i, DiameterEnd::largest);
            QVERIFY(std::abs(shares.section_um) <= rounding_um);
            QCOMPARE(shares.complianceRatio, 1.0);
        }
    }

    void aMoreCompliantSectionStaysLarger() {
        Project project = fixtures::plunge();
        project.sections = 2;
        project.machine->compliance_mm_per_n = std::vector<double>{2e-5, 4e-5};
        project.gauge->section = 0;
        const SimulationResult result = simulateUnchecked(project);
        const DiameterShares shares = diameterShares(result, 1, DiameterEnd::largest);
        QCOMPARE(shares.complianceRatio, 2.0);
        QVERIFY(shares.section_um > 0.1);
    }
};

} // namespace sparkout::test_diameter_shares

SPARKOUT_TEST(test_diameter_shares, TestDiameterShares)
#include "test_diameter_shares.moc"
