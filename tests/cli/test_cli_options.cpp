// SPDX-License-Identifier: GPL-3.0-or-later
// The table of options: what it says is what the programs accept, refuse and print.
#include "app/manual/given.h"
#include "app/manual/help_text.h"
#include "tests/cli/cli_process.h"
#include "tests/registry.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <cmath>
#include <map>
#include <stdexcept>

namespace test_cli_options {

using namespace sparkout;
using namespace cli;
using namespace manual;

const Program* const programs[] = {&windowProgram(), &commandLineProgram()};

/// The words that lead to a command, as a shell hands them over.
QStringList wordsTo(const Program& program, const Command& command) {
    return &command == &program ? QStringList()
                                : QString::fromUtf8(command.name).split(u' ', Qt::SkipEmptyParts);
}

std::vector<std::string> standard(const QStringList& words) {
    std::vector<std::string> all;
    for (const QString& word : words) {
        all.push_back(word.toStdString());
    }
    return all;
}

QString faultOf(const Program& program, const QStringList& words) {
    return QString::fromStdString(Reading(program, standard(words)).fault);
}

const Program& programNamed(const QString& name) {
    return name == u"sparkout" ? windowProgram() : commandLineProgram();
}

/// A bound of a range as a message states it.
QString boundText(double bound) {
    return bound == std::floor(bound) ? QString::number(bound, 'f', 0) : QString::number(bound);
}

bool isNumber(const Value& value) {
    return value.kind == manual::Kind::integer || value.kind == manual::Kind::integers
           || value.kind == manual::Kind::number || value.kind == manual::Kind::numbers;
}

/// A row for each option that takes such a value.
template <class Takes>
void optionRows(Takes takes) {
    addColumns<QString, QStringList, QString>("program", "command", "option");
    for (const Program* program : programs) {
        for (const Command* command : withAllBelow(*program)) {
            for (const Option& option : command->options) {
                if (command->commands.empty() && takes(option)) {
                    QTest::addRow("%s %s %s", program->name,
                                  command == program ? "" : command->name, option.name)
                        << QString::fromUtf8(program->name) << wordsTo(*program, *command)
                        << QString::fromUtf8(option.name);
                }
            }
        }
    }
}

const Option& rowOf(const Program& program, const QStringList& words, const QString& name) {
    const Command* command = &program;
    for (const QString& word : words) {
        command = commandNamed(*command, word.toStdString());
    }
    return *optionNamed(*command, name.toStdString());
}

/// The sections of a help page with a usage line of a command; for a program with commands the text
/// before the first section, which is about all of them.
QString textOn(const QString& html, const Program& program, const Command& command) {
    static const QRegularExpression heading("(?=<h2 )");
    const QStringList parts = html.split(heading);
    if (&command == &program && !program.commands.empty()) {
        return parts.front();
    }
    const QString words = (QStringList{program.name} + wordsTo(program, command)).join(u' ');
    const QRegularExpression usage("(^|<pre>)" + words + "(?= )",
                                   QRegularExpression::MultilineOption);
    return parts.filter(usage).join(u'\n');
}

class TestCliOptions : public QObject {
    Q_OBJECT

private slots:
    void everyCommandHelps_data() {
        addColumns<QStringList, QStringList>("words", "options");
        const Program& program = commandLineProgram();
        for (const Command* command : withAllBelow(program)) {
            QStringList options;
            for (const Command* each : withAllBelow(*command)) {
                for (const Option& option : each->options) {
                    options << QString::fromStdString(asTyped(option));
                }
            }
            QTest::newRow(command->name) << wordsTo(program, *command) << options;
        }
    }
    void everyCommandHelps() {
        QFETCH(QStringList, words);
        QFETCH(QStringList, options);
        for (const char* help : {"--help", "-h"}) {
            const ProcessOutcome outcome = run(words + QStringList{QString::fromUtf8(help)});
            QVERIFY2(outcome.status == 0 && outcome.err.empty(), outcome.text().c_str());
            const QString text = QString::fromStdString(outcome.out);
            QVERIFY2(text.contains("sparkout-cli " + words.join(u' ')), outcome.out.c_str());
            for (const QString& option : options + QStringList{"--help"}) {
                QVERIFY2(text.contains("\n  " + option), qPrintable(option));
            }
        }
        // Whatever else stands there.
        const QStringList crowded = words + QStringList{"--help", "a", "b", "--none"};
        QCOMPARE(run(crowded).status, 0);
    }

