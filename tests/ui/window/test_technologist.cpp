// SPDX-License-Identifier: GPL-3.0-or-later
// A technologist's hour, with mouse and keys: a stepped shaft of a gearbox from its drawing to the
// passport and the operation card. Each cycle that the window offers on the way is judged for every
// stock and by 500 fresh parts of its batch. One line a surface is printed. Pictures of the stages
// are kept where SPARKOUT_HOUR_PICTURES names a folder.
#include "core/batch/judgement.h"
#include "core/batch/scenario_source.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/part.h"
#include "core/search/robust.h"
#include "core/setup/worn_project.h"
#include "core/study/outcome.h"
#include "core/study/whole_batch.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/hand.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/part_runs.h"
#include "ui/session/run_controller.h"
#include "ui/window/actions.h"
#include "ui/window/dialogs/part_drawing.h"
#include "ui/window/dialogs/part_strip.h"
#include "ui/window/dialogs/part_window.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace sparkout::test_technologist {

constexpr int mostClicks = 70;
constexpr double mostTime_s = 600;
constexpr double leastPlunge_s = 10;
constexpr double mostFinishFeed_mm_min = 0.2;
constexpr int otherDraw = 1000; // than any that a search tries its answers on

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

/// A cycle as it was offered, and what it is good for.
struct Offered {
    Project project;
    OutcomePtr outcome;
    Judgement judgement; ///< with the fresh parts as its batch
    std::optional<double> leastPpk;

    [[nodiscard]] double time_s() const { return outcome->result.time_s; }
    /// Infeed per side [mm/min], of traverse that of a double stroke over its time.
    [[nodiscard]] double feed_mm_min(std::size_t stage) const {
        const Stage& of = project.cycle->stages[stage];
        const SimulationResult& result = outcome->result;
        constexpr double secondsPerMinute = 60;
        return project.operation->travels
                   ? of.radial_feed_mm.value_or(0) * result.countsByStage[stage]
                             / result.timeByStage_s[stage] * secondsPerMinute
                         + of.continuousFeed_mm_min()
                   : of.radial_feed_mm_min.value_or(0);
    }
    [[nodiscard]] std::size_t finish() const { ///< the last stage that feeds
        const std::vector<Stage>& stages = project.cycle->stages;
        return stages.size() - (stages.size() > 1 && !stages.back().feeds() ? 2 : 1);
    }
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString fault() const; ///< why a shop would not run it; empty: it would
};

Offered judged(const Project& project) {
    Offered offered;
    offered.project = project;
    offered.outcome = evaluate(project, {});
    const BatchOutcomePtr batch = runWholeBatch(withFreshParts(project, otherDraw));
    const SimulationResult& result = offered.outcome->result;
    offered.judgement = judge(result, offered.outcome->constraints, judgeStocks(result),
                              judgeBatch(batch->result, batch->summary));
    for (const CharacteristicSummary& each : batch->summary.characteristics) {
        if (each.ppk && (!offered.leastPpk || each.ppk->value < *offered.leastPpk)) {
            offered.leastPpk = each.ppk->value;
        }
    }
    return offered;
}

QString Offered::text() const {
    const auto number = [](double value, int digits) {
        return QString::number(value, 'f', digits);
    };
    const SimulationResult& result = outcome->result;
    const std::vector<Stage>& stages = project.cycle->stages;
    QStringList parts{number(time_s(), 1) + QStringLiteral(" s")};
    for (std::size_t i = 0; i <= finish(); ++i) {
        parts += number(feed_mm_min(i), 3) + QStringLiteral(" mm/min × ")
                 + number(stages[i].stock_mm, 3);
        if (project.operation->travels) {
            parts.back() += QStringLiteral(" (S_t %1 µm, S_ax %2)")
                                .arg(number(stages[i].radial_feed_mm.value_or(0) * 1000, 1),
                                     number(stages[i].axial_feed_mm_min.value_or(0), 0));
        }
    }
    const bool sparksOut = !stages.back().feeds();
    parts += sparksOut ? QStringLiteral("spark-out %1 (%2 s)")
                             .arg(result.countsByStage.back())
                             .arg(number(result.timeByStage_s.back(), 1))
                       : QStringLiteral("no spark-out");
    double runout_mm = 0;
    for (const SectionResult& section : result.sections) {
        runout_mm = std::max(runout_mm, section.radialRunout_mm);
    }
    for (const ConstraintResult& each : worstByKind(outcome->constraints)) {
        if (each.kind == ConstraintKind::roughness) {
            parts +=
                QStringLiteral("Ra %1…%2")
                    .arg(number(each.value, 2), number(each.mostValue.value_or(each.value), 2));
        } else if (each.kind == ConstraintKind::roundness
                   || each.kind == ConstraintKind::cylindricity) {
            parts += QStringLiteral("%1 %2").arg(QString::fromLatin1(requirementOf(each.kind).key),
                                                 number(each.value, 2));
        }
    }
    parts += QStringLiteral("runout %1").arg(number(runout_mm * 1000, 2));
    parts +=
        leastPpk ? QStringLiteral("Ppk %1").arg(number(*leastPpk, 2)) : QStringLiteral("no Ppk");
    parts += QStringLiteral("%1 bad of %2").arg(judgement.batch->bad).arg(judgement.batch->parts);
    parts += QString::fromLatin1(stateKey(judgement.state));
    return parts.join(QStringLiteral(", "));
}

