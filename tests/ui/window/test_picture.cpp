// SPDX-License-Identifier: GPL-3.0-or-later
// sparkout --picture, --report and --export: the whole program, as the documents and the gallery on
// the web use it.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <initializer_list>
#include <utility>

#include <sys/resource.h>

namespace {

struct Run {
    int status = -1;
    QString said;
};

/// With words in any spelling, and further ones.
Run sparkout(std::initializer_list<QAnyStringView> words, const QStringList& more = {},
             const char* epoch = nullptr) {
    QStringList arguments;
    for (const QAnyStringView word : words) {
        arguments << word.toString();
    }
    QProcess process;
    if (epoch) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("SOURCE_DATE_EPOCH"), QString::fromLatin1(epoch));
        process.setProcessEnvironment(environment);
    }
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral(SPARKOUT_PROGRAM), arguments + more);
    if (!process.waitForFinished(60'000)) {
        return {};
    }
    return {process.exitCode(), QString::fromUtf8(process.readAll())};
}

const QString example =
    QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/wheel-sharp.sparkout");

const QString batch =
    QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/shaft-30h6-factory.sparkout");

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool putBytes(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

Run report(const QString& path, const QString& project, const QStringList& more = {}) {
    return sparkout({"--report", "card", project, "-o", path}, more);
}

Run exported(const QString& part, const QString& path, const QString& language) {
    return sparkout({"--export", part, "-o", path, "--lang", language, example});
}

} // namespace

