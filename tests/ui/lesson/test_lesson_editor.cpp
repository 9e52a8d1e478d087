// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// A teacher makes a laboratory work in the window, by mouse and keys, tries it and saves it; what
// the editor does not show is kept as it is.
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "tests/registry.h"
#include "tests/ui/lesson/lesson_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/text_checks.h"
#include "ui/kit/font_size.h"
#include "ui/lesson/lesson_editor.h"
#include "ui/lesson/lessons_dialog.h"
#include "ui/lesson/variant_check_dialog.h"

#include <QGroupBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QTabWidget>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTreeWidget>

#include <nlohmann/json.hpp>

namespace test_lesson_editor {

using namespace lesson_bench;

namespace {

std::string contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// A window with an example, and the editor that is opened from its menu.
struct Desk {
    explicit Desk(const QString& language = QStringLiteral("en")) : bench(language) {
        bench.settings.setLastFolder(folder.path());
        QVERIFY(bench.open(examplePaths().constFirst()));
        bench.action("editLesson")->trigger();
        editor = bench.window->findChild<LessonEditor*>();
        QVERIFY(editor && editor->isVisible());
        bench.settle();
    }
    ~Desk() { editor->draft().history().setClean(); }

    template <typename Widget>
    [[nodiscard]] Widget* part(const QString& name) const {
        auto* found = editor->findChild<Widget*>(name);
        if (!found) {
            qWarning("no %s", qPrintable(name));
        }
        return found;
    }
    void press(const char* name) const {
        QTest::mouseClick(part<QPushButton>(QString::fromLatin1(name)), Qt::LeftButton);
        QTest::qWait(1); // what was left goes
    }
    void type(const char* name, const QString& text) const {
        auto* box = part<QWidget>(QString::fromLatin1(name));
        box->setFocus();
        QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
        for (const QChar letter : text) { // of any alphabet
            QTest::sendKeyEvent(QTest::Click, box, Qt::Key_unknown, QString(letter),
                                Qt::NoModifier);
        }
    }
    void choose(const char* name, const QString& text) const {
        auto* combo = part<QComboBox>(QString::fromLatin1(name));
        const int index = combo->findText(text);
        QVERIFY2(index >= 0, qPrintable(text));
        combo->setFocus();
        while (combo->currentIndex() != index) {
            const int before = combo->currentIndex();
            QTest::keyClick(combo, before < index ? Qt::Key_Down : Qt::Key_Up);
            combo = part<QComboBox>(QString::fromLatin1(name)); // it may have been made anew
            QVERIFY(combo->currentIndex() != before);
        }
    }
    /// One of a long list, by what is typed of its name.
    void find(const char* name, const QString& text) const {
        auto* combo = part<QComboBox>(QString::fromLatin1(name));
        combo->setFocus();
        QTest::keyClick(combo, Qt::Key_F4);
        auto* search = combo->findChild<QLineEdit*>(QStringLiteral("search"));
        QTest::keyClicks(search, text);
        QTest::keyClick(search, Qt::Key_Return);
        QTest::qWait(1);
    }
    void tab(int index) const {
        part<QTabWidget>(QStringLiteral("editPage"))->setCurrentIndex(index);
    }
    [[nodiscard]] QStringList faults() const {
        QTest::qWait(400); // after a pause in typing
        QStringList lines;
        const auto* list = part<QListWidget>(QStringLiteral("editFaults"));
        for (int i = 0; i < list->count(); ++i) {
            lines += list->item(i)->text();
        }
        return lines;
    }
    [[nodiscard]] const Lesson& lesson() const { return editor->draft().lesson(); }

