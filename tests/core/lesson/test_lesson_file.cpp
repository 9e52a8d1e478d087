// SPDX-License-Identifier: GPL-3.0-or-later
// The lesson file: what it holds is read and written to the byte, every fault is named by its
// path, and no text makes the reader do anything else.
#include "core/lesson/text_markup.h"
#include "core/project/project.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/core/support/json_mutator.h"
#include "tests/core/support/project_mutator.h"
#include "tests/registry.h"

namespace sparkout::test_lesson_file {

using nlohmann::json;
using samples::faultOfLesson;
using samples::lessonJsonOf;

class TestLessonFile : public QObject {
    Q_OBJECT

private slots:
    void shippedLessonsAreAsTheirWriterWritesThem_data() {
        QTest::addColumn<QString>("file");
        for (const auto& file : samples::lessonFiles()) {
            addRow(file.filename().string().c_str(), QString::fromStdString(file.string()));
        }
    }
    void shippedLessonsAreAsTheirWriterWritesThem() {
        QFETCH(QString, file);
        const std::string text = samples::readText(file.toStdString());
        const ReadLesson read = readLesson(text);
        QVERIFY2(read.lesson.has_value(), samples::listed(read.issues).c_str());
        QVERIFY2(read.issues.empty(), samples::listed(read.issues).c_str());
        if (qEnvironmentVariableIsSet("SPARKOUT_WRITE_LESSONS")) {
            std::ofstream(file.toStdString(), std::ios::binary) << writeLesson(*read.lesson);
        }
        QCOMPARE(QString::fromStdString(writeLesson(*read.lesson)), QString::fromStdString(text));
    }

    void shippedLessonsAreInBothLanguages() {
        const auto files = samples::lessonFiles();
        QVERIFY(!files.empty());
        for (const auto& file : files) {
            const json lesson = json::parse(samples::readText(file));
            eachText(lesson, [&](const json& text) {
                QVERIFY2(text.contains("ru") && text.contains("en"), text.dump().c_str());
            });
        }
    }

    void everyFaultHasItsPath_data() {
        QTest::addColumn<QString>("pointer"); // what is changed
        QTest::addColumn<QString>("value");   // to which JSON; empty: it is taken out
        addColumns<int, QString>("code", "path");
        headerRows();
        textRows();
        stepRows();
        goalRows();
        variantRows();
    }
    void everyFaultHasItsPath() {
        QFETCH(QString, pointer);
        QFETCH(QString, value);
        QFETCH(int, code);
        QFETCH(QString, path);
        const json file =
            samples::changedAt(lessonJsonOf(), pointer.toStdString(), value.toStdString());
        const ReadLesson read = readLesson(file.dump());
        QVERIFY(!read.lesson);
        QVERIFY2(samples::holds(read.issues, static_cast<IssueCode>(code), path.toStdString()),
                 samples::listed(read.issues).c_str());
        QCOMPARE(faultOfLesson(read), std::string());
    }

    void aWrongTypeIsRefusedAtEveryPlace() {
        const json whole = lessonJsonOf();
        const json flat = whole.flatten();
        int tried = 0;
        for (const auto& [path, value] : flat.items()) {
            json file = whole;
            file[json::json_pointer(path)] = json{{{"x", nullptr}}};
            const ReadLesson read = readLesson(file.dump());
            QVERIFY2(!read.lesson, path.c_str());
            QCOMPARE(faultOfLesson(read), std::string());
            ++tried;
        }
        QVERIFY(tried > 200);
    }

    void anUnknownKeyIsRefusedInEveryObject() {
        const json whole = lessonJsonOf();
        std::vector<std::string> objects;
        eachObject(whole, {}, objects);
        QVERIFY(objects.size() > 40);
        for (const std::string& path : objects) {
            json file = whole;
            file[json::json_pointer(path)]["strange"] = 1;
            const ReadLesson read = readLesson(file.dump());
            QVERIFY2(samples::holds(read.issues, IssueCode::unknownKey, path + "/strange"),
                     (path + "\n" + samples::listed(read.issues)).c_str());
        }
    }

