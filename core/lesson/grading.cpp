// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/grading.h"

#include "core/deadline_stop.h"
#include "core/file/csv_line.h"
#include "core/lesson/make_variants.h"
#include "core/setup/setup_file.h"
#include "core/study/run_comparison.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace sparkout {

namespace {

constexpr int minuteDecimals = 3, ratioDecimals = 3;

template <typename Texts>
std::string joined(const Texts& texts, const char* separator) {
    std::string all;
    for (const std::string& text : texts) {
        all += (all.empty() ? "" : separator) + text;
    }
    return all;
}

GradeCell orEmpty(const std::optional<double>& value) {
    return value ? GradeCell(*value) : GradeCell();
}

std::vector<GradeColumn> columnsFor(const Lesson& lesson) {
    constexpr int points = GradeColumn::asGiven;
    std::vector<GradeColumn> columns{{"file", "file"},     {"name", "name"},
                                     {"group", "group"},   {"variant", "variant"},
                                     {"flags", "remarks"}, {"copied_from", "copied from"}};
    for (std::size_t i = 1; i <= lesson.steps.size(); ++i) {
        const std::string number = std::to_string(i);
        columns.push_back({"step_" + number + "_points", "step " + number, points});
    }
    const GradeColumn last[] = {{"points", "points", points},
                                {"most", "most", points},
                                {"pending", "to be marked", points},
                                {"attempts", "attempts"},
                                {"hints_points", "points for hints", points},
                                {"time_min", "time, min", minuteDecimals},
                                {"best_min", "best time, min", minuteDecimals},
                                {"best_over_time", "best / time", ratioDecimals}};
    columns.insert(columns.end(), std::begin(last), std::end(last));
    return columns;
}

std::vector<GradeCell> rowOf(const GradedWork& work, std::size_t steps, FlagStyle style) {
    std::vector<std::string> flags;
    for (const WorkFlag flag : work.flags) {
        flags.emplace_back(style.word(flag));
    }
    std::vector<GradeCell> row{work.file,
                               work.name,
                               work.group,
                               work.variant > 0 ? GradeCell(work.variant) : GradeCell(),
                               joined(flags, style.separator),
                               joined(work.copiedFrom, "; ")};
    int attempts = 0;
    double hints = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const bool isMarked = i < work.steps.size();
        row.push_back(isMarked ? GradeCell(work.steps[i].points) : GradeCell());
        attempts += isMarked ? work.steps[i].attempts : 0;
        hints += isMarked ? work.steps[i].hints : 0;
    }
    row.insert(row.end(),
               {work.points, work.most, work.pending, attempts, hints, orEmpty(work.time_min),
                orEmpty(work.best_min), orEmpty(work.nearness())});
    return row;
}

void addCell(CsvLine& line, const GradeCell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
        line.text(*text);
    } else if (const auto* count = std::get_if<int>(&cell)) {
        line.whole(*count);
    } else if (const auto* number = std::get_if<double>(&cell)) {
        line.number(*number);
    } else {
        line.empty();
    }
}

} // namespace

GradeTable gradeTable(const Lesson& lesson, const std::vector<GradedWork>& works, FlagStyle flags) {
    GradeTable table{columnsFor(lesson), {}};
    for (const GradedWork& work : works) {
        table.rows.push_back(rowOf(work, lesson.steps.size(), flags));
    }
    return table;
}

std::string gradesCsv(const Lesson& lesson, const std::vector<GradedWork>& works) {
    const GradeTable table = gradeTable(lesson, works);
    CsvLine line;
    for (const GradeColumn& column : table.columns) {
        line.text(column.key);
    }
    std::string text = line.end();
    for (const auto& row : table.rows) {
        for (const GradeCell& cell : row) {
            addCell(line, cell);
        }
        text += line.end();
    }
    return text;
}

