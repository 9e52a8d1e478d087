// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that the plot tools write, read back: PNG, SVG and PDF, from the disk.
#include "tests/registry.h"
#include "tests/ui/chart/plot_export_bench.h"
#include "ui/text/language.h"

#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

#include <cmath>

namespace sparkout::test_plot_pictures {

using namespace plot_export_bench;

QPalette darkPalette() {
    QPalette dark;
    for (const auto role : {QPalette::Window, QPalette::Base, QPalette::Button}) {
        dark.setColor(role, QColor(0x20, 0x22, 0x26));
    }
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        dark.setColor(role, QColor(0xe6, 0xe6, 0xe6));
    }
    return dark;
}

/// All texts of an SVG; empty if it is not well-formed.
QStringList svgTexts(const QByteArray& svg) {
    QXmlStreamReader reader(svg);
    QStringList texts;
    while (!reader.atEnd()) {
        reader.readNext();
        if (reader.isStartElement() && reader.name() == QStringLiteral("text")) {
            texts << reader.readElementText();
        }
    }
    return reader.hasError() ? QStringList() : texts;
}

QString output(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished() && process.exitCode() == 0
               ? QString::fromUtf8(process.readAllStandardOutput())
               : QString();
}

class TestPlotPictures : public PlotExportTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }
    void init() { showView(); }
    void cleanup() { m_view.reset(); }

    void pngDecodesAtEveryScaleAndIsNotBlank_data() {
        QTest::addColumn<int>("scale");
        for (int scale = 1; scale <= largestPictureScale; ++scale) {
            QTest::addRow("%d×", scale) << scale;
        }
    }

    void pngDecodesAtEveryScaleAndIsNotBlank() {
        QFETCH(int, scale);
        const QByteArray bytes =
            saved(m_view->tools()->png[static_cast<std::size_t>(scale - 1)], "picture.png");
        QImage image;
        QVERIFY(image.loadFromData(bytes, "PNG"));
        QCOMPARE(image.width(), m_view->plot()->width() * scale);
        QVERIFY(image.height() > m_view->plot()->height() * scale); // heading and legend
        // The same size on paper at every scale.
        const double inches = image.width() / (image.dotsPerMeterX() * 0.0254);
        QVERIFY(std::abs(inches - m_view->plot()->width() / 96.0) < 0.01);
        // The curves' colours are there, the corners are white.
        QSet<QRgb> colours;
        for (int y = 0; y < image.height(); y += scale) {
            for (int x = 0; x < image.width(); x += scale) {
                colours << image.pixel(x, y);
            }
        }
        QVERIFY(colours.size() > 50);
        QVERIFY(colours.contains(QColor(0xD5, 0x5E, 0x00).rgb())); // the actual feed
        QCOMPARE(image.pixel(0, 0), QColor(Qt::white).rgb());
        QCOMPARE(image.pixel(image.width() - 1, image.height() - 1), QColor(Qt::white).rgb());
        // The title line is not blank.
        int dark = 0;
        for (int y = 0; y < 25 * scale; ++y) {
            for (int x = 0; x < image.width(); ++x) {
                dark += qGray(image.pixel(x, y)) < 100 ? 1 : 0;
            }
        }
        QVERIFY(dark > 50 * scale);
    }

    void picturesAreLightWhateverTheTheme() {
        const QByteArray light = saved(m_view->tools()->png[0], "light.png");
        m_view->setPalette(darkPalette());
        QCoreApplication::processEvents();
        QCOMPARE(m_view->plot()->palette().color(QPalette::Base),
                 darkPalette().color(QPalette::Base));
        const QByteArray dark = saved(m_view->tools()->png[0], "dark.png");
        QVERIFY(!light.isEmpty());
        QCOMPARE(QImage::fromData(dark), QImage::fromData(light));
    }

    void aPictureLeavesTheWindowAsItWas() {
        m_view->setPalette(darkPalette());
        QCoreApplication::processEvents();
        m_view->plot()->replot();
        const QImage before = m_view->grab().toImage();
        const QColor corner = before.pixelColor(0, m_view->plot()->geometry().center().y());
        QVERIFY2(corner.lightness() < 60, "the dark theme reached the plot");
        for (QAction* action : {m_view->tools()->png[3], m_view->tools()->svg, m_view->tools()->pdf,
                                m_view->tools()->copyPicture}) {
            User user;
            user.paths << path("file");
            action->trigger();
            m_view->plot()->replot();
            QTRY_VERIFY(m_view->grab().toImage()
                        == before); // the dialog's last events may be under way
        }
        // A later change of theme still reaches the plot.
        m_view->setPalette(QPalette());
        QCoreApplication::processEvents();
        QCOMPARE(m_view->plot()->palette().color(QPalette::Base), QPalette().color(QPalette::Base));
    }

    void svgIsWellFormedAndHoldsTitleLegendAndAxes() {
        const QStringList texts = svgTexts(saved(m_view->tools()->svg, "drawing.svg"));
        for (const char* text :
             {"Feeds by stage", "Shaft 30h6: rough/fine", "actual feed", "normal force",
              "Time, min", "stage 1", "Axial feed,", "force, N"}) {
            QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
        }
    }

    /// A zoomed curve reaches far beyond its plot: whatever lies outside is within a clip path that
    /// does not.
    void svgClipsWhatIsZoomed() {
        const double end_s = m_view->plot()->series().end_s;
        m_view->plot()->showTimes(0.40 * end_s, 0.42 * end_s);
        m_view->plot()->cell(0, 1)->axis(QCPAxis::atLeft)->setRange(140, 141);
        const QByteArray svg = saved(m_view->tools()->svg, "zoomed.svg");
        const QSize sheet = pictureSize({m_view->plot(), {}, {}});
        QXmlStreamReader reader(svg);
        static const QRegularExpression pair(QStringLiteral("(-?[0-9.e+-]+) (-?[0-9.e+-]+)"));
        const auto outside = [&](const QString& data) {
            auto matches = pair.globalMatch(data);
            while (matches.hasNext()) {
                const double y = matches.next().captured(2).toDouble();
                if (y < -1 || y > sheet.height() + 200) {
                    return true;
                }
            }
            return false;
        };
        QStringList clips; // of the groups around the reader
        int far = 0, clipPaths = 0;
        while (!reader.atEnd()) {
            reader.readNext();
            if (reader.isStartElement()) {
                const auto attributes = reader.attributes();
                const bool isClip = !clips.isEmpty() && clips.back() == QStringLiteral("clipPath");
                if (reader.name() == QStringLiteral("path")) {
                    const bool leaves = outside(attributes.value(QStringLiteral("d")).toString());
                    QVERIFY2(!isClip || !leaves, "a clip path lies within the sheet");
                    clipPaths += isClip ? 1 : 0;
                    if (leaves) {
                        ++far;
                        QVERIFY(clips.join(u' ').contains(QStringLiteral("url(#")));
                    }
                }
                clips << (reader.name() == QStringLiteral("clipPath")
                              ? QStringLiteral("clipPath")
                              : attributes.value(QStringLiteral("clip-path")).toString());
            } else if (reader.isEndElement()) {
                clips.removeLast();
            }
        }
        QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
        QVERIFY(clipPaths > 9);
        QVERIFY2(far > 0, "the test is of a curve that leaves its plot");
    }

    void pdfHoldsItsTextsInRussianAndIsNoPicture() {
        Language language;
        language.apply(QStringLiteral("ru"));
        QCoreApplication::processEvents();
        const QByteArray bytes = saved(m_view->tools()->pdf, "document.pdf");
        language.apply(QStringLiteral("en"));
        QLocale::setDefault(QLocale::c());
        QVERIFY(bytes.startsWith("%PDF-") && bytes.trimmed().endsWith("%%EOF"));
        const QString text =
            output(QStringLiteral("pdftotext"), {path("document.pdf"), QStringLiteral("-")});
        for (const char* part : {"Подачи по ступеням", "Shaft 30h6", "Время, мин", "Продольная,",
                                 "фактическая подача", "РЗ1"}) {
            QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
        }
        // Every font is embedded, no page is a picture.
        const QStringList fonts = output(QStringLiteral("pdffonts"), {path("document.pdf")})
                                      .split(u'\n', Qt::SkipEmptyParts);
        QVERIFY(fonts.size() > 2);
        for (const QString& font : fonts.mid(2)) {
            QVERIFY2(font.contains(QStringLiteral(" yes ")), qPrintable(font));
        }
        const QString images =
            output(QStringLiteral("pdfimages"), {QStringLiteral("-list"), path("document.pdf")});
        QCOMPARE(images.split(u'\n', Qt::SkipEmptyParts).size(), 2); // its own two lines of header
        const QString info = output(QStringLiteral("pdfinfo"), {path("document.pdf")});
        QVERIFY(info.contains(QStringLiteral("Pages:           1")));
    }

    void hiddenCurvesAreInNoFile() {
        m_view->plot()->toggleCurve(static_cast<int>(Quantity::force));
        const QStringList texts = svgTexts(saved(m_view->tools()->svg, "drawing.svg"));
        QVERIFY(texts.contains(QStringLiteral("actual feed")));
        QVERIFY(!texts.contains(QStringLiteral("normal force")));
        const QByteArray csv = saved(m_view->tools()->csvEnglish, "data.csv");
        QVERIFY(csv.contains("actual feed"));
        QVERIFY(!csv.contains("normal force"));
    }
};

} // namespace sparkout::test_plot_pictures

SPARKOUT_TEST(test_plot_pictures, TestPlotPictures)
#include "test_plot_pictures.moc"
