// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course_papers.h"

#include "ui/report/lesson_markup.h"
#include "ui/report/paper_writer.h"
#include "ui/report/student_view.h"
#include "ui/report/worksheet.h"
#include "ui/results/run_table.h"
#include "ui/text/goal_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>

namespace sparkout::report {

namespace {

class GuideWriter {
    Q_DECLARE_TR_FUNCTIONS(MethodicalGuide)
public:
    GuideWriter(const Lesson& lesson, const PaperWish& wish)
        : m_lesson(lesson)
        , m_wish(wish)
        , m_paper(tr("Teaching guide"), WorkTitle(lesson.title).inFull(), wish.file, wish.date,
                  PageStyle::sheet) {}

    Report write() {
        m_paper.say(tr("For the teacher only: it contains the answers."));
        m_paper.section(tr("Aim of the work"));
        m_paper.lesson(m_lesson.aim);
        m_paper.section(tr("Theory"));
        m_paper.lesson(m_lesson.theory);
        m_paper.section(tr("Equipment needed"));
        m_paper.say(tr("A computer for each student with the program %1; no network. The student "
                       "gets a file of his variant and hands the same file in; the report is "
                       "printed from it.")
                        .arg(m_paper.report().program));
        m_paper.table(StudentView(Lesson()).inputs(m_lesson.base.surfaces.front().project),
                      tr("Inputs of the original lesson"));
        writeVariants();
        writeTime();
        writeOrder();
        writeQuestions();
        writeMistakes();
        m_paper.section(tr("The report"));
        m_paper.say(tr("The report contains, in the order of GOST 7.32: title page, contents, "
                       "introduction with the aim, data of the variant, theory in brief, results "
                       "step by step with tables and figures, predictions beside results, kept "
                       "runs compared, conclusion in the student's own words, sources."));
        return m_paper.take();
    }

private:
    void writeVariants() {
        if (!m_lesson.variants) {
            return;
        }
        Table table;
        table.head = {tr("Input that the variants vary"), tr("Values")};
        table.texts = {true, true};
        for (const VariedInput& input : m_lesson.variants->inputs) {
            const std::string path =
                !input.path.empty() || input.sets.empty() || input.sets.front().values.empty()
                    ? input.path
                    : input.sets.front().values.front().path;
            QString values;
            if (input.isRange()) {
                values = tr("%1…%2 in steps of %3")
                             .arg(printedNumber(*input.from), printedNumber(*input.to),
                                  printedNumber(*input.step));
            } else if (input.list) {
                QStringList list;
                for (const double value : *input.list) {
                    list << printedNumber(value);
                }
                values = list.join(QStringLiteral("; "));
            } else {
                values = tr("sets of values: %1").arg(input.sets.size());
            }
            table.rows.push_back({locationText(path), values});
        }
        m_paper.table(std::move(table), tr("Variants"));
    }

    void writeTime() {
        m_paper.section(tr("Time norm and points"));
        if (m_lesson.guide) {
            m_paper.say(
                tr("The work takes %1 min, including the defence.").arg(m_lesson.guide->minutes));
        }
        Table table;
        table.head = {tr("Step"), tr("Task"), tr("Points"), tr("Hints, price in points")};
        table.texts = {true, true, false, true};
        for (std::size_t i = 0; i < m_lesson.steps.size(); ++i) {
            const LessonStep& step = m_lesson.steps[i];
            QStringList prices;
            for (const Hint& hint : step.hints) {
                prices << printedNumber(hint.price);
            }
            table.rows.push_back(
                {QString::number(i + 1), GoalText::asked(step.goal, projectOf(m_lesson, i)),
                 printedNumber(step.points),
                 prices.isEmpty() ? QStringLiteral("–") : prices.join(QStringLiteral("; "))});
        }
        table.rows.push_back({tr("All"), QStringLiteral("–"), printedNumber(m_lesson.points()),
                              QStringLiteral("–")});
        table.lastIsSum = true;
        m_paper.table(std::move(table), tr("Points of the steps"));
    }

