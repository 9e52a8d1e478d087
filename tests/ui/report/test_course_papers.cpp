// SPDX-License-Identifier: GPL-3.0-or-later
// The papers of the course: their sections, their numbers held against the engine, what no student
// may find in them, and their pages.
#include "core/process/force.h"
#include "tests/registry.h"
#include "tests/ui/report/course_bench.h"
#include "tests/ui/report/handout_bench.h"
#include "ui/report/format/formula_writer.h"
#include "ui/report/lesson_markup.h"
#include "ui/text/names.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sparkout::test_course_papers {

using namespace course_bench;
using report::Blank;
using report::Formula;
using report::Pages;
using report::Paragraph;
using report::Table;
using Box = Pages::Box;

/// A4 within the margins of each style [tenths of a point].
QSizeF areaOf(const Report& report) {
    return report.style == report::PageStyle::standard ? QSizeF(4677, 7569) : QSizeF(5100, 7740);
}

std::map<QString, Formula> formulasByLabel(const Report& report) {
    std::map<QString, Formula> formulas;
    for (const report::Block& block : report.blocks) {
        if (const auto* formula = std::get_if<Formula>(&block)) {
            formulas.emplace(formula->label, *formula);
        }
    }
    return formulas;
}

/// The number that an equation ends with, without its unit.
QString resultOf(const Formula& formula) {
    return inOneLine(formula.sides.back()).section(QChar::Nbsp, 0, 0);
}

/// A text by its letters: without spaces and the marks of indices.
QString bare(QString text) {
    return text.remove(u' ').remove(u'\u00a0').remove(u'_');
}

bool hasNumber(const QString& text, const QString& number) {
    const QRegularExpression whole(QStringLiteral("(?<![0-9.,])%1(?![0-9]|[.,][0-9])")
                                       .arg(QRegularExpression::escape(number)));
    return text.contains(whole);
}

