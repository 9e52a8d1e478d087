// SPDX-License-Identifier: GPL-3.0-or-later
// Wheel markings and tolerance classes as a user types them on the pages of the inputs.
#include "tests/registry.h"
#include "tests/ui/support/catalogue_bench.h"
#include "tests/ui/support/typing.h"
#include "tests/whole_project.h"
#include "ui/text/designation_text.h"
#include "ui/text/hint_text.h"

#include <QLabel>
#include <QLineEdit>

#include <utility>

namespace sparkout::test_marking_fields {

using namespace catalogue_bench;

class TestMarkingFields : public QObject {
    Q_OBJECT

private slots:
    void aMarkingIsExplainedAndFillsWhatItSays() {
        Window window(wheelPage);
        auto* line = window.on<QLineEdit>("/wheel/marking");
        auto* meaning = window.on<QLabel>("markingMeaning");
        auto* fill = window.on<QPushButton>("fillFromMarking");
        typeOver(*line, QStringLiteral("400x40x203 63C F80 K 8 V 30"));
        QVERIFY2(meaning->text().contains(QStringLiteral("green silicon carbide")),
                 qPrintable(meaning->text()));
        QVERIFY(meaning->text().contains(QStringLiteral("0.185")));
        QVERIFY(fill->isEnabled());
        const Project before = window.document().project();
        window.press("fillFromMarking");
        const Wheel& wheel = *window.document().project().wheel;
        QCOMPARE(wheel.diameter_mm, 400.0);
        QCOMPARE(wheel.width_mm, 40.0);
        QCOMPARE(wheel.grain_mm, 0.185);
        QCOMPARE(wheel.grain_share, (62 - 2 * 8) / 100.0);
        QCOMPARE(wheel.dullness, before.wheel->dullness); // it says nothing of it
        QVERIFY(!fill->isEnabled());
        window.document().undo();
        QCOMPARE(window.document().project().wheel->diameter_mm, before.wheel->diameter_mm);
        QCOMPARE(window.document().project().wheel->marking, before.wheel->marking);
        typeOver(*line, QStringLiteral("the old one"));
        QVERIFY(meaning->text().startsWith(QStringLiteral("This is not a marking")));
        QVERIFY(!fill->isVisible());
    }

    void aMarkingBelowTheMachinesSpeedIsSaid() {
        Window window(wheelPage);
        Project project = window.document().project();
        project.machine->wheel_speed_m_s = 50;
        project.wheel->marking = "25А F60 L 6 V 35";
        window.document().edit(project, {"Input", "Marking"});
        auto* meaning = window.on<QLabel>("markingMeaning");
        QVERIFY(meaning->text().contains(QStringLiteral("above what the marking allows")));
        project.machine->wheel_speed_m_s = 35;
        window.document().edit(project, {"Input", "Wheel speed"});
        QVERIFY(!meaning->text().contains(QStringLiteral("above what the marking allows")));
    }

    void aToleranceClassFillsTheLimits_data() {
        addColumns<QString, double, double, double, QString>("typed", "nominal", "upper", "lower",
                                                             "shown");
        addRow("30h6", "30h6", 30.0, 0.0, -13.0, "30h6");
        addRow("Cyrillic, comma", QString::fromUtf8("38,74к6"), 38.74, 18.0, 2.0, "38.74k6");
        addRow("letters alone", "f7", 30.0, -20.0, -41.0, "30f7");
    }

