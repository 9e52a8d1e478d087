// SPDX-License-Identifier: GPL-3.0-or-later
// Every example in every view, language and theme: pictures to look at, in gallery/ of the build
// folder, and none of them empty or with a warning. With SPARKOUT_GALLERY set also two of them with
// batch, sweep, search and comparison filled, in three themes, sizes of type and two of the window.
#include "core/project/cycle.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/kit/font_size.h"
#include "ui/plot/view.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QPointer>
#include <QPushButton>
#include <QScopeGuard>
#include <QSet>
#include <QTest>
#include <QTimer>

#include <string_view>
#include <vector>

namespace test_gallery {

using namespace sparkout;

namespace {

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

} // namespace

class TestGallery : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qInfo("The pictures are in %s", qPrintable(galleryFolder().absolutePath()));
    }

    void everyExampleInEveryViewHasAPicture_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("theme");
        QTest::addColumn<QSize>("size");
        std::vector<Theme> themes{Theme::light, Theme::dark};
        if (qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
            themes.push_back(Theme::contrast);
        }
        for (const char* language : {"en", "ru"}) {
            for (const Theme theme : themes) {
                QTest::addRow("%s %s", language, qPrintable(themeCode(theme)))
                    << QString::fromUtf8(language) << int(theme) << QSize(1366, 768);
                if (qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
                    QTest::addRow("%s %s large", language, qPrintable(themeCode(theme)))
                        << QString::fromUtf8(language) << int(theme) << QSize(1920, 1080);
                }
            }
        }
    }

    void everyExampleInEveryViewHasAPicture() {
        QFETCH(QString, language);
        QFETCH(int, theme);
        QFETCH(QSize, size);
        WarningCatcher warnings;
        Bench bench(language, Theme(theme));
        bench.window->resize(size);
        const QDir folder = galleryFolder();
        for (const QString& path : examplePaths()) {
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
        QTest::addColumn<QString>("path");
        if (!qEnvironmentVariableIsSet("SPARKOUT_GALLERY")) {
            QSKIP("SPARKOUT_GALLERY is not set");
        }
        for (const char* name : {"shaft-30h6-factory", "setups/spindle"}) {
            QTest::newRow(name) << QStringLiteral(SPARKOUT_SOURCE_DIR
                                                  "/resources/examples/%1.sparkout")
                                       .arg(QLatin1String(name));
        }
    }
    void everyViewFilledInEveryLook() {
        QFETCH(QString, path);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        Bench bench(QStringLiteral("en"));
        MainWindow& window = *bench.window;
        QVERIFY(bench.open(path));
        fill(bench);
        const QDir folder = galleryFolder();
        for (const char* language : {"english", "russian"}) {
            bench.action(language)->trigger();
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
                            const QString name =
                                QStringLiteral("%1/%2-%3-%4-%5-%6.png")
                                    .arg(nameOf(path), view->objectName(), QLatin1String(language))
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
    }

    /// Whatever window a menu's entry opens, on request.
    void everyDialogHasAPicture_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("theme");
        QTest::addColumn<int>("percent");
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
    void everyDialogHasAPicture() {
        QFETCH(QString, language);
        QFETCH(int, theme);
        QFETCH(int, percent);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        applyFontSize(percent);
        Bench bench(language, Theme(theme));
        QVERIFY(bench.open(
            QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/setups/spindle.sparkout")));
        const QDir folder = galleryFolder();
        QVERIFY(folder.mkpath(QStringLiteral("dialogs")));
        int seen = 0;
        for (const QAction* found : bench.window->findChildren<QAction*>()) {
            const QPointer<QAction> action = const_cast<QAction*>(found);
            const QString name = found->objectName();
            const QSet<QString> others{QStringLiteral("about"), QStringLiteral("log"),
                                       QStringLiteral("helpContents"),
                                       QStringLiteral("helpShortcuts")};
            if (name.isEmpty() || !found->isEnabled() || name.startsWith(u"print-")
                || (!found->text().endsWith(u'…') && !others.contains(name))) {
                continue;
            }
            const auto grab = [&] {
                for (QWidget* window : QApplication::topLevelWidgets()) {
                    if (window->isVisible() && window != bench.window.get()
                        && !window->inherits("QMenu")) {
                        const QString file =
                            QStringLiteral("dialogs/%1-%2.png")
                                .arg(name, QString::fromUtf8(QTest::currentDataTag()));
                        seen += pictureOf(*window).save(folder.filePath(file)) ? 1 : 0;
                        window->close();
                    }
                }
            };
            QTimer timer;
            connect(&timer, &QTimer::timeout, this, grab);
            timer.start(400);
            action->trigger();
            QTest::qWait(500);
        }
        QVERIFY(seen >= 15);
    }

    void anEmptyWidgetIsNoPicture() {
        QWidget empty;
        empty.resize(300, 200);
        QVERIFY(coloursIn(pictureOf(empty)) < 3);
    }
};

} // namespace test_gallery

SPARKOUT_TEST(test_gallery, TestGallery)
#include "test_gallery.moc"
