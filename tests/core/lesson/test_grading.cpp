// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// A class of 25 is given out, worked through by a script (some right, some wrong, some tampered
// with, some copied), and marked: the table as expected, to the point.
#include "core/lesson/grading.h"

#include "core/project/machine.h"
#include "core/quality/run_summary.h"
#include "tests/core/lesson/class_samples.h"
#include "tests/processor_time.h"
#include "tests/registry.h"

#include <set>

namespace sparkout::test_grading {

using nlohmann::json;

constexpr std::size_t classSize = 25;

/// Points of the eight steps of work 2.
constexpr std::array<double, 8> points{1, 2, 3, 2, 2, 3, 5, 2};
constexpr double all = 20, ofEngine = 18; ///< the last step is the teacher's

HandedIn handedIn(const Work& work) {
    return {work.name + ".sparkout-work", writeWork(work)};
}

using Flags = std::set<WorkFlag>;

class TestGrading : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_out = samples::giveOut(samples::lesson(), classSize, 42);
        QCOMPARE(m_out.works.size(), classSize);
        const ReadBestTable table =
            readBestTable(bestTableCsv(m_out.lesson, m_out.works, m_out.made.variants));
        QCOMPARE(table.faultLine, std::size_t{0});
        m_wish.best = table.rows;
        m_wish.group = m_out.group;
    }

    void theTeachersTableIsReadAgain() {
        QCOMPARE(m_wish.best.size(), classSize);
        for (std::size_t i = 0; i < classSize; ++i) {
            QCOMPARE(m_wish.best[i].name, m_out.group[i].name);
            QCOMPARE(m_wish.best[i].levels, m_out.made.variants[i].levels);
            QCOMPARE(*m_wish.best[i].best_min, m_out.made.variants[i].best->time_min);
            QCOMPARE(m_wish.best[i].digest, variantDigest(m_out.works[i].lesson));
        }
        QVERIFY(readBestTable("a,b\nc,d\n").faultLine > 0);
        QVERIFY(readBestTable("").faultLine > 0);
    }

    void theAssignmentsHoldNoAnswers() {
        const std::string sheet = assignmentsCsv(m_out.lesson, m_out.works);
        QVERIFY(sheet.find("best") == std::string::npos);
        QCOMPARE(std::count(sheet.begin(), sheet.end(), '\n'),
                 static_cast<std::ptrdiff_t>(classSize) + 1);
        QVERIFY(sheet.find("Студент 7") != std::string::npos);
    }

    void aClassIsMarkedToThePoint() {
        std::vector<HandedIn> files;
        std::map<std::string, double> expected; // points by name
        std::map<std::string, Flags> flags;
        const auto hand = [&](const Work& work, double sum, Flags of = {}) {
            files.push_back(handedIn(work));
            expected[work.name] = sum;
            flags[work.name] = std::move(of);
        };
        // 0…9: right in all; 10…14: each wrong in one step or two.
        for (std::size_t i = 0; i < 10; ++i) {
            hand(samples::solved(m_out, i), ofEngine);
        }
        const std::vector<std::vector<std::size_t>> wrong{{1}, {2, 3}, {5}, {6}, {7, 4}};
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            double sum = ofEngine;
            for (const std::size_t step : wrong[i]) {
                sum -= points[step - 1];
            }
            hand(samples::solved(m_out, 10 + i, wrong[i]), sum);
        }
        // 15: hints of 1 and 1.5 points in step 7, one of them twice.
        Work hinted = samples::solved(m_out, 15);
        for (const int hint : {1, 2, 1}) {
            samples::takeHint(hinted, 6, hint, "2026-11-26T11:00:00Z");
        }
        hand(hinted, ofEngine - 2.5);
        // 16: looks first, then predicts in step 2.
        Work late = m_out.works[16];
        Answer look;
        look.setup.text = writeSetup(late.lesson.base);
        WorkEntry looked;
        looked.step = 2;
        looked.when = "2026-11-26T09:00:00Z";
        looked.answer = look;
        addEntry(late, looked);
        const Work rest = samples::solved(m_out, 16);
        for (WorkEntry entry : rest.entries) {
            addEntry(late, entry);
        }
        hand(late, ofEngine - points[1], {WorkFlag::late});
        // 17: a locked input is changed to be quicker in step 7.
        Work forbidden = samples::solved(m_out, 17);
        Setup setup = setupOf(forbidden.lesson, 6);
        setup.surfaces.front().project = m_out.made.variants[17].best->project;
        setup.surfaces.front().project.machine->dwell_entry_s = 0;
        Answer quicker;
        quicker.setup.text = writeSetup(setup);
        samples::handIn(forbidden, 6, quicker, "2026-11-26T11:00:00Z");
        hand(forbidden, ofEngine - points[6], {WorkFlag::forbidden});
        // 18: the answer to step 4 is made right in an editor.
        Work edited = samples::solved(m_out, 18, {4});
        edited.entries[3].answer = samples::scripted(m_out, 18, 3, true);
        hand(edited, ofEngine, {WorkFlag::edited});
        // 19: an easier time in his file, all sealed anew.
        Work easier = m_out.works[19];
        easier.lesson.steps[6].goal.time->below_min = 100;
        easier.sha256 = firstSeal(easier);
        for (const WorkEntry& entry : samples::solved(m_out, 19, {7}).entries) {
            addEntry(easier, entry);
        }
        hand(easier, ofEngine - points[6], {WorkFlag::edited});
        // 20 hands in the work of 3 under his own name, sealed anew.
        Work copy = samples::solved(m_out, 3);
        copy.name = m_out.group[20].name;
        copy.group = m_out.group[20].group;
        copy.sha256 = firstSeal(copy);
        const auto entries = std::move(copy.entries);
        copy.entries.clear();
        for (const WorkEntry& entry : entries) {
            addEntry(copy, entry);
        }
        hand(copy, ofEngine, {WorkFlag::copied});
        flags[m_out.group[3].name] = {WorkFlag::copied}; // by its entries
        // 21: of another lesson. 22: no work at all. 23 hands in nothing; 24 only half.
        json other = samples::lessonJsonOf();
        other["title"]["en"] = "Another work";
        const Lesson otherLesson = samples::lessonOf(other);
        Work foreign = newWork(otherLesson, m_out.made.variants[21].levels,
                               m_out.made.variants[21].best->time_min, 22, m_out.group[21].name,
                               m_out.group[21].group);
        hand(foreign, 0, {WorkFlag::foreign});
        files.push_back({m_out.group[22].name + ".sparkout-work", "{\"format\": 1}"});
        Work half = m_out.works[24];
        for (std::size_t step = 0; step < 4; ++step) {
            samples::handIn(half, step, samples::scripted(m_out, 24, step, true), "10:00");
        }
        hand(half, points[0] + points[1] + points[2] + points[3]);

        const std::vector<GradedWork> graded = gradeClass(m_out.lesson, files, m_wish);
        // 24 files, and 22 and 23 are missing by their names.
        QCOMPARE(graded.size(), std::size_t{24} + 2);
        for (const GradedWork& work : graded) {
            if (work.name.empty()) {
                QVERIFY(work.flags == Flags{WorkFlag::unreadable});
                QCOMPARE(work.points, 0.0);
                continue;
            }
            if (!expected.contains(work.name)) {
                QVERIFY2(work.flags == Flags{WorkFlag::missing}, work.name.c_str());
                QVERIFY(work.name == m_out.group[22].name || work.name == m_out.group[23].name);
                continue;
            }
            QVERIFY2(std::abs(work.points - expected[work.name]) < 1e-12,
                     (work.name + ' ' + std::to_string(work.points) + ", expected "
                      + std::to_string(expected[work.name]))
                         .c_str());
            QVERIFY2(work.flags == flags[work.name], flagsText(work).c_str());
            QCOMPARE(work.most, all);
        }
        const GradedWork& best = graded.front();
        QCOMPARE(best.pending, points[7]);
        QVERIFY(std::abs(*best.nearness() - 1) < 1e-9); // it is the proved best
        checkCsv(graded);
    }

    /// The best answers are searched for where no table is given; without it nobody knows whose a
    /// variant is.
    void withoutTheTableTheBestIsSearchedFor() {
        const std::vector<HandedIn> files{handedIn(samples::solved(m_out, 0)),
                                          handedIn(samples::solved(m_out, 1))};
        const auto graded = gradeClass(m_out.lesson, files, {});
        for (const GradedWork& work : graded) {
            QCOMPARE(work.points, ofEngine);
            QVERIFY2(work.flags.empty(), flagsText(work).c_str());
        }
        Work same = samples::solved(m_out, 0, {1});
        same.name = "Кто-то";
        same.sha256 = firstSeal(same);
        const auto entries = std::move(same.entries);
        same.entries.clear();
        for (const WorkEntry& entry : entries) {
            addEntry(same, entry);
        }
        const std::vector<HandedIn> alike{files[0], handedIn(same)};
        const auto both = gradeClass(m_out.lesson, alike, {});
        QVERIFY(both[0].flags == Flags{WorkFlag::copied});
        QVERIFY(both[1].flags == Flags{WorkFlag::copied});
        QCOMPARE(both[1].copiedFrom, std::vector{m_out.group[0].name});
    }

    void keptRunsThatWereInventedAreNamed() {
        Work work = samples::solved(m_out, 2);
        const StudiedRun run = studyRun(work.lesson.base.surfaces.front().project, false);
        const RunSummary summary = summarise(run.result, run.accuracy, run.constraints);
        RunSummary invented = summary;
        invented.cycle_time_min /= 2;
        for (const RunSummary& each : {summary, invented}) {
            WorkEntry entry;
            entry.event = WorkEvent::run;
            entry.step = 8;
            entry.when = "2026-11-26T12:00:00Z";
            const bool isTrue = each.cycle_time_min == summary.cycle_time_min;
            entry.run = keptRun(run.result, each, isTrue ? "true" : "invented", entry.when);
            addEntry(work, entry);
        }
        const GradedWork graded = gradeWork(m_out.lesson, handedIn(work), m_wish);
        QVERIFY(graded.flags == Flags{WorkFlag::untrueRuns});
        QCOMPARE(graded.untrueRuns, std::vector<std::string>{"invented"});
    }

    void aStudentTwiceOrOfNoListIsNamed() {
        Work stranger = samples::solved(m_out, 4);
        const std::vector<HandedIn> files{handedIn(samples::solved(m_out, 5)),
                                          handedIn(samples::solved(m_out, 5, {1})),
                                          handedIn(stranger)};
        GradeWish wish;
        wish.group = {m_out.group[5]};
        const auto graded = gradeClass(m_out.lesson, files, wish);
        QVERIFY(graded[0].flags == Flags{WorkFlag::handedInTwice});
        QVERIFY(graded[1].flags == Flags{WorkFlag::handedInTwice});
        QVERIFY(graded[2].flags == Flags{WorkFlag::notInGroup});
    }

    void aHundredWorksInTenSeconds() {
        std::vector<HandedIn> files;
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < classSize; ++i) {
            texts.push_back(writeWork(samples::solved(m_out, i)));
        }
        const auto works = static_cast<std::size_t>(samples::sized(100, 25, 100));
        for (std::size_t i = 0; i < works; ++i) {
            files.push_back({std::to_string(i), texts[i % classSize]});
        }
        for (const bool hasTable : {true, false}) {
            const double start_ms = processorTime_ms();
            const auto graded = gradeClass(m_out.lesson, files, hasTable ? m_wish : GradeWish());
            const double took_s = (processorTime_ms() - start_ms) / 1e3;
            qInfo("%zu works marked in %.2f s %s the teacher's table (100 in 10 s are the target)",
                  works, took_s, hasTable ? "with" : "without");
            QCOMPARE(graded.size(), works);
            QVERIFY(works < 100 || took_s < 40); // four times the target
        }
    }

    void listsOfStudentsAreRead() {
        const GroupList english = readGroup("Group,Name\nA,\"Ivanov, I.\"\nB,Petrov\n");
        QVERIFY(english.faults.empty());
        QVERIFY((english.students == std::vector<Student>{{"Ivanov, I.", "A"}, {"Petrov", "B"}}));
        const GroupList russian = readGroup("\xEF\xBB\xBFФИО;Группа\r\nИванов И.;ТМ-31\r\n");
        QVERIFY((russian.students == std::vector<Student>{{"Иванов И.", "ТМ-31"}}));
        const GroupList plain = readGroup("Иванов\nПетров\n\n");
        QVERIFY((plain.students == std::vector<Student>{{"Иванов", ""}, {"Петров", ""}}));
        const GroupList twice = readGroup("name\nA\nB\nA\n");
        QCOMPARE(twice.faults.size(), std::size_t{1});
        QVERIFY(twice.faults[0].kind == GroupFault::Kind::twice);
        QCOMPARE(twice.faults[0].line, std::size_t{4});
        QVERIFY(readGroup("").faults[0].kind == GroupFault::Kind::empty);
        QVERIFY(readGroup("group,name\nA,\n").faults[0].kind == GroupFault::Kind::noName);
    }

    /// As deans' offices, Excel and Moodle write them.
    void listsOfOtherProgramsAreRead() {
        const auto read = [](const TableText& text) {
            const GroupList list = readGroup(text);
            return list.faults.empty() ? list.students : std::vector<Student>();
        };
        const std::vector<Student> two{{"Иванов \"Ваня\" И.", "МТ-41"}, {"Фёдоров П.", "МТ-41"}};
        QCOMPARE(read("№ п/п;Ф.И.О.;№ книжки;Группа\r\n1;\"Иванов \"\"Ваня\"\" И.\";7;МТ-41\r\n"
                      "2;Фёдоров  П.;8;МТ-41\r\n"),
                 two);
        QCOMPARE(read("ФИО;Группа\r\"Иванов \"\"Ваня\"\" И.\";МТ-41\rФёдоров\tП.;МТ-41\r"), two);
        QCOMPARE(read("Имя,Фамилия,Группа\n\"\"\"Ваня\"\" И.\",Иванов,МТ-41\nП.,Фёдоров,МТ-41\n"),
                 two);
        QCOMPARE(read("Student name;Group\nA B;1\n"), (std::vector<Student>{{"A B", "1"}}));
        QCOMPARE(read("ФИО\nСмит, Джон\n"), (std::vector<Student>{{"Смит, Джон", ""}}));
        // Two students by one letter, and one student typed twice.
        QCOMPARE(readGroup("ФИО\nФедоров\nФёдоров\n").students.size(), std::size_t{2});
        QVERIFY(readGroup("ФИО\nАндрей Й.\nандреи\u0306  И\u0306.\n").faults[0].kind
                == GroupFault::Kind::twice);
        const GroupList comma = readGroup("Name,Group\nSmith, John,ME-1\nO'Neil,ME-1\n");
        QCOMPARE(comma.faults.size(), std::size_t{1});
        QVERIFY(comma.faults[0].kind == GroupFault::Kind::moreCells && comma.faults[0].line == 2);
    }

    /// Whatever his name is, the teacher's table knows him again, saved by Excel or not.
    void honestStudentWithAnyNameHasCopiedNothing() {
        const std::vector<std::string> names{
            "Иванов \"Ваня\"", "Пётр\tПетров",    "=1+1",        "'-5",
            "a\u202Eb",        "Смит, Джон; мл.", "две\nстроки", "\\u0009"};
        samples::GivenOut out = m_out;
        GradeWish wish;
        std::vector<HandedIn> files;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const MadeVariant& variant = out.made.variants[i];
            out.works[i] = newWork(out.lesson, variant.levels, variant.best->time_min,
                                   static_cast<int>(i) + 1, names[i], "ТМ \"1\"");
            wish.group.push_back({names[i], "ТМ \"1\""});
            files.push_back({std::to_string(i), writeWork(out.works[i])});
        }
        out.works.resize(names.size());
        wish.best = readBestTable(bestTableCsv(out.lesson, out.works, out.made.variants)).rows;
        QCOMPARE(wish.best.size(), names.size());
        for (const GradedWork& work : gradeClass(out.lesson, files, wish)) {
            QVERIFY2(work.flags.empty(), flagsText(work).c_str());
        }
    }

    void workOverItsBudgetIsNamedAndEnds() {
        Work work = samples::solved(m_out, 6);
        const StudiedRun run = studyRun(work.lesson.base.surfaces.front().project, false);
        const RunSummary summary = summarise(run.result, run.accuracy, run.constraints);
        WorkEntry entry;
        entry.event = WorkEvent::run;
        entry.step = 8;
        entry.when = "2026-11-26T12:00:00Z";
        entry.run = keptRun(run.result, summary, "run", entry.when);
        for (int i = 0; i < 200; ++i) {
            addEntry(work, entry);
        }
        GradeWish wish = m_wish;
        const double whole_ms = processorTime_ms();
        QVERIFY(gradeWork(m_out.lesson, handedIn(work), wish).flags.empty());
        const double start_ms = processorTime_ms();
        wish.budget = std::chrono::milliseconds(0);
        const GradedWork graded = gradeWork(m_out.lesson, handedIn(work), wish);
        QVERIFY2(graded.flags == Flags{WorkFlag::overBudget}, flagsText(graded).c_str());
        QVERIFY(processorTime_ms() - start_ms < (start_ms - whole_ms) / 2);
        QVERIFY(gradesCsv(m_out.lesson, {graded}).find("over_budget") != std::string::npos);
    }

    void worksAreReadOneAtATimeAndAStopLeavesThoseMarked() {
        std::vector<HandedIn> files;
        for (std::size_t i = 0; i < 5; ++i) {
            files.push_back(handedIn(samples::solved(m_out, i)));
        }
        std::size_t marked = 0;
        std::stop_source stop;
        const ClassWorks works(files.size(), [&](std::size_t i) {
            [&] { QCOMPARE(i, marked); }(); // the one before is done
            return files[i];
        });
        const auto note = [&](std::size_t done) {
            marked = done;
            if (done == 2) {
                stop.request_stop();
            }
        };
        const auto graded = gradeClass(m_out.lesson, works, m_wish, stop.get_token(), note);
        QCOMPARE(graded.size(), std::size_t{2}); // and nobody is said to be missing
        for (const GradedWork& work : graded) {
            QVERIFY2(work.flags.empty() && work.points == ofEngine, flagsText(work).c_str());
        }
    }

    void filesHaveNamesThatAnySystemTakes() {
        Work work;
        work.name = "Иванов, И./..\\:*";
        QCOMPARE(workFileName(work, 7), std::string("007-Иванов__И_______.sparkout-work"));
        work.name.assign(300, 'x');
        QVERIFY(workFileName(work, 7).size() < 130);
    }

private:
    static std::string flagsText(const GradedWork& work) {
        std::string text = work.name;
        for (const WorkFlag flag : work.flags) {
            text += std::string(" ") + flagKey(flag);
        }
        return text;
    }

    void checkCsv(const std::vector<GradedWork>& graded) const {
        const std::string csv = gradesCsv(m_out.lesson, graded);
        const std::string row = "Студент 11.sparkout-work,Студент 11,ТМ-31,11,,,0,2,3,2,2,3,5,0,"
                                "17,20,2,8,0,";
        QVERIFY2(csv.find(row) != std::string::npos, csv.c_str());
        QVERIFY(csv.find(",missing,") != std::string::npos);
    }

    samples::GivenOut m_out;
    GradeWish m_wish;
};

} // namespace sparkout::test_grading

SPARKOUT_TEST(test_grading, TestGrading)
#include "test_grading.moc"
