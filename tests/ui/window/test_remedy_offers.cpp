// SPDX-License-Identifier: GPL-3.0-or-later
// What would help, beneath the verdict: offered after a run, taken by a click, undone.
#include "core/file/project_file.h"
#include "core/study/operation.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/kit/font_size.h"
#include "ui/session/remedy_finder.h"
#include "ui/views/requirements/verdict_sections.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>

#include <algorithm>

namespace sparkout::test_remedy_offers {

/// The parts of the section in a window.
struct Offers {
    explicit Offers(const Bench& bench)
        : window(*bench.window)
        , section(*window.findChild<RemedySection*>())
        , finder(*window.findChild<RemedyFinder*>()) {}

    [[nodiscard]] QPushButton& take(int number) const {
        return *section.findChild<QPushButton*>(QStringLiteral("takeRemedy%1").arg(number));
    }
    [[nodiscard]] QString line(int number) const {
        return section.findChild<QLabel*>(QStringLiteral("remedy%1").arg(number))->text();
    }
    [[nodiscard]] QString note() const {
        return section.findChild<QLabel*>(QStringLiteral("remediesNote"))->text();
    }
    [[nodiscard]] bool wait() const {
        return QTest::qWaitFor([this] { return !window.runs().running() && !finder.running(); },
                               120'000);
    }
    /// A click as the windowing system sends it.
    void click(const QWidget& widget) const {
        for (QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
            if (auto* area = qobject_cast<QScrollArea*>(up)) {
                area->ensureWidgetVisible(const_cast<QWidget*>(&widget));
            }
        }
        QTest::qWait(20);
        QTest::mouseClick(window.windowHandle(), Qt::LeftButton, Qt::NoModifier,
                          widget.mapTo(&window, widget.rect().center()));
    }

    MainWindow& window;
    RemedySection& section;
    RemedyFinder& finder;
};

bool holds(const Outcome& outcome) {
    return outcome.result.status == RunStatus::completed
           && std::ranges::all_of(outcome.constraints, &ConstraintResult::holds);
}

class TestRemedyOffers : public QObject {
    Q_OBJECT

private slots:
    void aClickTakesARemedyAndUndoBringsBackWhatWas() {
        OpenBench bench(QStringLiteral("en"), examplePath("wheel-dull"));
        const Offers offers(bench);
        QVERIFY(offers.wait());
        QVERIFY(offers.section.isVisible());
        const Project before = bench.window->document().project();
        const OutcomePtr outcome = bench.window->studies().outcome;
        QVERIFY(!holds(*outcome));
        const RemedyResult found = findRemedies(outcome->result, outcome->constraints);
        QVERIFY(!found.remedies.empty());
        for (std::size_t i = 0; i < RemedyResult::most; ++i) {
            const bool there = i < found.remedies.size();
            QPushButton& take = offers.take(static_cast<int>(i) + 1);
            QCOMPARE(take.isVisible(), there);
            if (there) {
                const std::string line = RemedyText().line(before, found.remedies[i]);
                QCOMPARE(take.accessibleName(),
                         QStringLiteral("Apply the change: ") + QString::fromStdString(line));
                QVERIFY(take.toolTip().contains(QStringLiteral("all requirements are met")));
            }
        }
        offers.click(offers.take(1));
        const Project after = bench.window->document().project();
        QVERIFY(sameProject(after, found.remedies[0].applied(before)));
        QVERIFY(!sameProject(after, before));
        QVERIFY(bench.window->document().canUndo());
        QVERIFY(!bench.window->document().undoText().isEmpty());
        QVERIFY(!offers.take(1).isEnabled()); // of the inputs before
        QVERIFY(offers.wait());
        QVERIFY(holds(*bench.window->studies().outcome));
        bench.action("undo")->trigger();
        QVERIFY(sameProject(bench.window->document().project(), before));
        QVERIFY(!bench.window->document().canUndo());
        QVERIFY(offers.wait());
        QVERIFY(offers.take(1).isVisible() && offers.take(1).isEnabled());
    }

    void theKeyboardReachesAndTakesIt() {
        OpenBench bench(QStringLiteral("en"), examplePath("wheel-dull"));
        const Offers offers(bench);
        QVERIFY(offers.wait());
        const OutcomePtr outcome = bench.window->studies().outcome;
        const RemedyResult found = findRemedies(outcome->result, outcome->constraints);
        QVERIFY(found.remedies.size() >= 2);
        offers.take(1).setFocus(Qt::TabFocusReason);
        QTest::keyClick(bench.window->windowHandle(), Qt::Key_Tab);
        QVERIFY(offers.take(2).hasFocus());
        QTest::keyClick(bench.window->windowHandle(), Qt::Key_Space);
        QVERIFY(sameProject(bench.window->document().project(),
                            found.remedies[1].applied(outcome->result.project)));
    }