namespace {

constexpr std::array<const char*, workFlags> flagKeys{
    "unreadable",  "foreign", "edited",    "copied",  "handed_in_twice", "not_in_group",
    "untrue_runs", "late",    "forbidden", "missing", "over_budget"};

/// The best answers of variants; each is searched once.
class BestAnswers {
public:
    std::optional<double> of(const Lesson& lesson, const VariantLevels& levels,
                             const std::stop_token& stop) {
        const auto found = m_known.find(levels);
        if (found != m_known.end()) {
            return found->second;
        }
        const Lesson variant = withVariant(lesson, levels, std::nullopt);
        const auto best = bestAnswer(variant.base.surfaces[variedSurface(lesson)].project, stop);
        const auto best_min = best ? std::optional(best->time_min) : std::nullopt;
        if (!stop.stop_requested()) {
            m_known.emplace(levels, best_min);
        }
        return best_min;
    }

private:
    std::map<VariantLevels, std::optional<double>> m_known;
};

/// A work that was read, with the data for comparing it with others.
struct ReadForClass {
    GradedWork graded;
    std::string content; ///< contentDigest()
    VariantLevels levels;
    std::u32string name, group; ///< comparedName()
    bool isRead = false;
};

const BestRow* rowOfVariant(const GradeWish& wish, int variant) {
    const auto found = std::find_if(wish.best.begin(), wish.best.end(),
                                    [&](const BestRow& row) { return row.variant == variant; });
    return found == wish.best.end() ? nullptr : &*found;
}

class WorkMarker {
public:
    WorkMarker(const Lesson& lesson, const GradeWish& wish, BestAnswers& best,
               const std::stop_token& stop)
        : m_lesson(lesson)
        , m_digest(lessonDigest(lesson))
        , m_wish(wish)
        , m_best(best)
        , m_stop(stop) {}

    /// The result must be discarded if a stop was requested meanwhile.
    ReadForClass mark(HandedIn handedIn) {
        ReadForClass read;
        GradedWork& graded = read.graded;
        graded.file = std::move(handedIn.file);
        graded.most = m_lesson.points();
        ReadWork file = readInTime(std::exchange(handedIn.text, {}), graded);
        if (!file.work) {
            if (!graded.flags.contains(WorkFlag::overBudget)) {
                graded.flags.insert(WorkFlag::unreadable);
            }
            graded.issues = std::move(file.issues);
            return read;
        }
        const Work& work = *file.work;
        graded.name = work.name;
        graded.group = work.group;
        graded.variant = work.variant;
        read.name = comparedName(work.name);
        read.group = comparedName(work.group);
        read.levels = work.variantLevels();
        read.content = contentDigest(work);
        read.isRead = true;
        graded.brokenAt = brokenSeal(work);
        if (graded.brokenAt) {
            graded.flags.insert(WorkFlag::edited);
        }
        if (!m_wish.group.empty()
            && std::ranges::none_of(m_wish.group, [&work](const Student& student) {
                   return isSameStudent(student, {work.name, work.group});
               })) {
            graded.flags.insert(WorkFlag::notInGroup);
        }
        const bool isOfLesson =
            work.lesson_sha256 == m_digest && work.lesson.steps.size() == m_lesson.steps.size();
        if (!isOfLesson) {
            graded.flags.insert(WorkFlag::foreign);
        } else if (!areLevels(m_lesson, read.levels)) {
            graded.flags.insert(WorkFlag::edited);
        } else {
            markSteps(work, read.levels, graded);
        }
        return read;
    }

private:
    /// The text is freed when the work is marked.
    ReadWork readInTime(const std::string& text, GradedWork& graded) {
        const DeadlineStop within(m_stop, m_wish.budget);
        ReadWork file = readWork(text, within.token());
        if (within.token().stop_requested()) {
            graded.flags.insert(WorkFlag::overBudget);
            return {};
        }
        return file;
    }