    void aToleranceClassFillsTheLimits() {
        QFETCH(QString, typed);
        QFETCH(double, nominal);
        QFETCH(double, upper);
        QFETCH(double, lower);
        QFETCH(QString, shown);
        Window window(partPage);
        const Part before = *window.document().project().part;
        auto* size = window.on<QLineEdit>("sizeField");
        size->setFocus();
        size->selectAll();
        size->insert(typed); // pasted: QTest types no Cyrillic
        size->setModified(true);
        QVERIFY(window.on<QLabel>("sizeMeaning")->isVisible());
        QTest::keyClick(size, Qt::Key_Return);
        const Part& part = *window.document().project().part;
        QCOMPARE(part.diameter_mm, nominal);
        QCOMPARE(part.upper_deviation_um, upper);
        QCOMPARE(part.lower_deviation_um, lower);
        QCOMPARE(size->text(), shown);
        QVERIFY(!window.on<QLabel>("sizeMeaning")->isVisible());
        window.document().undo();
        QCOMPARE(window.document().project().part->diameter_mm, before.diameter_mm);
        QCOMPARE(window.document().project().part->lower_deviation_um, before.lower_deviation_um);
        QVERIFY(!window.document().canUndo());
    }

    /// By hand: 12 mm on a diameter of 40 mm are 2·asin(0.3) = 34.92°.
    void aKeywayBecomesAGap() {
        Window window(partPage);
        Project project = window.document().project();
        project.part->diameter_mm = 40;
        project.part->length_mm = 60;
        window.document().edit(project, {"Input", "Diameter"});
        auto* keyway = window.on<QLineEdit>("keywayField");
        typeOver(*keyway, QStringLiteral("12P9 x 45"));
        auto* meaning = window.on<QLabel>("keywayMeaning");
        QVERIFY2(meaning->isVisible() && meaning->text().contains(QStringLiteral("34.92")),
                 qPrintable(meaning->text()));
        QVERIFY(meaning->text().contains(QStringLiteral("45 mm"))); // shorter than the surface
        QTest::keyClick(keyway, Qt::Key_Return);
        const auto gaps = [&window] { return window.document().project().part->gaps; };
        QCOMPARE(gaps().size(), 1U);
        QCOMPARE(gaps().front().from_deg, 0.0);
        QCOMPARE(gaps().front().width_deg, 34.92);
        typeOver(*keyway, QStringLiteral("10P9 x 45")); // there: it takes the other's place
        QTest::keyClick(keyway, Qt::Key_Return);
        QCOMPARE(gaps().size(), 1U);
        QCOMPARE(gaps().front().width_deg, 28.96);
        typeOver(*keyway, QStringLiteral("10P9 x 70"));
        QVERIFY(!meaning->text().contains(QStringLiteral("long"))); // through
        typeOver(*keyway, QStringLiteral("45 P9"));
        QTest::keyClick(keyway, Qt::Key_Return);
        QCOMPARE(gaps().front().width_deg, 28.96);
        QVERIFY2(meaning->text().contains(QStringLiteral("not narrower")),
                 qPrintable(meaning->text()));
        window.document().undo();
        QCOMPARE(gaps().front().width_deg, 34.92);
        window.document().undo();
        QVERIFY(gaps().empty());
    }

    /// ISO 286: the deviations of holes are ES and EI.
    void deviationsOfBoresAreCapitals() {
        Window window(partPage);
        Project project = window.document().project();
        const Field& upper = *tableOf<Part>().find("upper_deviation_um");
        QCOMPARE(symbolOf(upper, *project.part), QStringLiteral("es"));
        QVERIFY(labelMarkup(upper, project).contains(QStringLiteral("<i>es</i>")));
        project.part->surface = Surface::internal;
        QCOMPARE(symbolOf(upper, *project.part), QStringLiteral("ES"));
        QVERIFY(labelMarkup(upper, project).contains(QStringLiteral("<i>ES</i>")));
        const Field& diameter = *tableOf<Part>().find("diameter_mm");
        QCOMPARE(labelMarkup(diameter, project), labelMarkup(diameter));
    }

