// SPDX-License-Identifier: GPL-3.0-or-later
// A student's work: written and read to the byte, its chain of seals breaks at whatever is changed,
// and it holds neither answers nor the seed.
#include "core/quality/run_summary.h"
#include "tests/core/lesson/class_samples.h"
#include "tests/core/support/project_mutator.h"
#include "tests/registry.h"

namespace sparkout::test_work {

using nlohmann::json;

class TestWork : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_out = samples::giveOut(samples::lesson(), 2, 20'260'923);
        QCOMPARE(m_out.works.size(), std::size_t{2});
        m_work = samples::solved(m_out, 0, {3});
        samples::takeHint(m_work, 6, 1, "2026-11-26T10:30:00Z");
        WorkEntry run;
        run.event = WorkEvent::run;
        run.step = 7;
        run.when = "2026-11-26T10:31:00Z";
        const StudiedRun studied =
            studyRun(m_out.works[0].lesson.base.surfaces.front().project, false);
        run.run = keptRun(studied.result,
                          summarise(studied.result, studied.accuracy, studied.constraints), "A",
                          "2026-11-26T10:31:00Z");
        addEntry(m_work, run);
        m_text = writeWork(m_work);
    }

    void aWorkIsReadAsItWasWritten() {
        const ReadWork read = readWork(m_text);
        QVERIFY2(read.work.has_value(), samples::listed(read.issues).c_str());
        QCOMPARE(QString::fromStdString(writeWork(*read.work)), QString::fromStdString(m_text));
        QVERIFY(!brokenSeal(*read.work));
    }

    void aWorkGivenOutHoldsNeitherAnswersNorSeed() {
        for (const Work& work : m_out.works) {
            const std::string text = writeWork(work);
            for (const char* word :
                 {"\"right\"", "seed", "20260923", "\"variants\"", "\"runs\": [{", "best_time"}) {
                QVERIFY2(text.find(word) == std::string::npos, word);
            }
            // What is asked of him is there: the time that he has to reach.
            QVERIFY(work.lesson.steps[6].goal.time->below_min.has_value());
        }
    }

    /// Every value of the file but the seals themselves, changed in turn: the chain does not hold.
    void whateverIsChangedBreaksASeal() {
        const json whole = json::parse(m_text);
        QVERIFY(!brokenSeal(*readWork(whole.dump()).work));
        int changed = 0, seen = 0;
        const int step = samples::sized(11, 101, 1); // a work is read for each
        const json flat = whole.flatten();
        for (const auto& [path, value] : flat.items()) {
            if (seen++ % step != 0 || path == "/format" || path == "/version"
                || path == "/lesson/format" || path == "/lesson/version"
                || path.starts_with("/lesson/project/part/shaft")) {
                continue;
            }
            json file = whole;
            json& place = file[json::json_pointer(path)];
            if (value.is_number()) {
                place = value.get<double>() * 1.0001 + 0.001;
            } else if (value.is_string()) {
                place = value.get<std::string>() + "x";
            } else if (value.is_boolean()) {
                place = !value.get<bool>();
            } else {
                continue;
            }
            const ReadWork read = readWork(file.dump());
            if (read.work) { // else the reader names it
                QVERIFY2(brokenSeal(*read.work), path.c_str());
                ++changed;
            }
        }
        QVERIFY2(changed >= 100 / step, std::to_string(changed).c_str());
    }

    void theBrokenSealIsThatOfTheEntryChanged() {
        Work work = m_work;
        work.entries[3].when += "x";
        QCOMPARE(brokenSeal(work), std::optional<std::size_t>(4));
        work.entries[3].sha256 = nextSeal(work.entries[2].sha256, work.entries[3]);
        QCOMPARE(brokenSeal(work), std::optional<std::size_t>(5)); // the next covers the seal
        work = m_work;
        work.name = "Другой";
        QCOMPARE(brokenSeal(work), std::optional<std::size_t>(0));
        work = m_work;
        work.entries.erase(work.entries.begin() + 2);
        QCOMPARE(brokenSeal(work), std::optional<std::size_t>(3));
        std::swap(work.entries[0], work.entries[1]);
        QCOMPARE(brokenSeal(work), std::optional<std::size_t>(1));
    }

    /// What the page of the seals says that they cannot tell: it is so.
    void theSealsHaveNoSecret() {
        Work work = m_work;
        work.entries.pop_back();
        QVERIFY(!brokenSeal(work)); // an end cut off
        work = m_work;
        work.name = "Другой";
        work.sha256 = firstSeal(work);
        const auto entries = std::move(work.entries);
        work.entries.clear();
        for (const WorkEntry& entry : entries) {
            addEntry(work, entry);
        }
        QVERIFY(!brokenSeal(work)); // sealed anew, and yet a copy
        QCOMPARE(contentDigest(work), contentDigest(m_work));
    }

    void theRecordIsWhatCounts() {
        Work work = m_out.works[0];
        const auto number = [](double value) {
            Answer answer;
            answer.number = value;
            return answer;
        };
        samples::handIn(work, 1, number(4), "1");
        samples::handIn(work, 1, number(5), "2");
        StepRecord record = recordOf(work, 1);
        QCOMPARE(*record.answer->number, 4.0); // of predictions the first
        QCOMPARE(record.attempts, 2);
        QVERIFY(!record.isPredictedLate);
        Answer first, second;
        first.chosen = {{2}};
        second.chosen = {{1}};
        samples::handIn(work, 0, first, "3");
        samples::handIn(work, 0, second, "4");
        QCOMPARE((*recordOf(work, 0).answer->chosen)[0], 1.0); // else the last
        samples::takeHint(work, 0, 1, "5");
        samples::takeHint(work, 0, 1, "6");
        QCOMPARE(priceOf(work.lesson.steps[0], recordOf(work, 0)), 0.5); // each once
        WorkEntry seen;
        seen.event = WorkEvent::run;
        seen.step = 3;
        addEntry(work, seen);
        samples::handIn(work, 2, number(1), "7");
        QVERIFY(recordOf(work, 2).isPredictedLate);
    }

    void everyFaultHasItsPath_data() {
        addColumns<QString, QString, int, QString>("pointer", "value", "code", "path");
        const auto row = [](const char* name, const char* pointer, const char* value,
                            IssueCode code, const char* path) {
            addRow(name, pointer, value, static_cast<int>(code), path);
        };
        row("other format", "/format", "\"sparkout-lesson\"", IssueCode::notOneOf, "/format");
        row("no lesson", "/lesson", "", IssueCode::missingKey, "/lesson");
        row("fault of the lesson", "/lesson/steps/0/points", "-1", IssueCode::outOfRange,
            "/lesson/steps/0/points");
        row("no name", "/name", "", IssueCode::missingKey, "/name");
        row("variant 0", "/variant", "0", IssueCode::outOfRange, "/variant");
        row("half a level", "/levels/0", "1.5", IssueCode::wrongType, "/levels/0");
        row("no seal", "/sha256", "", IssueCode::missingKey, "/sha256");
        row("step that there is not", "/entries/0/step", "9", IssueCode::outOfRange,
            "/entries/0/step");
        row("other event", "/entries/0/event", "\"sleep\"", IssueCode::notOneOf,
            "/entries/0/event");
        row("hint that there is not", "/entries/8/hint", "3", IssueCode::outOfRange,
            "/entries/8/hint");
        row("hint without its number", "/entries/8/hint", "", IssueCode::missingKey,
            "/entries/8/hint");
        row("run without its run", "/entries/9/run", "", IssueCode::missingKey, "/entries/9/run");
        row("unknown key", "/entries/0/points", "5", IssueCode::unknownKey, "/entries/0/points");
    }
    void everyFaultHasItsPath() {
        QFETCH(QString, pointer);
        QFETCH(QString, value);
        QFETCH(int, code);
        QFETCH(QString, path);
        const json file =
            samples::changedAt(json::parse(m_text), pointer.toStdString(), value.toStdString());
        const ReadWork read = readWork(file.dump());
        QVERIFY(!read.work);
        QVERIFY2(samples::holds(read.issues, static_cast<IssueCode>(code), path.toStdString()),
                 samples::listed(read.issues).c_str());
    }

    void cutAndFlippedWorksAreAnswered() {
        std::string text = m_text;
        auto pick = samples::fromSeed(5);
        for (int i = samples::sized(150, 20, 3000); i > 0; --i) {
            const auto bit = static_cast<std::size_t>(pick(static_cast<int>(8 * text.size())));
            const char before = text[bit / 8];
            text[bit / 8] = static_cast<char>(before ^ (1 << bit % 8));
            const ReadWork read = readWork(text);
            QVERIFY(read.work.has_value() != hasErrors(read.issues));
            if (read.work) {
                const std::string again = writeWork(*read.work);
                QCOMPARE(writeWork(*readWork(again).work), again);
            }
            text[bit / 8] = before;
            const std::size_t end = std::min(bit / 8, text.rfind('}')); // what follows says nothing
            const ReadWork cut = readWork(std::string_view(text).substr(0, end));
            QVERIFY(!cut.work);
        }
    }

private:
    samples::GivenOut m_out;
    Work m_work;
    std::string m_text;
};

} // namespace sparkout::test_work

SPARKOUT_TEST(test_work, TestWork)
#include "test_work.moc"
