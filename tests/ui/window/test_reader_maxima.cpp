// SPDX-License-Identifier: GPL-3.0-or-later
// The largest that each reader allows is opened in the window, every view and every page of inputs
// is shown with it, and the window goes on beating. The maxima are those of the readers' own tables
// and constants; without SPARKOUT_LONG a small case of each is opened alone. Prints the worst gap
// and the memory of each; fails at four times the target.
#include "core/file/struct_json.h"
#include "core/lesson/text_markup.h"
#include "core/project/member.h"
#include "core/study/new_project.h"
#include "core/study/operation.h"
#include "core/study/search_edits.h"
#include "tests/check_line.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/lesson/lesson_bench.h"
#include "tests/ui/support/heartbeat.h"
#include "tests/ui/window/long_project.h"
#include "tests/whole_project.h"
#include "ui/inputs/form_page.h"

#include <QSignalSpy>
#include <QTabWidget>

#include <set>

namespace sparkout::test_reader_maxima {

const bool longTest = qEnvironmentVariableIsSet("SPARKOUT_LONG");
constexpr double target_ms = 100;
constexpr double limit_ms = 4 * target_ms;

/// A file whose text has `count` of something.
struct Maximum {
    std::string path;      ///< in the file, where it counts
    std::size_t most = 0;  ///< that the reader allows
    std::size_t small = 0; ///< of the short test
    std::function<std::string(std::size_t count)> file;
    bool isWork = false; ///< of a student, else a project
};

/// What the row of a member allows of its number, items or values.
std::size_t mostOf(const StructInfo& table, std::string_view key) {
    const Range& range = table.find(key)->hard;
    return static_cast<std::size_t>(range.high);
}
template <typename Struct>
std::size_t mostOf(std::string_view key) {
    return mostOf(tableOf<Struct>(), key);
}

using File = std::function<std::string(std::size_t count)>;

/// A new project with so many of something.
File changed(Operation operation, std::function<void(Project&, std::size_t)> change) {
    return [operation, change = std::move(change)](std::size_t count) {
        Project project = newProject(operation);
        change(project, count);
        return writeProject(project);
    };
}
File plunge(std::function<void(Project&, std::size_t)> change) {
    return changed(Operation::plunge, std::move(change));
}
File traverse(std::function<void(Project&, std::size_t)> change) {
    return changed(Operation::traverse, std::move(change));
}

void ofStages(Project& project, std::size_t count) {
    const Stage first = project.cycle->stages.front();
    project.cycle->stages.assign(count, first);
    for (Stage& stage : project.cycle->stages) {
        stage.stock_mm = project.part->stock_mm / double(count);
    }
}

void ofSegments(Project& project, std::size_t count) {
    ShaftSegment whole;
    for (const ShaftSegment& each : project.part->shaft.segments) {
        whole.length_mm += each.length_mm;
        whole.diameter_mm = each.diameter_mm;
    }
    whole.length_mm = std::max(whole.length_mm, project.part->length_mm) * 2 / double(count);
    whole.diameter_mm = std::max(whole.diameter_mm, 10.0);
    project.part->shaft.segments.assign(count, whole);
}

void ofSteadyRests(Project& project, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        project.part->shaft.steady_rests.push_back(
            {.position_mm = project.part->length_mm * double(i) / double(count),
             .stiffness_n_um = 20});
    }
}

void ofGaps(Project& project, std::size_t count) {
    project.part->radii_per_section = 360;
    for (std::size_t i = 0; i < count; ++i) {
        project.part->gaps.push_back(
            {.from_deg = 360.0 * double(i) / double(count), .width_deg = 2});
    }
}

std::string ofSections(std::size_t count) {
    return writeProject(withSections(newProject(Operation::plunge), static_cast<int>(count)));
}

void ofPlaces(Project& project, std::size_t count) { // a part of many zones' worth of measurements
    Measured& measured = project.measured.emplace();
    for (std::size_t i = 0; i < count; ++i) {
        MeasuredPart part;
        part.part = std::to_string(i / 3 + 1);
        part.place = static_cast<int>(i % 3);
        part.diameters_mm = {project.part->diameter_mm};
        part.roundness_um = 1.5;
        measured.parts.push_back(part);
    }
}