class TestCoursePapers : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void theReportHasItsSectionsInOrder_data() { addLessons(); }
    void theReportHasItsSectionsInOrder() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const bool ru = language == u"ru";
        const Report made = report::labReport(finished(lessonIn(path)), wish());
        const auto* title = std::get_if<report::TitlePage>(&made.blocks.front());
        QVERIFY(title && std::holds_alternative<report::Contents>(made.blocks[1]));
        QCOMPARE(title->above.size(), 3);
        QVERIFY(title->people.front().second.contains(QStringLiteral("Иванов Пётр")));
        QVERIFY(title->people.back().second.contains(QStringLiteral("доцент Петров")));
        QVERIFY(title->title.last().endsWith(u'7'));
        QCOMPARE(title->below, QStringLiteral("Челябинск 2026"));
        QStringList sections;
        for (const QString& heading : headingsOf(made)) {
            static const QRegularExpression below(QStringLiteral("^\\d+\\.\\d+ "));
            if (!heading.contains(below)) {
                sections << heading;
            }
        }
        QStringList wanted =
            ru ? QStringLiteral("Введение|Исходные данные варианта|Краткая теория|"
                                "Результаты работы|Предсказания и результаты|"
                                "Сравнение запомненных расчётов|Заключение|"
                                "Список использованных источников")
                     .split(u'|')
               : QStringLiteral("Introduction|Data of the variant|Theory in brief|"
                                "Results of the work|"
                                "Predictions and results|Kept runs compared|Conclusion|"
                                "List of sources used")
                     .split(u'|');
        const auto steps = lessonIn(path).steps;
        if (std::ranges::none_of(steps,
                                 [](const LessonStep& step) { return isPrediction(step.goal); })) {
            wanted.removeAt(4);
        }
        for (qsizetype i = 1; i + 2 < wanted.size(); ++i) {
            wanted[i].prepend(QStringLiteral("%1 ").arg(i));
        }
        QCOMPARE(sections, wanted);
        int tables = 0, figures = 0;
        for (const report::Block& block : made.blocks) {
            QVERIFY(!std::holds_alternative<Blank>(block)); // nothing is left to write
            if (const auto* table = std::get_if<Table>(&block)) {
                QCOMPARE(table->number, ++tables);
                QVERIFY(!table->caption.isEmpty());
            } else if (const auto* figure = std::get_if<report::Figure>(&block)) {
                const QString number =
                    (ru ? QStringLiteral("Рисунок %1 — ") : QStringLiteral("Figure %1 — "))
                        .arg(++figures);
                QVERIFY2(figure->caption.startsWith(number), qPrintable(figure->caption));
            }
        }
        for (const QString& cell : cellsOf(made)) {
            QVERIFY2(!cell.contains(QStringLiteral("__")), qPrintable(cell));
        }
    }

    void itsNumbersAreTheEngines_data() { addLessons(); }
    void itsNumbersAreTheEngines() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const Work work = finished(lessonIn(path));
        const Report made = report::labReport(work, wish());
        const QStringList cells = cellsOf(made);
        int compared = 0;
        for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
            const Goal& goal = work.lesson.steps[i].goal;
            if (!isAnsweredByEngine(goal.kind())) {
                continue;
            }
            const GoalResult engine = checkStep(work.lesson, i, {});
            const int digits = rowOf(goal.asked()->name).digits;
            if (goal.prediction) {
                QVERIFY(cells.contains(Names::fixed(*engine.value, digits)));
                ++compared;
            }
            for (const ComparedPoint& point : engine.curve) {
                QVERIFY(cells.contains(Names::fixed(point.value, digits)));
                ++compared;
            }
        }
        QVERIFY(compared > 0);
        // The run that was kept says what it came to, by the engine now.
        const KeptRun& kept = *work.entries.back().run;
        const auto project = readSetup(kept.inputs.text).setup->surfaces.front().project;
        const OutcomePtr outcome = evaluate(project, {});
        const double time_s = outcome->result.time_s;
        QVERIFY(std::ranges::any_of(cells, [time_s](QString cell) {
            bool isNumber = false;
            const double shown = cell.replace(u',', u'.').toDouble(&isNumber);
            const qsizetype point = cell.indexOf(u'.');
            const auto digits = static_cast<double>(point < 0 ? 0 : cell.size() - point - 1);
            const auto isShown = [&](double time) {
                return std::abs(shown - time) <= 0.5001 * std::pow(10, -digits);
            };
            return isNumber && (isShown(time_s) || isShown(time_s / 60));
        }));
    }

    void noResultStandsBesideAnOpenPrediction_data() { addLessons(); }
    void noResultStandsBesideAnOpenPrediction() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const Lesson lesson = lessonIn(path);
        Work work = givenOut(lesson);
        std::size_t open = work.lesson.steps.size();
        for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
            if (isPrediction(work.lesson.steps[i].goal)) {
                open = i; // the last one
            }
        }
        if (open == work.lesson.steps.size()) {
            return; // it predicts nothing
        }
        for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
            if (i != open) {
                handIn(work, i);
            }
        }
        const Report without = report::labReport(work, wish());
        int tables = 0;
        for (const report::Block& block : without.blocks) {
            tables += std::holds_alternative<Table>(block) ? 1 : 0;
            QVERIFY(!std::holds_alternative<report::Figure>(block)
                    || std::get<report::Figure>(block).caption.contains(QStringLiteral(" 1 — ")));
        }
        QCOMPARE(tables, 1); // the inputs
        handIn(work, open);
        QVERIFY(cellsOf(report::labReport(work, wish())).size() > cellsOf(without).size());
    }

    void theConclusionIsTheStudents() {
        const Lesson lesson = lessonIn(lessonFiles().front());
        const Report made = report::labReport(finished(lesson), wish());
        QVERIFY(textOf(made).contains(QStringLiteral("Зона с большим числом проходов меньше.")));
        Work work = givenOut(lesson);
        for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
            if (!work.lesson.steps[i].goal.text) {
                handIn(work, i);
            }
        }
        const Report open = report::labReport(work, wish());
        QVERIFY(std::ranges::any_of(open.blocks, [](const report::Block& block) {
            return std::holds_alternative<Blank>(block); // lines to write it on
        }));
    }

    void theWorksheetHasNoAnswer_data() { addLessons(); }
    void theWorksheetHasNoAnswer() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const Lesson lesson = lessonIn(path);
        const Report sheet = report::worksheet(lesson, wish());
        const Report key = report::worksheetKey(lesson, wish());
        checkApart(sheet, key);
        const QString text = textOf(sheet);
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const Goal& goal = lesson.steps[i].goal;
            const QString task = report::LessonMarkup::inOneLine(
                QString::fromStdString(lesson.steps[i].task.in(language == u"ru")));
            QVERIFY2(bare(text).contains(bare(task).left(40)), qPrintable(task));
            if (goal.prediction) {
                const GoalResult engine = checkStep(lesson, i, {});
                const QString answer =
                    Names::fixed(*engine.value, rowOf(goal.prediction->figure.name).digits);
                // One of two digits may stand there as an input.
                QVERIFY2(QString(answer).remove(u'.').remove(u',').size() < 3
                             || !hasNumber(text, answer),
                         qPrintable(answer));
                QVERIFY2(hasNumber(textOf(key), answer), qPrintable(answer));
            }
            if (goal.choice) {
                for (const ChoiceOption& option : goal.choice->options) {
                    const QString name = report::LessonMarkup::inOneLine(
                        QString::fromStdString(option.text.in(language == u"ru")));
                    QVERIFY(text.contains(QStringLiteral("☐ ") + name)); // all alike
                    QCOMPARE(textOf(key).contains(name + u'.'), option.right);
                }
            }
        }
    }

    void theWorksheetOfAProjectHasNoAnswer_data() { handout_bench::addCases(); }
    void theWorksheetOfAProjectHasNoAnswer() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = handout_bench::exampleOutcome(path);
        QVERIFY(outcome && outcome->ran());
        checkApart(report::worksheet(outcome, report::usualStep(), wish()),
                   report::worksheetKey(outcome, report::usualStep(), wish()));
    }

    // Whoever hides an input has its number found by the student.
    void aHiddenInputIsPrintedNowhere() {
        for (const char* language : {"en", "ru"}) {
            m_language.apply(QString::fromLatin1(language));
            Lesson lesson = lessonIn(lessonFiles().front());
            Project& project = lesson.base.surfaces.front().project;
            setDullness(*project.wheel, 0.021371);
            auto& feed = project.cycle->stages.front().*project.operation->radial().value;
            feed = 0.005413;
            lesson.variants.reset();
            for (const auto& [path, value] :
                 {std::pair("/wheel/dullness", 0.021371),
                  std::pair("/cycle/stages/0/radial_feed_mm", 0.005413)}) {
                const QString number =
                    QString::number(value).replace(u'.', QLocale().decimalPoint());
                QVERIFY(hasNumber(textOf(report::worksheet(lesson, wish())), number));
                QVERIFY(hasNumber(textOf(report::labReport(finished(lesson), wish())), number));
                Lesson hiding = lesson;
                hiding.steps.front().inputs.push_back({path, Access::hidden});
                for (const Report& made : {report::worksheet(hiding, wish()),
                                           report::labReport(finished(hiding), wish())}) {
                    QVERIFY2(!hasNumber(textOf(made), number), qPrintable(made.title));
                }
                QVERIFY(hasNumber(textOf(report::methodicalGuide(hiding, wish())), number));
            }
        }
    }

    void theGuideHasItsSectionsInOrder_data() { addLessons(); }
    void theGuideHasItsSectionsInOrder() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const bool ru = language == u"ru";
        const Lesson lesson = lessonIn(path);
        QVERIFY(lesson.guide);
        const Report made = report::methodicalGuide(lesson, wish());
        const QStringList wanted =
            ru ? QStringLiteral("1 Цель работы|2 Теория|3 Оснащение|4 Норма времени и баллы|"
                                "5 Порядок выполнения работы|"
                                "6 Контрольные вопросы с ответами|7 Типичные ошибки|8 Отчёт")
                     .split(u'|')
               : QStringLiteral("1 Aim of the work|2 Theory|3 Equipment needed|"
                                "4 Time norm and points|5 Order of the work|"
                                "6 Control questions with answers|7 Typical mistakes|"
                                "8 The report")
                     .split(u'|');
        QStringList sections;
        for (const QString& heading : headingsOf(made)) {
            if (!heading.section(u' ', 0, 0).contains(u'.')) {
                sections << heading;
            }
        }
        QCOMPARE(sections, wanted);
        const QString text = bare(textOf(made));
        const auto has = [&](const Bilingual& of) {
            const QString plain =
                report::LessonMarkup::inOneLine(QString::fromStdString(of.in(ru)));
            return text.contains(bare(plain.section(u'.', 0, 0).left(30)));
        };
        for (const ControlQuestion& question : lesson.guide->questions) {
            QVERIFY2(has(question.question), question.question.in(ru).c_str());
            QVERIFY2(has(question.answer), question.answer.in(ru).c_str());
        }
        for (const TypicalMistake& mistake : lesson.guide->mistakes) {
            QVERIFY2(has(mistake.text), mistake.text.in(ru).c_str());
        }
        QVERIFY(text.contains(QString::number(lesson.guide->minutes)));
    }

    void everyBoxOfEveryPageHasItsRoom_data() { addLessons(); }
    void everyBoxOfEveryPageHasItsRoom() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        for (const Report& made : allPapers(lessonIn(path))) {
            const QSizeF area = areaOf(made);
            const Pages pages(made, area);
            const std::vector<Box>& boxes = pages.boxes();
            QVERIFY(!boxes.empty());
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const Box& box = boxes[i];
                QVERIFY(box.y >= 0 && box.y + box.height <= area.height());
                if (box.kind == Box::Kind::heading || box.kind == Box::Kind::caption
                    || box.kind == Box::Kind::head) {
                    QVERIFY2(i + 1 < boxes.size() && boxes[i + 1].page == box.page,
                             qPrintable(made.title + QStringLiteral(": ")
                                        + box.cells.front().texts().join(u' ')));
                }
                for (const report::TextBox& cell : box.cells) {
                    const QFontMetricsF metrics(cell.font());
                    for (const QString& line : cell.texts()) {
                        QVERIFY2(metrics.horizontalAdvance(line) <= cell.width() + 1,
                                 qPrintable(line));
                    }
                }
            }
            const QByteArray pdf = bytesOf(made, report::Format::pdf);
            const QString info = reading::told(QStringLiteral("pdfinfo"), {}, pdf);
            QVERIFY2(info.contains(QStringLiteral("(A4)")), qPrintable(info));
            checkOdt(bytesOf(made, report::Format::odt));
            QVERIFY(!textOf(made).isEmpty()); // the web page is well-formed
        }
    }

    void theContentsNameTheirPages() {
        m_language.apply(QStringLiteral("ru"));
        const Report made = report::labReport(finished(lessonIn(lessonFiles().front())), wish());
        const QByteArray pdf = bytesOf(made, report::Format::pdf);
        const QStringList pages = reading::textOf(pdf).split(u'\f');
        const QStringList headings = headingsOf(made);
        static const QRegularExpression entry(QStringLiteral("^\\s*(.+?)[ .]+(\\d+)$"));
        int found = 0;
        for (const QString& line : pages.at(1).split(u'\n')) {
            const auto match = entry.match(line);
            if (!match.hasMatch() || !headings.contains(match.captured(1))) {
                continue;
            }
            const QString page = pages.at(match.captured(2).toInt() - 1);
            QVERIFY2(page.contains(match.captured(1), Qt::CaseInsensitive), qPrintable(line));
            QVERIFY(page.trimmed().endsWith(match.captured(2))); // the number at its foot
            ++found;
        }
        QCOMPARE(found, headings.size());
        static const QRegularExpression number(QStringLiteral("\\n\\s*1\\s*$"));
        QVERIFY(!pages.front().contains(number)); // the title page has none
    }

    void theRussianPapersHaveNoEnglishWord_data() { addLessons(); }
    void theRussianPapersHaveNoEnglishWord() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        if (language != u"ru") {
            return;
        }
        m_language.apply(language);
        Lesson lesson = lessonIn(path);
        for (GroundSurface& surface : lesson.base.surfaces) {
            surface.project.title = surface.project.part->name = {};
        }
        static const QRegularExpression english(QStringLiteral("(?<![\\w_])[A-Za-z]{3,}(?!\\w)"),
                                                QRegularExpression::UseUnicodePropertiesOption);
        static const std::set<QString> known{
            QStringLiteral("Sparkout"), QStringLiteral("sparkout"), QStringLiteral("work"),
            QStringLiteral("HRC"),      QStringLiteral("MODEL"),    QStringLiteral("CNC"),
            QStringLiteral("ISO"),      QStringLiteral("exp"),      QStringLiteral("ierfc"),
            QStringLiteral("max"),      QStringLiteral("min"),      QStringLiteral("rad"),
            QStringLiteral("Sax"),      QStringLiteral("Cpk"),      QStringLiteral("Ppk"),
            QStringLiteral("Cp"),       QStringLiteral("Pp")};
        for (const Report& made : allPapers(lesson)) {
            QString text = textOf(made);
            for (const report::Block& block : made.blocks) { // keys of sources
                if (const auto* table = std::get_if<Table>(&block)) {
                    for (const QStringList& row : table->rows) {
                        text.remove(row.front().size() > 4 && row.front().isUpper() ? row.front()
                                                                                    : QString());
                    }
                }
            }
            for (auto it = english.globalMatch(text); it.hasNext();) {
                const QString word = it.next().captured();
                QVERIFY2(known.contains(word) || word.isUpper(),
                         qPrintable(made.title + QStringLiteral(": ") + word));
            }
        }
    }

    void markupBecomesBlocks() {
        int formulas = 3;
        const auto blocks = report::LessonMarkup::blocks(
            QStringLiteral(
                "<p>a <i>S<sub>t</sub></i>, 10<sup>-3</sup> &lt; b</p>\n"
                "<p class=\"formula\"><i>a<sub>E1</sub> = h</i></p>"
                "<ul><li>one</li><li>two</li></ul><ol><li>three</li></ol>"
                "<table><tr><td>h</td><td>g</td></tr><tr><td>1</td><td></td></tr></table>"),
            &formulas);
        QCOMPARE(blocks.size(), std::size_t(6));
        const auto& text = std::get<Paragraph>(blocks[0]);
        QCOMPARE(text.text, QStringLiteral("a S_t, 10⁻³ < b"));
        QVERIFY(text.symbols);
        QCOMPARE(inOneLine(std::get<Formula>(blocks[1])), QStringLiteral("a_E1 = h"));
        QCOMPARE(std::get<Formula>(blocks[1]).label, QStringLiteral("(4)"));
        QCOMPARE(std::get<Paragraph>(blocks[2]).text, QStringLiteral("– one"));
        QCOMPARE(std::get<Paragraph>(blocks[4]).text, QStringLiteral("1) three"));
        const auto& table = std::get<Table>(blocks[5]);
        QCOMPARE(table.head, (QStringList{QStringLiteral("h"), QStringLiteral("g")}));
        QCOMPARE(table.rows.size(), std::size_t(1));
    }