    void theWindowHelpsToo() {
        const Program& program = windowProgram();
        QVERIFY(Reading(program, {"--help"}).asksForHelp && Reading(program, {"-h"}).asksForHelp);
        const std::string text = helpText(program, program);
        for (const Option& option : program.options) {
            QVERIFY2(text.find("\n  " + asTyped(option)) != std::string::npos, option.name);
        }
    }

    void numbersAreHeldAgainstTheirRange_data() {
        optionRows([](const Option& option) { return isNumber(option.value); });
    }
    void numbersAreHeldAgainstTheirRange() {
        QFETCH(QString, program);
        QFETCH(QStringList, command);
        QFETCH(QString, option);
        const Program& of = programNamed(program);
        const Value& value = rowOf(of, command, option).value;
        const bool fromZero = value.low == aboveZero;
        const bool isDecimal =
            value.kind == manual::Kind::number || value.kind == manual::Kind::numbers;
        const int digits = isDecimal ? 3 : 0;
        const auto said = [&](const QString& text) {
            return faultOf(of, command + QStringList{"a", option, text});
        };
        for (const QString& wrong : {QString("x"), QString("1x"), QString(), QString("nan"),
                                     QString::number(value.low - 1, 'f', digits),
                                     QString::number(2 * value.high + 1, 'f', 0)}) {
            const QString fault = said(wrong);
            QVERIFY2(fault.startsWith(option + " needs "), qPrintable(fault));
            QVERIFY2(fault.endsWith(", not “" + wrong + "”"), qPrintable(fault));
            QVERIFY2(
                fault.contains((fromZero ? " above 0, up to " : " to ") + boundText(value.high)),
                qPrintable(fault));
            QVERIFY2(fromZero || fault.contains(" from " + boundText(value.low)),
                     qPrintable(fault));
        }
        for (const double bound : {value.low, value.high}) {
            const QString fault = said(QString::number(bound, 'f', fromZero ? 9 : 2 * digits / 3));
            QVERIFY2(!fault.contains("not “"), qPrintable(fault));
        }
        QVERIFY(faultOf(of, command + QStringList{"a", option}).startsWith(option + " needs "));
    }

    void theProgramSaysWhatIsWrongWithANumber() {
        const ProcessOutcome outcome = run({"batch", "a", "--parts", "1000001"});
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
        QCOMPARE(outcome.err, std::string("sparkout-cli: --parts needs a number from 1 to 1000000, "
                                          "not “1000001”; see sparkout-cli --help\n"));
    }

    void choicesAreWhatTheTableNames_data() {
        optionRows([](const Option& option) { return option.value.kind == manual::Kind::choice; });
    }
    void choicesAreWhatTheTableNames() {
        QFETCH(QString, program);
        QFETCH(QStringList, command);
        QFETCH(QString, option);
        const Program& of = programNamed(program);
        const auto choices = wordsOf(rowOf(of, command, option).value.choices);
        const QString fault = faultOf(of, command + QStringList{"a", option, "nothing"});
        QVERIFY2(fault.startsWith(option + " needs ") && fault.endsWith("not “nothing”"),
                 qPrintable(fault));
        for (const std::string_view choice : choices) {
            const QString word = QString::fromUtf8(choice.data(), qsizetype(choice.size()));
            QVERIFY2(fault.contains(word), qPrintable(fault));
            const QString right = faultOf(of, command + QStringList{"a", option, word});
            QVERIFY2(!right.contains("not “"), qPrintable(right));
        }
    }

