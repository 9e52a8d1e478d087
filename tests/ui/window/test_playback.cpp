// SPDX-License-Identifier: GPL-3.0-or-later
// The playback bar moves the cursor by buttons, keys, slider and by itself.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/window/playback_bar.h"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

namespace sparkout::test_playback {

struct Bench {
    Bench() : bar(cursor) {
        bar.resize(900, 40);
        bar.show();
        bar.place()->resize(900, 20); // the window's status line has it
        cursor.setOutcome(fixtures::run(fixtures::traverseProject()));
    }
    void click(const char* name) {
        QTest::mouseClick(bar.findChild<QToolButton*>(QLatin1String(name)), Qt::LeftButton);
    }
    [[nodiscard]] QToolButton& button(const char* name) {
        return *bar.findChild<QToolButton*>(QLatin1String(name));
    }
    [[nodiscard]] QString place() const { return bar.findChild<QLabel*>()->text(); }
    void choose(const char* box, int index) {
        auto* const choice = bar.findChild<QComboBox*>(QLatin1String(box));
        choice->setFocus();
        QTest::keyClick(choice, Qt::Key_Home);
        for (int i = 0; i < index; ++i) {
            QTest::keyClick(choice, Qt::Key_Down);
        }
    }
    CycleCursor cursor;
    PlaybackBar bar;
};

class TestPlayback : public QObject {
    Q_OBJECT

private slots:
    void theButtonsStepByTheUnit() {
        Bench bench;
        QVERIFY(!bench.button("playNext").isEnabled());
        bench.click("playFirst");
        QVERIFY(bench.cursor.atStart());
        QVERIFY(!bench.button("playPrevious").isEnabled());
        bench.click("playNext");
        QCOMPARE(bench.cursor.stroke(), 1);
        bench.click("playNext");
        QCOMPARE(bench.cursor.stroke(), 2);
        const long long second = bench.cursor.position();
        bench.choose("playUnit", static_cast<int>(CursorUnit::radius));
        bench.click("playNext");
        QCOMPARE(bench.cursor.position(), second + 1);
        bench.click("playPrevious");
        QCOMPARE(bench.cursor.position(), second);
        bench.click("playLast");
        QVERIFY(bench.cursor.atEnd());
    }

    void theSliderFollowsAndMoves() {
        Bench bench;
        auto& slider = *bench.bar.findChild<QSlider*>();
        QCOMPARE(slider.value(), slider.maximum());
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Home);
        QVERIFY(bench.cursor.atStart());
        QCOMPARE(slider.value(), 0);
        QTest::keyClick(&slider, Qt::Key_Right);
        QCOMPARE(bench.cursor.stroke(), 1);
        QVERIFY(slider.value() > 0);
        QTest::keyClick(&slider, Qt::Key_Left);
        QVERIFY(bench.cursor.atStart());
        QTest::keyClick(&slider, Qt::Key_Left);
        QCOMPARE(slider.value(), 0);
        QTest::keyClick(&slider, Qt::Key_PageUp);
        QCOMPARE(bench.cursor.stroke(), 10);
        QTest::keyClick(&slider, Qt::Key_End);
        QVERIFY(bench.cursor.atEnd());
    }

    void itPlaysToTheEndAndStops() {
        Bench bench;
        bench.choose("playUnit", static_cast<int>(CursorUnit::stage));
        bench.choose("playSpeed", 5);
        bench.click("play");
        QVERIFY(bench.bar.isPlaying());
        QVERIFY(bench.cursor.atStart()); // anew from the end
        QTRY_VERIFY(bench.cursor.atEnd());
        QTRY_VERIFY(!bench.bar.isPlaying());
        bench.cursor.toStroke(3);
        bench.choose("playUnit", static_cast<int>(CursorUnit::stroke));
        bench.click("play");
        QTRY_VERIFY(bench.cursor.stroke() > 4);
        bench.click("play");
        QVERIFY(!bench.bar.isPlaying());
        const long long at = bench.cursor.position();
        QTest::qWait(100);
        QCOMPARE(bench.cursor.position(), at);
    }

    /// In a plunge a revolution is all there is between a stage and a radius.
    void aPlungeHasItsOwnUnits() {
        Bench bench;
        auto* const unit = bench.bar.findChild<QComboBox*>(QStringLiteral("playUnit"));
        QCOMPARE(unit->count(), 5);
        bench.choose("playUnit", 3);
        QCOMPARE(bench.bar.unit(), CursorUnit::revolution);
        bench.cursor.setOutcome(fixtures::run(fixtures::plungeProject(2)));
        QCOMPARE(unit->count(), 3);
        QCOMPARE(bench.bar.unit(), CursorUnit::stroke);
        QCOMPARE(unit->currentText(), QStringLiteral("by revolution"));
        bench.click("playFirst");
        bench.click("playNext");
        QCOMPARE(bench.cursor.stroke(), 1);
        bench.cursor.setOutcome(fixtures::run(fixtures::traverseProject()));
        QCOMPARE(unit->count(), 5);
        QCOMPARE(bench.bar.unit(), CursorUnit::stroke);
    }

    void thePlaceIsSaid() {
        Bench bench;
        bench.cursor.toStroke(2);
        const QString text = bench.place();
        QVERIFY2(text.startsWith(QStringLiteral("Stage 1, double stroke 2 of ")), qPrintable(text));
        bench.cursor.step(CursorUnit::radius, 1);
        const QString third =
            QStringLiteral("3 of %1, plunge-in (RZ1\u00A0E1), revolution 1, radius 0, ")
                .arg(bench.cursor.outcome()->result.cycleCount);
        QVERIFY2(bench.place().contains(third), qPrintable(bench.place()));
        while (bench.cursor.progress().end - bench.cursor.progress().open == 1) {
            bench.cursor.step(CursorUnit::revolution, 1);
        }
        QVERIFY2(bench.place().contains(QStringLiteral(
                     "working stroke (RZ1\u00A0E3, NZ\u00A0E1, RZ2\u00A0E1), radius 35, ")),
                 qPrintable(bench.place()));
        bench.cursor.setPosition(0);
        QCOMPARE(bench.place(), QStringLiteral("Blank, before the first touch"));
    }
};

} // namespace sparkout::test_playback

SPARKOUT_TEST(test_playback, TestPlayback)
#include "test_playback.moc"