    void textsHaveTheTagsOfTheHelpAlone_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("foreign"); // null: none
        addRow("plain", "a < b needs no tag", "< b needs no tag");
        addRow("escaped", "a &lt; b", QString());
        addRow("formula", "<p class=\"formula\"><i>a<sub>1</sub></i></p>", QString());
        QTest::newRow("image") << "<p><img src=\"file:///etc/passwd\"></p>"
                               << "<img src=\"file:///etc/passwd\">";
        addRow("attribute", "<p onclick=\"x\">", "<p onclick=\"x\">");
        QTest::newRow("link") << "<a href=\"http://x\">"
                              << "<a href=\"http://x\">";
        addRow("not closed", "<b", "<b");
        addRow("other case", "<SCRIPT>", "<SCRIPT>");
    }
    void textsHaveTheTagsOfTheHelpAlone() {
        QFETCH(QString, text);
        QFETCH(QString, foreign);
        const auto found = foreignTag(text.toStdString());
        QCOMPARE(found.has_value(), !foreign.isNull());
        QCOMPARE(QString::fromStdString(found.value_or("")), foreign.isNull() ? "" : foreign);
    }

    void textsAtTheirLimitsAreRead() {
        json file = lessonJsonOf();
        file["title"]["en"] = std::string(limits::lessonTitle.bytes, 'a');
        file["aim"]["en"] = std::string(limits::lessonLine.bytes, 'a');
        file["theory"]["ru"] = std::string(limits::lessonText.bytes, 'a');
        file["theory"]["en"] = repeated("<br>", limits::lessonText.tags);
        file["steps"][0]["task"]["en"] = repeated("<sub>", limits::lessonTagDepth);
        const ReadLesson read = readLesson(file.dump());
        QVERIFY2(read.lesson.has_value(), samples::listed(read.issues).c_str());
    }

    void tagsThatEndByThemselvesAreNotNested_data() {
        addColumns<QString, int, int>("text", "tags", "depth");
        addRow("none", "a &lt; b", 0, 0);
        addRow("closed", "<b>a</b><i>b</i>", 4, 1);
        addRow("paragraphs", "<p>a<p><b>b<p class=\"formula\">c", 4, 2);
        addRow("lines", "a<br>b<br>c", 2, 0);
        addRow("list", "<ul><li>a<li>b<li>c</ul><p>d", 6, 2);
        addRow("list in a list", "<ul><li>a<ul><li>b</ul></ul>", 6, 4);
        addRow("rows and cells", "<table><tr><td>a<td>b<tr><td>c</table>", 7, 3);
        addRow("table in a cell", "<table><tr><td><table><tr><td>a</table></table>", 8, 6);
        addRow("closed from within", "<b><i><sub>a</b><b>b", 5, 3);
        addRow("closes nothing", "</b></i>a<sub>", 3, 1);
    }
    void tagsThatEndByThemselvesAreNotNested() {
        QFETCH(QString, text);
        QFETCH(int, tags);
        QFETCH(int, depth);
        const TagCounts counts = countTags(text.toStdString());
        QCOMPARE(int(counts.tags), tags);
        QCOMPARE(int(counts.depth), depth);
    }

    void aStudentsLessonHasNoAnswers() {
        const Lesson lesson = samples::lesson();
        const std::string text = writeLesson(forStudents(lesson));
        QVERIFY(text.find("\"right\"") == std::string::npos);
        QVERIFY(text.find("\"variants\"") == std::string::npos);
        QVERIFY(lesson.guide && lesson.guide->questions.size() > 2);
        QVERIFY(text.find(lesson.guide->questions.front().answer.en) == std::string::npos);
        QVERIFY(!readLesson(text, LessonOf::student).lesson->guide);
        QVERIFY(writeLesson(lesson).find("\"right\"") != std::string::npos);
        QVERIFY(!readLesson(text).lesson); // a teacher's has its answers
        const ReadLesson read = readLesson(text, LessonOf::student);
        QVERIFY2(read.lesson.has_value(), samples::listed(read.issues).c_str());
        QCOMPARE(writeLesson(*read.lesson), text);
    }

    void keptRunsOfTheProjectAreTheTeachers() {
        json file = lessonJsonOf();
        const json project = file["project"];
        file["project"]["runs"] = {{{"name", "Solved by me"},
                                    {"when", "2026-11-26T12:00:00Z"},
                                    {"engine_version", "0.1.0"},
                                    {"inputs", project},
                                    {"summary", json::object()}}};
        const Lesson lesson = samples::lessonOf(file);
        QCOMPARE(lesson.base.surfaces.front().project.runs.size(), std::size_t{1});
        QVERIFY(writeLesson(lesson).find("Solved by me") != std::string::npos);
        QVERIFY(writeLesson(forStudents(lesson)).find("Solved by me") == std::string::npos);
    }

