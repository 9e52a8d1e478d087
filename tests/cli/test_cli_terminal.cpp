// SPDX-License-Identifier: GPL-3.0-or-later
// What a file holds never steers the terminal that its results are printed to, nor forges a line.
#include "core/lesson/lesson_file.h"
#include "core/printable.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <string_view>

namespace test_cli_terminal {

using namespace sparkout;
using namespace cli;

/// Sets the window's title, clears the screen, colours, turns the direction, and begins a line.
const std::string hostile = "A\x1b]0;title\x07\x1b[2J\x1b[31m\b\x7f\u0085\u009b2J\u202e\u2066\u200f"
                            "\u061c\u2028\r\nforged: all requirements hold\tB";

/// The first character of a text that steers a terminal; empty: there is none.
std::string steering(std::string_view text) {
    for (const unsigned char byte : text) {
        if ((byte < 0x20 && byte != '\n') || byte == 0x7f) {
            return "byte " + std::to_string(byte);
        }
    }
    for (unsigned code = 0x80; code < 0xa0; ++code) {
        if (text.find(std::string{'\xc2', static_cast<char>(code)}) != text.npos) {
            return "C1 " + std::to_string(code);
        }
    }
    for (const char* mark :
         {"\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202b", "\u202c", "\u202d",
          "\u202e", "\u2066", "\u2067", "\u2068", "\u2069"}) {
        if (text.find(mark) != text.npos) {
            return printable(mark);
        }
    }
    return {};
}

using Accepted = std::function<bool(const json& file)>;

/// Puts a text into every text of a file, one after the other, where the file stays readable; names
/// those where it did.
void poison(json& file, json& place, const std::string& path, const Accepted& accepted,
            QStringList& where) {
    if (place.is_string()) {
        const json before = std::exchange(place, hostile);
        if (accepted(file)) {
            where << QString::fromStdString(path);
        } else {
            place = before;
        }
        return;
    }
    if (place.is_structured()) {
        for (auto& [key, value] : place.items()) {
            poison(file, value, path + '/' + key, accepted, where);
        }
    }
}

void checkPrinted(const ProcessOutcome& outcome, const QStringList& command) {
    const std::string name = command.join(' ').toStdString();
    for (const std::string* text : {&outcome.out, &outcome.err}) {
        const std::string found = steering(*text);
        QVERIFY2(found.empty(), (name + ": " + found + '\n' + printableLines(*text)).c_str());
        QVERIFY2(text->find("\nforged:") == text->npos, (name + '\n' + *text).c_str());
    }
}

class TestCliTerminal : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    /// The requirement's name of a kept run that is not the engine's any more.
    void namesOfKeptRunsAreShownLetterByLetter() {
        json file = json::parse(samples::readText(
            samples::sourcePath("resources/examples/shaft-30h6-factory.sparkout")));
        file["runs"][0]["summary"]["requirements"][0]["name"] = hostile;
        const QString path = save("kept.sparkout", file.dump());
        const ProcessOutcome outcome = run({"simulate", path});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(has(outcome.err, "\\u001B]0;title\\u0007"), outcome.err.c_str());
        QCOMPARE(lines(outcome.err), 1U); // one kept run, one line
        checkPrinted(outcome, {"simulate"});
    }

    void noTextOfAProjectSteersTheTerminal() {
        json file = json::parse(samples::readText(
            samples::sourcePath("resources/examples/shaft-30h6-factory.sparkout")));
        file["runs"].erase(1);
        file["batch"]["parts"] = 3;
        QStringList where;
        poison(
            file, file, {},
            [](const json& now) { return readProject(now.dump()).project.has_value(); }, where);
        for (const char* path : {"/title", "/notes", "/machine/name", "/runs/0/name",
                                 "/runs/0/summary/requirements/0/name"}) {
            QVERIFY2(where.contains(path), path);
        }
        const QString path = save("poisoned.sparkout", file.dump());
        for (const QStringList& command : {QStringList{"validate", path},
                                           {"simulate", path},
                                           {"batch", path},
                                           {"phases", path, "--from", "0.15", "--to", "0.1501"},
                                           {"remedies", path}}) {
            const ProcessOutcome outcome = run(command);
            QVERIFY2(outcome.status >= 0 && outcome.status != 2, outcome.text().c_str());
            checkPrinted(outcome, command);
        }
        // JSON stays valid.
        const ProcessOutcome outcome = run({"simulate", path, "--json"});
        checkPrinted(outcome, {"simulate --json"});
        const json result = json::parse(outcome.out);
        QVERIFY(result.is_object() && !result.empty());
    }

    /// Faults quote what stands in the file, keys and values.
    void faultsQuoteLetterByLetter() {
        json file = samples::sample("smallest-plunge");
        file["wheel"][hostile] = hostile;
        file["part"]["profile"] = hostile;
        const QString path = save("faults.sparkout", file.dump());
        for (const QStringList& command : {QStringList{"validate", path}, {"simulate", path}}) {
            const ProcessOutcome outcome = run(command);
            QCOMPARE(outcome.status, 1);
            QVERIFY(lines(outcome.err) >= 2);
            checkPrinted(outcome, command);
        }
        checkPrinted(run({"simulate", QString::fromStdString(hostile)}), {"simulate", "a name"});
        checkPrinted(run({QString::fromStdString(hostile)}), {"a command"});
    }

    void noTextOfALessonSteersTheTerminal() {
        json file = json::parse(samples::readText(
            samples::sourcePath("resources/lessons/02-actual-feed.sparkout-lesson")));
        QStringList where;
        poison(
            file, file, {},
            [](const json& now) { return readLesson(now.dump()).lesson.has_value(); }, where);
        QVERIFY(where.contains("/title/en"));
        const QString path = save("poisoned.sparkout-lesson", file.dump());
        for (const QStringList& command :
             {QStringList{"course", "check", path}, {"course", "check", path, "--json"}}) {
            checkPrinted(run(command), command);
        }
    }

    void escapedLinesKeepWhatJsonMeans() {
        const json value = {{"name", hostile}, {"nested", {hostile, "вал", "a\\b"}}};
        for (const int indent : {-1, 2}) {
            const std::string printed = printableLines(value.dump(indent) + '\n');
            QCOMPARE(steering(printed), std::string());
            QVERIFY(json::parse(printed) == value);
        }
        QCOMPARE(printableLines("a\nвал\n"), std::string("a\nвал\n"));
        QCOMPARE(printableLines("\xff\t"), std::string("\\xFF\\u0009"));
    }
};

} // namespace test_cli_terminal

SPARKOUT_TEST(test_cli_terminal, TestCliTerminal)
#include "test_cli_terminal.moc"
