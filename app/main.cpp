// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"
#include "app/display_start.h"
#include "app/manual/given.h"
#include "app/manual/help_text.h"
#include "app/portable_folder.h"
#include "app/report_command.h"
#include "app/window_io.h"
#include "core/printable.h"
#include "core/study/new_project.h"
#include "core/version.h"
#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"
#include "ui/report/format/report_text.h"
#include "ui/report/logo.h"
#include "ui/session/program_log.h"
#include "ui/session/recovery_store.h"
#include "ui/session/remedy_finder.h"
#include "ui/text/file_error_text.h"
#include "ui/text/language.h"
#include "ui/text/texts.h"
#include "ui/views/study/batch_view.h"
#include "ui/views/study/sweep_view.h"
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

#include <clocale>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

using namespace sparkout;

namespace {

constexpr int pictureTimeout_ms = 60'000;
constexpr int pictureTick_ms = 200; ///< two of them suffice for queued replots and layouts
constexpr int pictureRound_ms = 30, calmRounds = 3, mostRounds = 100;

/// The options in the form used by the rest of the program.
struct Options {
    explicit Options(const manual::Given& words);
    [[nodiscard]] QString text(const char* option) const;

    const manual::Given& given;
    QString file;
    ReportRequest request;
    ManyReports many; ///< with its folder, a report for every file
    ExportRequest exported;
    QSize size{1366, 768};
    QString fault; ///< the fault of the options; empty without one

private:
    void readReport();
};

QString Options::text(const char* option) const {
    return fromSystemText(given.text(option));
}

bool readSize(const QString& text, QSize& size) {
    const QStringList parts = text.split(u'x');
    bool readWidth = false;
    bool readHeight = false;
    size = {parts.value(0).toInt(&readWidth), parts.value(1).toInt(&readHeight)};
    return parts.size() == 2 && readWidth && readHeight && size.width() >= 400
           && size.height() >= 300 && size.width() <= 10'000 && size.height() <= 10'000;
}

/// The fault of the output of a report or an export; empty without one.
QString outputFault(const Options& options) {
    const QString output = options.text("-o");
    if (output.isEmpty()) {
        return {};
    }
    if (options.given.has("--report") && !report::formatOf(output)) {
        return QStringLiteral("the file of -o ends in .pdf, .html, .md or .odt");
    }
    if (options.given.has("--export") && !canExport(options.exported)) {
        return QStringLiteral(
            "--export is all (into .xlsx or .json), inputs, cycle, stages, zones, "
            "profiles, requirements, trace, batch, sweep or search (into .xlsx or .csv)");
    }
    const QString target = QFileInfo(output).canonicalFilePath();
    return !target.isEmpty() && target == QFileInfo(options.file).canonicalFilePath()
               ? QStringLiteral("the output would replace the project")
               : QString();
}

/// Whether a report takes --at, --views or --answers.
bool takesOption(const QString& kind, QLatin1StringView option) {
    const auto paper = report::paperOf(kind);
    return kind == u"handout"
           || (paper == report::Paper::labReport && option == QLatin1StringView("--views"))
           || (paper && report::rowOf(*paper).takesStep && option == QLatin1StringView("--at"));
}

Options::Options(const manual::Given& words) : given(words) {
    for (const std::string& operand : given.operands) {
        many.files += fromSystemText(operand);
    }
    file = many.files.value(0);
    exported = {text("--export"), file, text("--surface"), text("-o")};
    if (many.files.size() > 1 && !given.has("-d")) {
        fault = QStringLiteral("more than one file");
    }
    if (given.has("--size") && !readSize(text("--size"), size)) {
        fault = QString::fromStdString(given.refusal("--size"));
    }
    for (const char* output : {"--picture", "--report", "--export"}) {
        if (given.has(output) && file.isEmpty()) {
            fault = QStringLiteral("%1 needs a FILE").arg(QLatin1StringView(output));
        }
    }
    if (given.has("--report") && fault.isEmpty()) {
        readReport();
    }
    if (fault.isEmpty()) {
        fault = outputFault(*this);
    }
}

void Options::readReport() {
    const QString kind = text("--report");
    request.paper = report::paperOf(kind);
    request.kind = report::kindOf(kind).value_or(request.kind);
    request.file = file;
    request.surface = text("--surface");
    request.output = text("-o");
    many.folder = text("-d");
    many.suffix = given.has("--format") ? text("--format") : many.suffix;
    many.force = given.has("--force");
    if (!report::kindOf(kind) && !request.paper) {
        fault = QStringLiteral("unknown report “%1”; known: %2").arg(kind, reportKeys());
        return;
    }
    fault = readHandoutOptions(given, request);
    for (const char* option : {"--at", "--views", "--answers"}) {
        if (given.has(option) && !takesOption(kind, QLatin1StringView(option))) {
            fault = QStringLiteral("%1 needs --report handout").arg(QLatin1StringView(option));
        }
    }
}

int refuseUsage(const QString& fault) {
    say(stderr, QStringLiteral("sparkout: %1; see sparkout --help").arg(printableText(fault)));
    return exitUsage;
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
    if (hasErrors(document.openCopy(ExamplesDialog::textOf(ExamplesDialog::paths().front())))) {
        document.startUntitled(newProject());
    }
}

/// The final picture of the window: waits until layouts and replots change nothing any more.
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
            app.exit(writePicture(window, options.text("--picture")) ? 0 : exitRefused);
        }
    });
    QObject::connect(&window, &MainWindow::outcomeShown, &app, [&] {
        if (const auto stroke = options.given.integer("--stroke")) {
            window.cursor().toStroke(*stroke);
        }
        ticks.start(pictureTick_ms);
    });
    QTimer::singleShot(pictureTimeout_ms, &app, [&] {
        say(stderr, QStringLiteral("sparkout: the run took too long for a picture"));
        app.exit(exitRefused);
    });
    if (!openOrSay(window.document(), options.file, options.text("--surface"))) {
        return exitRefused;
    }
    return app.exec();
}

