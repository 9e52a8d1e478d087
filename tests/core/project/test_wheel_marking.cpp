// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/wheel.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <rapidcheck.h>

namespace sparkout::test_wheel_marking {

using fixtures::close;

class TestWheelMarking : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(2000); }

    void markingIsReadHoweverItIsWritten_data() {
        addColumns<QString, QString>("text", "spelled");
        const auto row = [](const char* text, const char* spelled) { addRow(text, text, spelled); };
        row("25А F60 L 6 V", "25А F60 L 6 V");
        row("25A F60 L 6 V", "25А F60 L 6 V"); // Latin A
        row("25АF60L6V", "25А F60 L 6 V");     // as on the wheel
        row("25а f60 l 6 v", "25А F60 L 6 V");
        row("  25А  F60 L 6 V ", "25А F60 L 6 V");
        row("25А F60 К 6 V", "25А F60 K 6 V"); // Cyrillic К
        row("14А F36 N V", "14А F36 N V");     // no structure number
        row("63С F80 J 7 B", "63С F80 J 7 B");
        row("63С F80 J 7 BF", "63С F80 J 7 BF");
        row("A F120 M 10 R", "А F120 M 10 R");
        row("500x50x203 25А F60 L 6 V", "500×50×203 25А F60 L 6 V");
        row("1 500×50×203 25А F60 L 6 V 35 м/с", "500×50×203 25А F60 L 6 V 35 м/с");
        row("1 600х63х305 25А F46 K 6 V 50 м/с 2 кл.", "600×63×305 25А F46 K 6 V 50 м/с");
        row("40х12,5х16 92А F100 M 8 V 40", "40×12.5×16 92А F100 M 8 V 40 м/с");
        row("500х50 25А F60 L 6 V", "500×50 25А F60 L 6 V");
        row("25А F60 L 6 V 2 кл", "25А F60 L 6 V");
    }
    void markingIsReadHoweverItIsWritten() {
        QFETCH(QString, text);
        QFETCH(QString, spelled);
        const auto marking = readWheelMarking(text.toStdString());
        QVERIFY(marking);
        QCOMPARE(QString::fromStdString(markingText(*marking)), spelled);
    }

    void whatIsNoMarkingIsNotRead_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"", " ", "25А", "F60 L 6 V", "25А F60", "25А F60 L", "25А F60 L 6", "25А F61 L 6 V",
              "25А F60 6 V", "25А F60 L 6 W", "25А F60 L 66 V", "25А F60 L 6 V и ещё",
              "2500А F60 L 6 V", "25Б F60 L 6 V", "25А P60 L 6 V", "500х 25А F60 L 6 V",
              "25А F99999999999999999999 L 6 V", "25А F60 L 6 V 35 м/с хорошо"}) {
            addRow(text, text);
        }
        addRow("endless", QString(100000, QLatin1Char('2')));
    }
    void whatIsNoMarkingIsNotRead() {
        QFETCH(QString, text);
        QVERIFY(!readWheelMarking(text.toStdString()));
    }

    void partsAreTold() {
        const auto m = readWheelMarking("1 500×50×203 25А F60 L 6 V 35 м/с 2 кл");
        QVERIFY(m);
        QCOMPARE(m->abrasive, std::string("25А"));
        QCOMPARE(m->grit, 60);
        QCOMPARE(m->hardness, 'L');
        QCOMPARE(m->structure, std::optional<int>(6));
        QCOMPARE(m->bond, std::string("V"));
        QCOMPARE(m->diameter_mm, std::optional<double>(500));
        QCOMPARE(m->width_mm, std::optional<double>(50));
        QCOMPARE(m->bore_mm, std::optional<double>(203));
        QCOMPARE(m->speed_m_s, std::optional<double>(35));
    }

    void everySpellingReadsBack() {
        const bool held = rc::check("round trip", [] {
            WheelMarking m;
            m.abrasive = *rc::gen::element(std::string("25А"), std::string("14А"),
                                           std::string("63С"), std::string("А"));
            m.grit = *rc::gen::element(16, 36, 46, 60, 80, 100, 120, 220);
            m.hardness = *rc::gen::inRange('A', char('Z' + 1));
            if (*rc::gen::arbitrary<bool>()) {
                m.structure = *rc::gen::inRange(0, 21);
            }
            m.bond = *rc::gen::element(std::string("V"), std::string("BF"), std::string("R"));
            if (*rc::gen::arbitrary<bool>()) {
                m.diameter_mm = *rc::gen::inRange(1, 1100);
                m.width_mm = *rc::gen::inRange(1, 2000) / 8.0;
            }
            if (m.diameter_mm && *rc::gen::arbitrary<bool>()) {
                m.bore_mm = *rc::gen::inRange(1, 305);
            }
            if (*rc::gen::arbitrary<bool>()) {
                m.speed_m_s = *rc::gen::inRange(20, 125);
            }
            const auto again = readWheelMarking(markingText(m));
            RC_ASSERT(again.has_value());
            RC_ASSERT(markingText(*again) == markingText(m));
            RC_ASSERT(again->structure == m.structure && again->hardness == m.hardness);
            RC_ASSERT(again->diameter_mm == m.diameter_mm && again->speed_m_s == m.speed_m_s);
        });
        QVERIFY(held);
    }

    void hostileTextsAreAnswered() {
        const bool held = rc::check("any bytes", [] {
            const auto text = *rc::gen::container<std::string>(rc::gen::element(
                '2', '5', 'A', 'F', '6', '0', 'L', 'V', ' ', 'x', '\xD0', '\x90', '.', '\0', '-'));
            const auto marking = readWheelMarking(text);
            if (marking) {
                RC_ASSERT(readWheelMarking(markingText(*marking)).has_value());
            }
        });
        QVERIFY(held);
    }

    // A finer grit is a smaller grain, by the steps of the sieves' series.
    void grainFallsWithTheGrit() {
        const int grits[] = {16, 20, 22, 24, 30,  36,  40,  46,  54,
                             60, 70, 80, 90, 100, 120, 150, 180, 220};
        double last = 1.23 * 1.2;
        for (const int grit : grits) {
            const auto grain = grainOfGrit(grit);
            QVERIFY(grain && last / *grain > 1.15 && last / *grain < 1.35);
            last = *grain;
        }
        QVERIFY(!grainOfGrit(61) && !grainOfGrit(0) && !grainOfGrit(-60));
    }

    // N_s = 0.5·(62 − 100·W_g) gives the structure number back [MODEL-8].
    void grainShareGivesTheStructureBack() {
        for (int N = 0; N <= 20; ++N) {
            QVERIFY(close(0.5 * (62 - 100 * grainShareOfStructure(N)), N, 1e-12) || N == 0);
        }
        QCOMPARE(grainShareOfStructure(6), 0.5);
    }

    void markingFillsTheWheelAndLeavesTheRest() {
        Wheel wheel;
        wheel.dullness = 0.07;
        wheel.bond_share = 0.2;
        applyMarking(*readWheelMarking("600×63×305 25А F46 K 8 V"), wheel);
        QCOMPARE(wheel.marking, std::string("600×63×305 25А F46 K 8 V"));
        QCOMPARE(wheel.diameter_mm, 600.0);
        QCOMPARE(wheel.width_mm, 63.0);
        QCOMPARE(wheel.grain_mm, 0.37);
        QCOMPARE(wheel.grain_share, 0.46);
        QCOMPARE(wheel.dullness, 0.07);
        QCOMPARE(wheel.bond_share, 0.2);
        applyMarking(*readWheelMarking("25А F60 L V"), wheel);
        QCOMPARE(wheel.diameter_mm, 600.0); // the marking says nothing of it
        QCOMPARE(wheel.grain_share, 0.46);
        QVERIFY(!wheel.max_speed_m_s);
        applyMarking(*readWheelMarking("25А F60 L 6 V 50 м/с"), wheel);
        QCOMPARE(wheel.max_speed_m_s, std::optional(50.0));
        applyMarking(*readWheelMarking("25А F60 L 6 V"), wheel);
        QCOMPARE(wheel.max_speed_m_s, std::optional(50.0));
    }
};

} // namespace sparkout::test_wheel_marking

SPARKOUT_TEST(test_wheel_marking, TestWheelMarking)
#include "test_wheel_marking.moc"
