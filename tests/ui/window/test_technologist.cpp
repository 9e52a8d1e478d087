// SPDX-License-Identifier: GPL-3.0-or-later
// A technologist's hour, with mouse and keys: a stepped shaft of a gearbox from its drawing to the
// passport and the operation card. Each cycle that the window offers on the way is judged for every
// stock.
#include "core/judgement/judgement.h"
#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/setup/worn_project.h"
#include "core/study/evaluate.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/hand.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/fields/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/part/part_drawing.h"
#include "ui/part/part_strip.h"
#include "ui/part/part_window.h"
#include "ui/session/cycle_judge.h"
#include "ui/session/part_runs.h"
#include "ui/window/window_head.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include <functional>
#include <vector>

namespace sparkout::test_technologist {

constexpr int mostClicks = 70;
constexpr double mostTime_s = 600;
constexpr double leastPlunge_s = 10;

constexpr int traverseEntry = 1, plungeEntry = 2; // of what a new surface begins with

struct Step {
    const char *length_mm, *diameter_mm;
};
/// From the headstock on.
const std::vector<Step> shaft{{"18", "36"}, {"26", "40"}, {"44", "45"},
                              {"12", "52"}, {"90", "48"}, {"26", "40"}};

/// What the drawing says of a ground step.
struct Drawn {
    const char* name;
    std::size_t step; ///< of the shaft
    bool travels;     ///< it is longer than the wheel is wide
    const char* size;
    const char* stock_mm;
    const char *roundness_um, *cylindricity_um, *roughness_um; ///< null: not required
};
const std::vector<Drawn> drawing{
    {"Шейка под муфту", 0, false, "36h8", "0,15", nullptr, nullptr, "1,6"},
    {"Подшипник слева", 1, false, "40k6", "0,15", "5", nullptr, "0,8"},
    {"Под шестерню", 2, false, "45n6", "0,15", nullptr, nullptr, "0,8"},
    {"Цапфа", 4, true, "48h6", "0,2", nullptr, "8", "0,8"},
    {"Подшипник справа", 5, false, "40k6", "0,15", "5", nullptr, "0,8"}};

/// A cycle as it was offered.
struct Offered {
    explicit Offered(const Project& project) {
        const OutcomePtr outcome = evaluate(project, {});
        const SimulationResult& result = outcome->result;
        const Judgement judgement = judge(result, outcome->constraints, judgeStocks(result));
        time_s = result.time_s;
        state = QString::fromLatin1(stateKey(judgement.state));
        isFit = !isFailure(judgement.state) && judgement.stocks && judgement.stocks->holds
                && (project.operation->travels || time_s >= leastPlunge_s);
    }
    double time_s;
    QString state;
    bool isFit; ///< for every stock, and in a time that a shop believes
};

/// The window as he has it, and what he does there.
struct Workplace : Bench {
    Workplace() : Bench(QStringLiteral("ru")) {
        settings.setAllInputs(false); // as a new user has it
        window.reset();
        window = std::make_unique<MainWindow>(settings, language);
        window->resize(1366, 768);
        window->show();
        window->activateWindow();
        time.start();
    }

    /// All that a user waits for has come, and keys go to the window again that he looks at.
    void calm(QWidget* in = nullptr) {
        const auto* runs = window->findChild<PartRuns*>();
        const auto* judge = window->findChild<CycleJudge*>();
        constexpr int patience_ms = 60'000;
        hand.check(QTest::qWaitFor(
                       [&] {
                           return !window->runs().running() && !runs->running()
                                  && !judge->judged().areStocksComing
                                  && !judge->judged().isBatchComing;
                       },
                       patience_ms),
                   QStringLiteral("the window does not come to rest"));
        settle();
        activate(in ? *in : *window);
    }
    void activate(QWidget& shown) { // as the desktop does when a menu or a dialog closes
        shown.activateWindow();
        const auto hasKeys = [&shown] {
            const QWidget* const focus = QApplication::focusWidget();
            return shown.isActiveWindow() && focus && focus->window() == &shown;
        };
        hand.check(QTest::qWaitFor(hasKeys), QStringLiteral("a window has no keys"));
    }
    /// Nothing is refused, all that is in sight has its room; a stage is over.
    void endStage(const QString& stage, QWidget* of = nullptr) {
        calm(of);
        for (const Refusal& refusal : window->inputs().refusals()) {
            hand.check(false, QString::fromStdString(refusal.path) + u' ' + refusal.reason);
        }
        QWidget& shown = of ? *of : *window;
        for (const QString& cut : textsWithoutRoom(shown)) {
            hand.check(false, QStringLiteral("no room, %1: %2").arg(stage, cut));
        }
    }