    void aRussianWindowHasRussianWordsAndNumbers() {
        OpenBench bench(QStringLiteral("ru"), examplePath("wheel-dull"));
        Project project = bench.window->document().project();
        project.machine->limits.work_speed_rpm = std::vector<double>{160, 160, 5}; // for a feed
        bench.window->document().edit(project, {"Edit", "x"});
        const Offers offers(bench);
        QVERIFY(offers.wait());
        bool feeds = false;
        for (int i = 1; i <= 3; ++i) {
            const QString line = offers.line(i);
            QVERIFY2(englishIn(line).isEmpty(), qPrintable(line));
            QVERIFY2(englishIn(offers.take(i).toolTip()).isEmpty(),
                     qPrintable(offers.take(i).toolTip()));
            QVERIFY2(!line.contains(QRegularExpression(QStringLiteral("[0-9]\\.[0-9]"))),
                     qPrintable(line));
            feeds |= line.startsWith(QStringLiteral("Подача S<sub>"));
        }
        QVERIFY(feeds);
        QCOMPARE(offers.take(1).text(), QStringLiteral("Применить"));
        bench.action("english")->trigger();
        QCOMPARE(offers.take(1).text(), QStringLiteral("Apply"));
    }

    void whereNoneHelpsTheRequirementsAreNamed() {
        for (const char* language : {"en", "ru"}) {
            OpenBench bench(QString::fromUtf8(language), examplePath("plunge-shaft-two-stage"));
            Project project = bench.window->document().project();
            project.machine->geometric_runout_um = 6;
            bench.window->document().edit(project, {"Edit", "x"});
            const Offers offers(bench);
            QVERIFY(offers.wait());
            QVERIFY(offers.section.isVisible());
            QVERIFY(!offers.take(1).isVisible());
            QVERIFY2(offers.note().contains(QString::fromUtf8(language) == QStringLiteral("en")
                                                ? QStringLiteral("“Radial runout”")
                                                : QStringLiteral("«Радиальное биение»")),
                     qPrintable(offers.note()));
        }
    }

    void nothingIsOfferedWhereAllHoldsWithRoom() {
        OpenBench bench(QStringLiteral("en"), examplePath("shaft-30h6-factory"));
        const Offers offers(bench);
        QVERIFY(offers.wait());
        QVERIFY(!offers.section.isVisible());
        Project project = bench.window->document().project();
        project.cycle->stages.clear(); // refused
        bench.window->document().edit(project, {"Edit", "x"});
        QVERIFY(offers.wait());
        QVERIFY(!offers.section.isVisible());
    }

    void anEditEndsTheSearchOfTheInputsBefore() {
        OpenBench bench(QStringLiteral("en"), examplePath("wheel-dull"));
        const Offers offers(bench);
        QVERIFY(offers.wait());
        Project project = bench.window->document().project();
        int found = 0, late = 0;
        connect(&offers.finder, &RemedyFinder::found, bench.window.get(),
                [&](const OutcomePtr& outcome) {
                    ++found;
                    late += outcome->result.project.machine->wheel_speed_m_s
                                    == project.machine->wheel_speed_m_s
                                ? 0
                                : 1;
                });
        for (int i = 0; i < 20; ++i) {
            project.machine->wheel_speed_m_s = 30.05 + 0.1 * i;
            bench.window->document().edit(project, {"Edit", "x"});
            QVERIFY(!offers.take(1).isEnabled());
            QTest::qWait(10);
        }
        QVERIFY(offers.wait());
        QVERIFY(found > 0);
        QCOMPARE(late, 0);
    }

    // Of slow cycles what is found stands there while the rest is looked for, with a button to
    // stop.
    void aSlowSearchShowsItsProgressAndIsStopped() {
        OpenBench bench(QStringLiteral("en"), examplePath("plunge-shaft-two-stage"));
        Project project = withSections(bench.window->document().project(), 200);
        project.part->radii_per_section = 360;
        project.part->tolerance.radial_runout_um = 1.5;
        for (Stage& stage : project.cycle->stages) {
            if (stage.radial_feed_mm_min) {
                *stage.radial_feed_mm_min /= 10; // some ten times the revolutions
            }
        }
        bench.window->document().edit(project, {"Edit", "x"});
        const Offers offers(bench);
        const QPushButton& end =
            *offers.section.findChild<QPushButton*>(QStringLiteral("endRemedies"));
        QTRY_VERIFY_WITH_TIMEOUT(end.isVisible() && end.isEnabled(), 120'000);
        QVERIFY2(offers.note().contains(QStringLiteral("settings tried")),
                 qPrintable(offers.note()));
        offers.click(end);
        QVERIFY(offers.wait());
        QVERIFY(!end.isVisible());
        QVERIFY2(offers.note().contains(QStringLiteral("Stopped after")),
                 qPrintable(offers.note()));
    }

    void theLinesHaveRoomAlsoInLargeType() {
        for (const char* language : {"en", "ru"}) {
            for (const int percent : {100, 130}) {
                OpenBench bench(QString::fromUtf8(language), examplePath("wheel-dull"));
                if (percent != usualFontSize) {
                    bench.action(("fontSize-" + QByteArray::number(percent)).constData())
                        ->trigger();
                }
                const Offers offers(bench);
                QVERIFY(offers.wait());
                QTest::qWait(100); // layouts
                bench.settle();
                const QStringList cut = textsWithoutRoom(*bench.window);
                QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
                for (int i = 1; i <= 3; ++i) {
                    const QLabel& text =
                        *offers.section.findChild<QLabel*>(QStringLiteral("remedy%1").arg(i));
                    QVERIFY(text.height() >= text.heightForWidth(text.width()));
                    QVERIFY(text.width() > offers.take(i).width());
                }
            }
        }
    }
};

} // namespace sparkout::test_remedy_offers

SPARKOUT_TEST(test_remedy_offers, TestRemedyOffers)
#include "test_remedy_offers.moc"
