// SPDX-License-Identifier: GPL-3.0-or-later
// A technologist's hour, with mouse and keys: five surfaces of a part from their drawing to the
// passport and the operation card. Each cycle that the window offers on the way is judged for every
// stock and by 500 fresh parts of its batch. A table of the cycles is printed, with clicks, keys
// and the time of a person. Pictures of the stages are kept where SPARKOUT_HOUR_PICTURES names a
// folder. With SPARKOUT_LONG there are more drawings than the first.
#include "core/batch/judgement.h"
#include "core/batch/scenario_source.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
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
#include "ui/inputs/form_page.h"
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
#include <QLineEdit>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout::test_technologist {

constexpr int mostClicks = 70;
constexpr double mostTime_s = 600;
constexpr double leastPlunge_s = 10;
constexpr double mostFinishFeed_mm_min = 0.2;
constexpr int otherDraw = 1000; // than any that a search tries its answers on

constexpr int traverseEntry = 1, plungeEntry = 2;           // of what a new surface begins with
constexpr int partPage = 0, machinePage = 3, cyclePage = 5; // of the inputs

struct Step {
    const char *length_mm, *diameter_mm;
};

/// What the drawing says of a ground step.
struct Drawn {
    const char* name;
    std::size_t step; ///< of the part
    bool travels;     ///< it is longer than the wheel is wide
    const char* size;
    const char* stock_mm;
    const char *roundness_um, *cylindricity_um, *roughness_um; ///< null: not required
    const char* keyway = nullptr;                              ///< null: none
};

/// A drawing of five ground surfaces.
struct Drawing {
    const char* key; ///< of its row, and before the names of its pictures
    const char* part;
    const char* internalGrinder; ///< the machine of a part of bores; null: a shaft
    std::vector<Step> steps;     ///< from the headstock on; those of bores are not entered
    std::vector<Drawn> surfaces;
};
const std::vector<Drawing> drawings{
    {"gearbox",
     "Вал редуктора",
     nullptr,
     {{"18", "36"}, {"26", "40"}, {"44", "45"}, {"12", "52"}, {"90", "48"}, {"26", "40"}},
     {{"Шейка под муфту", 0, false, "36h8", "0,15", nullptr, nullptr, "1,6"},
      {"Подшипник слева", 1, false, "40k6", "0,15", "5", nullptr, "0,8"},
      {"Под шестерню", 2, false, "45n6", "0,15", nullptr, nullptr, "0,8"},
      {"Цапфа", 4, true, "48h6", "0,2", nullptr, "8", "0,8"},
      {"Подшипник справа", 5, false, "40k6", "0,15", "5", nullptr, "0,8"}}},
    {"pump",
     "Вал насоса",
     nullptr,
     {{"24", "32"}, {"22", "35"}, {"8", "44"}, {"50", "38"}, {"130", "36"}, {"22", "35"}},
     {{"Под полумуфту", 0, false, "32k6", "0,15", nullptr, nullptr, "1,6", "10P9 × 18"},
      {"Подшипник у муфты", 1, false, "35k6", "0,15", "5", nullptr, "0,8"},
      {"Под рабочее колесо", 3, false, "38h6", "0,15", nullptr, nullptr, "0,8"},
      {"Под уплотнение", 4, true, "36g6", "0,2", nullptr, "8", "0,8"},
      {"Подшипник у торца", 5, false, "35k6", "0,15", "5", nullptr, "0,8"}}},
    {"sleeve", // the wheel of the first bore goes into all
     "Гильза",
     "3К227",
     {{"35", "60"}, {"28", "62"}, {"30", "65"}, {"34", "70"}, {"25", "80"}},
     {{"Под ступицу", 0, false, "60H7", "0,15", nullptr, nullptr, "0,8", "18P9 × 35"},
      {"Подшипник слева", 1, false, "62H7", "0,15", "6", nullptr, "0,8"},
      {"Под манжету", 2, false, "65H8", "0,2", nullptr, nullptr, "1,6"},
      {"Подшипник справа", 3, false, "70H7", "0,15", "6", nullptr, "0,8"},
      {"Под крышку", 4, false, "80H7", "0,2", nullptr, nullptr, "1,6"}}}};

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
    [[nodiscard]] QStringList cells() const; ///< of the table, by heads()
    [[nodiscard]] QString fault() const;     ///< why a shop would not run it; empty: it would
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

QStringList heads() {
    return {QStringLiteral("surface"),   QStringLiteral("cycle"),
            QStringLiteral("T, s"),      QStringLiteral("feeds, mm/min × stock, mm"),
            QStringLiteral("spark-out"), QStringLiteral("Ra, µm"),
            QStringLiteral("form, µm"),  QStringLiteral("runout, µm"),
            QStringLiteral("Ppk"),       QStringLiteral("bad"),
            QStringLiteral("state")};
}