    QTemporaryDir folder;
    Bench bench;
    LessonEditor* editor = nullptr;
};

enum Tab { task, inputs, values, hidden, goal, hints, moment };
constexpr int variants = 1; // of the work as a whole

} // namespace

class TestLessonEditor : public QObject {
    Q_OBJECT

private slots:
    void whatIsNotChangedIsKept() {
        const Desk desk;
        for (const QString& path : LessonsDialog::paths()) {
            const std::string before = contentOf(path);
            QVERIFY2(desk.editor->openLesson(path), qPrintable(path));
            auto* pages = desk.part<QListWidget>(QStringLiteral("editPages"));
            QCOMPARE(pages->count(), int(desk.lesson().steps.size()) + 1);
            const bool isWhole = path == LessonsDialog::paths()[6]; // all of its pages and tabs
            for (int page = 0; page < (isWhole ? pages->count() : 2); ++page) {
                pages->setCurrentRow(page);
                auto* tabs = desk.part<QTabWidget>(QStringLiteral("editPage"));
                for (int i = 0; i < tabs->count(); ++i) {
                    tabs->setCurrentIndex(i);
                }
            }
            QVERIFY(!desk.editor->draft().isChanged());
            QCOMPARE(desk.editor->draft().text(), before);
            // One thing is changed: that alone is another one.
            pages->setCurrentRow(0);
            desk.type("/title/en", QStringLiteral("Another title"));
            nlohmann::json wanted = nlohmann::json::parse(before);
            wanted["title"]["en"] = "Another title";
            QCOMPARE(nlohmann::json::parse(desk.editor->draft().text()), wanted);
            while (desk.editor->draft().history().canUndo()) {
                desk.press("editUndo");
            }
            QCOMPARE(desk.editor->draft().text(), before);
        }
    }

    void theVariantsAreRuled() {
        const Desk desk;
        QVERIFY(desk.editor->openLesson(LessonsDialog::paths()[1]));
        const std::string before = desk.editor->draft().text();
        desk.tab(variants);
        const auto shown = [&](const char* name) {
            return desk.part<QLabel>(QString::fromLatin1(name))->text();
        };
        QCOMPARE(shown("/variants/inputs/0/levels"), QStringLiteral("Levels: 9"));
        QCOMPARE(shown("/variants/inputs/count"), QStringLiteral("Total variants: 2592"));
        // A range of another input, chosen by its name; it begins with the value of the project.
        desk.press("/variants/inputs/add");
        QCOMPARE(desk.faults().size(), 1);
        desk.find("/variants/inputs/4/path", QStringLiteral("part ground length"));
        const double length_mm = desk.lesson().base.surfaces.front().project.part->length_mm;
        QCOMPARE(desk.lesson().variants->inputs[4].from, std::optional(length_mm));
        const QString hint =
            desk.part<QLineEdit>(QStringLiteral("/variants/inputs/4/from"))->toolTip();
        QVERIFY2(hint.contains(QStringLiteral("Allowed")) && hint.contains(QStringLiteral("mm")),
                 qPrintable(hint));
        desk.type("/variants/inputs/4/from", QStringLiteral("90"));
        desk.type("/variants/inputs/4/to", QStringLiteral("100"));
        desk.type("/variants/inputs/4/step", QStringLiteral("2"));
        QCOMPARE(shown("/variants/inputs/4/levels"), QStringLiteral("Levels: 6"));
        QCOMPARE(shown("/variants/inputs/count"), QStringLiteral("Total variants: 15552"));
        desk.press("/variants/inputs/4/up");
        nlohmann::json wanted = nlohmann::json::parse(before);
        auto& inputs = wanted["variants"]["inputs"];
        inputs.push_back(inputs[3]);
        inputs[3] = {{"path", "/part/length_mm"}, {"from", 90}, {"to", 100}, {"step", 2}};
        desk.type("/variants/difficulty/least_time_percent", QStringLiteral("60"));
        wanted["variants"]["difficulty"]["least_time_percent"] = 60;
        // A bound of a figure, in a step by its name.
        desk.press("/variants/figures/add");
        desk.choose("/variants/figures/0/step", QStringLiteral("2. Number predicted"));
        desk.type("/variants/figures/0/most", QStringLiteral("3"));
        wanted["variants"]["figures"].push_back(
            {{"figure", {{"name", "cycle_time_min"}}}, {"step", 2}, {"most", 3}});
        const QString path = desk.folder.filePath(QStringLiteral("ruled.sparkout-lesson"));
        DialogAnswers saved({QStringLiteral("file:") + path});
        desk.press("editSaveAs");
        QCOMPARE(saved.fault(), QString());
        QCOMPARE(nlohmann::json::parse(contentOf(path)), wanted);
        QVERIFY(readLesson(contentOf(path)).lesson.has_value());
        // What the input does not take is named and not taken.
        desk.type("/variants/inputs/3/from", QStringLiteral("-5"));
        QStringList faults = desk.faults();
        QVERIFY2(faults[0].startsWith(QStringLiteral("Variants › Varied input 4 › From: out of")),
                 qPrintable(faults[0]));
        QCOMPARE(desk.lesson().variants->inputs[3].from, std::optional(90.0));
        desk.type("/variants/inputs/3/from", QStringLiteral("90"));
        desk.choose("/variants/inputs/1/by", QStringLiteral("a list of values"));
        desk.type("/variants/inputs/1/list", QStringLiteral("0.012; 0.014; -7"));
        faults = desk.faults();
        QVERIFY2(faults[0].startsWith(QStringLiteral("Variants › Varied input 2 › List: −7; ")),
                 qPrintable(faults[0]));
        while (desk.editor->draft().history().canUndo()) {
            desk.press("editUndo");
        }
        QCOMPARE(desk.editor->draft().text(), before);
        // None at all, and the least that there can be.
        auto* rules = desk.part<QGroupBox>(QStringLiteral("/variants"));
        rules->setFocus();
        QTest::keyClick(rules, Qt::Key_Space);
        QVERIFY(!desk.lesson().variants && desk.editor->draft().faults().empty());
        QVERIFY(!desk.part<QPushButton>(QStringLiteral("checkVariants"))->isEnabled());
        QTest::keyClick(desk.part<QGroupBox>(QStringLiteral("/variants")), Qt::Key_Space);
        QCOMPARE(desk.lesson().variants->inputs.size(), std::size_t(1));
        desk.tab(0);
        QCOMPARE(desk.faults().size(), 1);
        auto* list = desk.part<QListWidget>(QStringLiteral("editFaults"));
        list->setFocus();
        list->setCurrentRow(0);
        QTest::keyClick(list, Qt::Key_Return);
        QCOMPARE(desk.part<QTabWidget>(QStringLiteral("editPage"))->currentIndex(), int(variants));
        QCOMPARE(desk.editor->focusWidget()->objectName(), QStringLiteral("/variants/inputs/0/by"));
    }