    void unknownOptionsAreRefusedAndTheNearOnesNamed_data() {
        optionRows(
            [](const Option& option) { return std::string_view(option.name).starts_with("--"); });
    }
    void unknownOptionsAreRefusedAndTheNearOnesNamed() {
        QFETCH(QString, program);
        QFETCH(QStringList, command);
        QFETCH(QString, option);
        const Program& of = programNamed(program);
        for (const QString& wrong : {option + u'x', option + "x=1"}) {
            const QString fault = faultOf(of, command + QStringList{"a", wrong});
            QVERIFY2(fault.startsWith("unknown option " + option + "x (did you mean "),
                     qPrintable(fault));
            QVERIFY2(fault.contains(option + ' ') || fault.contains(option + ',')
                         || fault.contains(option + '?'),
                     qPrintable(fault));
        }
    }

    void everyCommandRefusesWhatItDoesNotKnow() {
        const Program& program = commandLineProgram();
        for (const Command* command : withAllBelow(program)) {
            const QStringList words = wordsTo(program, *command);
            const ProcessOutcome near = run(words + QStringList{"--hepl"});
            QVERIFY2(isUsageError(near), near.text().c_str());
            QVERIFY2(near.err.find("unknown option --hepl (did you mean --help?)")
                         != std::string::npos,
                     near.err.c_str());
            const ProcessOutcome far = run(words + QStringList{"--qqqqqqqq"});
            QVERIFY2(isUsageError(far), far.text().c_str());
            QVERIFY2(far.err.find("did you mean") == std::string::npos, far.err.c_str());
        }
        QCOMPARE(faultOf(program, {"simulat", "a"}),
                 QString("unknown command simulat (did you mean simulate?)"));
        QCOMPARE(faultOf(program, {"course", "mark"}), QString("unknown command course mark"));
    }