QStringList Offered::cells() const {
    if (!outcome->ran() || !judgement.batch) {
        return {QStringLiteral("not judged")};
    }
    const auto number = [](double value, int digits) {
        return QString::number(value, 'f', digits);
    };
    const SimulationResult& result = outcome->result;
    const std::vector<Stage>& stages = project.cycle->stages;
    QStringList feeds;
    for (std::size_t i = 0; i <= finish(); ++i) {
        feeds += number(feed_mm_min(i), 3) + QStringLiteral(" × ") + number(stages[i].stock_mm, 3);
        if (project.operation->travels) {
            feeds.back() += QStringLiteral(" (S_t %1 µm, S_ax %2)")
                                .arg(number(stages[i].radial_feed_mm.value_or(0) * 1000, 1),
                                     number(stages[i].axial_feed_mm_min.value_or(0), 0));
        }
    }
    const QString sparkOut = stages.back().feeds()
                                 ? QStringLiteral("none")
                                 : QStringLiteral("%1 (%2 s)")
                                       .arg(result.countsByStage.back())
                                       .arg(number(result.timeByStage_s.back(), 1));
    double runout_mm = 0;
    for (const SectionResult& section : result.sections) {
        runout_mm = std::max(runout_mm, section.radialRunout_mm);
    }
    QStringList roughness, form;
    for (const ConstraintResult& each : worstByKind(outcome->constraints)) {
        if (each.kind == ConstraintKind::roughness) {
            roughness +=
                number(each.value, 2) + u'…' + number(each.mostValue.value_or(each.value), 2);
        } else if (each.kind == ConstraintKind::roundness
                   || each.kind == ConstraintKind::cylindricity) {
            form +=
                QString::fromLatin1(requirementOf(each.kind).key) + u' ' + number(each.value, 2);
        }
    }
    return {number(time_s(), 1),
            feeds.join(QStringLiteral("; ")),
            sparkOut,
            roughness.join(u' '),
            form.join(QStringLiteral(", ")),
            number(runout_mm * 1000, 2),
            leastPpk ? number(*leastPpk, 2) : QString(),
            QStringLiteral("%1 of %2").arg(judgement.batch->bad).arg(judgement.batch->parts),
            QString::fromLatin1(stateKey(judgement.state))};
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
    explicit Workplace(const Drawing& of) : Bench(QStringLiteral("ru")), drawing(of) {
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
        takePicture(shown, picture);
    }
    /// The path of what is kept of this drawing; empty: nothing is kept.
    [[nodiscard]] QString keptAs(const QString& name) const {
        const QString folder = qEnvironmentVariable("SPARKOUT_HOUR_PICTURES");
        return folder.isEmpty() ? QString()
                                : folder + u'/' + QLatin1StringView(drawing.key) + u'-' + name;
    }
    void takePicture(QWidget& of, const QString& name) {
        const QString path = keptAs(name + QStringLiteral(".png"));
        hand.check(path.isEmpty() || of.grab().save(path), QStringLiteral("no picture ") + path);
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
        activate(*window); // as a window manager does
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
            typeInto("/part/length_mm", drawing.steps[drawn.step].length_mm);
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
        if (drawn.keyway) {
            hand.click(window->findChild<QLineEdit*>(QStringLiteral("keywayField")));
            hand.type(QString::fromUtf8(drawn.keyway));
            hand.key(Qt::Key_Return);
            calm();
        }
        const Document& document = window->document();
        hand.check(document.openInputs().empty() && window->studies().outcome->ran(),
                   QStringLiteral("not run: ") + QString::fromUtf8(drawn.name));
        hand.check(document.project().part->gaps.empty() == !drawn.keyway,
                   QStringLiteral("the keyway: ") + QString::fromUtf8(drawn.name));
    }
    /// From the size of a new project on, and back to it.
    void chooseInternalGrinder() {
        hand.tabTo(QStringLiteral("/part/surface"), Qt::ShiftModifier);
        hand.key(Qt::Key_Down);
        showPage(machinePage);
        const FormPage& page = *window->inputs().pages().at(machinePage);
        inDialog([&] { hand.click(page.findChild<QPushButton*>(QStringLiteral("fromCatalogue"))); },
                 [&](QDialog&) { hand.type(QString::fromUtf8(drawing.internalGrinder)); });
        showPage(partPage);
        hand.click(window->findChild<QLineEdit*>(QStringLiteral("sizeField")));
        hand.key(Qt::Key_A, Qt::ControlModifier);
        const Project& project = window->document().project();
        hand.check(project.part->surface == Surface::internal
                       && project.machine->name == drawing.internalGrinder,
                   QStringLiteral("not on the internal grinder"));
    }
    /// The first step is there with the first surface.
    void typeSteps() {
        auto* view = window->findChild<QTableView*>(QStringLiteral("/part/shaft/segments"));
        hand.click(toolsOf(*view->parentWidget()).front()); // adds one
        for (std::size_t i = 1; i < drawing.steps.size(); ++i) {
            if (i > 1) {
                hand.key(Qt::Key_Insert);
                hand.key(Qt::Key_Left);
            }
            hand.type(QString::fromLatin1(drawing.steps[i].length_mm));
            hand.key(Qt::Key_Tab);
            hand.type(QString::fromLatin1(drawing.steps[i].diameter_mm));
            hand.key(Qt::Key_Return);
            settle();
        }
    }
    void addSurface(const Drawn& drawn) {
        auto& strip = *window->findChild<PartStrip*>();
        const bool isOnStep = strip.isVisible() && !drawing.internalGrinder;
        PartDrawing& part = strip.drawing();
        const auto open = [&] {
            if (!isOnStep) {
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
            takePicture(dialog, QStringLiteral("add"));
        });
        calm();
        // A step of the shaft has its diameter, and the tolerance class is typed; a bore has none.
        const bool isSized = !window->document().isOpen("/part/diameter_mm");
        const QString first = QString::fromLatin1(isSized ? "sizeField" : "/part/diameter_mm");
        hand.check(QApplication::focusWidget()
                       && QApplication::focusWidget()->objectName() == first,
                   QStringLiteral("the size of a new surface is not asked for first"));
        hand.type(QString::fromLatin1(drawn.size));
        typeDrawing(drawn);
    }

    const Drawing& drawing;
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
    void fiveSurfacesFromTheirDrawing_data() {
        QTest::addColumn<int>("row");
        const std::size_t count = qEnvironmentVariableIsSet("SPARKOUT_LONG") ? drawings.size() : 1;
        for (std::size_t i = 0; i < count; ++i) {
            QTest::newRow(drawings[i].key) << int(i);
        }
    }
    void fiveSurfacesFromTheirDrawing() {
        QFETCH(int, row);
        const Drawing& drawing = drawings.at(std::size_t(row));
        const std::vector<Drawn>& surfaces = drawing.surfaces;
        Workplace place(drawing);
        Hand& hand = place.hand;
        const QTemporaryDir folder; // where he keeps his files
        place.settings.setLastFolder(folder.path());
        place.choose("newPlunge");
        place.endStage(QStringLiteral("1-new"));

        if (drawing.internalGrinder) {
            place.chooseInternalGrinder();
        }
        hand.type(QString::fromLatin1(surfaces[0].size));
        place.typeDrawing(surfaces[0]);
        if (!drawing.internalGrinder) {
            place.typeSteps();
        }
        hand.click(place.window->findChild<QLineEdit*>(QStringLiteral("/part/name")));
        hand.type(QString::fromUtf8(drawing.part));
        hand.key(Qt::Key_Return);
        place.endStage(QStringLiteral("2-first-drawing"));
        place.showPage(cyclePage);
        place.endStage(QStringLiteral("3-first-cycle"));
        for (std::size_t i = 1; i < surfaces.size(); ++i) {
            place.addSurface(surfaces[i]);
            place.endStage(QStringLiteral("4-drawing-%1").arg(i + 1));
            place.showPage(cyclePage);
            place.endStage(QStringLiteral("5-cycle-%1").arg(i + 1));
        }
        auto& tabs = place.window->findChild<PartStrip*>()->tabs();
        hand.clickAt(tabs, tabs.tabRect(0).center());
        place.inDialog([&] { place.choose("renameSurface"); },
                       [&](QDialog&) { hand.type(QString::fromUtf8(surfaces[0].name)); });
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
        for (const QString& paper : papers) {
            if (const QString path = place.keptAs(paper); !path.isEmpty()) {
                QFile::copy(folder.filePath(paper), path);
            }
        }
        const double wall_s = double(place.time.elapsed()) / 1000;
        qInfo("HOUR %s: %d clicks, %d keys, %d turns of the wheel, %.1f s, searches %.1f s of it; "
              "a person with the searches %.0f s",
              drawing.key, hand.clicks(), hand.keys(), hand.turns(), wall_s, searched_s,
              hand.person_s() + searched_s);

        QStringList faults;
        const auto print = [](const QStringList& cells) {
            qInfo().noquote() << QStringLiteral("HOUR | ") + cells.join(QStringLiteral(" | "));
        };
        print(heads());
        const std::vector<Offered> before = judgedAll(started), after = judgedAll(found);
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const QString name = QString::fromStdString(found.surfaces[i].name);
            for (const auto& [cycle, offered] :
                 {std::pair("starting", &before[i]), std::pair("optimum", &after[i])}) {
                const QString of = QString::fromLatin1(cycle);
                print(QStringList{name, of} + offered->cells());
                if (const QString fault = offered->fault(); !fault.isEmpty()) {
                    faults += QStringLiteral("%1, %2: %3").arg(name, of, fault);
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
};

} // namespace sparkout::test_technologist

SPARKOUT_TEST(test_technologist, TestTechnologist)
#include "test_technologist.moc"