void ofTraces(Project& project, std::size_t count) {
    std::vector<double> times, values;
    const std::size_t samples = longTest ? limits::traceSamples : 100;
    for (std::size_t i = 0; i < samples; ++i) {
        times.push_back(double(i) * 0.01);
        values.push_back(project.part->diameter_mm + 0.1 / (1 + double(i)));
    }
    Measured& measured = project.measured.emplace();
    for (std::size_t i = 0; i < count; ++i) {
        MeasuredTrace trace;
        trace.time_s = Samples(times);
        trace.values = Samples(values);
        measured.traces.push_back(trace);
    }
}

void ofSummaries(Project& project, std::size_t count) {
    Measured& measured = project.measured.emplace();
    measured.summaries.assign(count, {});
    for (std::size_t i = 0; i < count; ++i) {
        measured.summaries[i].place = static_cast<int>(i % 3);
        measured.summaries[i].count = 10;
        measured.summaries[i].mean_um = 1 + double(i) * 1e-3;
    }
}

void ofCalibrations(Project& project, std::size_t count) {
    Calibration calibration;
    calibration.input = "/wheel/dullness";
    calibration.value = 0.02;
    calibration.data = "trial";
    project.measured.emplace().calibrations.assign(count, calibration);
}

void ofSweep(Project& project, std::size_t points) {
    const int count = static_cast<int>(points);
    project.sweep.emplace().inputs = {
        {.input = "/wheel/dullness", .from = 0.02, .to = 0.05, .points = count},
        {.input = "/part/initial_runout_mm", .from = 0.01, .to = 0.05, .points = count}};
}

void ofMeasuredBlanks(Project& project, std::size_t count) {
    auto& values = project.batch.emplace().factors.stock_mm.emplace().measured.emplace();
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(0.14 + 1e-8 * double(i));
    }
}

std::string ofLevels(std::size_t count) {
    Project project = withOfferedSearch(newProject(Operation::traverse));
    std::vector<double> levels;
    for (std::size_t i = 0; i < count; ++i) {
        levels.push_back(0.001 + 1e-7 * double(i));
    }
    project.optimisation->radial_feed_mm = levels;
    return writeProject(project);
}

void ofContactPoints(Project& project, std::size_t count) {
    auto& rows = project.machine->wheel_contact.emplace().n_um_at_n.emplace();
    for (std::size_t i = 0; i < count; ++i) {
        rows.push_back({double(i), 10 + double(i) * 1e-3});
    }
}

std::string ofSurfaces(std::size_t count) {
    Setup setup;
    for (std::size_t i = 0; i < count; ++i) {
        GroundSurface surface;
        surface.name = "surface " + std::to_string(i + 1);
        surface.project = newProject(Operation::traverse);
        setup.surfaces.push_back(surface);
    }
    return writeSetup(setup);
}

// --- works ------------------------------------------------------------------------------------

Lesson lessonOfWork() {
    static const Lesson lesson = lesson_bench::givenOut().works.front().lesson;
    return lesson;
}
File work(std::function<void(Lesson&, std::size_t)> change) {
    return [change = std::move(change)](std::size_t count) {
        Lesson lesson = lessonOfWork();
        change(lesson, count);
        return writeWork(newWork(lesson, {}, {}, 1, "Student", "Group"));
    };
}