private:
    /// Well-formed, with every style and every mark that it names.
    static void checkOdt(const QByteArray& odt) {
        const QByteArray content = reading::unzipped(odt, "content.xml");
        const QString all = QString::fromUtf8(content + reading::unzipped(odt, "styles.xml"));
        QXmlStreamReader reader(content);
        while (!reader.atEnd()) {
            reader.readNext();
        }
        QVERIFY2(!content.isEmpty() && !reader.hasError(), qPrintable(reader.errorString()));
        const auto named = [&all](const char* pattern) {
            std::set<QString> names;
            for (auto it = QRegularExpression(QString::fromLatin1(pattern)).globalMatch(all);
                 it.hasNext();) {
                names.insert(it.next().captured(1));
            }
            return names;
        };
        const std::set<QString> styles = named("style:name=\"([^\"]+)\"");
        for (const char* use : {"text:style-name=\"([^\"]+)\"", "table:style-name=\"([^\"]+)\"",
                                "master-page-name=\"([^\"]+)\""}) {
            for (const QString& style : named(use)) {
                QVERIFY2(styles.contains(style), qPrintable(style));
            }
        }
        const std::set<QString> marks = named("bookmark-start text:name=\"([^\"]+)\"");
        for (const QString& mark : named("text:ref-name=\"([^\"]+)\"")) {
            QVERIFY2(marks.contains(mark), qPrintable(mark));
        }
    }

    /// Every result of the key is left out of the worksheet, whose formulas have the same numbers.
    static void checkApart(const Report& sheet, const Report& key) {
        const auto asked = formulasByLabel(sheet), answered = formulasByLabel(key);
        QVERIFY(answered.size() > 5);
        int blanks = 0;
        std::set<QString> given; // that stand as they are in both
        for (const QString& cell : cellsOf(sheet)) {
            given.insert(cell.section(QChar::Nbsp, 0, 0));
        }
        QString equations;
        for (const auto& [label, formula] : asked) {
            equations += inOneLine(formula) + u'\n';
        }
        for (const auto& [label, formula] : answered) {
            QVERIFY2(asked.contains(label), qPrintable(label));
        }
        QCOMPARE(asked.size(), answered.size());
        for (const auto& [label, formula] : answered) {
            QVERIFY(asked.contains(label));
            const Formula& question = asked.at(label);
            QCOMPARE(inOneLine(question.sides.front()), inOneLine(formula.sides.front()));
            if (resultOf(question) != report::blankNumber()) {
                QCOMPARE(question.sides.size(), std::size_t(2)); // it states a given number
                continue;
            }
            ++blanks;
            const QString result = resultOf(formula);
            const bool tells = result.size() > 4 && !given.contains(result);
            if (tells) {
                QVERIFY2(!hasNumber(equations, result), qPrintable(label + u' ' + result));
            }
        }
        QVERIFY(blanks > 5);
        for (const report::Block& block : sheet.blocks) {
            if (const auto* figure = std::get_if<report::Figure>(&block)) {
                QVERIFY(figure->size.width() > 0); // the part, or a grid to draw on
            }
        }
        for (const report::Block& block : key.blocks) {
            QVERIFY(!std::holds_alternative<Blank>(block));
        }
    }

    Language m_language;
};

} // namespace sparkout::test_course_papers

SPARKOUT_TEST(test_course_papers, TestCoursePapers)
#include "test_course_papers.moc"