    void optionsReadAsTheyAreWritten() {
        const Program& program = commandLineProgram();
        const Reading joined(program, {"batch", "--parts=7", "a", "--rows=b=c.csv", "--force"});
        QVERIFY2(joined.fault.empty(), joined.fault.c_str());
        QCOMPARE(joined.given.integer("--parts").value(), 7);
        QCOMPARE(joined.given.text("--rows"), std::string("b=c.csv"));
        QVERIFY(joined.given.has("--force") && !joined.given.has("--json"));
        QVERIFY(!joined.given.integer("--seed") && joined.given.text("--shard").empty());
        QCOMPARE(joined.given.operands, std::vector<std::string>{"a"});
        QCOMPARE(faultOf(program, {"batch", "a", "--json=1"}), QString("--json takes no value"));
        // The last one counts, and behind -- everything is an operand.
        const Reading twice(program, {"optimize", "--stages", "1", "--stages", "2,3", "--", "-o"});
        QVERIFY2(twice.fault.empty(), twice.fault.c_str());
        QCOMPARE(twice.given.integers("--stages"), (std::vector<int>{2, 3}));
        QCOMPARE(twice.given.operands, std::vector<std::string>{"-o"});
        const Reading phases(program, {"phases", "a", "--from", "0.125"});
        QCOMPARE(phases.given.number("--from").value(), 0.125);
        const Reading comma(program, {"phases", "a", "--from", "0,125"});
        QVERIFY2(comma.fault.empty(), comma.fault.c_str());
        QCOMPARE(comma.given.number("--from").value(), 0.125);
        QCOMPARE(faultOf(program, {"phases", "a", "--from=0,1,2"}).section(u',', -3),
                 QString(" not “0,1,2”"));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)phases.given.has("--csv"));
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)phases.given.integer("--from"));
    }

    void whatIsMissingOrContradictsItselfIsNamed_data() {
        addColumns<QString, QStringList, QString>("program", "words", "fault");
        const auto row = [](const char* program, const QStringList& words, const char* fault) {
            QTest::newRow(fault) << QString(program) << words << QString(fault);
        };
        row("sparkout-cli", {}, "a command is needed");
        row("sparkout-cli", {"course"}, "course needs one of check, variants and grade");
        row("sparkout-cli", {"simulate", ""}, "simulate needs a file");
        row("sparkout-cli", {"simulate", "a", "b"}, "one file or folder too many: b");
        row("sparkout-cli", {"new", "35k6", "--stock", "0.1"},
            "new needs --length MM and -o OUT.sparkout");
        row("sparkout-cli", {"sweep", "a", "--json", "--csv"}, "only one of --json and --csv");
        row("sparkout-cli", {"measured", "a", "--indicator", "part"},
            "--indicator needs --stiffness-sheet or --stiffness TABLE.csv");
        row("sparkout-cli", {"--version", "a"}, "no operand is allowed with --version: a");
        row("sparkout", {"--picture", "a", "--report", "card", "-o", "b", "c"},
            "only one of --picture, --report and --export");
        row("sparkout", {"--report", "card", "a"}, "--report needs -o OUT or -d DIR");
        row("sparkout", {"--surface", "1", "a"},
            "--surface needs --picture OUT.png, --report KIND or --export PART");
    }
    void whatIsMissingOrContradictsItselfIsNamed() {
        QFETCH(QString, program);
        QFETCH(QStringList, words);
        QFETCH(QString, fault);
        QCOMPARE(faultOf(programNamed(program), words), fault);
    }

    void helpPageNamesEveryOptionBesideItsCommand_data() {
        addColumns<QString>("language");
        addRow("English", QString("en"));
        addRow("Russian", QString("ru"));
    }
    void helpPageNamesEveryOptionBesideItsCommand() {
        QFETCH(QString, language);
        QFile file(SPARKOUT_SOURCE_DIR "/resources/help/" + language + "/cli.html");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString html = QString::fromUtf8(file.readAll());
        QStringList missing;
        for (const Program* program : programs) {
            for (const Command* command : withAllBelow(*program)) {
                const QString text = textOn(html, *program, *command);
                for (const Option& option : command->options) {
                    const QRegularExpression named("(?<![\\w-])" + QString(option.name)
                                                   + "(?![\\w-])");
                    if (!text.contains(named)) {
                        missing << QString(command->name) + ' ' + option.name;
                    }
                }
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
    }

    void everyRowIsSound() {
        for (const Program* program : programs) {
            for (const Command* command : withAllBelow(*program)) {
                QSet<QString> names;
                QVERIFY2(*command->text.russian != '\0', command->name);
                for (const Option& option : command->options) {
                    QVERIFY2(!names.contains(option.name), option.name);
                    names << option.name;
                    QVERIFY2(*option.text.english != '\0' && *option.text.russian != '\0',
                             option.name);
                    QVERIFY2(!isNumber(option.value) || option.value.low < option.value.high,
                             option.name);
                    for (const std::string_view needed : wordsOf(option.needs)) {
                        QVERIFY2(optionNamed(*command, needed), option.name);
                    }
                }
            }
        }
    }

    /// A name that the table does not have would end the program when it is asked for.
    void whatTheSourcesAskForIsInTheTable() {
        QMultiMap<QString, manual::Kind> kinds;
        for (const Program* program : programs) {
            for (const Command* command : withAllBelow(*program)) {
                for (const Option& option : command->options) {
                    kinds.insert(option.name, option.value.kind);
                }
            }
        }
        const std::map<QString, manual::Kind> asked{
            {"integer", manual::Kind::integer}, {"integers", manual::Kind::integers},
            {"number", manual::Kind::number},   {"numbers", manual::Kind::numbers},
            {"has", manual::Kind::none},        {"text", manual::Kind::none}};
        static const QRegularExpression question(R"re(\b(\w+)\(\s*"(--?[a-z][a-z-]*)"\))re");
        int questions = 0;
        QDirIterator files(SPARKOUT_SOURCE_DIR "/app", {"*.cpp"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            auto all = question.globalMatch(QString::fromUtf8(file.readAll()));
            while (all.hasNext()) {
                const auto match = all.next();
                const auto kind = asked.find(match.captured(1));
                if (kind == asked.end()) {
                    continue;
                }
                const QString name = match.captured(2);
                QVERIFY2(kind->second == manual::Kind::none ? kinds.contains(name)
                                                            : kinds.contains(name, kind->second),
                         qPrintable(match.captured(0)));
                ++questions;
            }
        }
        QVERIFY(questions > 100);
    }
};

} // namespace test_cli_options

SPARKOUT_TEST(test_cli_options, TestCliOptions)
#include "test_cli_options.moc"
