// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: own_language
// Every example in every view, language and theme: pictures to look at, in gallery/ of the build
// folder, and none of them empty or with a warning. With SPARKOUT_GALLERY set also two of them with
// batch, sweep, search and comparison filled, in three themes, sizes of type and two of the window.
#include "core/files/safe_file.h"
#include "core/setup/setup_file.h"
#include "tests/registry.h"
#include "tests/ui/support/examples.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/dialogs/file_questions.h"
#include "ui/files/file_lock.h"
#include "ui/files/recovery_store.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/kit/font_size.h"
#include "ui/plot/view.h"
#include "ui/window/dialogs/recovery_dialog.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QPointer>
#include <QPushButton>
#include <QSet>
#include <QTemporaryDir>
#include <QTimer>

#include <cerrno>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout::test_gallery {

constexpr int leastColours = 40; ///< an empty window of frames and grounds has fewer

int coloursIn(const QImage& image) {
    QSet<QRgb> colours;
    for (int y = 0; y < image.height(); y += 2) {
        for (int x = 0; x < image.width(); x += 2) {
            colours += image.pixel(x, y);
        }
    }
    return static_cast<int>(colours.size());
}

QImage pictureOf(QWidget& widget) {
    return widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

QDir galleryFolder() {
    const QDir folder(QStringLiteral(SPARKOUT_BUILD_DIR "/gallery"));
    return folder.mkpath(QStringLiteral(".")) ? folder : QDir();
}

void fill(Bench& bench) {
    MainWindow& window = *bench.window;
    bench.action("keepRun")->trigger();
    Project project = window.document().project();
    project.cycle->stages[0].axial_feed_mm_min = 1400;
    window.document().edit(std::move(project), {"Edit", "Change"});
    QTRY_VERIFY_WITH_TIMEOUT(!window.runs().running(), 60'000);
    for (const char* view : {"batch", "sweep", "optimise"}) {
        QVERIFY(window.showView(QLatin1String(view)));
        bench.settle();
        if (view != std::string_view("batch")) {
            if (auto* const run = window.findChild<QPushButton*>(QString::fromLatin1(view)
                                                                 + QStringLiteral("Run"));
                run->isEnabled()) {
                QTest::mouseClick(run, Qt::LeftButton);
            }
        }
        QTest::qWait(100);
        const View* const shown = window.viewTabs().currentView();
        QTRY_VERIFY_WITH_TIMEOUT(!shown->busy(), 240'000);
    }
}

/// Whether some of the looks that dialogs are drawn in are wanted.
void dialogLooks() {
    addColumns<QString, int, int>("language", "theme", "percent");
    if (!qEnvironmentVariableIsSet("SPARKOUT_GALLERY")) {
        QSKIP("SPARKOUT_GALLERY is not set");
    }
    for (const char* language : {"en", "ru"}) {
        for (const Theme theme : {Theme::light, Theme::dark}) {
            for (const int percent : {100, 130}) {
                QTest::addRow("%s-%s-%d", language, qPrintable(themeCode(theme)), percent)
                    << QString::fromUtf8(language) << int(theme) << percent;
            }
        }
    }
}

/// Draws whatever window stands beside the main one, then closes it; how many there were.
int drawDialogs(const Bench& bench, const QString& name) {
    const QDir folder = galleryFolder();
    int drawn = 0;
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (folder.mkpath(QStringLiteral("dialogs")) && window->isVisible()
            && window != bench.window.get() && !window->inherits("QMenu")) {
            const QString file = QStringLiteral("dialogs/%1-%2.png")
                                     .arg(name, QString::fromUtf8(QTest::currentDataTag()));
            drawn += pictureOf(*window).save(folder.filePath(file)) ? 1 : 0;
            window->close();
        }
    }
    return drawn;
}

/// The same of a dialog that is answered before the program goes on.
int drawModal(const Bench& bench, const QString& name, const std::function<void()>& show) {
    int drawn = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] { drawn += drawDialogs(bench, name); });
    timer.start(400);
    show();
    return drawn;
}