    void rangeListAndSetsTurnIntoEachOther() {
        const Desk desk;
        QVERIFY(desk.editor->openLesson(LessonsDialog::paths()[0]));
        desk.tab(variants);
        const auto input = [&] { return desk.lesson().variants->inputs[0]; };
        desk.choose("/variants/inputs/0/by", QStringLiteral("a list of values"));
        QCOMPARE(input().list->size(), std::size_t(8));
        QCOMPARE(input().list->at(7), 0.028);
        desk.choose("/variants/inputs/0/by", QStringLiteral("named sets of values"));
        QCOMPARE(input().sets.size(), std::size_t(8));
        QCOMPARE(input().sets[1].name, std::string("0.016"));
        QCOMPARE(input().sets[1].values, (std::vector<InputValue>{{"/wheel/dullness", 0.016, {}}}));
        // A value more in a set, as its input takes it: a name, then a choice.
        desk.press("/variants/inputs/0/sets/1/values/add");
        const char* const more = "/variants/inputs/0/sets/1/values/1/path";
        desk.find(more, QStringLiteral("material grade"));
        desk.type("/variants/inputs/0/sets/1/values/1/text", QStringLiteral("45"));
        QCOMPARE(input().sets[1].values[1], (InputValue{"/material/grade", {}, "45"}));
        desk.find(more, QStringLiteral("gauge stages switch"));
        const InputValue chosen = input().sets[1].values[1];
        QVERIFY2(!chosen.number && !chosen.text.empty(), chosen.path.c_str());
        QVERIFY(desk.part<QComboBox>(QStringLiteral("/variants/inputs/0/sets/1/values/1/text")));
        desk.press("/variants/inputs/0/sets/1/values/1/remove");
        desk.choose("/variants/inputs/0/by", QStringLiteral("a range in steps"));
        QCOMPARE(input().from, std::optional(0.014));
        QCOMPARE(input().to, std::optional(0.028));
        QVERIFY(!input().step); // a list may have any
    }