LessonStep stepWith(Goal goal) {
    LessonStep step;
    step.task.en = "Task";
    step.goal = std::move(goal);
    return step;
}
Goal inWords() {
    Goal goal;
    goal.text.emplace();
    return goal;
}
std::string textOf(std::size_t bytes) {
    std::string text;
    while (text.size() + 16 <= bytes) {
        text += "words of a text ";
    }
    return text;
}
std::string tagsOf(std::size_t tags) {
    std::string text = "<table><tr>";
    for (std::size_t i = 2; i + 4 <= tags; i += 2) {
        text += "<td>a</td>";
    }
    return text + "</tr></table>";
}
/// Tables within one another, as deep as may be, as many as may be.
std::string tablesOf(std::size_t tags) {
    const std::size_t deep = limits::lessonTagDepth / 3;
    std::string text;
    for (std::size_t used = 0; used + 6 * deep <= tags; used += 6 * deep) {
        for (std::size_t i = 0; i < deep; ++i) {
            text += "<table><tr><td>";
        }
        text += "x";
        for (std::size_t i = 0; i < deep; ++i) {
            text += "</td></tr></table>";
        }
    }
    return text;
}

std::vector<Maximum> allMaxima() {
    const std::size_t listed = limits::listItems, numbers = limits::listNumbers;
    return {
        {"/cycle/stages", mostOf<Cycle>("stages"), 20, plunge(ofStages)},
        {"/part/shaft/segments", mostOf<Shaft>("segments"), 20, plunge(ofSegments)},
        {"/part/shaft/steady_rests", mostOf<Shaft>("steady_rests"), 5, plunge(ofSteadyRests)},
        {"/part/gaps", mostOf<Part>("gaps"), 6, plunge(ofGaps)},
        {"/part/radii_per_section", mostOf<Part>("radii_per_section"), 36,
         plunge([](Project& project, std::size_t count) {
             project.part->radii_per_section = static_cast<int>(count);
         })},
        {"/sections", mostOf<Project>("sections"), 8, ofSections},
        {"/zone_sections", mostOf<Project>("zone_sections"), 3,
         traverse([](Project& project, std::size_t count) {
             project.zone_sections = static_cast<int>(count);
         })},
        {"/sweep/inputs", mostOf<Sweep>("inputs"), 2,
         traverse([](Project& project, std::size_t) { ofSweep(project, longTest ? 21 : 3); })},
        {"/sweep/inputs/points", mostOf<SweepAxis>("points"), 3, traverse(ofSweep)},
        {"/runs", mostOf<Project>("runs"), 20,
         [](std::size_t count) {
             return writeProject(
                 projectOfRuns(newProject(Operation::traverse), static_cast<int>(count)));
         }},
        {"/measured/parts", mostOf<Measured>("parts"), 30, traverse(ofPlaces)},
        {"/measured/traces", mostOf<Measured>("traces"), 3, traverse(ofTraces)},
        {"/measured/summaries", mostOf<Measured>("summaries"), 6, traverse(ofSummaries)},
        {"/measured/calibrations", mostOf<Measured>("calibrations"), 6, traverse(ofCalibrations)},
        {"/batch/factors/stock_mm/measured", numbers, 50, traverse(ofMeasuredBlanks)},
        {"/optimisation/radial_feed_mm", limits::levels, 50, ofLevels},
        {"/machine/wheel_contact/n_um_at_n", listed, 20, traverse(ofContactPoints)},
        {"/notes", limits::stringBytes, 500,
         traverse([](Project& project, std::size_t bytes) { project.notes = textOf(bytes); })},
        {"/title", limits::stringBytes, 50,
         traverse([](Project& project, std::size_t bytes) { project.title = textOf(bytes); })},
        {"/surfaces", limits::surfaces, 3, ofSurfaces},
        {"/lesson/steps", mostOf<LessonSheet>("steps"), 5,
         work([](Lesson& lesson, std::size_t count) {
             lesson.steps.assign(count, stepWith(inWords()));
         }),
         true},
        {"/lesson/steps/values", mostOf<LessonStep>("values"), 3,
         work([](Lesson& lesson, std::size_t count) {
             lesson.steps = {stepWith(inWords())};
             lesson.steps.front().values.assign(count, {"/wheel/dullness", 0.03, {}});
         }),
         true},
        {"/lesson/steps/goal/choice/options", mostOf<ChoiceGoal>("options"), 3,
         work([](Lesson& lesson, std::size_t count) {
             Goal goal;
             goal.choice.emplace().options.assign(
                 count,
                 {{.ru = {},
                   .en = longTest ? textOf(limits::lessonLine.bytes) : std::string("Option")}});
             lesson.steps = {stepWith(std::move(goal))};
         }),
         true},
        {"/lesson/theory", limits::lessonText.bytes, 500,
         work([](Lesson& lesson, std::size_t bytes) { lesson.theory.en = textOf(bytes); }), true},
        {"/lesson/steps/task", limits::lessonText.bytes, 500,
         work([](Lesson& lesson, std::size_t bytes) { lesson.steps[0].task.en = textOf(bytes); }),
         true},
        {"/lesson/theory (tags)", limits::lessonText.tags, 20,
         work([](Lesson& lesson, std::size_t tags) { lesson.theory.en = tagsOf(tags); }), true},
        {"/lesson/steps/task (tags)", limits::lessonText.tags, 20,
         work([](Lesson& lesson, std::size_t tags) { lesson.steps[0].task.en = tagsOf(tags); }),
         true},
        {"/lesson/steps/task (nested tags)", limits::lessonText.tags, 100,
         work([](Lesson& lesson, std::size_t tags) { lesson.steps[0].task.en = tablesOf(tags); }),
         true},
        {"/entries", limits::workEntries, 20,
         [](std::size_t count) {
             Work work =
                 *readWork(sparkout::writeWork(lesson_bench::givenOut().works.front())).work;
             work.lesson.steps = {stepWith(inWords())};
             for (std::size_t i = 0; i < count; ++i) {
                 Answer answer;
                 answer.text = "An answer in words.";
                 samples::handIn(work, 0, answer, "2026-11-26T10:00:00Z");
             }
             return writeWork(work);
         },
         true},
    };
}