Settings settingsFor(const manual::Given& given) {
    return given.has("--portable") ? Settings(PortableFolder::settingsFile()) : Settings();
}

/// Ends the program once the window has been painted and reports it, so that the caller can take
/// the time.
class FirstPaint : public QObject {
public:
    explicit FirstPaint(QWidget& window) : QObject(&window) { window.installEventFilter(this); }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            watched->removeEventFilter(this);
            QTimer::singleShot(0, this, [] { // when it is on the screen
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
    if (options.given.has("--time-start")) {
        firstPaint.emplace(window);
    }
    const QString state =
        options.given.has("--portable") ? PortableFolder::stateFolder() : userStateFolder();
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
        } else if (!isOpen) { // it cannot be opened, or is not a project
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
    say(stderr, QStringLiteral("sparkout: unknown view “%1”; known: %2")
                    .arg(printableText(name), names.join(QStringLiteral(", "))));
    return false;
}

} // namespace

int main(int argc, char** argv) {
    cli::useConsoleOfCaller();
    const std::vector<std::string> words = cli::argumentsOf(argc, argv);
    for (const std::string& word : words) {
        if (systemText(fromSystemText(word)) != word) { // another file would be read or written
            say(stderr,
                QStringLiteral("sparkout: “%1” is not UTF-8; sparkout-cli accepts such names")
                    .arg(QString::fromStdString(printable(word))));
            return exitUsage;
        }
    }
    const manual::Program& program = manual::windowProgram();
    const manual::Reading reading(program, words);
    if (!reading.fault.empty()) {
        return refuseUsage(QString::fromStdString(reading.fault));
    }
    const manual::Given& given = reading.given;
    if (reading.asksForHelp || given.has("--version")) {
        say(stdout, reading.asksForHelp
                        ? QString::fromStdString(manual::helpText(program, program)).trimmed()
                        : QStringLiteral("sparkout %1").arg(QString::fromUtf8(version)));
        return 0;
    }
    const Options options(given);
    if (!options.fault.isEmpty()) {
        return refuseUsage(options.fault);
    }
    const bool picture = given.has("--picture");
    const bool hidden = picture || given.has("-o") || given.has("-d");
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
    int noArguments = 1; // Qt does not need the program's options
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
    if (given.has("--portable") && !PortableFolder::make()) {
        return exitUsage;
    }
    Settings settings = hidden ? Settings::transient() : settingsFor(given);
    settings.setAllInputs(!hidden && settings.allInputs()); // pictures show the usual inputs
    Language language;
    language.apply(given.has("--lang") ? options.text("--lang") : settings.language());
    applyTheme(themeFrom(given.has("--theme") ? options.text("--theme") : settings.theme()));
    PortableFolder::addItsFonts(); // again: the style took system fonts for some kinds of widgets
    if (given.has("--report")) {
        ReportRequest request = options.request;
        const Settings own = settingsFor(given); // otherwise no settings of the user are read
        request.company = own.company();
        const QString logoFault = report::Logo::fault(request.company.logo);
        if (!request.paper && !logoFault.isEmpty()) {
            say(stderr, QStringLiteral("sparkout: the logo of the settings is left out. %1")
                            .arg(logoFault));
        }
        request.institution = report::Institution::fromKept(own.titlePage());
        return given.has("-d") ? writeReports(request, options.many) : writeReport(request);
    }
    if (given.has("--export")) {
        return writeExport(options.exported);
    }
    applyFontSize(fontSizeFrom(given.has("--font-size") ? options.text("--font-size").toInt()
                                                        : settings.fontSize()));
    MainWindow window(settings, language);
    if (!showWantedView(window, options.text("--view"))) {
        return exitUsage;
    }
    return picture ? makePicture(app, window, options) : runWindow(app, window, options);
}