    /// The student's lesson, with the data for marking it.
    Lesson givenTo(const Work& work, const VariantLevels& levels, GradedWork& graded) {
        const BestRow* const row = rowOfVariant(m_wish, work.variant);
        const bool isKnown = row && row->levels == levels;
        if (isKnown) {
            graded.best_min = row->best_min;
        } else if (needsSearch(m_lesson)) {
            const DeadlineStop within(m_stop, m_wish.budget);
            graded.best_min = m_best.of(m_lesson, levels, within.token());
            if (within.token().stop_requested()) {
                graded.flags.insert(WorkFlag::overBudget);
            }
        }
        Lesson given = withVariant(m_lesson, levels, graded.best_min);
        const std::string digest = variantDigest(forStudents(given));
        const bool isGivenOut = digest == variantDigest(work.lesson)
                                && (m_wish.best.empty() || (isKnown && row->digest == digest));
        if (!isGivenOut) {
            graded.flags.insert(WorkFlag::edited);
        }
        if (isKnown && !isSameStudent({row->name, row->group}, {work.name, work.group})) {
            graded.flags.insert(WorkFlag::copied);
            graded.copiedFrom.push_back(row->name);
        }
        return given;
    }

    void markSteps(const Work& work, const VariantLevels& levels, GradedWork& graded) {
        const Lesson given = givenTo(work, levels, graded);
        const DeadlineStop within(m_stop, m_wish.budget);
        const std::stop_token over = within.token();
        for (std::size_t i = 0; i < given.steps.size(); ++i) {
            graded.steps.push_back(markStep(given, i, recordOf(work, i), over));
            const GradedStep& step = graded.steps.back();
            graded.points += step.points;
            graded.pending += step.isPending ? std::max(step.most - step.hints, 0.0) : 0;
            const GoalResult& result = step.result;
            if (result.passed() && result.time_min && isMetBySetting(result.kind)) {
                graded.time_min =
                    std::min(graded.time_min.value_or(*result.time_min), *result.time_min);
            }
            if (step.isLate) {
                graded.flags.insert(WorkFlag::late);
            }
            if (result.finding == Finding::forbidden) {
                graded.flags.insert(WorkFlag::forbidden);
            }
        }
        for (const WorkEntry& entry : work.entries) {
            if (entry.run && !over.stop_requested()) {
                const bool isTrue = checkKeptRun(*entry.run, over).isTrue();
                if (!isTrue && !over.stop_requested()) {
                    graded.flags.insert(WorkFlag::untrueRuns);
                    graded.untrueRuns.push_back(entry.run->name);
                }
            }
        }
        if (over.stop_requested()) {
            graded.flags.insert(WorkFlag::overBudget);
        }
    }

    /// A step that was not marked in time is left to the teacher.
    static GradedStep markStep(const Lesson& given, std::size_t index, const StepRecord& record,
                               const std::stop_token& over) {
        const LessonStep& step = given.steps[index];
        GradedStep graded;
        graded.most = step.points;
        graded.hints = priceOf(step, record);
        graded.attempts = record.attempts;
        graded.isLate = record.isPredictedLate;
        graded.result.kind = step.goal.kind();
        if (record.answer) {
            graded.result = checkStep(given, index, *record.answer, over);
            graded.answer = *record.answer;
            graded.answer.setup = {};
            if (over.stop_requested()) {
                graded.result = {};
                graded.result.kind = step.goal.kind();
                graded.result.finding = Finding::forTeacher;
            }
        }
        graded.isPending = graded.result.finding == Finding::forTeacher;
        if (graded.result.passed() && !graded.isLate) {
            graded.points = std::max(step.points - graded.hints, 0.0);
        }
        return graded;
    }