/// The lists of objects that a table leads to, by their paths without numbers.
void addLists(const StructInfo& table, const std::string& path, std::set<std::string>& lists) {
    for (const Field& field : table.fields) {
        const std::string at = path + "/" + field.key;
        if (field.kind == Kind::objectList) {
            lists.insert(at);
        }
        if (field.nested) {
            addLists(*field.nested, at, lists);
        }
    }
}

/// Peak of the resident memory since the last call of it, in MB.
double peak_mb() {
    double peak = 0;
    QFile status(QStringLiteral("/proc/self/status"));
    if (status.open(QIODevice::ReadOnly)) {
        for (const QByteArray& line : status.readAll().split('\n')) {
            if (line.startsWith("VmHWM:")) {
                peak = line.mid(6).trimmed().split(' ').front().toDouble() / 1024;
            }
        }
    }
    QFile reset(QStringLiteral("/proc/self/clear_refs"));
    if (reset.open(QIODevice::WriteOnly)) {
        reset.write("5");
    }
    return peak;
}

/// What was done while the worst gap came, and how long it was.
struct Worst {
    QString doing = QStringLiteral("nothing");
    double gap_ms = 0;

    void watch(const QString& step, const std::function<void()>& act) {
        Heartbeat heart;
        act();
        const Beats beats = heart.stop();
        // What the thread itself was at: a busy machine does not change it, a wait for a disk none.
        const double step_ms = std::min(worstGap_ms(beats), worstWork_ms(beats));
        if (step_ms > gap_ms) {
            *this = {step, step_ms};
        }
    }
};

