// SPDX-License-Identifier: GPL-3.0-or-later
// What the plot tools write, read back: through the real menu, the real file dialog, from the disk.
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/view_fixtures.h"
#include "ui/language.h"
#include "ui/session/settings.h"
#include "ui/views/feeds_plot.h"
#include "ui/views/feeds_view.h"
#include "ui/views/plot_tools.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QXmlStreamReader>

#include <clocale>
#include <functional>
#include <memory>

namespace test_plot_export {

using namespace sparkout;
using namespace fixtures;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Answers the dialogs that open while it lives: names a file, presses buttons of messages.
class User : public QObject {
public:
    QStringList paths;    ///< for the file dialogs, in turn; none left: cancel
    QStringList proposed; ///< names the dialogs proposed
    QStringList folders;  ///< they started in
    QStringList messages; ///< texts of the message boxes
    bool tryAgain = true; ///< in message boxes: the accepting button

    User() {
        m_timer.callOnTimeout(this, &User::look);
        m_timer.start(10);
    }

private:
    void look() {
        QWidget* dialog = QApplication::activeModalWidget();
        if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
            auto* name = files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            proposed << name->text();
            folders << files->directory().absolutePath();
            if (paths.isEmpty()) {
                files->reject();
                return;
            }
            name->setText(paths.takeFirst());
            QTest::keyClick(name, Qt::Key_Return);
        } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
            messages << box->text();
            for (QAbstractButton* button : box->buttons()) {
                const bool accepts = box->buttonRole(button) == QMessageBox::AcceptRole;
                if (accepts == tryAgain) {
                    QTest::mouseClick(button, Qt::LeftButton);
                    return;
                }
            }
        }
    }

    QTimer m_timer;
};

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

/// Cells of a line of numbers and plain texts.
QStringList cells(const QByteArray& line, char separator) {
    return QString::fromUtf8(line.trimmed()).split(QLatin1Char(separator));
}

} // namespace

class TestPlotExport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { m_view.reset(); }

    void pngDecodesAtEveryScaleAndIsNotBlank_data();
    void pngDecodesAtEveryScaleAndIsNotBlank();
    void picturesAreLightWhateverTheTheme();
    void aPictureLeavesTheWindowAsItWas();
    void svgIsWellFormedAndHoldsTitleLegendAndAxes();
    void svgClipsWhatIsZoomed();
    void pdfHoldsItsTextsInRussianAndIsNoPicture();
    void hiddenCurvesAreInNoFile();
    void csvHoldsTheNumbersOfTheCurves_data();
    void csvHoldsTheNumbersOfTheCurves();
    void csvHoldsTheVisibleRangeOnly();
    void theDialogProposesFolderAndName();
    void aFailureSaysWhyAndOffersAnotherPlace();
    void cancelWritesNothing();
    void savingDoesNotStallTheWindow();

private:
    [[nodiscard]] QString path(const char* name) const {
        return m_folder->filePath(QString::fromUtf8(name));
    }
    /// The bytes of the file that the action saves under the name.
    QByteArray saved(QAction* action, const char* name) {
        User user;
        user.paths << path(name);
        action->trigger();
        return contentOf(path(name));
    }

    QTemporaryDir m_config;
    OutcomePtr m_outcome;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<FeedsView> m_view;
};

void TestPlotExport::initTestCase() {
    setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    // Where Qt's file dialog remembers the folders it has seen: not the user's own file.
    QVERIFY(m_config.isValid());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_config.path());
    Project project = traverseProject();
    project.title = "Shaft 30h6: rough/fine";
    m_outcome = run(project);
    QVERIFY(m_outcome->ran());
}

void TestPlotExport::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_settings = std::make_unique<Settings>(Settings::transient());
    m_settings->setLastFolder(m_folder->path());
    m_view = std::make_unique<FeedsView>(nullptr, m_settings.get());
    m_view->resize(700, 620);
    m_view->show();
    QSignalSpy spy(m_view.get(), &FeedsView::updated);
    m_view->setOutcome(m_outcome);
    QTRY_COMPARE(spy.count(), 1);
    m_view->grab();
}

void TestPlotExport::pngDecodesAtEveryScaleAndIsNotBlank_data() {
    QTest::addColumn<int>("scale");
    for (int scale = 1; scale <= largestPictureScale; ++scale) {
        QTest::addRow("%d×", scale) << scale;
    }
}

