// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/safe_file.h"
#include "core/version.h"
#include "ui/dialogs/examples_dialog.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/file_commands.h"
#include "ui/help/help_desk.h"
#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/report/cycle_card.h"
#include "ui/report/report_text.h"
#include "ui/session/operation.h"
#include "ui/session/program_log.h"
#include "ui/session/recovery_store.h"
#include "ui/session/texts.h"
#include "ui/theme.h"
#include "ui/views/batch_view.h"
#include "ui/views/sweep_view.h"

#include <QApplication>
#include <QBuffer>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QSysInfo>
#include <QTimer>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <optional>

using namespace sparkout;

namespace {

constexpr int exitRefused = 1;
constexpr int exitUsage = 2;
constexpr int exitCannotReachSize = 3;
constexpr int pictureTimeout_ms = 60'000;
constexpr int pictureTick_ms = 200; ///< for queued replots and layouts two of them pass
constexpr int pictureRound_ms = 30, calmRounds = 3, mostRounds = 100;

constexpr const char* usage =
    "Usage: sparkout [FILE]\n"
    "       sparkout --picture OUT.png [--lang en|ru] [--theme THEME] [--view VIEW]\n"
    "                [--stroke N] [--size WIDTHxHEIGHT] FILE\n"
    "       sparkout --report card -o OUT.pdf|OUT.html|OUT.md [--lang en|ru] FILE\n"
    "\n"
    "Opens the workbench, with FILE or with an example.\n"
    "\n"
    "  --picture OUT.png  write a picture of the window with FILE and its result, show nothing\n"
    "  --report card      write the cycle card of FILE into OUT, show nothing\n"
    "  -o OUT             the file of the report; its ending says as what it is written:\n"
    "                     .pdf, .html or .md (Markdown)\n"
    "  --lang en|ru       language of the window or the report, this time only\n"
    "  --theme THEME      system, light, dark or contrast, this time only\n"
    "  --view VIEW        the view in front, by name (feeds) or number\n"
    "  --stroke N         the cycle after N double strokes or revolutions, at its end unless told\n"
    "  --size WxH         size of the window, 1366x768 unless told\n"
    "  --version          print the version\n"
    "  --help             print this text\n"
    "\n"
    "Exit status: 0 done, 1 the file is refused or the output cannot be written, 2 wrong usage or\n"
    "no display, 3 the cycle cannot reach size (the report is written). sparkout-cli does without\n"
    "a display.\n";

struct Options {
    QString file;
    QString picture;
    QString report; ///< the kind of report
    QString output; ///< its file
    QString language;
    QString theme;
    QString view;
    std::optional<int> stroke;
    QSize size{1366, 768};
    bool version = false;
    bool help = false;
    QString fault; ///< what is wrong with the command line
};

bool readSize(const QString& text, QSize& size) {
    const QStringList parts = text.split(u'x');
    bool readWidth = false;
    bool readHeight = false;
    size = {parts.value(0).toInt(&readWidth), parts.value(1).toInt(&readHeight)};
    return parts.size() == 2 && readWidth && readHeight && size.width() >= 400
           && size.height() >= 300 && size.width() <= 10'000 && size.height() <= 10'000;
}

void readOption(const QStringList& words, qsizetype& i, Options& options) {
    const QString& word = words[i];
    if (word == u"--version") {
        options.version = true;
    } else if (word == u"--help" || word == u"-h") {
        options.help = true;
    } else if (i + 1 == words.size()) {
        options.fault = QStringLiteral("unknown option, or its value is missing: %1").arg(word);
    } else if (word == u"--picture") {
        options.picture = words[++i];
    } else if (word == u"--report") {
        options.report = words[++i];
        if (options.report != u"card") {
            options.fault = QStringLiteral("--report is card, not “%1”").arg(options.report);
        }
    } else if (word == u"-o") {
        options.output = words[++i];
        if (!report::formatOf(options.output)) {
            options.fault = QStringLiteral("the file of -o ends in .pdf, .html or .md");
        }
    } else if (word == u"--lang") {
        options.language = words[++i];
        if (options.language != u"en" && options.language != u"ru") {
            options.fault = QStringLiteral("--lang is en or ru");
        }
    } else if (word == u"--theme") {
        options.theme = words[++i];
        if (!isThemeCode(options.theme)) {
            options.fault = QStringLiteral("--theme is system, light, dark or contrast");
        }
    } else if (word == u"--view") {
        options.view = words[++i];
    } else if (word == u"--stroke") {
        bool read = false;
        options.stroke = words[++i].toInt(&read);
        if (!read || *options.stroke < 0) {
            options.fault = QStringLiteral("--stroke is a whole number from 0 on");
        }
    } else if (word == u"--size") {
        if (!readSize(words[++i], options.size)) {
            options.fault = QStringLiteral("--size is WIDTHxHEIGHT, 400x300 to 10000x10000");
        }
    } else {
        options.fault = QStringLiteral("unknown option: %1").arg(word);
    }
}

Options readOptions(const QStringList& words) {
    Options options;
    bool optionsOver = false;
    for (qsizetype i = 0; i < words.size() && options.fault.isEmpty(); ++i) {
        if (words[i] == u"--" && !optionsOver) {
            optionsOver = true;
        } else if (!optionsOver && words[i].startsWith(u'-') && words[i].size() > 1) {
            readOption(words, i, options);
        } else if (options.file.isEmpty()) {
            options.file = words[i];
        } else {
            options.fault = QStringLiteral("more than one file");
        }
    }
    if (!options.picture.isEmpty() && options.file.isEmpty() && options.fault.isEmpty()) {
        options.fault = QStringLiteral("--picture needs a FILE");
    }
    if (!options.report.isEmpty() != !options.output.isEmpty() && options.fault.isEmpty()) {
        options.fault = QStringLiteral("--report and -o go together");
    }
    if (!options.report.isEmpty() && options.fault.isEmpty()) {
        if (options.file.isEmpty()) {
            options.fault = QStringLiteral("--report needs a FILE");
        } else if (!options.picture.isEmpty()) {
            options.fault = QStringLiteral("--report and --picture do not go together");
        } else if (const QString target = QFileInfo(options.output).canonicalFilePath();
                   !target.isEmpty() && target == QFileInfo(options.file).canonicalFilePath()) {
            options.fault = QStringLiteral("the report would take the place of the project");
        }
    }
    return options;
}

void say(std::FILE* stream, const QString& text) {
    std::fputs((text + u'\n').toLocal8Bit().constData(), stream);
}

bool displayMissing() {
    const auto set = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
    return !set("DISPLAY") && !set("WAYLAND_DISPLAY") && !set("QT_QPA_PLATFORM");
}

void openFirstExample(Document& document) {
    const QStringList paths = ExamplesDialog::paths();
    const auto usual = std::find_if(paths.begin(), paths.end(), [](const QString& path) {
        return path.contains(QLatin1StringView("30h6"), Qt::CaseInsensitive);
    });
    const QString path = usual != paths.end() ? *usual : paths.value(0);
    if (path.isEmpty() || hasErrors(document.openCopy(ExamplesDialog::textOf(path)))) {
        document.startUntitled(newProject(Operation::traverse));
    }
}

/// As the window stays: layouts and replots are done when nothing changes any more.
QImage settledPicture(MainWindow& window) {
    QImage picture = window.grab().toImage();
    for (int calm = 0, round = 0; calm < calmRounds && round < mostRounds; ++round) {
        QEventLoop loop;
        QTimer::singleShot(pictureRound_ms, &loop, &QEventLoop::quit);
        loop.exec();
        const QImage now = window.grab().toImage();
        calm = now == picture ? calm + 1 : 0;
        picture = now;
    }
    return picture;
}

bool writeBytes(const QByteArray& bytes, const QString& path) {
    const auto error = writeFileSafely(QFile::encodeName(path).toStdString(),
                                       {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    if (error) {
        say(stderr, QStringLiteral("sparkout: %1").arg(saveErrorText(*error)));
    }
    return !error;
}

bool writePicture(MainWindow& window, const QString& path) {
    QByteArray png;
    QBuffer buffer(&png);
    if (!buffer.open(QIODevice::WriteOnly) || !settledPicture(window).save(&buffer, "PNG")) {
        say(stderr, QStringLiteral("sparkout: the picture could not be made"));
        return false;
    }
    return writeBytes(png, path);
}

/// Reads a project; what is wrong with it is said.
bool openOrSay(Document& document, const QString& path) {
    const OpenResult result = document.open(path);
    if (result.error) {
        say(stderr, QStringLiteral("sparkout: %1").arg(readErrorText(*result.error)));
    } else if (!result.opened()) {
        for (const QString& line : FaultsDialog::lines(result.issues)) {
            say(stderr, QStringLiteral("sparkout: %1").arg(line));
        }
    }
    return result.opened();
}

int makePicture(QApplication& app, MainWindow& window, const Options& options) {
    window.resize(options.size);
    window.show();
    int quietTicks = 0;
    QTimer ticks;
    QObject::connect(&ticks, &QTimer::timeout, &app, [&] {
        const bool busy =
            window.findChild<BatchView*>()->busy() || window.findChild<SweepView*>()->busy();
        quietTicks = busy ? 0 : quietTicks + 1;
        if (quietTicks == 2) {
            app.exit(writePicture(window, options.picture) ? 0 : exitRefused);
        }
    });
    QObject::connect(&window, &MainWindow::outcomeShown, &app, [&] {
        if (options.stroke) {
            window.cursor().toStroke(*options.stroke);
        }
        ticks.start(pictureTick_ms);
    });
    QTimer::singleShot(pictureTimeout_ms, &app, [&] {
        say(stderr, QStringLiteral("sparkout: the run took too long for a picture"));
        app.exit(exitRefused);
    });
    if (!openOrSay(window.document(), options.file)) {
        return exitRefused;
    }
    return app.exec();
}

int makeReport(const Options& options) {
    Document document;
    if (!openOrSay(document, options.file)) {
        return exitRefused;
    }
    const OutcomePtr outcome = runProject(document.project(), {});
    if (!outcome->ran()) {
        for (const QString& line : FaultsDialog::lines(outcome->issues)) {
            say(stderr, QStringLiteral("sparkout: %1").arg(line));
        }
        return exitRefused;
    }
    const report::Report card = report::cycleCard(outcome, options.file, QDate::currentDate());
    const QByteArray bytes = report::bytesOf(card, *report::formatOf(options.output));
    if (bytes.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: the report could not be made"));
        return exitRefused;
    }
    if (!writeBytes(bytes, options.output)) {
        return exitRefused;
    }
    return outcome->result.status == RunStatus::completed ? 0 : exitCannotReachSize;
}

int runWindow(QApplication& app, MainWindow& window, const Options& options) {
    window.files().protect(userStateFolder());
    window.show();
    openFirstExample(window.document());
    QTimer::singleShot(0, &window, [&] {
        window.files().start(options.file);
        if (options.file.isEmpty()) {
            window.help().offerTour();
        }
    });
    return app.exec();
}

bool showWantedView(MainWindow& window, const QString& name) {
    if (name.isEmpty() || window.showView(name)) {
        return true;
    }
    QStringList names;
    for (const View* view : window.views()) {
        names += view->objectName();
    }
    say(stderr, QStringLiteral("sparkout: there is no view “%1”; there are: %2")
                    .arg(name, names.join(QStringLiteral(", "))));
    return false;
}

} // namespace

int main(int argc, char** argv) {
    QStringList words;
    for (int i = 1; i < argc; ++i) {
        words += QString::fromLocal8Bit(argv[i]);
    }
    const Options options = readOptions(words);
    if (!options.fault.isEmpty()) {
        say(stderr,
            QStringLiteral("sparkout: %1\n\n%2").arg(options.fault, QString::fromUtf8(usage)));
        return exitUsage;
    }
    if (options.help || options.version) {
        say(stdout, options.help ? QString::fromUtf8(usage).trimmed()
                                 : QStringLiteral("sparkout %1").arg(QString::fromUtf8(version)));
        return 0;
    }
    const bool picture = !options.picture.isEmpty();
    const bool hidden = picture || !options.report.isEmpty();
    if (hidden && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    if (displayMissing()) {
        say(stderr, QStringLiteral("sparkout: there is no display (DISPLAY and WAYLAND_DISPLAY are "
                                   "not set). Use sparkout-cli, sparkout --picture or "
                                   "sparkout --report."));
        return exitUsage;
    }
    int noArguments = 1; // the options are ours, Qt reads none of them
    QApplication app(noArguments, argv);
    std::setlocale(LC_NUMERIC, "C"); // QApplication took the environment's
    const ProgramLog log;
    ProgramLog::note(QStringLiteral("Sparkout %1, Qt %2, %3")
                         .arg(QString::fromUtf8(version), QString::fromUtf8(qVersion()),
                              QSysInfo::prettyProductName()));
    QApplication::setApplicationName(QStringLiteral("sparkout"));
    QApplication::setApplicationVersion(QString::fromUtf8(version));
    Settings settings = hidden ? Settings::transient() : Settings();
    Language language;
    language.apply(options.language.isEmpty() ? settings.language() : options.language);
    applyTheme(themeFrom(options.theme.isEmpty() ? settings.theme() : options.theme));
    if (!options.report.isEmpty()) {
        return makeReport(options);
    }
    MainWindow window(settings, language);
    if (!showWantedView(window, options.view)) {
        return exitUsage;
    }
    return picture ? makePicture(app, window, options) : runWindow(app, window, options);
}
