// SPDX-License-Identifier: GPL-3.0-or-later
// What is taken for a logo: PNG and JPEG of a bounded size, whatever the bytes declare or unpack
// to.
#include "tests/registry.h"
#include "tests/ui/support/logo_samples.h"
#include "ui/report/logo.h"

#include <QLocale>

#include <sys/resource.h>

namespace sparkout::test_logo {

using report::Logo;

long peakMemory_kB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

QByteArray drawing(const QByteArray& inside) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"40\">" + inside
           + "</svg>";
}

class TestLogo : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::English); }

    void picturesUpToTheLargestSideAreTaken() {
        for (const char* format : {"PNG", "JPG"}) {
            for (const QSize size : {QSize(1, 1), QSize(160, 40), QSize(4096, 3), QSize(3, 4096)}) {
                const QByteArray bytes = samples::picture(size, format);
                QCOMPARE(Logo::fault(bytes), QString());
                const QImage image = Logo::image(bytes);
                QVERIFY2(!image.isNull(), format);
                QVERIFY(image.width() <= 1200 && image.height() <= 1200);
            }
        }
        QCOMPARE(Logo::fault({}), QString());
        QVERIFY(Logo::image({}).isNull());
    }

    void aLargerPictureIsRefusedByItsSize() {
        for (const char* format : {"PNG", "JPG"}) {
            for (const QSize size : {QSize(4097, 2), QSize(2, 4097)}) {
                const QByteArray bytes = samples::picture(size, format);
                const QString fault = Logo::fault(bytes);
                QVERIFY2(fault.contains(QStringLiteral("4,097"))
                             && fault.contains(QStringLiteral("4,096")),
                         qPrintable(fault));
                QVERIFY(Logo::image(bytes).isNull());
            }
        }
    }

    /// Some hundred bytes that declare terabytes.
    void declaredSizesAreNotBelieved() {
        QByteArray png = samples::picture({10, 10}, "PNG");
        png.replace(16, 8, QByteArray("\x7f\xff\xff\xff\x7f\xff\xff\xff", 8));
        QByteArray jpeg = samples::picture({10, 10}, "JPG");
        const qsizetype frame = jpeg.indexOf("\xff\xc0");
        QVERIFY(frame > 0);
        jpeg.replace(frame + 5, 4, QByteArray("\xff\xff\xff\xff", 4));
        for (const QByteArray& bytes : {png, jpeg}) {
            QVERIFY(!Logo::fault(bytes).isEmpty());
            QVERIFY(Logo::image(bytes).isNull());
        }
    }

    void everyOtherKindIsRefusedAndDrawingsAreToldHowToBeConverted_data() {
        addColumns<QByteArray, bool>("bytes", "isDrawing");
        const QByteArray plain = drawing("<rect width=\"9\" height=\"9\"/>");
        addRow("SVG", plain, true);
        addRow("with a head", QByteArray("<?xml version=\"1.0\"?>\n") + plain, true);
        addRow("after a comment", "<!-- " + QByteArray(3000, 'x') + " -->" + plain, true);
        addRow("in capitals", plain.toUpper(), true);
        const QString wide = QString::fromLatin1(plain);
        addRow("UTF-16",
               QByteArray("\xff\xfe", 2)
                   + QByteArray(reinterpret_cast<const char*>(wide.utf16()), 2 * wide.size()),
               true);
        addRow("packed", QByteArray("\x1f\x8b\x08\0\0\0\0\0\0\x03", 10), true);
        addRow("names a file", drawing("<image href=\"/etc/hostname\" width=\"9\" height=\"9\"/>"),
               true);
        addRow("entities",
               QByteArray("<!DOCTYPE svg [<!ENTITY a \"aaaa\">]>") + drawing("<text>&a;</text>"),
               true);
        for (const char* format : {"BMP", "PPM", "XPM", "XBM", "ICO"}) {
            const QByteArray bytes = samples::picture({8, 8}, format);
            QVERIFY2(!bytes.isEmpty(), format);
            addRow(format, bytes, false);
        }
        addRow("GIF", QByteArray("GIF89a\x01\0\x01\0\x80\0\0", 13), false);
        addRow("TIFF", QByteArray("II*\0\x08\0\0\0", 8), false);
        addRow("WEBP", QByteArray("RIFF\x1a\0\0\0WEBPVP8L", 16), false);
        addRow("no picture", QByteArray("%PDF-1.7"), false);
        addRow("one byte", QByteArray("x"), false);
    }

    void everyOtherKindIsRefusedAndDrawingsAreToldHowToBeConverted() {
        QFETCH(const QByteArray, bytes);
        QFETCH(const bool, isDrawing);
        const QString fault = Logo::fault(bytes);
        QVERIFY(!fault.isEmpty());
        QCOMPARE(fault.contains(QStringLiteral("rsvg-convert")), isDrawing);
        QVERIFY(fault.contains(QStringLiteral("PNG")));
        QVERIFY(Logo::image(bytes).isNull());
    }

    void aDamagedPictureIsNull() {
        for (const char* format : {"PNG", "JPG"}) {
            const QByteArray whole = samples::picture({60, 60}, format);
            for (qsizetype size = 0; size < whole.size(); size += 7) {
                (void)Logo::image(whole.left(size)); // neither crashes nor hangs
                (void)Logo::fault(whole.left(size));
            }
            QVERIFY(!Logo::fault(whole.left(12)).isEmpty());
            QVERIFY(Logo::image(whole.left(12)).isNull());
        }
        const QByteArray cut = samples::withoutPixels(samples::picture({60, 60}, "PNG"));
        QCOMPARE(Logo::fault(cut), QString()); // its head is in order
        QVERIFY(Logo::image(cut).isNull());
    }

    /// A megabyte of texts that unpack to a gigabyte beside a picture of some pixels.
    void textsBesideThePictureAreNotUnpacked() {
        QByteArray png = samples::picture({20, 20}, "PNG");
        const QByteArray text =
            QByteArray("k\0\0", 3) + qCompress(QByteArray(7'900'000, 'x'), 9).mid(4);
        constexpr qsizetype headEnd = 8 + 25;
        for (int i = 0; i < 100 && png.size() < Logo::mostBytes - 20'000; ++i) {
            png.insert(headEnd, samples::pngChunk("zTXt", text));
        }
        QCOMPARE(Logo::fault(png), QString());
        const long before_kB = peakMemory_kB();
        QVERIFY(!Logo::image(png).isNull());
        QVERIFY2(peakMemory_kB() - before_kB < 50'000,
                 qPrintable(QString::number(peakMemory_kB() - before_kB)));
    }

    /// Each scan of a progressive JPEG runs over all pixels: ten thousand take minutes.
    void aPictureOfTooManyScansIsRefused() {
        QByteArray jpeg = samples::picture({100, 100}, "JPG");
        const qsizetype scan = jpeg.indexOf("\xff\xda");
        QVERIFY(scan > 0);
        jpeg.insert(jpeg.size() - 2, jpeg.mid(scan, 20).repeated(10'000));
        QVERIFY(!Logo::fault(jpeg).isEmpty());
        QVERIFY(Logo::image(jpeg).isNull());
    }

    void tooManyBytesAreRefused() {
        const QByteArray png = samples::picture({20, 20}, "PNG") + QByteArray(Logo::mostBytes, ' ');
        QVERIFY(Logo::fault(png).contains(QStringLiteral("1,048,576")));
        QVERIFY(Logo::image(png).isNull());
    }
};

} // namespace sparkout::test_logo

SPARKOUT_TEST(test_logo, TestLogo)
#include "test_logo.moc"