void TestPlotExport::pngDecodesAtEveryScaleAndIsNotBlank() {
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

void TestPlotExport::picturesAreLightWhateverTheTheme() {
    const QByteArray light = saved(m_view->tools()->png[0], "light.png");
    m_view->setPalette(darkPalette());
    QCoreApplication::processEvents();
    QCOMPARE(m_view->plot()->palette().color(QPalette::Base), darkPalette().color(QPalette::Base));
    const QByteArray dark = saved(m_view->tools()->png[0], "dark.png");
    QVERIFY(!light.isEmpty());
    QCOMPARE(QImage::fromData(dark), QImage::fromData(light));
}

void TestPlotExport::aPictureLeavesTheWindowAsItWas() {
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

void TestPlotExport::svgIsWellFormedAndHoldsTitleLegendAndAxes() {
    const QStringList texts = svgTexts(saved(m_view->tools()->svg, "drawing.svg"));
    for (const char* text : {"Feeds by stage", "Shaft 30h6: rough/fine", "actual feed",
                             "normal force", "Time, min", "stage 1", "Axial feed,", "force, N"}) {
        QVERIFY2(texts.contains(QString::fromUtf8(text)), text);
    }
}

/// A zoomed curve reaches far beyond its plot: whatever lies outside is within a clip path that
/// does not.
void TestPlotExport::svgClipsWhatIsZoomed() {
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

void TestPlotExport::pdfHoldsItsTextsInRussianAndIsNoPicture() {
    Language language;
    language.apply(QStringLiteral("ru"));
    QCoreApplication::processEvents();
    const QByteArray bytes = saved(m_view->tools()->pdf, "document.pdf");
    language.apply(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
    QVERIFY(bytes.startsWith("%PDF-") && bytes.trimmed().endsWith("%%EOF"));
    const QString text =
        output(QStringLiteral("pdftotext"), {path("document.pdf"), QStringLiteral("-")});
    for (const char* part : {"Подачи по ступеням", "Shaft 30h6", "Время, мин", "Осевая подача,",
                             "фактическая подача", "РЗ1"}) {
        QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
    }
    // Every font is embedded, no page is a picture.
    const QStringList fonts =
        output(QStringLiteral("pdffonts"), {path("document.pdf")}).split(u'\n', Qt::SkipEmptyParts);
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

void TestPlotExport::hiddenCurvesAreInNoFile() {
    m_view->plot()->toggleCurve(static_cast<int>(Quantity::force));
    const QStringList texts = svgTexts(saved(m_view->tools()->svg, "drawing.svg"));
    QVERIFY(texts.contains(QStringLiteral("actual feed")));
    QVERIFY(!texts.contains(QStringLiteral("normal force")));
    const QByteArray csv = saved(m_view->tools()->csvEnglish, "data.csv");
    QVERIFY(csv.contains("actual feed"));
    QVERIFY(!csv.contains("normal force"));
}

void TestPlotExport::csvHoldsTheNumbersOfTheCurves_data() {
    QTest::addColumn<bool>("russian");
    QTest::newRow("Russian Excel") << true;
    QTest::newRow("English") << false;
}

void TestPlotExport::csvHoldsTheNumbersOfTheCurves() {
    QFETCH(bool, russian);
    const PlotTools* tools = m_view->tools();
    QByteArray bytes = saved(russian ? tools->csvRussian : tools->csvEnglish, "data.csv");
    QVERIFY(bytes.startsWith("\xEF\xBB\xBF"));
    bytes.replace("\xEF\xBB\xBF", "");
    QList<QByteArray> lines = bytes.split('\n');
    QVERIFY(lines.takeLast().isEmpty());
    const char separator = russian ? ';' : ',';
    // Names hold commas: in the English dialect they stand between quotation marks.
    QVERIFY(lines[0].contains(russian ? "actual feed, µm" : "\"actual feed, µm\""));
    const CsvTable table = m_view->plot()->table();
    QCOMPARE(lines.size(), qsizetype(table.rows.size()) + 1);
    int compared = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const QStringList read = cells(lines[qsizetype(row) + 1], separator);
        QCOMPARE(read.size(), qsizetype(table.rows[row].size()));
        for (std::size_t column = 0; column < table.rows[row].size(); ++column) {
            if (const auto* number = std::get_if<double>(&table.rows[row][column])) {
                QString text = read[qsizetype(column)];
                QVERIFY(!text.contains(russian ? u'.' : u','));
                QCOMPARE(text.replace(u',', u'.').toDouble(), *number);
                ++compared;
            }
        }
    }
    QVERIFY(compared > 1000);
    // And the curve on the screen is this one: the last actual feed of the last zone.
    const auto column = table.header.indexOf(QStringLiteral("actual feed, µm"));
    const QCPGraph* graph = m_view->plot()->curve(2, Quantity::actual, Edge::mean);
    QString last = cells(lines.back(), separator)[column];
    QCOMPARE(last.replace(u',', u'.').toDouble(), (graph->data()->constEnd() - 1)->value);
}

void TestPlotExport::csvHoldsTheVisibleRangeOnly() {
    const auto whole = saved(m_view->tools()->csvEnglish, "whole.csv").count('\n');
    const FeedSeries& series = m_view->plot()->series();
    m_view->plot()->showTimes(series.strokeStart_s[19], series.strokeEnd_s(40)); // 20…40
    const QByteArray part = saved(m_view->tools()->csvEnglish, "part.csv");
    QCOMPARE(part.count('\n'), 1 + 3 * 21);
    QVERIFY(part.count('\n') < whole);
}

void TestPlotExport::theDialogProposesFolderAndName() {
    User user;
    m_view->tools()->pdf->trigger();
    QCOMPARE(user.folders.value(0), m_folder->path());
    // Without the characters that some file systems refuse.
    QCOMPARE(user.proposed.value(0), QStringLiteral("Shaft 30h6_ rough_fine – Feeds by stage.pdf"));
    // The folder of the last file is where the next dialog starts.
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("deeper")));
    user.paths << path("deeper/one.csv");
    m_view->tools()->csvRussian->trigger();
    m_view->tools()->csvEnglish->trigger();
    QCOMPARE(user.folders.value(2), path("deeper"));
    QCOMPARE(m_settings->lastFolder(), path("deeper"));
    QVERIFY(user.proposed.value(2).endsWith(QStringLiteral(".csv")));
}

void TestPlotExport::aFailureSaysWhyAndOffersAnotherPlace() {
    User user;
    // The folder is gone, a thing not even root can write into; then the suffix comes by itself.
    user.paths << path("gone/first.png") << path("second");
    m_view->tools()->png[0]->trigger();
    QCOMPARE(user.messages.size(), 1);
    QVERIFY2(user.messages[0].contains(path("gone/first.png"))
                 && user.messages[0].contains(QStringLiteral("was not saved")),
             qPrintable(user.messages[0]));
    QVERIFY(!QImage::fromData(contentOf(path("second.png"))).isNull());
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    // Whoever gives up is left alone.
    user.tryAgain = false;
    user.paths << path("gone/third.svg") << path("third.svg");
    m_view->tools()->svg->trigger();
    QCOMPARE(user.messages.size(), 2);
    QVERIFY(!QFile::exists(path("third.svg")));
}

void TestPlotExport::cancelWritesNothing() {
    User user;
    for (QAction* action : {m_view->tools()->png[1], m_view->tools()->svg, m_view->tools()->pdf,
                            m_view->tools()->csvRussian}) {
        action->trigger();
    }
    QCOMPARE(user.proposed.size(), 4);
    QVERIFY(QDir(m_folder->path()).isEmpty());
}

/// The largest picture of a large view: its pixels are made beside the window.
void TestPlotExport::savingDoesNotStallTheWindow() {
    constexpr double target_ms = 50;
    m_view->resize(1600, 1000);
    m_view->grab();
    for (QAction* action : {m_view->tools()->png[3], m_view->tools()->svg, m_view->tools()->pdf,
                            m_view->tools()->csvRussian, m_view->tools()->xlsx}) {
        const double longest_ms = leastOfTries_ms(4 * target_ms, [&] {
            User user;
            user.paths << path("large");
            QElapsedTimer clock, whole;
            double worst_ms = 0;
            QTimer heart;
            heart.callOnTimeout([&] {
                if (user.paths.isEmpty()) { // the dialog is answered
                    worst_ms = std::max(worst_ms, double(clock.nsecsElapsed()) * 1e-6);
                }
                clock.start();
            });
            heart.start(2);
            whole.start();
            action->trigger();
            qInfo("saving %s: worst gap %.0f ms of %lld ms in all, target %g ms",
                  qPrintable(action->text()), worst_ms, static_cast<long long>(whole.elapsed()),
                  target_ms);
            return worst_ms;
        });
        QVERIFY(longest_ms <= 4 * target_ms);
    }
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 5);
}

} // namespace test_plot_export

SPARKOUT_TEST(test_plot_export, TestPlotExport)
#include "test_plot_export.moc"