class TestPicture : public QObject {
    Q_OBJECT

private slots:
    /// The command that a passport prints to be computed again, of a surface of several.
    void thePrintedCommandRuns() {
        const QTemporaryDir folder;
        QVERIFY(QFile::copy(
            QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/setups/spindle.sparkout"),
            folder.filePath(QStringLiteral("spindle.sparkout"))));
        const QString page = folder.filePath(QStringLiteral("passport.html"));
        const Run first =
            sparkout({"--report", "passport", folder.filePath(QStringLiteral("spindle.sparkout")),
                      "--surface", "2", "-o", page});
        QVERIFY2(QFile::exists(page), qPrintable(first.said));
        const QString html = QString::fromUtf8(bytesOf(page))
                                 .replace(QStringLiteral("&quot;"), QStringLiteral("\""));
        static const QRegularExpression printed(
            QStringLiteral("sparkout (--report passport [^<]*-o passport\\.pdf)"));
        const QString command = printed.match(html).captured(1);
        QVERIFY2(command.contains(QStringLiteral("--surface 2 ")), qPrintable(command));
        QProcess process;
        process.setWorkingDirectory(folder.path());
        process.start(QStringLiteral(SPARKOUT_PROGRAM), QProcess::splitCommand(command));
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), first.status);
        QVERIFY(bytesOf(folder.filePath(QStringLiteral("passport.pdf"))).startsWith("%PDF-"));
    }

    /// Neither the hashes of a process nor the second of writing is in a file.
    void equalInputsGiveEqualBytes() {
        using Made = std::pair<const char*, const char*>; // what, and the ending of its file
        QList<Made> reports{{"card", "html"}, {"card", "pdf"}, {"handout", "md"}};
        QList<Made> exports{{"all", "xlsx"}, {"cycle", "csv"}, {"all", "json"}};
        if (qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
            for (const char* kind : {"card", "passport", "handout", "operation-card",
                                     "sketch-sheet", "worksheet", "worksheet-key"}) {
                for (const char* format : {"html", "pdf", "md", "odt"}) {
                    reports << Made(kind, format);
                }
            }
            exports << Made("batch", "xlsx") << Made("trace", "csv");
        }
        const QTemporaryDir folder;
        const auto bytes = [&](const char* option, const Made& made) {
            const QString path =
                folder.filePath(QStringLiteral("made.%1").arg(QString::fromLatin1(made.second)));
            const Run run = sparkout({option, made.first, batch, "-o", path, "--lang", "en"});
            if (run.status != 0) {
                qWarning("%s", qPrintable(run.said));
            }
            return bytesOf(path);
        };
        for (const auto& [option, all] :
             {std::pair("--report", reports), std::pair("--export", exports)}) {
            for (const Made& made : all) {
                const QByteArray first = bytes(option, made);
                QVERIFY2(!first.isEmpty(), made.first);
                for (int again = 0; again < 2; ++again) {
                    QTest::qWait(qstrcmp(made.second, "xlsx") == 0 ? 1000 : 0); // another second
                    QVERIFY2(bytes(option, made) == first, qPrintable(QStringLiteral("%1.%2").arg(
                                                               QString::fromLatin1(made.first),
                                                               QString::fromLatin1(made.second))));
                }
            }
        }
    }

    /// Faults quote what stands in a file, letter by letter, a line each.
    void whatIsSaidOfAFileSteersNoTerminal() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("faults.sparkout"));
        QByteArray project = bytesOf(example);
        project.replace("\"wheel\": {",
                        "\"wheel\": {\"a\\u001b]0;title\\u0007\\u009b2J\\u202e\\nforged: b\": 1,");
        QVERIFY(putBytes(path, project));
        const Run run = report(folder.filePath(QStringLiteral("card.html")), path);
        QCOMPARE(run.status, 1);
        QVERIFY2(run.said.contains(QStringLiteral("\\u001B]0;title")), qPrintable(run.said));
        QVERIFY(!run.said.contains(QStringLiteral("\nforged")));
        for (const QChar c : {QChar(0x1b), QChar(0x07), QChar(0x9b), QChar(0x202e)}) {
            QVERIFY(!run.said.contains(c));
        }
    }

    /// So a document can be made anew on another day.
    void theDayOfADocumentIsThatOfTheEnvironment() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("card.md"));
        const auto written = [&](const char* epoch) {
            (void)sparkout({"--report", "card", example, "-o", path, "--lang", "en"}, {}, epoch);
            return bytesOf(path);
        };
        QVERIFY(written("1000000000").contains("9 September 2001"));
        const QByteArray today = written(nullptr);
        QVERIFY(!today.isEmpty() && !today.contains("2001"));
        QCOMPARE(written("no number"), today);
    }

    void papersOfTheCourseAreWritten() {
        const QTemporaryDir folder;
        const QString lesson =
            QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons/02-actual-feed.sparkout-lesson");
        const auto paper = [&](const char* kind, const QString& file, const QString& name) {
            return sparkout({"--report", kind, file, "-o", folder.filePath(name), "--lang", "ru"});
        };
        const auto wrote = [&](const QString& name, const QByteArray& start) {
            return bytesOf(folder.filePath(name)).startsWith(start);
        };
        for (const char* kind : {"worksheet", "worksheet-key"}) {
            for (const QString& file : {lesson, example}) {
                const QString name = QString::fromLatin1(kind) + QStringLiteral(".odt");
                const Run run = paper(kind, file, name);
                QVERIFY2(run.status == 0 && run.said.isEmpty(), qPrintable(run.said));
                QVERIFY(wrote(name, "PK"));
            }
        }
        const Run guide = paper("guide", lesson, QStringLiteral("guide.pdf"));
        QVERIFY2(guide.status == 0 && wrote(QStringLiteral("guide.pdf"), "%PDF"),
                 qPrintable(guide.said));
        // What is another's is refused by its name, and nothing is written.
        for (const auto& [kind, file] :
             {std::pair("lab-report", lesson), std::pair("lab-report", example),
              std::pair("guide", example)}) {
            const Run run = paper(kind, file, QStringLiteral("none.pdf"));
            QVERIFY2(run.status == 1 && run.said.contains(QStringLiteral("needs")),
                     qPrintable(run.said));
            QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("none.pdf"))));
        }
        const QString work = folder.filePath(QStringLiteral("work.sparkout-work"));
        QVERIFY(putBytes(work, "{}"));
        for (const char* kind : {"worksheet-key", "guide"}) {
            const Run run = paper(kind, work, QStringLiteral("none.pdf"));
            QVERIFY2(run.status == 1 && run.said.contains(QStringLiteral("needs the teacher")),
                     qPrintable(run.said));
        }
        QCOMPARE(paper("lab-report", work, QStringLiteral("none.pdf")).status, 1); // no work
    }

    void nothingIsPrintedOfThePlatform() {
        const QTemporaryDir folder;
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("XDG_RUNTIME_DIR"));
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        process.setProcessEnvironment(environment);
        process.start(
            QStringLiteral(SPARKOUT_PROGRAM),
            {QStringLiteral("--picture"), folder.filePath(QStringLiteral("window.png")), example});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(QString::fromUtf8(process.readAll()), QString());
    }

    void thePictureHasTheSizeAndTheThemeAskedFor_data() {
        QTest::addColumn<QString>("theme");
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << QStringLiteral("light") << false;
        QTest::newRow("dark") << QStringLiteral("dark") << true;
        QTest::newRow("contrast") << QStringLiteral("contrast") << true;
    }

    void thePictureHasTheSizeAndTheThemeAskedFor() {
        QFETCH(QString, theme);
        QFETCH(bool, dark);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("window.png"));
        const Run run = sparkout({"--picture", path, "--theme", theme, "--view", "feeds", "--lang",
                                  "ru", "--size", "1200x700", example});
        QVERIFY2(run.status == 0, qPrintable(run.said));
        const QImage image(path);
        QCOMPARE(image.size(), QSize(1200, 700));
        QCOMPARE(image.pixelColor(600, 40).lightness() < 128, dark); // the tool bar
    }

    void whatIsUnknownIsRefusedAndWhatThereIsIsNamed() {
        const Run theme = sparkout({"--picture", "/dev/null", "--theme", "pink", example});
        QCOMPARE(theme.status, 2);
        QVERIFY2(theme.said.contains(QStringLiteral("contrast")), qPrintable(theme.said));
        const Run view = sparkout({"--picture", "/dev/null", "--view", "none", example});
        QCOMPARE(view.status, 2);
        QVERIFY2(view.said.contains(QStringLiteral("feeds")), qPrintable(view.said));
    }

    void theReportIsWrittenAsItsEndingSays_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("beginning");
        QTest::newRow("pdf") << "card"
                             << "pdf" << QByteArray("%PDF-");
        QTest::newRow("html") << "card"
                              << "html" << QByteArray("<!DOCTYPE html>");
        QTest::newRow("md") << "card"
                            << "md" << QByteArray("# Карта цикла");
        QTest::newRow("passport") << "passport"
                                  << "md" << QByteArray("# Паспорт точности");
    }
    void theReportIsWrittenAsItsEndingSays() {
        QFETCH(QString, kind);
        QFETCH(QString, ending);
        QFETCH(QByteArray, beginning);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("report.") + ending);
        const Run run = sparkout({"--report", kind, batch, "-o", path, "--lang", "ru"});
        QVERIFY2(run.status == 0, qPrintable(run.said));
        QVERIFY(bytesOf(path).startsWith(beginning));
    }

    void manyFilesGiveAReportEach() {
        const QTemporaryDir folder;
        const QString refused = folder.filePath(QStringLiteral("-no.sparkout"));
        QVERIFY(putBytes(refused, "{}"));
        const QString setup =
            QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/setups/sleeve.sparkout");
        const auto many = [&](const QStringList& more) {
            return sparkout({"--report", "operation-card", "-d", folder.path(), "--format", "md",
                             "--lang", "en"},
                            more);
        };
        // The one that is refused does not stop the others; the status is its.
        const Run run = many({setup, refused, example});
        QCOMPARE(run.status, 1);
        QVERIFY2(run.said.contains(QStringLiteral("1 of 3")), qPrintable(run.said));
        QVERIFY2(run.said.contains(QStringLiteral("3 of 3")), qPrintable(run.said));
        const QString first = folder.filePath(QStringLiteral("sleeve.md"));
        QVERIFY(bytesOf(first).contains("Втулка 7716-03.044"));
        QVERIFY(bytesOf(folder.filePath(QStringLiteral("wheel-sharp.md"))).size() > 500);
        QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("-no.md"))));
        // What is there stays, without a run, until it may be replaced.
        QVERIFY(putBytes(first, "mine"));
        const Run again = many({setup, example});
        QCOMPARE(again.status, 1);
        QVERIFY2(again.said.contains(QStringLiteral("--force")), qPrintable(again.said));
        QCOMPARE(bytesOf(first), QByteArray("mine"));
        QCOMPARE(many({QStringLiteral("--force"), setup}).status, 0);
        QVERIFY(bytesOf(first).contains("Втулка"));
        // A report never takes the place of a project.
        const QString project = folder.filePath(QStringLiteral("part.md"));
        QVERIFY(QFile::copy(example, project));
        const QByteArray before = bytesOf(project);
        QCOMPARE(many({QStringLiteral("--force"), project}).status, 1);
        QCOMPARE(bytesOf(project), before);
        for (const QStringList& wrong :
             {QStringList{}, QStringList{setup, QStringLiteral("--format"), QStringLiteral("doc")},
              QStringList{setup, QStringLiteral("-o"), first}}) {
            QCOMPARE(many(wrong).status, 2);
        }
        QCOMPARE(report(first, example, {QStringLiteral("--force")}).status, 2);
        QCOMPARE(report(first, example, {batch}).status, 2);
    }

    void aReportIsOfTheSurfaceThatIsNamed() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("out.md"));
        const auto made = [&](const char* kind, const QString& surface) {
            return sparkout({"--report", kind,
                             SPARKOUT_SOURCE_DIR "/tests/data/setups/spindle.sparkout", "-o", path,
                             "--lang", "en"},
                            surface.isEmpty() ? QStringList()
                                              : QStringList{QStringLiteral("--surface"), surface});
        };
        QCOMPARE(made("card", {}).status, 1); // it is about one
        QCOMPARE(made("card", QStringLiteral("4")).status, 1);
        QVERIFY(!QFile::exists(path));
        for (const char* kind : {"card", "operation-card"}) {
            for (const QString& surface :
                 {QStringLiteral("2"), QString::fromUtf8("посадка под шестерню")}) {
                const Run run = made(kind, surface);
                QVERIFY2(run.status == 0, qPrintable(run.said));
                QVERIFY(bytesOf(path).contains("36k6"));
                QVERIFY(!bytesOf(path).contains("40h6"));
            }
        }
        QCOMPARE(made("operation-card", {}).status, 0);
        QVERIFY(bytesOf(path).contains("36k6") && bytesOf(path).contains("40h6"));
    }

    void twoFilesOfOneNameAreRefused() {
        const QTemporaryDir folder, other;
        const QString twin = other.filePath(QStringLiteral("wheel-sharp.sparkout"));
        QVERIFY(QFile::copy(example, twin));
        const Run run = sparkout({"--report", "card", example, twin, "-d", folder.path()});
        QCOMPARE(run.status, 1);
        QVERIFY(QDir(folder.path()).isEmpty());
        QCOMPARE(
            sparkout({"--report", "card", example, "-d", folder.filePath(QStringLiteral("no"))})
                .status,
            1);
    }

    void theHandoutIsOfTheStepAskedFor() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("handout.md"));
        const auto handout = [&](const QStringList& more) {
            return sparkout({"--report", "handout", "--lang", "en", batch, "-o", path}, more);
        };
        const Run run = handout({QStringLiteral("--at"), QStringLiteral("20,nz,e2,k7"),
                                 QStringLiteral("--answers"), QStringLiteral("off"),
                                 QStringLiteral("--views"), QString()});
        QVERIFY2(run.status == 0, qPrintable(run.said));
        const QByteArray text = bytesOf(path);
        QVERIFY(text.contains("* Double stroke: **20**"));
        QVERIFY(text.contains("k = 7"));
        QVERIFY(!text.contains("## Answers") && !text.contains("## Charts"));
        for (const QStringList& wrong :
             {QStringList{QStringLiteral("--at"), QStringLiteral("99999")},
              QStringList{QStringLiteral("--at"), QStringLiteral("here")},
              QStringList{QStringLiteral("--views"), QStringLiteral("film")},
              QStringList{QStringLiteral("--answers"), QStringLiteral("yes")}}) {
            QCOMPARE(handout(wrong).status, 2);
        }
        QCOMPARE(report(path, example, {QStringLiteral("--at"), QStringLiteral("5")}).status, 2);
        QCOMPARE(bytesOf(path), text);
    }

    void aFullDiskLeavesTheOldReport_data() {
        QTest::addColumn<QString>("kind");
        QTest::newRow("card") << QStringLiteral("card");
        QTest::newRow("passport") << QStringLiteral("passport");
    }
    void aFullDiskLeavesTheOldReport() {
        QFETCH(QString, kind);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("report.pdf"));
        QVERIFY(putBytes(path, "old"));
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.setChildProcessModifier([] { // no file may grow beyond one page
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit few{4096, 4096};
            ::setrlimit(RLIMIT_FSIZE, &few);
        });
        process.start(QStringLiteral(SPARKOUT_PROGRAM),
                      {QStringLiteral("--report"), kind, example, QStringLiteral("-o"), path});
        QVERIFY(process.waitForFinished(60'000));
        const QString said = QString::fromUtf8(process.readAll());
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QVERIFY2(process.exitCode() == 1, qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("report.pdf")), qPrintable(said));
        QCOMPARE(bytesOf(path), QByteArray("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }

    void ctrlCEndsABatchAndLeavesTheOldReport() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("passport.pdf"));
        const QString large = folder.filePath(QStringLiteral("large.sparkout"));
        QVERIFY(putBytes(path, "old"));
        QByteArray project = bytesOf(batch);
        QVERIFY(project.contains("\"parts\": 50")); // kept runs have it, too
        QVERIFY(putBytes(large, project.replace("\"parts\": 50", "\"parts\": 1000000")));
        QProcess process;
        process.start(QStringLiteral(SPARKOUT_PROGRAM),
                      {QStringLiteral("--report"), QStringLiteral("passport"), large,
                       QStringLiteral("-o"), path});
        QVERIFY(process.waitForStarted());
        process.setReadChannel(QProcess::StandardError);
        while (process.waitForReadyRead(30'000)
               && !process.readAllStandardError().contains("of 1000000 parts")) {
        }
        const auto number = static_cast<pid_t>(process.processId());
        QVERIFY2(number > 0, "it has ended by itself"); // 0 would be the tests themselves
        ::kill(number, SIGINT);
        QVERIFY(process.waitForFinished(10'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(bytesOf(path), QByteArray("old"));
    }

    void aNameThatIsNotUtf8IsRefusedAndNoOtherFileIsWritten() {
        const QTemporaryDir folder;
        for (const char* words :
             {"--report card -o \"$name.pdf\" \"$example\"",
              "--export all -o \"$name.xlsx\" \"$example\"", "--picture \"$name.png\" \"$example\"",
              "--report card -o card.pdf \"$name.sparkout\""}) {
            QProcess process;
            process.setProcessChannelMode(QProcess::MergedChannels);
            process.setWorkingDirectory(folder.path());
            process.start(
                QStringLiteral("sh"),
                {QStringLiteral("-c"),
                 QStringLiteral("name=$(printf 'a\\377b'); example=\"%1\"; exec \"%2\" %3")
                     .arg(example, QStringLiteral(SPARKOUT_PROGRAM), QString::fromLatin1(words))});
            QVERIFY(process.waitForFinished(60'000));
            const QByteArray said = process.readAll();
            QCOMPARE(process.exitStatus(), QProcess::NormalExit);
            QCOMPARE(process.exitCode(), 2);
            QVERIFY2(said.contains("a\\xFFb") && said.contains("UTF-8"), said.constData());
            QVERIFY(QDir(folder.path()).isEmpty());
        }
    }

    void anUnusableDisplayEndsInWords_data() {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("named");
        QTest::newRow("no such display") << QString() << QStringLiteral(":77");
        QTest::newRow("no such plug-in")
            << QStringLiteral("nonsense") << QStringLiteral("nonsense");
        for (const char* name : {"xcb", "eglfs", "minimalegl", "linuxfb", "wayland"}) {
            QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(name);
        }
    }

    void anUnusableDisplayEndsInWords() {
        QFETCH(QString, platform);
        QFETCH(QString, named);
        for (const QStringList& arguments :
             {QStringList{},
              QStringList{QStringLiteral("--picture"), QStringLiteral("/dev/null"), example}}) {
            if (platform.isEmpty() && !arguments.isEmpty()) {
                continue; // a picture needs no display
            }
            QProcess process;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QStringLiteral("DISPLAY"), QStringLiteral(":77"));
            environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
            environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
            if (!platform.isEmpty()) {
                environment.insert(QStringLiteral("QT_QPA_PLATFORM"), platform);
            }
            process.setProcessEnvironment(environment);
            process.setProcessChannelMode(QProcess::MergedChannels);
            process.start(QStringLiteral(SPARKOUT_PROGRAM), arguments);
            QVERIFY(process.waitForFinished(20'000));
            const QString said = QString::fromUtf8(process.readAll());
            QVERIFY2(process.exitStatus() == QProcess::NormalExit, qPrintable(said));
            QVERIFY2(process.exitCode() == 2, qPrintable(said));
            QVERIFY2(said.contains(named) && said.contains(QStringLiteral("sparkout-cli")),
                     qPrintable(said));
        }
    }

    void aReportThatCannotBeIsRefused() {
        const QTemporaryDir folder;
        const QString text = folder.filePath(QStringLiteral("card.txt"));
        QCOMPARE(report(text, example).status, 2);
        const QString card = folder.filePath(QStringLiteral("none/card.pdf"));
        QCOMPARE(report(card, example).status, 1);
        QCOMPARE(report(folder.filePath(QStringLiteral("a.md")), QStringLiteral("/none.sparkout"))
                     .status,
                 1);
        const QString other = folder.filePath(QStringLiteral("a.pdf"));
        QCOMPARE(sparkout({"--report", "map", "-o", other, example}).status, 2);
        QCOMPARE(sparkout({"--report", "card", example}).status, 2);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void theResultIsExportedAsTheEndingSays_data() {
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QString>("language");
        QTest::addColumn<QByteArray>("beginning");
        const auto row = [](const char* part, const char* ending, const char* language,
                            const char* beginning) {
            QTest::addRow("%s %s %s", part, ending, language)
                << QString::fromLatin1(part) << QString::fromLatin1(ending)
                << QString::fromLatin1(language) << QByteArray(beginning);
        };
        row("all", "xlsx", "ru", "PK\x03\x04");
        row("all", "json", "ru", "{\n  \"status\": \"completed\"");
        row("trace", "csv", "ru", "\xEF\xBB\xBFВремя, мин;");
        row("trace", "csv", "en", "\xEF\xBB\xBF\"Time, min\",");
    }

    void theResultIsExportedAsTheEndingSays() {
        QFETCH(QString, part);
        QFETCH(QString, ending);
        QFETCH(QString, language);
        QFETCH(QByteArray, beginning);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("out.") + ending);
        const Run run = exported(part, path, language);
        QVERIFY2(run.status == 0, qPrintable(run.said));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY2(bytes.startsWith(beginning), bytes.left(60));
    }

    void anExportThatCannotBeIsRefused() {
        const QTemporaryDir folder;
        const QStringList refused = {QStringLiteral("all csv"), QStringLiteral("trace json"),
                                     QStringLiteral("everything xlsx"), QStringLiteral("all pdf"),
                                     QStringLiteral("trace sparkout")};
        for (const QString& wrong : refused) {
            const QStringList parts = wrong.split(u' ');
            const Run run = exported(parts[0], folder.filePath(QStringLiteral("a.") + parts[1]),
                                     QStringLiteral("en"));
            QVERIFY2(run.status == 2 && run.said.contains(QStringLiteral("requirements")),
                     qPrintable(wrong));
        }
        QCOMPARE(exported(QStringLiteral("all"), folder.filePath(QStringLiteral("none/a.xlsx")),
                          QStringLiteral("en"))
                     .status,
                 1);
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestPicture)
#include "test_picture.moc"
