// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/display_start.h"
#include "app/export_command.h"
#include "app/io/console.h"
#include "app/manual/help_text.h"
#include "app/portable_folder.h"
#include "app/report_command.h"
#include "app/window_io.h"
#include "core/printable.h"
#include "core/study/new_project.h"
#include "core/version.h"
#include "ui/files/recovery_store.h"
#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"
#include "ui/report/card/logo.h"
#include "ui/report/format/report_text.h"
#include "ui/session/program_log.h"
#include "ui/session/remedy_finder.h"
#include "ui/text/language.h"
#include "ui/text/system_text.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_view.h"
#include "ui/views/sweep/sweep_view.h"
#include "ui/window/dialogs/examples_dialog.h"
#include "ui/window/file_commands.h"
#include "ui/window/help_desk.h"
#include "ui/window/main_window.h"

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
#include <string>

using namespace sparkout;

namespace {

constexpr int pictureTimeout_ms = 60'000;
constexpr int pictureTick_ms = 200; ///< for queued replots and layouts two of them pass
constexpr int pictureRound_ms = 30, calmRounds = 3, mostRounds = 100;

QString usage() {
    return QString::fromStdString(manual::helpText(manual::windowProgram()));
}

struct Options {
    QString file;
    QString surface;
    QString picture;
    QString report; ///< the kind of report
    ExportRequest exported;
    QString output;   ///< the file of either
    ManyReports many; ///< with its folder: every file a report
    ReportRequest request;
    QString handoutOption; ///< one of --at, --views, --answers, if given
    QString language;
    QString theme;
    std::optional<int> fontSize;
    QString view;
    std::optional<int> stroke;
    QSize size{1366, 768};
    bool formatGiven = false; ///< by --format
    bool portable = false;
    bool timesStart = false;
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
    if (word != u"-h"
        && !manual::optionNamed(manual::windowProgram().options, word.toStdString())) {
        options.fault = QStringLiteral("unknown option: %1").arg(word);
    } else if (word == u"--version") {
        options.version = true;
    } else if (word == u"--help" || word == u"-h") {
        options.help = true;
    } else if (word == u"--time-start") {
        options.timesStart = true;
    } else if (word == u"--portable") {
        options.portable = true;
    } else if (word == u"--force") {
        options.many.force = true;
    } else if (i + 1 == words.size()) {
        options.fault = QStringLiteral("the value of %1 is missing").arg(word);
    } else if (word == u"--picture") {
        options.picture = words[++i];
    } else if (word == u"--report") {
        options.report = words[++i];
        if (!report::kindOf(options.report) && !report::paperOf(options.report)) {
            options.fault = QStringLiteral("there is no report “%1”; there are: %2")
                                .arg(options.report, reportKeys());
        }
    } else if (word == u"-o") {
        options.output = words[++i];
    } else if (word == u"-d") {
        options.many.folder = words[++i];
    } else if (word == u"--format") {
        options.many.suffix = words[++i];
        options.formatGiven = true;
        if (!report::formatOf(u'.' + options.many.suffix)) {
            options.fault = QStringLiteral("--format is pdf, html, md or odt");
        }
    } else if (word == u"--at" || word == u"--views" || word == u"--answers") {
        options.handoutOption = word;
        options.fault = readHandoutOption(word, words[++i], options.request);
    } else if (word == u"--export") {
        options.exported.part = words[++i];
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
    } else if (word == u"--font-size") {
        options.fontSize = words[++i].toInt();
        if (fontSizeFrom(*options.fontSize) != *options.fontSize) {
            options.fault = QStringLiteral("--font-size is 90, 100, 115 or 130");
        }
    } else if (word == u"--surface") {
        options.surface = words[++i];
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

/// What is wrong with --report, --export and -o.
QString outputFault(const Options& options) {
    const bool report = !options.report.isEmpty();
    const bool exported = !options.exported.part.isEmpty();
    if (!options.many.folder.isEmpty()) {
        return !report || exported || !options.output.isEmpty() || !options.picture.isEmpty()
                   ? QStringLiteral("-d goes with --report, and with no other output")
               : options.many.files.isEmpty() ? QStringLiteral("-d needs a FILE")
                                              : QString();
    }
    if (options.many.force || options.formatGiven) {
        return QStringLiteral("--format and --force go with -d");
    }
    if (!report && !exported && options.output.isEmpty()) {
        return {};
    }
    if (report == exported || options.output.isEmpty()) {
        return QStringLiteral("-o goes with --report or with --export");
    }
    if (options.file.isEmpty()) {
        return QStringLiteral("%1 needs a FILE")
            .arg(report ? QStringLiteral("--report") : QStringLiteral("--export"));
    }
    if (!options.picture.isEmpty()) {
        return QStringLiteral("--picture goes with neither --report nor --export");
    }
    if (report && !report::formatOf(options.output)) {
        return QStringLiteral("the file of -o ends in .pdf, .html, .md or .odt");
    }
    if (exported && !canExport(options.exported)) {
        return QStringLiteral(
            "--export is all (into .xlsx or .json), inputs, cycle, stages, zones, "
            "profiles, requirements, trace, batch, sweep or search (into .xlsx or .csv)");
    }
    const QString target = QFileInfo(options.output).canonicalFilePath();
    return !target.isEmpty() && target == QFileInfo(options.file).canonicalFilePath()
               ? QStringLiteral("the output would take the place of the project")
               : QString();
}

/// Whether a report takes --at, --views or --answers.
bool takesOption(const QString& kind, const QString& option) {
    const auto paper = report::paperOf(kind);
    return kind == u"handout" || (paper == report::Paper::labReport && option == u"--views")
           || (paper && report::rowOf(*paper).takesStep && option == u"--at");
}

Options readOptions(const QStringList& words) {
    Options options;
    bool optionsOver = false;
    for (qsizetype i = 0; i < words.size() && options.fault.isEmpty(); ++i) {
        if (words[i] == u"--" && !optionsOver) {
            optionsOver = true;
        } else if (!optionsOver && words[i].startsWith(u'-') && words[i].size() > 1) {
            readOption(words, i, options);
        } else {
            options.many.files += words[i];
        }
    }
    options.file = options.many.files.value(0);
    if (options.many.files.size() > 1 && options.many.folder.isEmpty() && options.fault.isEmpty()) {
        options.fault = QStringLiteral("more than one file");
    }
    if (!options.picture.isEmpty() && options.file.isEmpty() && options.fault.isEmpty()) {
        options.fault = QStringLiteral("--picture needs a FILE");
    }
    if (!options.surface.isEmpty() && options.picture.isEmpty() && options.report.isEmpty()
        && options.exported.part.isEmpty() && options.fault.isEmpty()) {
        options.fault = QStringLiteral("--surface needs --picture, --report or --export");
    }
    if (!options.handoutOption.isEmpty() && !takesOption(options.report, options.handoutOption)
        && options.fault.isEmpty()) {
        options.fault = QStringLiteral("%1 needs --report handout").arg(options.handoutOption);
    }
    options.exported.file = options.file;
    options.exported.surface = options.surface;
    options.exported.output = options.output;
    if (options.fault.isEmpty()) {
        options.fault = outputFault(options);
    }
    return options;
}

bool displayMissing() {
#ifdef Q_OS_WIN
    return false;
#else
    const auto set = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
    return !set("DISPLAY") && !set("WAYLAND_DISPLAY") && !set("QT_QPA_PLATFORM");
#endif
}

void openFirstExample(Document& document) {
    const QStringList paths = ExamplesDialog::paths();
    const auto usual = std::find_if(paths.begin(), paths.end(), [](const QString& path) {
        return path.contains(QLatin1StringView("30h6"), Qt::CaseInsensitive);
    });
    const QString path = usual != paths.end() ? *usual : paths.value(0);
    if (path.isEmpty() || hasErrors(document.openCopy(ExamplesDialog::textOf(path)))) {
        document.startUntitled(newProject());
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

bool writePicture(MainWindow& window, const QString& path) {
    QByteArray png;
    QBuffer buffer(&png);
    if (!buffer.open(QIODevice::WriteOnly) || !settledPicture(window).save(&buffer, "PNG")) {
        say(stderr, QStringLiteral("sparkout: the picture could not be made"));
        return false;
    }
    return writeBytes(png, path);
}

int makePicture(QApplication& app, MainWindow& window, const Options& options) {
    window.resize(options.size);
    window.show();
    int quietTicks = 0;
    QTimer ticks;
    QObject::connect(&ticks, &QTimer::timeout, &app, [&] {
        const bool busy = window.findChild<BatchView*>()->busy()
                          || window.findChild<SweepView*>()->busy()
                          || window.findChild<RemedyFinder*>()->running();
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
    if (!openOrSay(window.document(), options.file, options.surface)) {
        return exitRefused;
    }
    return app.exec();
}

Settings settingsFor(const Options& options) {
    return options.portable ? Settings(PortableFolder::settingsFile()) : Settings();
}

/// Ends the program once the window was painted, and says so: whoever started it takes the time.
class FirstPaint : public QObject {
public:
    explicit FirstPaint(QWidget& window) : QObject(&window) { window.installEventFilter(this); }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            watched->removeEventFilter(this);
            QTimer::singleShot(0, this, [] { // once it is on the screen
                say(stdout, QStringLiteral("painted"));
                std::fflush(stdout);
                QCoreApplication::exit(0);
            });
        }
        return false;
    }
};

int runWindow(QApplication& app, MainWindow& window, const Options& options) {
    std::optional<FirstPaint> firstPaint;
    if (options.timesStart) {
        firstPaint.emplace(window);
    }
    const QString state = options.portable ? PortableFolder::stateFolder() : userStateFolder();
    window.protect(state);
    window.show();
    if (options.file.isEmpty()) {
        openFirstExample(window.document());
    }
    QTimer::singleShot(0, &window, [&] {
        bool isOpen = options.file.isEmpty();
        const auto opening = QObject::connect(&window.document(), &Document::projectReplaced,
                                              &window, [&isOpen] { isOpen = true; });
        window.files().start(options.file);
        QObject::disconnect(opening);
        if (options.file.isEmpty()) {
            window.help().offerTour();
        } else if (!isOpen) { // it cannot be opened, or is no project
            openFirstExample(window.document());
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
                    .arg(printableText(name), names.join(QStringLiteral(", "))));
    return false;
}

} // namespace

int main(int argc, char** argv) {
    cli::useConsoleOfCaller();
    QStringList words;
    std::string unreadable;
    for (const std::string& word : cli::argumentsOf(argc, argv)) {
        words += fromSystemText(word);
        if (systemText(words.last()) != word) {
            unreadable = word;
        }
    }
    if (!unreadable.empty()) { // another file would be read, or written
        say(stderr, QStringLiteral("sparkout: “%1” is not UTF-8; sparkout-cli takes such names")
                        .arg(QString::fromStdString(printable(unreadable))));
        return exitUsage;
    }
    const Options options = readOptions(words);
    if (!options.fault.isEmpty()) {
        say(stderr,
            QStringLiteral("sparkout: %1\n\n%2").arg(printableText(options.fault), usage()));
        return exitUsage;
    }
    if (options.help || options.version) {
        say(stdout, options.help ? usage().trimmed()
                                 : QStringLiteral("sparkout %1").arg(QString::fromUtf8(version)));
        return 0;
    }
    const bool picture = !options.picture.isEmpty();
    const bool hidden = picture || !options.output.isEmpty() || !options.many.folder.isEmpty();
    if (hidden && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    if (displayMissing()) {
        say(stderr, QStringLiteral("sparkout: there is no display (DISPLAY and WAYLAND_DISPLAY are "
                                   "not set). Use sparkout-cli, sparkout --picture or "
                                   "sparkout --report."));
        return exitUsage;
    }
    passOverPlatformNotices();
    PortableFolder::useItsFonts();
    int noArguments = 1; // the options are ours, Qt reads none of them
    std::optional<DisplayStart> display(std::in_place);
    QApplication app(noArguments, argv);
    DisplayStart::checkScreen();
    display.reset();
    std::setlocale(LC_NUMERIC, "C"); // QApplication took the environment's
    const ProgramLog log;
    ProgramLog::note(QStringLiteral("Sparkout %1, Qt %2, %3")
                         .arg(QString::fromUtf8(version), QString::fromUtf8(qVersion()),
                              QSysInfo::prettyProductName()));
    QApplication::setApplicationName(QStringLiteral("sparkout"));
    QApplication::setApplicationVersion(QString::fromUtf8(version));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.sparkout.sparkout"));
    if (options.portable && !PortableFolder::make()) {
        return exitUsage;
    }
    Settings settings = hidden ? Settings::transient() : settingsFor(options);
    settings.setAllInputs(!hidden && settings.allInputs()); // a picture has the usual ones
    Language language;
    language.apply(options.language.isEmpty() ? settings.language() : options.language);
    applyTheme(themeFrom(options.theme.isEmpty() ? settings.theme() : options.theme));
    PortableFolder::addItsFonts(); // the style has taken the system's for some kinds of widgets
    if (!options.report.isEmpty()) {
        ReportRequest request = options.request;
        request.paper = report::paperOf(options.report);
        request.kind = report::kindOf(options.report).value_or(request.kind);
        request.file = options.file;
        request.surface = options.surface;
        request.output = options.output;
        const Settings own = settingsFor(options); // else nothing of the user's is read
        request.company = own.company();
        const QString logoFault = report::Logo::fault(request.company.logo);
        if (!request.paper && !logoFault.isEmpty()) {
            say(stderr, QStringLiteral("sparkout: the logo of the settings is left out. %1")
                            .arg(logoFault));
        }
        request.institution = report::Institution::fromKept(own.titlePage());
        return options.many.folder.isEmpty() ? writeReport(request)
                                             : writeReports(request, options.many);
    }
    if (!options.output.isEmpty()) {
        return writeExport(options.exported);
    }
    applyFontSize(options.fontSize.value_or(fontSizeFrom(settings.fontSize())));
    MainWindow window(settings, language);
    if (!showWantedView(window, options.view)) {
        return exitUsage;
    }
    return picture ? makePicture(app, window, options) : runWindow(app, window, options);
}