    const Lesson& m_lesson;
    std::string m_digest; ///< digest of the lesson
    const GradeWish& m_wish;
    BestAnswers& m_best;
    const std::stop_token& m_stop;
};

void addCopy(GradedWork& work, const GradedWork& other) {
    work.flags.insert(WorkFlag::copied);
    const std::string& name = other.name.empty() ? other.file : other.name;
    if (std::find(work.copiedFrom.begin(), work.copiedFrom.end(), name) == work.copiedFrom.end()) {
        work.copiedFrom.push_back(name);
    }
}

/// Compares two works. The teacher's table assigns variants to students; with it, having the same
/// variant is no sign of copying.
void compareWorks(ReadForClass& a, ReadForClass& b, bool hasTable) {
    if (!a.isRead || !b.isRead) {
        return;
    }
    if (a.name == b.name && a.group == b.group) {
        a.graded.flags.insert(WorkFlag::handedInTwice);
        b.graded.flags.insert(WorkFlag::handedInTwice);
        return;
    }
    const bool isSameContent = !a.content.empty() && a.content == b.content;
    const bool isSameVariant = !hasTable && !a.levels.empty() && a.levels == b.levels
                               && !a.graded.flags.contains(WorkFlag::foreign)
                               && !b.graded.flags.contains(WorkFlag::foreign);
    if (isSameContent || isSameVariant) {
        addCopy(a.graded, b.graded);
        addCopy(b.graded, a.graded);
    }
}

std::vector<GradedWork> missingOnes(const std::vector<GradedWork>& works,
                                    const std::vector<Student>& group, const Lesson& lesson) {
    std::vector<GradedWork> missing;
    for (const Student& student : group) {
        const bool isThere = std::any_of(works.begin(), works.end(), [&](const GradedWork& work) {
            return isSameStudent(student, {work.name, work.group});
        });
        if (!isThere) {
            GradedWork none;
            none.name = student.name;
            none.group = student.group;
            none.most = lesson.points();
            none.flags.insert(WorkFlag::missing);
            missing.push_back(std::move(none));
        }
    }
    return missing;
}

} // namespace

const char* flagKey(WorkFlag flag) {
    return flagKeys[static_cast<std::size_t>(flag)];
}

GradedWork gradeWork(const Lesson& lesson, HandedIn handedIn, const GradeWish& wish,
                     const std::stop_token& stop) {
    BestAnswers best;
    return WorkMarker(lesson, wish, best, stop).mark(std::move(handedIn)).graded;
}

std::vector<GradedWork> gradeClass(const Lesson& lesson, const ClassWorks& handedIn,
                                   const GradeWish& wish, const std::stop_token& stop,
                                   const std::function<void(std::size_t)>& note) {
    BestAnswers best;
    WorkMarker marker(lesson, wish, best, stop);
    std::vector<ReadForClass> read;
    while (read.size() < handedIn.count && !stop.stop_requested()) {
        ReadForClass one = marker.mark(handedIn.read(read.size()));
        if (stop.stop_requested()) {
            break; // it would be incomplete
        }
        read.push_back(std::move(one));
        if (note) {
            note(read.size());
        }
    }
    for (std::size_t i = 0; i < read.size(); ++i) {
        for (std::size_t j = i + 1; j < read.size(); ++j) {
            compareWorks(read[i], read[j], !wish.best.empty());
        }
    }
    std::vector<GradedWork> works;
    works.reserve(read.size());
    for (ReadForClass& each : read) {
        works.push_back(std::move(each.graded));
    }
    if (works.size() == handedIn.count) {
        for (GradedWork& none : missingOnes(works, wish.group, lesson)) {
            works.push_back(std::move(none));
        }
    }
    return works;
}

CheckedSteps checkedAsGiven(Lesson lesson, const std::stop_token& stop) {
    CheckedSteps checked{withBestTimes(std::move(lesson), stop), {}};
    for (std::size_t step = 0; step < checked.lesson.steps.size(); ++step) {
        Answer given;
        given.setup.text = writeSetup(setupOf(checked.lesson, step));
        checked.steps.push_back(checkStep(checked.lesson, step, given));
    }
    return checked;
}

CheckedSteps checkedAnswers(const Work& work) {
    CheckedSteps checked{work.lesson, {}};
    for (std::size_t step = 0; step < work.lesson.steps.size(); ++step) {
        checked.steps.push_back(
            checkStep(work.lesson, step, recordOf(work, step).answer.value_or(Answer())));
    }
    return checked;
}

} // namespace sparkout