class TestGallery : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qInfo("The pictures are in %s", qPrintable(galleryFolder().absolutePath()));
    }

    void everyExampleInEveryViewHasAPicture_data() {
        addColumns<QString, int, QSize>("language", "theme", "size");
        if (!qEnvironmentVariableIsSet("SPARKOUT_LONG")) { // each language and theme once
            addRow("en light", "en", int(Theme::light), QSize(1366, 768));
            addRow("ru dark", "ru", int(Theme::dark), QSize(1366, 768));
            return;
        }
        for (const char* language : {"en", "ru"}) {
            for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
                QTest::addRow("%s %s", language, qPrintable(themeCode(theme)))
                    << QString::fromUtf8(language) << int(theme) << QSize(1366, 768);
            }
        }
        addRow("en light large", "en", int(Theme::light), QSize(1920, 1080));
        addRow("ru dark large", "ru", int(Theme::dark), QSize(1920, 1080));
    }

    void everyExampleInEveryViewHasAPicture() {
        QFETCH(QString, language);
        QFETCH(int, theme);
        QFETCH(QSize, size);
        WarningCatcher warnings;
        Bench bench(language, Theme(theme));
        bench.window->resize(size);
        const QDir folder = galleryFolder();
        for (const QString& path : filesIn(language, examplePaths())) {
            QVERIFY2(bench.open(path), qPrintable(path));
            QSet<QByteArray> different;
            for (View* view : bench.window->views()) {
                bench.window->viewTabs().showView(view);
                bench.settle();
                QTRY_VERIFY_WITH_TIMEOUT(!view->busy(), 60'000);
                bench.settle();
                const QImage image = pictureOf(*bench.window);
                const QString name =
                    QStringLiteral("%1-%2-%3-%4-%5.png")
                        .arg(nameOf(path), view->objectName(), language, themeCode(Theme(theme)))
                        .arg(size.width());
                QVERIFY(image.save(folder.filePath(name)));
                QVERIFY2(coloursIn(image) >= leastColours, qPrintable(name));
                QVERIFY2(coloursIn(pictureOf(*view)) >= leastColours / 2, qPrintable(name));
                different += QByteArray(reinterpret_cast<const char*>(image.constBits()),
                                        image.sizeInBytes());
                const QStringList warned = warnings.take();
                QVERIFY2(warned.isEmpty(), qPrintable(name + u'\n' + warned.join(u'\n')));
            }
            QCOMPARE(different.size(), qsizetype(bench.window->views().size()));
        }
    }

    /// With batch, sweep, search and comparison filled; the looks are changed while it runs.
    void everyViewFilledInEveryLook_data() {
        addColumns<QString, QString>("path", "language");
        if (!qEnvironmentVariableIsSet("SPARKOUT_GALLERY")) {
            QSKIP("SPARKOUT_GALLERY is not set");
        }
        for (const char* name : {"shaft-30h6-factory", "setups/spindle"}) {
            for (const char* language : {"english", "russian"}) {
                QTest::addRow("%s %s", name, language)
                    << examplePath(name) << QString::fromLatin1(language);
            }
        }
    }
    void everyViewFilledInEveryLook() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        Bench bench(QStringLiteral("en"));
        MainWindow& window = *bench.window;
        QVERIFY(bench.open(path));
        fill(bench);
        const QDir folder = galleryFolder();
        bench.action(qPrintable(language))->trigger();
        for (const int percent : {100, 115, 130}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            for (const QSize size : {QSize(1366, 768), QSize(1920, 1080)}) {
                window.resize(size);
                for (View* view : window.views()) {
                    window.viewTabs().showView(view);
                    for (const char* theme : {"theme-light", "theme-dark", "theme-contrast"}) {
                        bench.action(theme)->trigger();
                        bench.settle();
                        QTest::qWait(30);
                        bench.settle();
                        const QString name = QStringLiteral("%1/%2-%3-%4-%5-%6.png")
                                                 .arg(nameOf(path), view->objectName(), language)
                                                 .arg(percent)
                                                 .arg(size.width())
                                                 .arg(QLatin1String(theme));
                        QVERIFY(folder.mkpath(nameOf(path)));
                        QVERIFY(pictureOf(window).save(folder.filePath(name)));
                    }
                }
            }
        }
    }

    /// Whatever window a menu's entry opens, on request.
    void everyDialogHasAPicture_data() { dialogLooks(); }
    void everyDialogHasAPicture() {
        QFETCH(QString, language);
        QFETCH(int, theme);
        QFETCH(int, percent);
        applyFontSize(percent);
        Bench bench(language, Theme(theme));
        QVERIFY(bench.open(examplePath("setups/spindle")));
        int seen = 0;
        for (const QAction* found : bench.window->findChildren<QAction*>()) {
            const QPointer<QAction> action = const_cast<QAction*>(found);
            const QString name = found->objectName();
            const QSet<QString> others{
                QStringLiteral("about"), QStringLiteral("log"), QStringLiteral("helpContents"),
                QStringLiteral("helpShortcuts"), QStringLiteral("wholePart")};
            if (name.isEmpty() || !found->isEnabled() || name.startsWith(u"print-")
                || (!found->text().endsWith(u'…') && !others.contains(name))) {
                continue;
            }
            seen += drawModal(bench, name, [&] {
                action->trigger();
                QTest::qWait(500);
            });
        }
        QVERIFY(seen >= 15);
    }

    /// The questions and refusals that the work itself brings up.
    void everyQuestionHasAPicture_data() { dialogLooks(); }
    void everyQuestionHasAPicture() {
        QFETCH(QString, language);
        QFETCH(int, theme);
        QFETCH(int, percent);
        applyFontSize(percent);
        Bench bench(language, Theme(theme));
        MainWindow& window = *bench.window;
        const QString example = examplePaths().front();
        QVERIFY(bench.open(example));
        Project project = window.document().project();
        project.wheel->width_mm = 41;
        window.document().edit(project, {"Edit", "Change"});
        LockHolder holder;
        holder.readable = true;
        holder.user = holder.host = QStringLiteral("shop");
        holder.program = QStringLiteral("sparkout");
        holder.since = QDateTime::currentDateTime();
        FileError full;
        full.path = example.toStdString();
        full.step = FileStep::write;
        full.systemError = ENOSPC;
        full.freeBytes = 1024;
        const Issues issues = readSetup("{\"format\": \"sparkout-project\", \"version\": 1, "
                                        "\"part\": {\"diameter_mm\": -3, \"colour\": 1}}")
                                  .issues;
        const std::vector<std::pair<const char*, std::function<void()>>> asked{
            {"q-unsaved",
             [&] { (void)askUnsaved(&window, window.document(), {QStringLiteral("x: 5x")}); }},
            {"q-replace", [&] { (void)mayReplace(&window, example); }},
            {"q-locked", [&] { (void)askLocked(&window, example, holder); }},
            {"q-changed",
             [&] {
                 (void)askChangedOutside(&window, example, Outside::changed, Reloading::offered);
             }},
            {"q-save-failed", [&] { (void)askSaveFailed(&window, full); }},
            {"q-faults", [&] { FaultsDialog(example, issues, &window).exec(); }},
            {"q-recovery",
             [&] {
                 const QTemporaryDir state;
                 const RecoveryStore store(state.path());
                 RecoveryItem item;
                 item.header.title = QStringLiteral("30h6");
                 item.header.path = example;
                 item.header.when = QDateTime::currentDateTime();
                 std::vector<RecoveryItem> items(1);
                 items[0] = std::move(item);
                 RecoveryDialog(store, std::move(items), false, &window).exec();
             }},
        };
        for (const auto& [name, show] : asked) {
            QCOMPARE(drawModal(bench, QLatin1String(name), show), 1);
        }
        for (const int page : {1, 2, 3}) { // material, wheel, machine
            window.inputs().showPage(page);
            bench.settle();
            auto* button = window.inputs().pages()[std::size_t(page)]->findChild<QPushButton*>(
                QStringLiteral("fromCatalogue"));
            QVERIFY(button);
            QCOMPARE(drawModal(bench, QStringLiteral("q-catalogue-%1").arg(page),
                               [&] { QTest::mouseClick(button, Qt::LeftButton); }),
                     1);
        }
    }

    void anEmptyWidgetIsNoPicture() {
        QWidget empty;
        empty.resize(300, 200);
        QVERIFY(coloursIn(pictureOf(empty)) < 3);
    }
};

} // namespace sparkout::test_gallery

SPARKOUT_TEST(test_gallery, TestGallery)
#include "test_gallery.moc"