    void cutAndFlippedTextsAreAnswered() {
        std::string text = samples::lessonText();
        const auto step = static_cast<std::size_t>(samples::sized(211, 2111, 71));
        for (std::size_t length = 0; length < text.size(); length += step) {
            const std::string fault = faultOfLesson(readLesson(text.substr(0, length)));
            QVERIFY2(fault.empty(), (fault + " at " + std::to_string(length)).c_str());
        }
        for (std::size_t bit = 0; bit < 8 * text.size(); bit += 8 * step + 1) {
            const char before = text[bit / 8];
            text[bit / 8] = static_cast<char>(before ^ (1 << bit % 8));
            const std::string fault = faultOfLesson(readLesson(text));
            QVERIFY2(fault.empty(), (fault + " at bit " + std::to_string(bit)).c_str());
            text[bit / 8] = before;
        }
    }

    /// Values and members are swapped, doubled, taken out and replaced at random: a lesson that is
    /// taken is written and read again to the byte, any other is refused by sentences.
    void mutatedLessonsAreAnswered() {
        auto pick = samples::fromSeed(20261126);
        const json whole = lessonJsonOf();
        int accepted = 0;
        const int tries = samples::sized(400, 40, 6'000);
        for (int i = 0; i < tries; ++i) {
            json file = whole;
            for (int changes = 1 + pick(3); changes > 0; --changes) {
                samples::mutateJson(file, pick);
            }
            const ReadLesson read = readLesson(file.dump());
            const std::string fault = faultOfLesson(read);
            QVERIFY2(fault.empty(), (fault + "\n" + file.dump()).c_str());
            accepted += read.lesson ? 1 : 0;
        }
        qInfo("%d of %d mutated lessons were taken", accepted, tries);
        QVERIFY(accepted > tries / 50 && accepted < tries);
    }

private:
    static std::string repeated(const std::string& text, std::size_t times) {
        std::string all;
        for (std::size_t i = 0; i < times; ++i) {
            all += text;
        }
        return all;
    }

    template <class Visit>
    static void eachText(const json& value, const Visit& visit) {
        if (value.is_object() && (value.contains("ru") || value.contains("en"))) {
            visit(value);
            return;
        }
        for (const json& item : value) {
            if (item.is_structured()) {
                eachText(item, visit);
            }
        }
    }

    /// All but those of kept runs and the compliance of zones, which have readers of their own.
    static void eachObject(const json& value, const std::string& path,
                           std::vector<std::string>& objects) {
        if (value.is_object()) {
            objects.push_back(path);
        }
        for (const auto& [key, item] : value.items()) {
            if (item.is_structured() && (path != "/project/optimisation" || !item.is_object())) {
                eachObject(item, path + "/" + key, objects);
            }
        }
    }

    static void row(const char* name, const char* pointer, const char* value, IssueCode code,
                    const char* path) {
        addRow(name, pointer, value, static_cast<int>(code), path);
    }

    static void headerRows() {
        row("no format", "/format", "", IssueCode::missingKey, "/format");
        row("other format", "/format", "\"sparkout-project\"", IssueCode::notOneOf, "/format");
        row("no version", "/version", "", IssueCode::missingKey, "/version");
        row("newer version", "/version", "2", IssueCode::newerVersion, "/version");
        row("no whole version", "/version", "1.5", IssueCode::wrongType, "/version");
        row("version 0", "/version", "0", IssueCode::outOfRange, "/version");
        row("no project", "/project", "", IssueCode::missingKey, "/project");
        row("project no object", "/project", "[]", IssueCode::wrongType, "/project");
        row("fault of the project", "/project/wheel/width_mm", "2000", IssueCode::outOfRange,
            "/project/wheel/width_mm");
        row("no steps", "/steps", "", IssueCode::missingKey, "/steps");
        row("empty steps", "/steps", "[]", IssueCode::wrongCount, "/steps");
        row("unknown key", "/points", "1", IssueCode::unknownKey, "/points");
    }

    static void textRows() {
        row("no title", "/title", "{}", IssueCode::missingKey, "/title");
        row("title left out", "/title", "", IssueCode::missingKey, "/title");
        row("no task", "/steps/1/task", "{}", IssueCode::missingKey, "/steps/1/task");
        row("tag in theory", "/theory/ru", "\"<img src='x'>\"", IssueCode::notOneOf, "/theory/ru");
        row("tag in a hint", "/steps/0/hints/0/text/en", "\"<script>\"", IssueCode::notOneOf,
            "/steps/0/hints/0/text/en");
        textLimitRows();
        row("question without an answer", "/guide/questions/1/answer", "{}", IssueCode::missingKey,
            "/guide/questions/1/answer");
        row("no question", "/guide/questions/0/question", "", IssueCode::missingKey,
            "/guide/questions/0/question");
        row("mistake without a text", "/guide/mistakes/0/text", "{}", IssueCode::missingKey,
            "/guide/mistakes/0/text");
        row("no time at all", "/guide/minutes", "0", IssueCode::outOfRange, "/guide/minutes");
    }

    /// A text at its limit is read; one beyond it is refused where it stands.
    static void textLimitRows() {
        const auto refused = [](const char* name, const char* path, const std::string& text,
                                IssueCode code) {
            row(name, path, json(text).dump().c_str(), code, path);
        };
        const char* const theory = "/theory/ru";
        const char* const task = "/steps/1/task/en";
        const char* const hint = "/steps/0/hints/0/text/en";
        refused("tables in tables", theory,
                repeated("<table><tr><td>", limits::lessonTagDepth / 3 + 1), IssueCode::outOfRange);
        refused("too deep in a task", task, repeated("<sub>", limits::lessonTagDepth + 1),
                IssueCode::outOfRange);
        refused("too many tags", theory, repeated("<br>", limits::lessonText.tags + 1),
                IssueCode::outOfRange);
        refused("too many tags in a hint", hint, repeated("<br>", limits::lessonLine.tags + 1),
                IssueCode::outOfRange);
        refused("theory too long", theory, std::string(limits::lessonText.bytes + 1, 'a'),
                IssueCode::stringTooLong);
        refused("hint too long", hint, std::string(limits::lessonLine.bytes + 1, 'a'),
                IssueCode::stringTooLong);
        refused("title too long", "/title/en", std::string(limits::lessonTitle.bytes + 1, 'a'),
                IssueCode::stringTooLong);
    }

    static void stepRows() {
        row("surface 2 of 1", "/steps/0/surface", "2", IssueCode::outOfRange, "/steps/0/surface");
        row("no such input", "/steps/5/inputs/0/path", "\"/cycle/stages/7/stock_mm\"",
            IssueCode::noSuchInput, "/steps/5/inputs/0/path");
        row("half a key", "/steps/6/inputs/0/path", "\"/cyc\"", IssueCode::noSuchInput,
            "/steps/6/inputs/0/path");
        row("input twice", "/steps/6/inputs",
            R"([{"path": "/cycle", "access": "free"}, {"path": "/cycle", "access": "locked"}])",
            IssueCode::duplicateKey, "/steps/6/inputs/1/path");
        row("no access", "/steps/6/inputs/0/access", "", IssueCode::missingKey,
            "/steps/6/inputs/0/access");
        row("other access", "/steps/6/inputs/0/access", "\"open\"", IssueCode::notOneOf,
            "/steps/6/inputs/0/access");
        row("other hidden", "/steps/0/hidden/0/name", "\"everything\"", IssueCode::notOneOf,
            "/steps/0/hidden/0/name");
        row("points below 0", "/steps/0/points", "-1", IssueCode::outOfRange, "/steps/0/points");
        row("hints above the points", "/steps/0/hints/0/price", "1.5", IssueCode::outOfRange,
            "/steps/0/hints/0/price");
        row("no such view", "/steps/0/moment/view", "\"front\"", IssueCode::notOneOf,
            "/steps/0/moment/view");
        row("section in a traverse cycle", "/steps/0/moment/place", "1", IssueCode::notOneOf,
            "/steps/0/moment/place");
        row("stage 3 of 2", "/steps/0/moment/stage", "3", IssueCode::outOfRange,
            "/steps/0/moment/stage");
        row("value of no input", "/steps/0/values", R"([{"path": "/wheel/colour", "number": 1}])",
            IssueCode::noSuchInput, "/steps/0/values/0/path");
        row("value that is refused", "/steps/0/values",
            R"([{"path": "/wheel/width_mm", "number": 5000}])", IssueCode::outOfRange,
            "/steps/0/values/wheel/width_mm");
    }

    static void goalRows() {
        row("no goal", "/steps/0/goal", "{}", IssueCode::wrongCount, "/steps/0/goal");
        row("two goals", "/steps/0/goal/requirements", "{}", IssueCode::wrongCount,
            "/steps/0/goal");
        row("no time", "/steps/6/goal/time", "{}", IssueCode::missingKey,
            "/steps/6/goal/time/below_min");
        row("time 0", "/steps/6/goal/time/below_min", "0", IssueCode::outOfRange,
            "/steps/6/goal/time/below_min");
        row("no figure", "/steps/1/goal/prediction/figure/name", "", IssueCode::missingKey,
            "/steps/1/goal/prediction/figure/name");
        row("other figure", "/steps/1/goal/prediction/figure/name", "\"colour\"",
            IssueCode::notOneOf, "/steps/1/goal/prediction/figure/name");
        row("figure without its place", "/steps/1/goal/prediction/figure/place", "",
            IssueCode::missingKey, "/steps/1/goal/prediction/figure/place");
        row("figure without its stage", "/steps/5/goal/figure/figure",
            R"({"name": "stage_time_min"})", IssueCode::missingKey,
            "/steps/5/goal/figure/figure/stage");
        row("no tolerance", "/steps/5/goal/figure/tolerance", "", IssueCode::missingKey,
            "/steps/5/goal/figure/tolerance");
        row("tolerance 0", "/steps/5/goal/figure/tolerance", "0", IssueCode::outOfRange,
            "/steps/5/goal/figure/tolerance");
        row("curve at one place", "/steps/2/goal/curve/at", "[1]", IssueCode::wrongCount,
            "/steps/2/goal/curve/at");
        row("curve that falls back", "/steps/2/goal/curve/at", "[1, 5, 5]", IssueCode::outOfRange,
            "/steps/2/goal/curve/at/2");
        row("curve at half a stroke", "/steps/2/goal/curve/at/1", "2.5", IssueCode::wrongType,
            "/steps/2/goal/curve/at/1");
        row("no right option", "/steps/0/goal/choice/options/0/right", "false",
            IssueCode::missingKey, "/steps/0/goal/choice/options");
        row("one option", "/steps/0/goal/choice/options",
            R"([{"text": {"en": "yes"}, "right": true}])", IssueCode::wrongCount,
            "/steps/0/goal/choice/options");
    }

    static void variantRows() {
        row("nothing varied", "/variants/inputs", "[]", IssueCode::wrongCount, "/variants/inputs");
        row("range and list", "/variants/inputs/0/list", "[0.02]", IssueCode::wrongCount,
            "/variants/inputs/0");
        row("range without a step", "/variants/inputs/0/step", "", IssueCode::missingKey,
            "/variants/inputs/0/step");
        row("step 0", "/variants/inputs/0/step", "0", IssueCode::outOfRange,
            "/variants/inputs/0/step");
        row("range upside down", "/variants/inputs/0/to", "0.01", IssueCode::wrongCount,
            "/variants/inputs/0");
        row("too many levels", "/variants/inputs/0/step", "1e-9", IssueCode::wrongCount,
            "/variants/inputs/0");
        row("empty list", "/variants/inputs/2/list", "[]", IssueCode::wrongCount,
            "/variants/inputs/2");
        row("no number", "/variants/inputs/0/path", "\"/wheel/marking\"", IssueCode::noSuchNumber,
            "/variants/inputs/0/path");
        row("varied twice", "/variants/inputs/1/path", "\"/wheel/dullness\"",
            IssueCode::variedTwice, "/variants/inputs/1/path");
        row("no such input in a set", "/variants/inputs/3/sets/1/values/2/path", "\"/wheel/x\"",
            IssueCode::noSuchNumber, "/variants/inputs/3/sets/1/values/2/path");
        row("bound of a step that is not there", "/variants/figures",
            R"([{"figure": {"name": "steps"}, "step": 9, "least": 1}])", IssueCode::outOfRange,
            "/variants/figures/0/step");
        row("bound without an end", "/variants/figures", R"([{"figure": {"name": "steps"}}])",
            IssueCode::missingKey, "/variants/figures/0/least");
        row("bound without a place", "/variants/figures",
            R"([{"figure": {"name": "roundness_um"}, "least": 1}])", IssueCode::missingKey,
            "/variants/figures/0/figure/place");
        row("bound of a batch that is not there", "/variants/figures",
            R"([{"figure": {"name": "batch_ppk", "place": "nz"}, "least": 1}])",
            IssueCode::missingKey, "/project/batch");
        row("other surface", "/variants/surface", "3", IssueCode::outOfRange, "/variants/surface");
    }
};

} // namespace sparkout::test_lesson_file

SPARKOUT_TEST(test_lesson_file, TestLessonFile)
#include "test_lesson_file.moc"