    void someVariantsAreMadeToBeLookedAt() {
        const Desk desk;
        QVERIFY(desk.editor->openLesson(LessonsDialog::paths()[1]));
        desk.tab(variants);
        DialogAnswers looked({QStringLiteral("checkStop"), QStringLiteral("Escape")});
        desk.press("checkVariants");
        QCOMPARE(looked.fault(), QString());
        QVERIFY(!desk.editor->draft().isChanged());
        // Every try with what was drawn; what is refused, with the reason.
        Lesson lesson = samples::lesson();
        lesson.steps.resize(3); // nothing is searched
        VariedInput& few = lesson.variants->inputs.front();
        few = {few.path, {}, {}, {}, std::vector{0.016, 0.018, 0.02, 0.022, 0.024}, {}};
        lesson.variants->inputs.resize(1);
        const MadeVariants made = makeVariants(lesson, 5, LessonDesk::seedByNumber);
        QVERIFY(made.variants.size() == 5 && made.tries > 5); // some were drawn twice
        VariantCheckDialog dialog(lesson, desk.editor);
        dialog.show();
        QVERIFY(QTest::qWaitFor([&] { return !dialog.isBusy(); }, 60'000));
        auto* table = dialog.findChild<QTableWidget*>();
        QCOMPARE(table->rowCount(), int(made.tries));
        std::size_t found = 0;
        for (int row = 0; row < table->rowCount(); ++row) {
            const auto cell = [&](int column) { return table->item(row, column)->text(); };
            if (!cell(4).isEmpty()) {
                QCOMPARE(cell(4), QStringLiteral("another variant has the same inputs"));
                QVERIFY(cell(0) != QString::number(found));
                continue;
            }
            const VariantLevels& levels = made.variants[found++].levels;
            QCOMPARE(cell(0), QString::number(found));
            for (std::size_t i = 0; i < levels.size(); ++i) {
                QCOMPARE(cell(int(i) + 1).toStdString(),
                         lesson.variants->inputs[i].nameOf(levels[i]));
            }
        }
        QCOMPARE(found, made.variants.size());
    }

    void theTeacherPrintsTheWorksPapers() {
        const Desk desk;
        const auto paper = [&](const char* command, const QString& answer) {
            DialogAnswers answers({answer});
            desk.editor->findChild<QAction*>(QString::fromLatin1(command))->trigger();
            return answers.fault();
        };
        QVERIFY(
            desk.editor->openLesson(LessonsDialog::paths()[3])); // its time follows from the best
        for (const auto& [command, title] :
             {std::pair("markdown-worksheet", "# Worksheet"),
              std::pair("markdown-worksheet-key", "# Key to the worksheet"),
              std::pair("markdown-guide", "# Teaching guide")}) {
            const QString path =
                desk.folder.filePath(QString::fromLatin1(command) + QStringLiteral(".md"));
            QCOMPARE(paper(command, QStringLiteral("file:") + path), QString());
            const std::string text = contentOf(path);
            QVERIFY2(text.starts_with(title), text.substr(0, 200).c_str());
        }
        desk.type("/title/ru", QString());
        desk.type("/title/en", QString());
        QCOMPARE(paper("markdown-guide", QStringLiteral("Escape")), QString()); // it has a fault
    }

    void aWorkIsMadeTriedAndSaved() {
        const Desk desk;
        MainWindow& window = *desk.bench.window;
        desk.type("/title/ru", QStringLiteral("Работа 11"));
        desk.type("/title/en", QStringLiteral("Work 11"));
        desk.type("/theory/en", QStringLiteral("<p class=\"formula\"><i>a = b</i></p>"));
        QVERIFY(desk.part<QTextBrowser>(QStringLiteral("lessonPreview"))
                    ->toPlainText()
                    .contains(QStringLiteral("a = b")));
        // The first step: the wheel's dullness is free, three requirements hold.
        desk.part<QListWidget>(QStringLiteral("editPages"))->setCurrentRow(1);
        QVERIFY(desk.faults().join(u'\n').contains(QStringLiteral("Step 1 › Task")));
        desk.type("/steps/0/task/en", QStringLiteral("Bring the cycle below the time."));
        desk.tab(inputs);
        desk.type("inputSearch", QStringLiteral("dullness"));
        auto* tree = desk.part<QTreeWidget>(QStringLiteral("inputTree"));
        const auto found =
            tree->findItems(QStringLiteral("dullness"), Qt::MatchContains | Qt::MatchRecursive);
        QVERIFY(!found.empty() && !found.first()->isHidden());
        tree->setCurrentItem(found.first());
        desk.choose("inputAccess", QStringLiteral("changed by the student"));
        QCOMPARE(desk.lesson().steps[0].inputs.size(), std::size_t(1));
        QVERIFY(desk.lesson().steps[0].inputs[0].path.find("dullness") != std::string::npos);
        desk.press("editUndo");
        QVERIFY(desk.lesson().steps[0].inputs.empty());
        desk.press("editRedo");
        desk.choose("/steps/0/others", QStringLiteral("changed by the student"));
        QCOMPARE(desk.lesson().steps[0].others, Access::free);
        desk.press("editUndo");
        QCOMPARE(desk.lesson().steps[0].others, Access::locked);
        desk.tab(hidden);
        auto* things = desk.part<QListWidget>(QStringLiteral("hiddenThings"));
        things->setFocus();
        things->setCurrentRow(int(Hideable::optimise));
        QTest::keyClick(things, Qt::Key_Space);
        QCOMPARE(desk.lesson().steps[0].hidden, std::vector{HiddenThing{Hideable::optimise}});
        desk.tab(goal);
        desk.choose("/steps/0/goal/kind", QStringLiteral("Quick enough"));
        QVERIFY(desk.faults().join(u'\n').contains(QStringLiteral("Below")));
        desk.type("/steps/0/goal/time/below_min", QStringLiteral("1000"));
        QTest::mouseClick(
            desk.part<QCheckBox>(QStringLiteral("/steps/0/goal/time/requirements_hold")),
            Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(desk.lesson().steps[0].goal.time->below_min, std::optional(1000.0));
        QVERIFY(!desk.lesson().steps[0].goal.time->requirements_hold);
        desk.tab(hints);
        desk.press("/steps/0/hints/add");
        desk.type("/steps/0/hints/0/text/en", QStringLiteral("Look at the time."));
        desk.type("/steps/0/hints/0/price", QStringLiteral("5"));
        // The price is above the points, which is said by name, value and range.
        const QStringList faults = desk.faults();
        QCOMPARE(faults.size(), 1);
        QVERIFY2(faults[0].contains(QStringLiteral("Price"))
                     && faults[0].contains(QStringLiteral("5")) && faults[0].contains(u'1'),
                 qPrintable(faults[0]));
        desk.type("/steps/0/hints/0/price", QStringLiteral("0.5"));
        // Another step, after the first; then before it.
        desk.press("stepAdd");
        desk.type("/steps/1/task/ru", QStringLiteral("Что тупит круг?"));
        desk.tab(goal);
        desk.choose("/steps/1/goal/kind", QStringLiteral("Choice"));
        desk.type("/steps/1/goal/choice/options/0/text/ru", QStringLiteral("Работа"));
        desk.type("/steps/1/goal/choice/options/1/text/ru", QStringLiteral("Отдых"));
        QTest::mouseClick(
            desk.part<QCheckBox>(QStringLiteral("/steps/1/goal/choice/options/0/right")),
            Qt::LeftButton, {}, QPoint(8, 8));
        desk.press("stepUp");
        QVERIFY(desk.lesson().steps[0].goal.choice && desk.lesson().steps[1].goal.time);
        QCOMPARE(desk.faults().size(), 1);
        QVERIFY2(desk.editor->draft().faults().empty(), qPrintable(desk.faults()[0]));
        // Tried as a student; the editor comes back as it was.
        const std::string before = desk.editor->draft().text();
        desk.part<QListWidget>(QStringLiteral("editPages"))->setCurrentRow(2);
        desk.press("editTry");
        QVERIFY(!desk.editor->isVisible() && window.lesson().isRunning());
        QCOMPARE(window.lesson().run().step(), std::size_t(1));
        QVERIFY(!desk.bench.action("show-optimise")->isVisible());
        QVERIFY(!desk.bench.action("editLesson")->isEnabled());
        QVERIFY(QTest::qWaitFor([&] { return !window.runs().running(); }, 30'000));
        auto* handIn =
            window.lesson().panel().findChild<QPushButton*>(QStringLiteral("lessonHandIn"));
        QTest::mouseClick(handIn, Qt::LeftButton);
        LessonRun& run = window.lesson().run();
        QVERIFY(QTest::qWaitFor([&] { return run.mark(1) != LessonRun::Mark::checked; }, 30'000));
        QCOMPARE(run.mark(1), LessonRun::Mark::passed);
        desk.bench.action("leaveLesson")->trigger();
        QVERIFY(desk.editor->isVisible() && !window.lesson().isRunning());
        QCOMPARE(desk.editor->draft().text(), before);
        QVERIFY(desk.editor->draft().isChanged());
        QVERIFY(
            sameProject(window.document().project(), desk.lesson().base.surfaces.front().project));
        // Saved, it is what is read.
        const QString path = desk.folder.filePath(QStringLiteral("eleven.sparkout-lesson"));
        DialogAnswers saved({QStringLiteral("file:") + path});
        desk.press("editSave");
        QCOMPARE(saved.fault(), QString());
        QVERIFY(!desk.editor->draft().isChanged());
        const ReadLesson read = readLesson(contentOf(path));
        QVERIFY(read.lesson && read.issues.empty());
        QCOMPARE(read.lesson->title.ru, std::string("Работа 11"));
        QCOMPARE(read.lesson->steps[1].hints[0].price, 0.5);
        QCOMPARE(contentOf(path), before);
    }

    void changesAreAskedFor() {
        const Desk desk;
        desk.type("/title/en", QStringLiteral("Work 12"));
        {
            DialogAnswers stay({QStringLiteral("Escape")});
            QTest::keyClick(desk.editor, Qt::Key_Escape);
            QCOMPARE(stay.fault(), QString());
            QVERIFY(stay.text().contains(QStringLiteral("Work 12")));
        }
        QVERIFY(desk.editor->isVisible() && desk.lesson().title.en == "Work 12");
        {
            DialogAnswers close({QStringLiteral("Escape")});
            desk.bench.window->close(); // nor does the window go over it
            QCOMPARE(close.fault(), QString());
        }
        QVERIFY(desk.bench.window->isVisible());
        DialogAnswers leave({QStringLiteral("discardLesson")});
        QTest::keyClick(desk.editor, Qt::Key_Escape);
        QCOMPARE(leave.fault(), QString());
        QVERIFY(!desk.editor->isVisible());
    }

    void itHasRoomInBothLanguages_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("percent");
        QTest::newRow("en 130") << QStringLiteral("en") << 130;
        QTest::newRow("ru 130") << QStringLiteral("ru") << 130;
    }

    void itHasRoomInBothLanguages() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        applyFontSize(percent);
        const Desk desk(language);
        QVERIFY(desk.editor->openLesson(LessonsDialog::paths()[1]));
        const QString pictures = qEnvironmentVariable("SPARKOUT_LESSON_PICTURES");
        for (const int page : {0, 4}) {
            desk.part<QListWidget>(QStringLiteral("editPages"))->setCurrentRow(page);
            auto* tabs = desk.part<QTabWidget>(QStringLiteral("editPage"));
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                desk.bench.settle();
                if (!pictures.isEmpty()) {
                    desk.editor->grab().save(QStringLiteral("%1/editor-%2-%3-%4-%5.png")
                                                 .arg(pictures, language)
                                                 .arg(percent)
                                                 .arg(page)
                                                 .arg(i));
                }
                const QStringList cut = textsWithoutRoom(*desk.editor);
                QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
            }
        }
        QVERIFY(desk.editor->width() <= 1366 && desk.editor->height() <= 728);
        if (language == u"ru") {
            QStringList written; // by the lesson's author
            for (const auto* box : desk.editor->findChildren<QPlainTextEdit*>()) {
                written += box->toPlainText();
            }
            for (const ShownText& shown : textsOf(*desk.editor)) {
                static const QRegularExpression code(QStringLiteral("`[^`]*`"));
                const QString words = QString(shown.text).remove(code);
                QVERIFY2(written.contains(shown.text) || englishIn(words).isEmpty(),
                         qPrintable(shown.text));
            }
        }
    }
};

} // namespace test_lesson_editor

SPARKOUT_TEST(test_lesson_editor, TestLessonEditor)
#include "test_lesson_editor.moc"
