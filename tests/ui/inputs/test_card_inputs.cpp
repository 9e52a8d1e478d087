// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// What the operation card needs, typed on the page "Part", and the mass that the shaft offers.
#include "core/setup/setup_run.h"
#include "tests/registry.h"
#include "tests/ui/support/catalogue_bench.h"
#include "tests/ui/support/typing.h"
#include "tests/whole_project.h"
#include "ui/form/number_field.h"
#include "ui/report/operation_card_report.h"

#include <QDate>
#include <QLabel>
#include <QLineEdit>

#include <string>

namespace sparkout::test_card_inputs {

using namespace catalogue_bench;

void type(Window& window, const char* path, const QString& text) {
    auto* line = window.on<QLineEdit>(path);
    QVERIFY2(line, path);
    window.bench.window->inputs().pages()[partPage]->showPath(path, true);
    typeOver(*line, text);
    QTest::keyClick(line, Qt::Key_Return);
    window.bench.settle();
}

void giveSteps(Window& window) {
    Project project = window.document().project();
    project.part->shaft.segments = {{100, 30}, {40, 50}};
    window.document().edit(project, {"Input", "Segments of the shaft"});
    window.bench.settle();
}

class TestCardInputs : public QObject {
    Q_OBJECT

private slots:
    void whatIsTypedStandsOnTheCardAndIsUndone() {
        Window window(partPage);
        const CardEntries& entries = *window.document().project().card;
        type(window, "/card/part_number", QStringLiteral("7716-03.021"));
        type(window, "/card/program", QStringLiteral("O1204"));
        type(window, "/card/blank", QStringLiteral("Round bar 50 x 325"));
        type(window, "/card/mass_kg", QStringLiteral("2.25"));
        type(window, "/card/blank_mass_kg", QStringLiteral("4.9"));
        QCOMPARE(entries.program, std::string("O1204"));
        QCOMPARE(entries.mass_kg, 2.25);
        QCOMPARE(entries.blank_mass_kg, 4.9);

        Company company;
        company.part = "another";
        company.designation = "60141.00012";
        const Setup setup = plainSetup(window.document().project());
        const report::CardHead head =
            report::OperationCardReport::head(setup, {}, company, QDate(2026, 11, 26));
        QCOMPARE(head.company.part, std::string("7716-03.021")); // before that of the settings
        QCOMPARE(head.company.designation, company.designation);
        QVERIFY(head.operation.contains(QStringLiteral("2.25")));
        QVERIFY(head.operation.contains(QStringLiteral("4.9")));
        QVERIFY(head.operation.contains(QStringLiteral("Round bar 50 x 325")));
        QVERIFY(head.equipment.contains(QStringLiteral("O1204")));

        for (int edits = 0; edits < 5; ++edits) {
            window.document().undo();
        }
        QVERIFY(entries.part_number.empty() && entries.program.empty() && entries.blank.empty());
        QVERIFY(!entries.mass_kg && !entries.blank_mass_kg);
    }

    void aShaftWithStepsOffersItsMass() {
        Window window(partPage);
        auto* note = window.on<QLabel>("massNote");
        auto* take = window.on<QPushButton>("takeMass");
        QVERIFY(note && take);
        QVERIFY(!take->isVisible()); // it has none
        giveSteps(window);
        window.bench.window->inputs().pages()[partPage]->showPath("/card/mass_kg", true);
        window.bench.settle();
        QVERIFY(take->isVisible());
        QVERIFY2(note->text().contains(QStringLiteral("1.17 kg")), qPrintable(note->text()));
        QVERIFY(note->text().contains(QStringLiteral("estimate")));
        QTest::mouseClick(take, Qt::LeftButton);
        window.bench.settle();
        QCOMPARE(window.document().project().card->mass_kg, 1.17);
        QVERIFY(!take->isVisible());
        window.document().undo();
        window.bench.settle();
        QVERIFY(!window.document().project().card->mass_kg);
        QVERIFY(take->isVisible());
    }

    /// The steps are not those of a sleeve.
    void aBoreOffersNone() {
        Window window(partPage);
        giveSteps(window);
        Project project = window.document().project();
        project.part->surface = Surface::internal;
        window.document().edit(project, {"Input", "Surface"});
        window.bench.settle();
        QVERIFY(!window.on<QPushButton>("takeMass")->isVisible());
    }
};

} // namespace sparkout::test_card_inputs

SPARKOUT_TEST(test_card_inputs, TestCardInputs)
#include "test_card_inputs.moc"