    void aToleranceClassIsTakenWhenItIsLeft() {
        Window window(partPage);
        auto* size = window.on<QLineEdit>("sizeField");
        typeOver(*size, QStringLiteral("40k6"));
        QVERIFY(window.on<QLabel>("sizeMeaning")->isVisible());
        QVERIFY(!window.document().canUndo());
        QTest::keyClick(size, Qt::Key_Tab);
        const Part& part = *window.document().project().part;
        QCOMPARE(part.diameter_mm, 40);
        QCOMPARE(part.upper_deviation_um, 18);
        QCOMPARE(part.lower_deviation_um, 2);
        QVERIFY(!window.on<QLabel>("sizeMeaning")->isVisible());
    }

    void aToleranceClassIsTakenByACommand() {
        Window window(partPage);
        auto* size = window.on<QLineEdit>("sizeField");
        typeOver(*size, QStringLiteral("40k6"));
        window.bench.window->inputs().endTyping(); // as Save does first
        QCOMPARE(window.document().project().part->diameter_mm, 40);
        QVERIFY(size->hasFocus());
    }

    void aClassThatIsThePartsOwnFollowsThePart() {
        Window window(partPage);
        auto* size = window.on<QLineEdit>("sizeField");
        const QString own = size->text();
        size->setFocus();
        QTest::keyClicks(size, QStringLiteral("h"));
        QTest::keyClick(size, Qt::Key_Backspace);
        QTest::keyClick(size, Qt::Key_Return);
        QCOMPARE(size->text(), own);
        Project project = window.document().project();
        project.part->diameter_mm += 20;
        window.document().edit(project, {"Input", "Diameter"});
        QVERIFY2(size->text() != own, qPrintable(own));
        QVERIFY(!window.on<QLabel>("sizeMeaning")->isVisible());
    }

    void aRefusedClassDoesNotOutliveItsReason() {
        Window window(partPage);
        auto* size = window.on<QLineEdit>("sizeField");
        typeOver(*size, QStringLiteral("30H7"));
        QTest::keyClick(size, Qt::Key_Tab);
        QCOMPARE(size->text(), QStringLiteral("30H7"));
        Project project = window.document().project();
        project.part->surface = Surface::internal;
        window.document().edit(project, {"Input", "Surface"});
        QVERIFY(!window.on<QLabel>("sizeMeaning")->isVisible());
        QVERIFY(size->text() != QStringLiteral("30H7"));
    }

    void aClassThatIsNoneIsExplained() {
        Window window(partPage);
        const Part before = *window.document().project().part;
        auto* size = window.on<QLineEdit>("sizeField");
        auto* meaning = window.on<QLabel>("sizeMeaning");
        for (const auto& [typed, said] :
             {std::pair("30H7", "Capital letters are for bores"), std::pair("30q6", "ISO 286 does"),
              std::pair("600h6", "ISO 286 does"), std::pair("thirty", "This is not a size")}) {
            typeOver(*size, QString::fromLatin1(typed));
            QVERIFY2(meaning->text().startsWith(QString::fromLatin1(said)),
                     qPrintable(meaning->text()));
            QTest::keyClick(size, Qt::Key_Return);
            QVERIFY(meaning->isVisible());
        }
        QCOMPARE(window.document().project().part->diameter_mm, before.diameter_mm);
        QVERIFY(!window.document().canUndo());
    }

    void limitsOfAClassAreRecognised() {
        Window window(partPage);
        Project project = window.document().project();
        project.part->diameter_mm = 50;
        project.part->upper_deviation_um = -9;
        project.part->lower_deviation_um = -25;
        window.document().edit(project, {"Input", "Diameter"});
        QCOMPARE(window.on<QLineEdit>("sizeField")->text(), QStringLiteral("50g6"));
        project.part->lower_deviation_um = -26;
        window.document().edit(project, {"Input", "Diameter"});
        QCOMPARE(window.on<QLineEdit>("sizeField")->text(), QString());
    }
};

} // namespace sparkout::test_marking_fields

SPARKOUT_TEST(test_marking_fields, TestMarkingFields)
#include "test_marking_fields.moc"