    void writeOrder() {
        m_paper.section(tr("Order of the work"));
        for (std::size_t i = 0; i < m_lesson.steps.size(); ++i) {
            m_wish.breathe();
            const LessonStep& step = m_lesson.steps[i];
            m_paper.subsection(tr("Step %1").arg(i + 1));
            m_paper.lesson(step.task);
            m_paper.add(Paragraph{tr("Answer"), true});
            StepKey::write(m_paper, m_lesson, i);
            for (std::size_t h = 0; h < step.hints.size(); ++h) {
                m_paper.say(
                    tr("Hint %1: %2")
                        .arg(QString::number(h + 1),
                             LessonMarkup::inOneLine(PaperWriter::text(step.hints[h].text))));
            }
        }
    }

    void writeQuestions() {
        if (!m_lesson.guide || m_lesson.guide->questions.empty()) {
            return;
        }
        m_paper.section(tr("Control questions with answers"));
        int number = 0;
        for (const ControlQuestion& each : m_lesson.guide->questions) {
            numbered(++number, each.question, true);
            m_paper.lesson(each.answer);
        }
    }

    void writeMistakes() {
        if (!m_lesson.guide || m_lesson.guide->mistakes.empty()) {
            return;
        }
        m_paper.section(tr("Typical mistakes"));
        int number = 0;
        for (const TypicalMistake& each : m_lesson.guide->mistakes) {
            numbered(++number, each.text, false);
        }
    }

    /// A text of the lesson with a number before its first paragraph.
    void numbered(int number, const Bilingual& text, bool strong) {
        std::vector<Block> blocks = LessonMarkup::blocks(PaperWriter::text(text));
        if (auto* first = blocks.empty() ? nullptr : std::get_if<Paragraph>(&blocks.front())) {
            first->text = QStringLiteral("%1. %2").arg(QString::number(number), first->text);
            first->strong = strong;
        }
        m_paper.add(std::move(blocks));
    }

    const Lesson& m_lesson;
    const PaperWish& m_wish;
    PaperWriter m_paper;
};

} // namespace

Report methodicalGuide(const Lesson& lesson, const PaperWish& wish) {
    return GuideWriter(lesson, wish).write();
}

namespace {

constexpr std::array allPapers{
    PaperRow{Paper::labReport, "lab-report", QT_TRANSLATE_NOOP("Paper", "Laboratory &report"), true,
             false, false, false},
    PaperRow{Paper::worksheet, "worksheet", QT_TRANSLATE_NOOP("Paper", "Wor&ksheet"), true, true,
             true, true},
    PaperRow{Paper::worksheetKey, "worksheet-key",
             QT_TRANSLATE_NOOP("Paper", "Key to the &worksheet"), false, true, true, true},
    PaperRow{Paper::guide, "guide", QT_TRANSLATE_NOOP("Paper", "Methodical &guide"), false, true,
             false, false},
};

std::vector<PaperRow> papersThat(bool PaperRow::*takes) {
    std::vector<PaperRow> rows;
    std::ranges::copy_if(allPapers, std::back_inserter(rows), takes);
    return rows;
}

} // namespace

std::span<const PaperRow> papers() {
    return allPapers;
}

std::vector<PaperRow> papersOfWorks() {
    return papersThat(&PaperRow::takesWork);
}

std::vector<PaperRow> papersOfLessons() {
    return papersThat(&PaperRow::takesLesson);
}

const PaperRow& rowOf(Paper paper) {
    return *std::ranges::find(allPapers, paper, &PaperRow::paper);
}

std::optional<Paper> paperOf(const QString& key) {
    const auto row = std::ranges::find_if(
        allPapers, [&key](const PaperRow& r) { return key == QLatin1StringView(r.key); });
    return row == allPapers.end() ? std::nullopt : std::optional(row->paper);
}

QString menuText(Paper paper) {
    return QCoreApplication::translate("Paper", rowOf(paper).menu);
}

Report makePaper(Paper paper, const Work& work, const PaperWish& wish) {
    return paper == Paper::labReport ? labReport(work, wish) : worksheet(work, wish);
}

Report makePaper(Paper paper, const Lesson& lesson, const PaperWish& wish) {
    switch (paper) {
    case Paper::worksheetKey: return worksheetKey(lesson, wish);
    case Paper::guide: return methodicalGuide(lesson, wish);
    default: return worksheet(lesson, wish);
    }
}

} // namespace sparkout::report
