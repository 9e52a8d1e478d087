// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Cells to and from a spreadsheet: what LibreOffice Calc put on the clipboard is pasted (see
// tests/data/clipboard/README.md), and what is copied is read by LibreOffice where it is installed.
#include "tests/registry.h"
#include "tests/ui/inputs/stage_table_bench.h"
#include "tests/ui/support/on_disk.h"
#include "ui/form/number_field.h"
#include "ui/table/pasted_cells.h"

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QLocale>
#include <QMimeData>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QUrl>

namespace sparkout::test_spreadsheet_clipboard {

using stage_table_bench::Bench;

QString calcData(const QString& suffix) {
    QFile file(QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/clipboard/calc-ru.") + suffix);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void offer(const QString& plain, const QString& html) {
    auto data = std::make_unique<QMimeData>();
    if (!plain.isNull()) {
        data->setText(plain);
    }
    data->setHtml(html);
    QGuiApplication::clipboard()->setMimeData(data.release());
}

void write(const QString& path, const QString& text) {
    on_disk::write(path, text.toUtf8());
}

/// The settings of a LibreOffice of its own whose numbers are of a language.
void makeProfile(const QString& folder, const QString& language) {
    QVERIFY(QDir().mkpath(folder + QStringLiteral("/user")));
    write(folder + QStringLiteral("/user/registrymodifications.xcu"),
          QStringLiteral(
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?><oor:items "
              "xmlns:oor=\"http://openoffice.org/2001/registry\"><item "
              "oor:path=\"/org.openoffice.Setup/L10N\"><prop oor:name=\"ooSetupSystemLocale\" "
              "oor:op=\"fuse\"><value>%1</value></prop></item></oor:items>")
              .arg(language));
}

class TestSpreadsheetClipboard : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void cellsOfCalcAreTaken_data() {
        QTest::addColumn<bool>("plain");
        QTest::newRow("text and HTML") << true;
        QTest::newRow("HTML alone") << false;
    }
    void cellsOfCalcAreTaken() {
        QFETCH(bool, plain);
        QVERIFY(calcData(QStringLiteral("html")).contains(QStringLiteral("sdval=\"0,006\"")));
        offer(plain ? calcData(QStringLiteral("txt")) : QString(),
              calcData(QStringLiteral("html")));
        Bench bench(0, 0);
        QTest::keySequence(&bench.table.view(), QKeySequence::Paste);
        QCOMPARE(bench.stages().size(), 2u);
        QCOMPARE(bench.stages()[0].radial_feed_mm, std::optional(0.006));
        QCOMPARE(bench.stages()[0].axial_feed_mm_min, std::optional(1500.0));
        QCOMPARE(bench.stages()[0].stock_mm, 0.09);
        QCOMPARE(bench.stages()[1].radial_feed_mm, std::optional(0.003));
        QCOMPARE(bench.stages()[1].axial_feed_mm_min, std::optional(900.0));
        QCOMPARE(bench.stages()[1].stock_mm, 0.06);
    }

    void aFieldOfAListTakesCellsOfHtml() {
        offer(QString(), calcData(QStringLiteral("html")));
        CellsLineEdit field;
        PastedCells taken;
        field.setTakesCells([&taken](const PastedCells& cells) { taken = cells; });
        QTest::keySequence(&field, QKeySequence::Paste);
        QCOMPARE(taken.rows, PastedCells::of(calcData(QStringLiteral("txt"))).rows);
        QCOMPARE(field.text(), QString());
    }

    void cellsThatSpanOthersAndEmptyOnesKeepTheirPlaces() {
        QMimeData data;
        data.setHtml(QStringLiteral("<table><tr><td colspan=\"2\">a<br>b</td><td>1</td></tr>"
                                    "<tr><td></td><td>2</td><td>&lt;3</td></tr></table>"));
        const std::vector<QStringList> rows = PastedCells::of(&data).rows;
        QCOMPARE(rows.size(), std::size_t(2));
        QCOMPARE(rows[0], (QStringList{QStringLiteral("a\nb"), QString(), QStringLiteral("1")}));
        QCOMPARE(rows[1], (QStringList{QString(), QStringLiteral("2"), QStringLiteral("<3")}));
        data.setHtml(QStringLiteral("<p>0,5</p><p>0,6</p>"));
        QCOMPARE(PastedCells::of(&data).inOrder(),
                 (std::vector<QString>{QStringLiteral("0,5"), QStringLiteral("0,6")}));
    }

    void whatIsCopiedComesBackAsTextAndAsHtml() {
        Bench bench;
        const std::vector<Stage> before = bench.stages();
        bench.table.view().selectAll();
        QTest::keySequence(&bench.table.view(), QKeySequence::Copy);
        const QMimeData* const copied = QGuiApplication::clipboard()->mimeData();
        QVERIFY(copied->hasText() && copied->hasHtml());
        const std::vector<QStringList> rows = PastedCells::of(copied->text()).rows;
        QCOMPARE(rows.size(), before.size());
        offer(QString(), copied->html());
        QCOMPARE(PastedCells::of(QGuiApplication::clipboard()->mimeData()).rows, rows);
    }

    // Texts stay texts, numbers are numbers with all their digits, in either language.
    void libreOfficeReadsWhatIsCopied_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("en") << QStringLiteral("en-US");
        QTest::newRow("ru") << QStringLiteral("ru-RU");
    }
    void libreOfficeReadsWhatIsCopied() {
        QFETCH(QString, language);
        const QString program = QStandardPaths::findExecutable(QStringLiteral("soffice"));
        if (program.isEmpty()) {
            QSKIP("LibreOffice (soffice) is not installed: its side of the clipboard is not run");
        }
        const CopiedCells copied(QStringLiteral("Stage\tStock\tRatio\n"
                                                "1\t0,0031234567\t1/2\n"
                                                "2\t−0.06\t1-3\n"
                                                "3\t1e-7\t\"a \"\"b\"\", ж\"\n"));
        const QTemporaryDir folder;
        QVERIFY(folder.isValid());
        makeProfile(folder.filePath(QStringLiteral("profile")), language);
        write(folder.filePath(QStringLiteral("copied.html")), copied.html());
        QProcess process;
        process.start(
            program,
            {QStringLiteral("-env:UserInstallation=")
                 + QUrl::fromLocalFile(folder.filePath(QStringLiteral("profile"))).toString(),
             QStringLiteral("--headless"), QStringLiteral("--infilter=HTML (StarCalc)"),
             QStringLiteral("--convert-to"),
             // tabs, quotes, UTF-8; texts in quotes, numbers as they are
             QStringLiteral("csv:Text - txt - csv (StarCalc):9,34,76,1,,0,true,false"),
             QStringLiteral("--outdir"), folder.path(),
             folder.filePath(QStringLiteral("copied.html"))});
        QVERIFY2(process.waitForFinished(120000), qPrintable(process.errorString()));
        QFile file(folder.filePath(QStringLiteral("copied.csv")));
        QVERIFY2(file.open(QIODevice::ReadOnly), process.readAllStandardError().constData());
        QString expected = QStringLiteral("\"Stage\"\t\"Stock\"\t\"Ratio\"\n"
                                          "1\t0.0031234567\t\"1/2\"\n"
                                          "2\t-0.06\t\"1-3\"\n"
                                          "3\t0.0000001\t\"a \"\"b\"\", ж\"\n");
        if (language == QStringLiteral("ru-RU")) {
            expected.replace(u'.', u',');
        }
        QCOMPARE(QString::fromUtf8(file.readAll()), expected);
    }
};

} // namespace sparkout::test_spreadsheet_clipboard

SPARKOUT_TEST(test_spreadsheet_clipboard, TestSpreadsheetClipboard)
#include "test_spreadsheet_clipboard.moc"
