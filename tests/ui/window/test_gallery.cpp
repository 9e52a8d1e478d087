// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: own_language
// Every example in every view, language and theme: pictures to look at, in gallery/ of the build
// folder, and none of them empty or with a warning.
#include "tests/registry.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/window/view_tabs.h"

#include <QDir>
#include <QSet>

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
    void anEmptyWidgetIsNoPicture() {
        QWidget empty;
        empty.resize(300, 200);
        QVERIFY(coloursIn(pictureOf(empty)) < 3);
    }
};

} // namespace sparkout::test_gallery

SPARKOUT_TEST(test_gallery, TestGallery)
#include "test_gallery.moc"