    [[nodiscard]] QMenuBar& menus() { return window->findChild<WindowHead*>()->menus(); }
    void choose(const char* name) { hand.choose(menus(), action(name)); }
    /// What opens a dialog, what is done in it, and Enter.
    void inDialog(const std::function<void()>& open, const std::function<void(QDialog&)>& work) {
        DialogAnswers answers({QStringLiteral("Enter")});
        answers.seen = [&](QDialog& dialog) {
            activate(dialog);
            if (work) {
                work(dialog);
            }
        };
        open();
        hand.countKey(); // Enter
        hand.check(QTest::qWaitFor([&] { return answers.fault().isEmpty(); }),
                   QStringLiteral("dialog: ") + answers.fault());
        settle();
    }
    [[nodiscard]] static QList<QToolButton*> toolsOf(const QWidget& widget) {
        return widget.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
    }
    void typeInto(const char* path, const char* text) {
        if (text) {
            hand.tabTo(QString::fromLatin1(path));
            hand.type(QString::fromUtf8(text));
        }
    }
    void showPage(int index) { hand.click(toolsOf(window->inputs()).at(index)); }

    /// What is left of a drawing once the size is typed.
    void typeDrawing(const Drawn& drawn) {
        hand.key(Qt::Key_Tab);
        if (window->document().isOpen("/part/length_mm")) {
            typeInto("/part/length_mm", shaft[drawn.step].length_mm);
        }
        typeInto("/part/stock_mm", drawn.stock_mm);
        hand.click(window->findChild<NumberField*>(
            QString::fromLatin1(drawn.roundness_um      ? "/part/tolerance/roundness_um"
                                : drawn.cylindricity_um ? "/part/tolerance/cylindricity_um"
                                                        : "/part/tolerance/roughness_ra_um")));
        typeInto("/part/tolerance/roundness_um", drawn.roundness_um);
        typeInto("/part/tolerance/cylindricity_um", drawn.cylindricity_um);
        typeInto("/part/tolerance/roughness_ra_um", drawn.roughness_um);
        hand.key(Qt::Key_Return);
        calm();
        hand.check(window->document().openInputs().empty() && window->outcome()->ran(),
                   QStringLiteral("not run: ") + QString::fromUtf8(drawn.name));
    }
    /// The first step is there with the first surface.
    void typeSteps() {
        auto* view = window->findChild<QTableView*>(QStringLiteral("/part/shaft/segments"));
        hand.click(toolsOf(*view->parentWidget()).front()); // adds one
        for (std::size_t i = 1; i < shaft.size(); ++i) {
            if (i > 1) {
                hand.key(Qt::Key_Insert);
                hand.key(Qt::Key_Left);
            }
            hand.type(QString::fromLatin1(shaft[i].length_mm));
            hand.key(Qt::Key_Tab);
            hand.type(QString::fromLatin1(shaft[i].diameter_mm));
            hand.key(Qt::Key_Return);
            settle();
        }
    }
    void addSurface(const Drawn& drawn) {
        auto& strip = *window->findChild<PartStrip*>();
        const bool isStrip = strip.isVisible();
        PartDrawing& part = strip.drawing();
        const auto open = [&] {
            if (!isStrip) {
                choose("addSurface");
                return;
            }
            const PartOutline::Step& step = part.outline().steps[drawn.step];
            hand.doubleClickAt(
                part, QPoint(int(part.xOf(step.from_mm + step.length_mm / 2)), part.height() / 2));
        };
        inDialog(open, [&](QDialog& dialog) {
            hand.type(QString::fromUtf8(drawn.name));
            const int wanted = drawn.travels ? traverseEntry : plungeEntry;
            const auto* begin = dialog.findChild<QComboBox*>(QStringLiteral("begin"));
            if (!hand.check(begin != nullptr,
                            QStringLiteral("another dialog: ") + dialog.windowTitle())) {
                return;
            }
            if (begin->currentIndex() != wanted) {
                hand.tabTo(begin->objectName());
                hand.key(begin->currentIndex() > wanted ? Qt::Key_Up : Qt::Key_Down);
            }
        });
        calm();
        hand.check(QApplication::focusWidget()
                       && QApplication::focusWidget()->objectName() == QStringLiteral("sizeField"),
                   QStringLiteral("the size of a new surface is not asked for first"));
        hand.type(QString::fromLatin1(drawn.size));
        typeDrawing(drawn);
    }

    Hand hand;
    QElapsedTimer time;
};

/// The cycles of all surfaces as they are in the document.
std::vector<Offered> judgedAll(const Setup& setup) {
    std::vector<Offered> all;
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        all.emplace_back(wornProject(setup, i).project);
    }
    return all;
}