/// Opens a file, and shows every view and every page of inputs, or of a work its theory.
bool opensAndShows(Bench& bench, const QString& path, bool isWork, Worst& worst) {
    MainWindow& window = *bench.window;
    bool isOpened = false;
    worst.watch(QStringLiteral("opening"), [&] {
        QSignalSpy shown(&window, &MainWindow::outcomeShown);
        isWork ? window.lesson().open(path) : void(window.files().openFile(path));
        isOpened =
            QTest::qWaitFor([&] { return !shown.isEmpty() && !window.runs().running(); }, 300'000);
        QTest::qWait(50);
    });
    if (isWork) {
        for (auto* tabs : window.lesson().panel().findChildren<QTabWidget*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                worst.watch(tabs->tabText(i), [&] {
                    tabs->setCurrentIndex(i);
                    QTest::qWait(50);
                });
            }
        }
        return isOpened && window.lesson().isRunning();
    }
    if (!longTest) { // what grows with the number is what is long
        return isOpened;
    }
    for (const View* view : window.views()) {
        worst.watch(view->objectName(), [&] {
            window.showView(view->objectName());
            QTest::qWait(30);
        });
    }
    worst.watch(QStringLiteral("the feeds again"), [&] {
        window.showView(QStringLiteral("feeds"));
        QTest::qWait(30);
    });
    const qsizetype pages = window.inputs().findChildren<FormPage*>().size();
    for (int page = 0; page < static_cast<int>(pages); ++page) {
        worst.watch(QStringLiteral("page %1").arg(page + 1), [&] {
            window.inputs().showPage(page);
            QTest::qWait(30);
        });
    }
    return isOpened && pages > 0;
}

class TestReaderMaxima : public QObject {
    Q_OBJECT

private slots:
    void everyListOfTheTablesIsAmongThem() {
        // Of these the window shows nothing that grows with them, or they are never opened in it.
        const std::set<std::string> notShown{
            "/lesson/steps/inputs",         "/lesson/steps/hidden",
            "/lesson/steps/hints",          "/lesson/variants/inputs",
            "/lesson/variants/inputs/sets", "/lesson/variants/inputs/sets/values",
            "/lesson/variants/figures",     "/lesson/guide/questions",
            "/lesson/guide/mistakes"};
        std::set<std::string> lists;
        addLists(tableOf<Project>(), {}, lists);
        addLists(tableOf<LessonSheet>(), "/lesson", lists);
        addLists(tableOf<WorkSheet>(), {}, lists);
        std::set<std::string> tried = notShown;
        for (const Maximum& each : allMaxima()) {
            tried.insert(each.path);
        }
        for (const std::string& list : lists) {
            QVERIFY2(tried.contains(list), list.c_str());
        }
    }

    void theLargestOfEachIsOpenedWithoutAPause_data() {
        QTest::addColumn<std::size_t>("index");
        const std::vector<Maximum> all = allMaxima();
        for (std::size_t i = 0; i < all.size(); ++i) {
            QTest::newRow(all[i].path.c_str()) << i;
        }
    }
    void theLargestOfEachIsOpenedWithoutAPause() {
        QFETCH(std::size_t, index);
        const Maximum maximum = allMaxima()[index];
        const std::size_t count = longTest ? maximum.most : maximum.small;
        QVERIFY(maximum.most > 0 && maximum.most < 10'000'000);
        const QTemporaryDir folder;
        const QString path = folder.filePath(maximum.isWork ? QStringLiteral("a.sparkout-work")
                                                            : QStringLiteral("a.sparkout"));
        QVERIFY(!writeFileSafely(path.toStdString(), maximum.file(count)));
        peak_mb();
        Worst worst;
        const double worst_ms = leastOfTries_ms(target_ms, [&] {
            Bench bench(QStringLiteral("en"));
            bench.window->lesson().protect(folder.path());
            bench.settle();
            worst = {};
            const bool isOpened = opensAndShows(bench, path, maximum.isWork, worst);
            return isOpened ? worst.gap_ms : std::numeric_limits<double>::infinity();
        });
        qInfo(
            "HEARTBEAT maximum of %s, %zu: worst gap %.1f ms (%s), peak %.0f MB, target %g ms: %s",
            maximum.path.c_str(), count, worst_ms, qPrintable(worst.doing), peak_mb(), target_ms,
            beside(worst_ms, target_ms));
        QVERIFY2(worst_ms <= limit_ms, qPrintable(QString::number(worst_ms)));
    }
};

} // namespace sparkout::test_reader_maxima

SPARKOUT_TEST(test_reader_maxima, TestReaderMaxima)
#include "test_reader_maxima.moc"
