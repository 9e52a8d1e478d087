// SPDX-License-Identifier: GPL-3.0-or-later
// Which inputs rest on a calibration: those that still have the value that was found.
#include "core/measured/calibrated_inputs.h"
#include "tests/whole_project.h"

#include "core/measured/calibration.h"
#include "core/project/member.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_calibrated_inputs {

void record(Project& project, const char* path, double value) {
    Calibration calibration;
    calibration.input = path;
    calibration.value = value;
    calibration.data = "trace.csv";
    recordCalibration(project, calibration);
}

const Field& inputAt(const Project& project, const char* path) {
    return *findMember(project, path).field;
}

class TestCalibratedInputs : public QObject {
    Q_OBJECT

private slots:
    void anotherValueIsNotTheCalibratedOne() {
        Project project = samples::project("smallest-plunge");
        const Field& dullness = inputAt(project, "/wheel/dullness");
        QVERIFY(!calibrationOf(project, "/wheel/dullness"));
        QVERIFY(!isCalibrated(project, dullness));
        project.wheel->dullness = 0.0123;
        record(project, "/wheel/dullness", 0.0123);
        QVERIFY(calibrationOf(project, "/wheel/dullness"));
        QVERIFY(isCalibrated(project, dullness));
        project.wheel->dullness = 0.0124;
        QVERIFY(calibrationOf(project, "/wheel/dullness")); // the record stays
        QVERIFY(!isCalibrated(project, dullness));
        project.wheel->dullness = 0.0123;
        QVERIFY(isCalibrated(project, dullness));
    }

    void aComplianceIsCalibratedInAllPlaces() {
        Project project = samples::project("smallest-plunge");
        project.sections = 2;
        project.machine->compliance_mm_per_n = std::vector<double>{1e-4, 2e-4};
        const Field& compliance = inputAt(project, "/machine/compliance_mm_per_n");
        record(project, "/machine/compliance_mm_per_n/0", 1e-4);
        record(project, "/machine/compliance_mm_per_n/1", 2e-4);
        QVERIFY(isCalibrated(project, compliance));
        project.machine->compliance_mm_per_n = std::vector<double>{1e-4, 3e-4};
        QVERIFY(!isCalibrated(project, compliance));
    }

    void aComputedComplianceRestsOnWhatItIsComputedFrom() {
        Project project = samples::project("stiffness-traverse");
        const Field& compliance = inputAt(project, "/machine/compliance_mm_per_n");
        QVERIFY(!isCalibrated(project, compliance));
        record(project, "/machine/stiffness_n_um/headstock",
               project.machine->stiffness_n_um->headstock);
        record(project, "/part/shaft/youngs_modulus_gpa", project.part->shaft.youngs_modulus_gpa);
        QVERIFY(isCalibrated(project, compliance));
        project.machine->stiffness_n_um->headstock *= 1.1;
        QVERIFY(!isCalibrated(project, compliance));
    }

    void anInputThatIsGoneIsNotCalibrated() {
        Project project = samples::project("smallest-plunge");
        record(project, "/machine/compliance_mm_per_n/7", 1e-4);
        QVERIFY(!hasCalibratedValue(project, project.measured->calibrations.front()));
    }
};

} // namespace sparkout::test_calibrated_inputs

SPARKOUT_TEST(test_calibrated_inputs, TestCalibratedInputs)
#include "test_calibrated_inputs.moc"
