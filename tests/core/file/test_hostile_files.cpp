// SPDX-License-Identifier: GPL-3.0-or-later
// Reliability checks 5 and 7: files that are damaged or meant to harm.
#include "core/file/safe_file.h"
#include "core/project/validate.h"
#include "tests/check_line.h"
#include "tests/core/support/project_samples.h"
#include "tests/processor_time.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <cstddef>

#ifndef Q_OS_WIN
#include <sys/resource.h>
#endif

namespace sparkout::test_hostile_files {

using nlohmann::json;

#ifdef Q_OS_WIN
// windows.h would bring its short names to all tests that are compiled together with this one.
struct ProcessMemory {
    unsigned long size = sizeof(ProcessMemory), faults = 0;
    std::size_t peak = 0, others[7] = {};
};
extern "C" __declspec(dllimport) void* __stdcall GetCurrentProcess();
extern "C" __declspec(dllimport) int __stdcall K32GetProcessMemoryInfo(void*, ProcessMemory*,
                                                                       unsigned long);
#endif

/// Peak resident memory of this process so far [MB].
double peakMemory_mb() {
#ifdef Q_OS_WIN
    ProcessMemory memory;
    if (K32GetProcessMemoryInfo(GetCurrentProcess(), &memory, sizeof memory) == 0) {
        qFatal("Windows does not tell the memory of this process");
    }
    return static_cast<double>(memory.peak) / (1024 * 1024);
#else
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
#endif
}

std::string repeated(const std::string& piece, std::size_t count) {
    std::string text;
    text.reserve(piece.size() * count);
    for (std::size_t i = 0; i < count; ++i) {
        text += piece;
    }
    return text;
}

/// What a reader must do with any text; empty when it does.
std::string faultOfAnswer(const ReadResult& read) {
    if (!read.project && !hasErrors(read.issues)) {
        return "refused without an error";
    }
    if (read.project && hasErrors(read.issues)) {
        return "accepted with errors";
    }
    if (read.issues.size() > limits::issues) {
        return "too many issues";
    }
    for (const Issue& issue : read.issues) {
        const std::string sentence = issueSentence(issue);
        if (sentence.empty() || sentence.size() > 2000 || issue.path.size() > 5000) {
            return "no readable sentence";
        }
        if (!QString::fromStdString(issue.path + sentence).toStdString().ends_with(sentence)) {
            return "the message is not UTF-8";
        }
    }
    if (read.project) {
        if (hasErrors(validate(*read.project))) {
            return "accepted a project with errors";
        }
        const ReadResult again = readProject(writeProject(*read.project));
        if (!again.project || !sameProject(*read.project, *again.project)) {
            return "does not round-trip";
        }
    }
    return {};
}

/// A fiftieth of a count under the sanitizers, which take ten times as long.
std::size_t many(int count) {
    return static_cast<std::size_t>(samples::sized(count, count / 50, count));
}

/// The sample without its last brace, to go on with: `… , KEY: VALUE }`.
std::string with(const std::string& members) {
    std::string text = samples::text("smallest-plunge");
    return text.substr(0, text.rfind('}')) + "," + members + "}";
}

/// The sample with the value of a key replaced by any text.
std::string replaced(const std::string& key, const std::string& value) {
    std::string text = samples::text("smallest-plunge");
    const std::size_t at = text.find("\"" + key + "\": ") + key.size() + 4;
    return text.replace(at, text.find_first_of(",\n", at) - at, value);
}

class TestHostileFiles : public QObject {
    Q_OBJECT

private slots:
    void file_data() {
        addColumns<int, bool>("index", "accepted");
        encodingRows();
        numberRows();
        syntaxRows();
        structureRows();
        sizeRows();
        leafRows();
        fileRows();
        QVERIFY(m_texts.size() >= 150);
    }
    void file() {
        QFETCH(int, index);
        QFETCH(bool, accepted);
        const std::string content = m_texts[static_cast<std::size_t>(index)]();
        const double start_ms = processorTime_ms();
        const ReadResult read = readProject(content);
        const auto time_ms = static_cast<qint64>(processorTime_ms() - start_ms);
        m_slowest_ms = std::max(m_slowest_ms, time_ms);
        QVERIFY2(time_ms < samples::sized(2000, 20'000, 2000), std::to_string(time_ms).c_str());
        const std::string fault = faultOfAnswer(read);
        QVERIFY2(fault.empty(), fault.c_str());
        QVERIFY2(read.project.has_value() == accepted, samples::listed(read.issues).c_str());
    }

    void memoryStaysBounded() {
        const double peak = peakMemory_mb();
        const bool judged = !std::getenv("SPARKOUT_QUICK"); // the sanitizers need memory themselves
        const bool small = peak < 512 && m_slowest_ms < 2000;
        checkLine(
            "07", double(m_texts.size()), 150, !judged || (small && m_texts.size() >= 150),
            QStringLiteral("hostile files answered as documented: slowest %1 ms (below 2000), "
                           "peak %2 MB (below 512%3)")
                .arg(m_slowest_ms)
                .arg(peak, 0, 'f', 0)
                .arg(judged ? QString() : QStringLiteral(", not judged here")));
        QVERIFY(!judged || small);
    }

    void cutAtEveryByte() {
        const std::string whole = sampleOf4Kb();
        qint64 slowest_us = 0;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            readTimed(whole.substr(0, length), slowest_us);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        checkLine("05", double(whole.size()), double(whole.size()), slowest_us < 1'000'000,
                  QStringLiteral("bytes of a sample, cut at each: no crash, slowest %1 µs")
                      .arg(slowest_us));
    }

    void everyBitFlipped() {
        std::string text = sampleOf4Kb();
        qint64 slowest_us = 0;
        const auto step = static_cast<std::size_t>(samples::sized(1, 13, 1));
        for (std::size_t bit = 0; bit < 8 * text.size(); bit += step) {
            const char before = text[bit / 8];
            text[bit / 8] = static_cast<char>(before ^ (1 << bit % 8));
            readTimed(text, slowest_us);
            text[bit / 8] = before;
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        const auto bits = double(8 * text.size()), flipped = double(8 * text.size() / step);
        checkLine(
            "05", flipped, asked(bits, flipped),
            slowest_us < 1'000'000 && flipped >= asked(bits, flipped),
            QStringLiteral("bits of the sample flipped: no crash, slowest %1 µs").arg(slowest_us));
    }

private:
    static void readTimed(const std::string& text, qint64& slowest_us) {
        RunningTimer timer;
        const ReadResult read = readProject(text);
        slowest_us = std::max(slowest_us, timer.nsecsElapsed() / 1000);
        QVERIFY(timer.elapsed() < 1000);
        const std::string fault = faultOfAnswer(read);
        QVERIFY2(fault.empty(), (fault + "\n" + text).c_str());
    }

    static std::string sampleOf4Kb() { return writeProject(samples::project("complete")); }

    /// A file that is built only when it is read: the large ones shall not stand in memory at once.
    using Text = std::function<std::string()>;

    void refused(const std::string& name, const Text& text) { add(name, text, false); }
    void accepted(const std::string& name, const Text& text) { add(name, text, true); }
    void refused(const std::string& name, const std::string& text) {
        add(
            name, [text] { return text; }, false);
    }
    void accepted(const std::string& name, const std::string& text) {
        add(
            name, [text] { return text; }, true);
    }
    void add(const std::string& name, const Text& text, bool isAccepted) {
        QTest::newRow(name.c_str()) << static_cast<int>(m_texts.size()) << isAccepted;
        m_texts.push_back(text);
    }

    void encodingRows() {
        using namespace std::string_literals;
        const std::string good = samples::text("smallest-plunge");
        refused("empty", "");
        refused("spaces", "   \n\t ");
        refused("BOM alone", "\xEF\xBB\xBF");
        accepted("BOM", "\xEF\xBB\xBF" + good);
        refused("two BOMs", "\xEF\xBB\xBF\xEF\xBB\xBF" + good);
        const QString wide = QString::fromStdString(good);
        const auto* units = reinterpret_cast<const char*>(wide.utf16());
        const auto bytes = static_cast<std::size_t>(wide.size()) * 2;
        refused("UTF-16", std::string(units, bytes));
        refused("UTF-16 with BOM", "\xFF\xFE" + std::string(units, bytes));
        refused("NUL", "\0"s);
        refused("many NULs", std::string(100'000, '\0'));
        refused("NUL before", "\0"s + good);
        refused("NUL after", good + "\0"s);
        refused("NUL in a string", with("\"notes\": \"a\0b\""s));
        accepted("escaped NUL", with(R"("notes": "a\u0000b")"));
        for (const char* bad :
             {"\xFF", "\xC0\x80", "\xC3", "\xE2\x28\xA1", "\xED\xA0\x80", "\xF5\x80\x80\x80",
              "\xF4\x90\x80\x80", "\x80", "\xE0\x80\xAF", "\xF0\x9F\x9B"}) {
            refused("invalid UTF-8 " + QByteArray(bad).toHex().toStdString(),
                    with("\"notes\": \"" + std::string(bad) + "\""));
        }
        refused("invalid UTF-8 in a key", with("\"\xFF\": 1"));
        refused("lone surrogate", with(R"("notes": "\ud800")"));
        refused("lone low surrogate", with(R"("notes": "\udc00 ")"));
        refused("reversed surrogates", with(R"("notes": "\udc00\ud800")"));
        accepted("surrogate pair", with(R"("notes": "\ud83d\udee0")"));
        accepted("noncharacter", with("\"notes\": \"\xEF\xBF\xBF\""));
        refused("NUL and more after", good + "\0"s + good);
        accepted("direction override in a text", with("\"notes\": \"\u202Egnp\""));
        refused("direction override in a key", with("\"\u202Eeltit\": 1"));
        refused("escape sequence in a key", with("\"\\u001b[2J\": 1"));
        refused("line ends in a key", with(R"("a\nb\r\u2028c": 1)"));
        refused("Latin-1", "{\"title\": \"\xD6\"}");
        refused("raw line end in a string", with("\"notes\": \"a\nb\""));
    }

    void numberRows() {
        for (const std::string& text : samples::listOf(
                 "1e309|-1e309|1e999999999|NaN|nan|Infinity|-Infinity|inf|1e308|-1e308|-1|0|"
                 "4.9e-324|0x32|050|+50|.5|5.|5e|1_000|5,0|9007199254740993|"
                 "18446744073709551616|-9223372036854775809|1e-400|--5|1e1e1|50mm|\"50\"|null|"
                 "true|[50]|{}|５０")) {
            refused("width " + text, replaced("width_mm", text));
        }
        accepted("width 5e1", replaced("width_mm", "5e1"));
        accepted("width 50.000…", replaced("width_mm", "50." + std::string(10'000, '0')));
        refused("width of 1e6 digits", replaced("width_mm", std::string(1'000'000, '9')));
        accepted("dullness denormal", replaced("dullness", "4.9e-324"));
        accepted("dullness -0", replaced("dullness", "-0"));
        for (const char* text : {"1.5", "2147483648", "-2147483648", "9007199254740993", "1e300",
                                 "-4", "0", "1e3", "18446744073709551615", "\"4\""}) {
            refused(std::string("sections ") + text, with(std::string("\"sections\": ") + text));
        }
        for (const char* text :
             {"2", "99999999999999999999", "-1", "1.5", "\"1\"", "null", "1e300", "[]"}) {
            refused(std::string("version ") + text, replaced("version", text));
        }
    }

    void syntaxRows() {
        const std::string good = samples::text("smallest-plunge");
        accepted("as it is", good);
        for (const char* tail : {"}", "{}", "x", "null", "//", "/* */", ";", "\x1a", "]"}) {
            refused(std::string("trailing ") + tail, good + tail);
        }
        refused("twice", good + good);
        refused("line comment", "// a project\n" + good);
        refused("block comment", with("/* notes */ \"notes\": \"\""));
        refused("hash comment", "# a project\n" + good);
        refused("single quotes", with("'notes': ''"));
        refused("bare key", with("notes: \"\""));
        refused("trailing comma", with("\"notes\": \"\","));
        refused("two commas", with(",\"notes\": \"\""));
        refused("no colon", with("\"notes\" \"\""));
        refused("unclosed string", with("\"notes\": \""));
        refused("bad escape", with(R"("notes": "\x41")"));
        refused("short escape", with(R"("notes": "\u00")"));
        refused("True", with("\"sections_coupled\": True"));
        refused("undefined", with("\"batch\": undefined"));
        refused("YAML", "format: sparkout-project\nversion: 1\n");
        refused("XML", "<?xml version=\"1.0\"?><project/>");
        refused("zip", "PK\x03\x04 and so on");
        refused("ELF", "\x7f"
                       "ELF\x02\x01\x01");
        refused("shell", "#!/bin/sh\nrm -rf /\n");
    }

    void structureRows() {
        for (const char* text :
             {"null", "true", "1", "\"sparkout-project\"", "[]", "{}", "[{}]", "[[]]"}) {
            refused(std::string("whole file ") + text, text);
        }
        for (const char* key :
             {"part", "wheel", "machine", "material", "cycle", "gauge", "runs", "batch"}) {
            refused(std::string(key) + " as text", with('"' + std::string(key) + "\": \"\""));
        }
        refused("key twice", with(R"("notes": "", "notes": "")"));
        refused("key twice, escaped", with(R"("notes": "", "\u006eotes": "")"));
        refused("operation twice", with(R"("operation": "traverse")"));
        refused("empty key", with("\"\": 1"));
        refused("prototype", with("\"__proto__\": {}"));
        refused("key with a slash", with("\"a/b~c\": {}"));
        refused("other case", with("\"Title\": \"\""));
        refused("Cyrillic look-alike", with("\"titlе\": \"\""));
        refused("runs in runs", nestedRuns(14));
        refused("no inputs in a run",
                with(R"("runs": [{"name": "", "when": "", "engine_version": "",
                                              "inputs": {}, "summary": {}}])"));
        accepted("runs in a kept run", nestedRuns(1));
    }

    static std::string nestedRuns(int levels) {
        std::string inner = samples::text("smallest-plunge");
        for (int i = 0; i < levels; ++i) {
            inner = with(R"("runs": [{"name": "", "when": "", "engine_version": "", "summary": {},
                           "inputs": )"
                         + inner + "}]");
        }
        return levels > 1 ? inner + "x" : inner;
    }

    static std::string manyKeys(std::size_t count) {
        std::string keys = "\"k\":0";
        for (std::size_t i = 0; i < count; ++i) {
            keys += ",\"k" + std::to_string(i) + "\":0";
        }
        return keys;
    }

    void sizeRows() {
        refused("depth 64", repeated("[", 64) + repeated("]", 64));
        refused("depth 65", repeated("[", 65) + repeated("]", 65));
        refused("depth 1e6", [] { return repeated("[", 1'000'000) + repeated("]", 1'000'000); });
        refused("depth 1e6 in a key", [] { return with("\"notes\":" + repeated("[", 1'000'000)); });
        refused("10 MB of [", [] { return std::string(10'000'000, '['); });
        refused("10 MB of {\"a\":", [] { return repeated("{\"a\":", 2'000'000); });
        refused("10 MB of [{\"a\":", [] { return repeated("[{\"a\":", 1'700'000); });
        refused("10 MB of ]", [] { return std::string(10'000'000, ']'); });
        refused("30 MB of [],", [] { return "[" + repeated("[],", many(10'000'000)) + "[]]"; });
        refused("30 MB of {},", [] { return "[" + repeated("{},", many(10'000'000)) + "{}]"; });
        refused("2,000,001 values", [] { return "[" + repeated("0,", 1'999'999) + "0]"; });
        refused("2e6 values out of range", [] {
            return with("\"optimisation\":{\"stages\":[" + repeated("9,", many(1'900'000)) + "9]}");
        });
        refused("2e6 values of wrong type", [] {
            return with("\"optimisation\":{\"stages\":[" + repeated("\"\",", many(1'900'000))
                        + "0]}");
        });
        refused("1e6 stages", [] {
            return "{\"format\":\"sparkout-project\",\"version\":1,\"operation\":\"plunge\","
                   "\"cycle\":{\"stages\":["
                   + repeated("{},", many(999'999)) + "{}]}}";
        });
        refused("500,000 unknown keys", [] { return with(manyKeys(many(500'000))); });
        refused("1e6 duplicate keys",
                [] { return with("\"notes\":\"\"" + repeated(",\"notes\":\"\"", 1'000'000)); });
        refused("duplicates under long keys", [] {
            const std::string key = "\"" + std::string(65'000, 'k') + "\":{";
            return with(repeated(key, 60) + "\"a\":0" + repeated(",\"a\":0", 1'000'000)
                        + repeated("}", 60));
        });
        accepted("a summary of 500,000 keys", [] {
            return with("\"runs\":[{\"name\":\"\",\"when\":\"\",\"engine_version\":\"\",\"inputs\":"
                        + samples::text("smallest-plunge") + ",\"summary\":{"
                        + manyKeys(many(500'000)) + "}}]");
        });
        accepted("a text of 64 KB", with("\"notes\":\"" + std::string(65'536, 'x') + "\""));
        refused("a text of 64 KB + 1", with("\"notes\":\"" + std::string(65'537, 'x') + "\""));
        refused("a text of 1 MB", with("\"notes\":\"" + std::string(1 << 20, 'x') + "\""));
        refused("a key of 1 MB", with("\"" + std::string(1 << 20, 'x') + "\":0"));
        refused("30 MB of spaces", [] { return std::string(30'000'000, ' '); });
        accepted("30 MB of spaces after",
                 [] { return samples::text("smallest-plunge") + std::string(30'000'000, ' '); });
        refused("32 MB + 1", [] {
            return samples::text("smallest-plunge") + std::string(limits::fileBytes, ' ');
        });
        refused("30 MB of escapes",
                [] { return with("\"notes\":\"" + repeated("\\u0041", 5'000'000) + "\""); });
    }

    /// Wrong types for every leaf of the fullest file stand in test_project_file; here one each.
    void leafRows() {
        const json whole = samples::sample("everything");
        const json flat = whole.flatten();
        for (const auto& [path, value] : flat.items()) {
            if (!path.starts_with("/runs/0/inputs") && !path.starts_with("/runs/0/summary")) {
                json file = whole;
                file[json::json_pointer(path)] = json{{{"x", nullptr}}};
                refused("wrong " + path, file.dump());
            }
        }
    }

    /// tests/data/hostile: refused unless the name says "accepted".
    void fileRows() {
        for (const auto& entry :
             std::filesystem::directory_iterator(samples::sourcePath("tests/data/hostile"))) {
            const std::string name = entry.path().filename().string();
            add(
                name, [path = entry.path()] { return samples::readText(path); },
                name.starts_with("accepted"));
        }
    }

    std::vector<Text> m_texts;
    qint64 m_slowest_ms = 0;
};

} // namespace sparkout::test_hostile_files

SPARKOUT_TEST(test_hostile_files, TestHostileFiles)
#include "test_hostile_files.moc"