class TestTechnologist : public QObject {
    Q_OBJECT

private slots:
    void theShaftOfAGearbox() {
        Workplace place;
        Hand& hand = place.hand;
        const QTemporaryDir folder; // where he keeps his files
        place.settings.setLastFolder(folder.path());
        place.choose("newPlunge");
        place.endStage(QStringLiteral("1-new"));

        hand.type(QString::fromLatin1(drawing[0].size));
        place.typeDrawing(drawing[0]);
        place.typeSteps();
        hand.click(place.window->findChild<QLineEdit*>(QStringLiteral("/part/name")));
        hand.type(QStringLiteral("Вал редуктора"));
        hand.key(Qt::Key_Return);
        place.endStage(QStringLiteral("2-first-drawing"));
        place.showPage(cyclePage);
        place.endStage(QStringLiteral("3-first-cycle"));
        for (std::size_t i = 1; i < drawing.size(); ++i) {
            place.addSurface(drawing[i]);
            place.endStage(QStringLiteral("4-drawing-%1").arg(i + 1));
            place.showPage(cyclePage);
            place.endStage(QStringLiteral("5-cycle-%1").arg(i + 1));
        }
        auto& tabs = place.window->findChild<PartStrip*>()->tabs();
        hand.clickAt(tabs, tabs.tabRect(0).center());
        place.inDialog([&] { place.choose("renameSurface"); },
                       [&](QDialog&) { hand.type(QString::fromUtf8(drawing[0].name)); });
        place.endStage(QStringLiteral("6-all"));
        const Setup started = place.window->document().setup();

        hand.click(place.window->findChild<QToolButton*>(QStringLiteral("wholePart")));
        auto* whole = place.window->findChild<PartWindow*>();
        QVERIFY(whole && whole->isVisible());
        place.endStage(QStringLiteral("7-whole"), whole);
        QElapsedTimer searching;
        searching.start();
        hand.click(whole->findChild<QPushButton*>(QStringLiteral("searchAll")));
        QVERIFY(QTest::qWaitFor([&] { return !whole->study().running(); }, int(mostTime_s) * 1000));
        const double searched_s = double(searching.elapsed()) / 1000;
        place.endStage(QStringLiteral("8-searched"), whole);
        hand.click(whole->findChild<QPushButton*>(QStringLiteral("takeFound")));
        place.endStage(QStringLiteral("9-taken"), whole);
        hand.key(Qt::Key_Escape);
        place.endStage(QStringLiteral("10-optimum"));
        const Setup found = place.window->document().setup();

        place.inDialog([&] { hand.key(Qt::Key_S, Qt::ControlModifier); }, {});
        const QDir kept(folder.path());
        hand.check(kept.entryList({QStringLiteral("*.sparkout")}).size() == 1,
                   QStringLiteral("not saved"));
        const auto bearing = tabs.tabRect(1).center();
        hand.clickAt(tabs, bearing);
        place.calm();
        for (const char* paper : {"pdf-passport", "pdf-operation-card"}) {
            place.inDialog([&] { place.choose(paper); }, {});
        }
        place.endStage(QStringLiteral("11-papers"));
        const QStringList papers = kept.entryList({QStringLiteral("*.pdf")});
        hand.check(papers.size() == 2, QStringLiteral("not exported"));
        const double wall_s = double(place.time.elapsed()) / 1000;
        qInfo("HOUR %d clicks, %d keys, %d turns of the wheel, %.1f s, searches %.1f s of it; "
              "a person with the searches %.0f s",
              hand.clicks(), hand.keys(), hand.turns(), wall_s, searched_s,
              hand.person_s() + searched_s);

        const std::vector<Offered> before = judgedAll(started), after = judgedAll(found);
        for (std::size_t i = 0; i < drawing.size(); ++i) {
            const QString how =
                QStringLiteral("%1: starting %2, optimum %3")
                    .arg(QString::fromUtf8(drawing[i].name), before[i].state, after[i].state);
            QVERIFY2(before[i].isFit && after[i].isFit && after[i].time_s <= before[i].time_s,
                     qPrintable(how));
        }
        QCOMPARE(hand.faults(), QString());
        QVERIFY(hand.clicks() <= mostClicks);
        QVERIFY(wall_s <= mostTime_s && hand.person_s() + searched_s <= mostTime_s);
    }

private:
    static constexpr int cyclePage = 5; ///< among those of the inputs
};

} // namespace sparkout::test_technologist

SPARKOUT_TEST(test_technologist, TestTechnologist)
#include "test_technologist.moc"