QString Offered::fault() const {
    if (!outcome->ran()
        || (isFailure(judgement.state) && judgement.state != JudgedState::batchFails)) {
        return QString::fromLatin1(stateKey(judgement.state));
    }
    if (!judgement.stocks || !judgement.stocks->holds) {
        return QStringLiteral("not for every stock");
    }
    // What was good on 500 parts promises no less than the bound that these leave.
    const double most = std::max(judgement.batch->allowedShare, mostFailing(freshPartCount, 1));
    if (judgement.batch->parts != freshPartCount
        || double(judgement.batch->bad) > most * freshPartCount) {
        return QStringLiteral("not for the batch");
    }
    if (!project.operation->travels && time_s() < leastPlunge_s) {
        return QStringLiteral("a plunge that nobody believes");
    }
    if (feed_mm_min(finish()) > mostFinishFeed_mm_min) {
        return QStringLiteral("a finish that nobody believes");
    }
    return {};
}

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
    void endStage(const QString& picture, QWidget* of = nullptr) {
        calm(of);
        for (const Refusal& refusal : window->inputs().refusals()) {
            hand.check(false, QString::fromStdString(refusal.path) + u' ' + refusal.reason);
        }
        QWidget& shown = of ? *of : *window;
        for (const QString& cut : textsWithoutRoom(shown)) {
            hand.check(false, QStringLiteral("no room, %1: %2").arg(picture, cut));
        }
        const QString folder = qEnvironmentVariable("SPARKOUT_HOUR_PICTURES");
        if (!folder.isEmpty()) {
            hand.check(shown.grab().save(folder + u'/' + picture + QStringLiteral(".png")),
                       QStringLiteral("no picture in ") + folder);
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
        hand.check(window->document().openInputs().empty() && window->studies().outcome->ran(),
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
            endPicture(dialog, QStringLiteral("add"));
        });
        calm();
        hand.check(QApplication::focusWidget()
                       && QApplication::focusWidget()->objectName() == QStringLiteral("sizeField"),
                   QStringLiteral("the size of a new surface is not asked for first"));
        hand.type(QString::fromLatin1(drawn.size));
        typeDrawing(drawn);
    }
    void endPicture(QDialog& dialog, const QString& name) {
        const QString folder = qEnvironmentVariable("SPARKOUT_HOUR_PICTURES");
        if (!folder.isEmpty()) {
            dialog.grab().save(folder + u'/' + name + QStringLiteral(".png"));
        }
    }

    Hand hand;
    QElapsedTimer time;
};

/// The cycles of all surfaces as they are in the document.
std::vector<Offered> judgedAll(const Setup& setup) {
    std::vector<Offered> all;
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        all.push_back(judged(wornProject(setup, i).project));
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
        if (const QString to = qEnvironmentVariable("SPARKOUT_HOUR_PICTURES"); !to.isEmpty()) {
            for (const QString& paper : papers) {
                QFile::copy(folder.filePath(paper), to + u'/' + paper);
            }
        }
        const double wall_s = double(place.time.elapsed()) / 1000;
        qInfo("HOUR %d clicks, %d keys, %d turns of the wheel, %.1f s, searches %.1f s of it; "
              "a person with the searches %.0f s",
              hand.clicks(), hand.keys(), hand.turns(), wall_s, searched_s,
              hand.person_s() + searched_s);

        QStringList faults;
        const std::vector<Offered> before = judgedAll(started), after = judgedAll(found);
        for (std::size_t i = 0; i < drawing.size(); ++i) {
            const QString name = QString::fromStdString(found.surfaces[i].name);
            qInfo().noquote() << QStringLiteral("HOUR %1: starting %2; optimum %3")
                                     .arg(name, before[i].text(), after[i].text());
            for (const Offered* offered : {&before[i], &after[i]}) {
                if (const QString fault = offered->fault(); !fault.isEmpty()) {
                    faults += QStringLiteral("%1, %2: %3")
                                  .arg(name,
                                       offered == &before[i] ? QStringLiteral("starting")
                                                             : QStringLiteral("optimum"),
                                       fault);
                }
            }
            if (after[i].time_s() > before[i].time_s()) {
                faults += name + QStringLiteral(": the optimum takes longer");
            }
        }
        QCOMPARE(hand.faults(), QString());
        QCOMPARE(faults.join(u'\n'), QString());
        QVERIFY(hand.clicks() <= mostClicks);
        QVERIFY(wall_s <= mostTime_s && hand.person_s() + searched_s <= mostTime_s);
    }

private:
    static constexpr int cyclePage = 5; ///< among those of the inputs
};

} // namespace sparkout::test_technologist

SPARKOUT_TEST(test_technologist, TestTechnologist)
#include "test_technologist.moc"
