// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Workbooks, read back by another program.
#include "ui/table/sheet.h"

#include "core/workbook/workbook.h"
#include "tests/registry.h"
#include "tests/ui/support/xlsx_reader.h"

#include <QFile>
#include <QTemporaryDir>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace sparkout::test_xlsx_book {

Book bookOf(std::vector<Sheet> sheets) {
    return {QStringLiteral("Вал 30h6 <&>"), QStringLiteral("А. Иванов"),
            QStringLiteral("Sparkout 0.1.0"), std::move(sheets)};
}

/// Writes a workbook and reads it with openpyxl.
XlsxReader reread(const Book& book) {
    static const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("book.xlsx"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        qFatal("no room for the test's file");
    }
    file.write(xlsxBytes(book));
    file.close();
    return XlsxReader(path);
}

CsvTable column(const QString& header, const std::vector<CsvCell>& cells) {
    CsvTable table;
    table.header = {header};
    for (const CsvCell& cell : cells) {
        table.rows.push_back({cell});
    }
    return table;
}

bool sameBits(std::optional<double> a, double b) {
    return a && std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(b);
}

class TestXlsxBook : public QObject {
    Q_OBJECT

private slots:
    void everyDoubleSurvives() {
        std::mt19937_64 random(20261122);
        std::uniform_real_distribution<double> mantissa(-1, 1);
        std::uniform_int_distribution<int> exponent(-300, 300);
        std::vector<CsvCell> cells{1e-7, 0.1,  1.0 / 3, -12345678.9,          2.0,
                                   1e16, 1e22, 0.0,     123456789012345678.0, std::nextafter(1, 2)};
        for (int i = 0; i < 2000; ++i) {
            cells.emplace_back(i % 2 ? mantissa(random)
                                     : std::ldexp(mantissa(random), exponent(random)));
        }
        const XlsxReader read =
            reread(bookOf({sheetOf(column(QStringLiteral("x, mm"), cells), QStringLiteral("s"))}));
        QCOMPARE(read.fault(), QString());
        QCOMPARE(read.rows(0), int(cells.size()) + 2);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            QVERIFY2(sameBits(read.number(0, int(i) + 2, 0), std::get<double>(cells[i])),
                     qPrintable(QString::number(std::get<double>(cells[i]), 'g', 17)));
        }
    }

    void unitsStandInARowOfTheirOwnAndBothRowsStayInSight() {
        CsvTable table;
        table.header = {QStringLiteral("zone"), QStringLiteral("actual feed, µm: largest"),
                        QStringLiteral("limit, so far, mm/min"), QStringLiteral("this, that")};
        table.rows = {{QStringLiteral("RZ1"), 1.25, 2000.0, 3.0}};
        const XlsxReader read = reread(bookOf({sheetOf(table, QStringLiteral("Feeds"))}));
        const QStringList names = {QStringLiteral("zone"), QStringLiteral("actual feed: largest"),
                                   QStringLiteral("limit, so far"), QStringLiteral("this, that")};
        const QStringList units = {QString(), QStringLiteral("µm"), QStringLiteral("mm/min"),
                                   QString()};
        for (int i = 0; i < 4; ++i) {
            QCOMPARE(read.text(0, 0, i), names[i]);
            QCOMPARE(read.text(0, 1, i), units[i]);
        }
        QCOMPARE(read.frozen(0), QStringLiteral("A3"));
        table.header = {QStringLiteral("a"), QStringLiteral("b")};
        QCOMPARE(reread(bookOf({sheetOf(table, QStringLiteral("x"))})).frozen(0),
                 QStringLiteral("A2"));
    }

    void numbersAreShownWithTheDigitsOfTheirColumn_data() {
        addColumns<double, QString>("largest", "format");
        QTest::newRow("whole") << 54.0 << "0";
        QTest::newRow("micrometres") << 12.5 << "0.0000";
        QTest::newRow("small") << 0.01234 << "0.0000000";
        QTest::newRow("large") << 123456.5 << "0.0";
        QTest::newRow("compliance") << 3.1e-5 << "0.00000E+00";
    }
    void numbersAreShownWithTheDigitsOfTheirColumn() {
        QFETCH(double, largest);
        QFETCH(QString, format);
        const CsvTable table = column(QStringLiteral("x"), {0.0, -largest, std::monostate()});
        const XlsxReader read = reread(bookOf({sheetOf(table, QStringLiteral("x"))}));
        QCOMPARE(read.format(0, 2, 0), format);
    }

    void numbersOfAnySizeAreShownWithTheirOwnDigits() {
        CsvTable table = column(QStringLiteral("x"), {0.1 + 0.2, 9.6034567890123, 30.0,
                                                      1234.5678901, 1.23456789e-7, 123456789.0});
        table.ownUnits = true; // a length beside a force beside a count
        const XlsxReader read = reread(bookOf({sheetOf(table, QStringLiteral("x"))}));
        const QStringList formats{QStringLiteral("0.0"),         QStringLiteral("0.00000"),
                                  QStringLiteral("General"),     QStringLiteral("0.00"),
                                  QStringLiteral("0.00000E+00"), QStringLiteral("General")};
        for (int i = 0; i < formats.size(); ++i) {
            QCOMPARE(read.format(0, i + 1, 0), formats[i]);
            QVERIFY(sameBits(read.number(0, i + 1, 0),
                             std::get<double>(table.rows[std::size_t(i)].front())));
        }
    }

    void sheetsPrintAcrossWithTheirHeads() {
        CsvTable shortOne;
        shortOne.header = {QStringLiteral("zone"), QStringLiteral("actual feed, µm")};
        shortOne.rows = {{QStringLiteral("RZ1"), 1.25}};
        Sheet longOne;
        longOne.name = QStringLiteral("Trace of John's");
        longOne.columns = {{QStringLiteral("n")}, {QStringLiteral("m")}, {QStringLiteral("k")}};
        longOne.rows = 2000;
        longOne.fill = [](std::size_t row, std::vector<CsvCell>& cells) {
            cells.assign(3, double(row));
        };
        const XlsxReader read =
            reread(bookOf({sheetOf(shortOne, QStringLiteral("Feeds")), longOne}));
        QCOMPARE(read.fault(), QString());
        for (const int sheet : {0, 1}) {
            const QJsonArray print = read.sheet(sheet).value(QStringLiteral("print")).toArray();
            QCOMPARE(print.at(0).toString(), QStringLiteral("landscape"));
            QVERIFY(print.at(1).toBool());
            QCOMPARE(print.at(2).toInt(), 1); // page wide
            QCOMPARE(print.at(3).toInt(), 0); // as many pages high as it takes
            QCOMPARE(print.at(4).toVariant().toInt(), 9);
        }
        const QJsonArray first = read.sheet(0).value(QStringLiteral("print")).toArray(),
                         second = read.sheet(1).value(QStringLiteral("print")).toArray();
        QCOMPARE(first.at(5).toString(), QStringLiteral("$1:$2"));
        QVERIFY(first.at(6).toString().isEmpty());
        QCOMPARE(second.at(5).toString(), QStringLiteral("$1:$1"));
        // not a thousand pages: the first rows alone
        QVERIFY2(second.at(6).toString().endsWith(QStringLiteral("$A$1:$C$501")),
                 qPrintable(second.at(6).toString()));
        QCOMPARE(read.rows(1), 2001);
    }

    void textsAreTextsWhateverTheyBeginWith() {
        const std::vector<CsvCell> cells{QStringLiteral("=1+1"),
                                         QStringLiteral("+1"),
                                         QStringLiteral("-1"),
                                         QStringLiteral("@SUM(A1)"),
                                         QStringLiteral("=cmd|' /C calc'!A0"),
                                         QStringLiteral("подача, мкм"),
                                         QStringLiteral("<b>&\"'"),
                                         QStringLiteral("two\nlines"),
                                         QStringLiteral("  spaced  "),
                                         QStringLiteral("12,5"),
                                         QStringLiteral("#N/A")};
        CsvTable table = column(QStringLiteral("=head"), cells);
        const XlsxReader read = reread(bookOf({sheetOf(table, QStringLiteral("=sheet"))}));
        QCOMPARE(read.fault(), QString());
        QCOMPARE(read.type(0, 0, 0), QStringLiteral("s"));
        QCOMPARE(read.names().value(0), QStringLiteral("=sheet"));
        for (int i = 0; i < int(cells.size()); ++i) {
            QCOMPARE(read.type(0, i + 1, 0), QStringLiteral("s"));
            QCOMPARE(read.text(0, i + 1, 0), std::get<QString>(cells[std::size_t(i)]));
            QCOMPARE(read.quoted(0, i + 1, 0), i < 5); // stays a text when it is edited
        }
    }

    void whatXmlCannotHoldIsLeftOutAndNoFileIsTorn() {
        QString wild = QStringLiteral("a");
        for (int code = 0; code < 0x20; ++code) {
            wild += QChar(code);
        }
        wild += QChar(0xfffe) + QString(QChar(0xd800)) + QStringLiteral("z]]>");
        const CsvTable table = column(wild, {wild, QString(100'000, u'ы')});
        const XlsxReader read = reread(bookOf({sheetOf(table, wild)}));
        QCOMPARE(read.fault(), QString());
        QVERIFY(read.text(0, 1, 0).startsWith(u'a') && read.text(0, 1, 0).endsWith(u'>'));
        QCOMPARE(read.text(0, 2, 0).size(), xlsxTextLength);
    }

    void whatIsNoNumberIsAnEmptyCell() {
        CsvTable table;
        table.header = {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"),
                        QStringLiteral("d")};
        table.rows = {
            {std::nan(""), std::numeric_limits<double>::infinity(), std::monostate(), QString()},
            {1.5, 1.5, 1.5, 1.5}};
        const XlsxReader read = reread(bookOf({sheetOf(table, QStringLiteral("x"))}));
        for (int i = 0; i < 4; ++i) {
            QCOMPARE(read.type(0, 1, i), QString());
            QCOMPARE(read.number(0, 2, i).value_or(0), 1.5);
        }
    }

    void sheetNamesAreValidAndDifferent() {
        const QStringList wanted = {
            QStringLiteral("РЗ1"),      QStringLiteral("рз1"),     QStringLiteral("a/b:c*?[d]\\"),
            QString(40, u'n'),          QString(40, u'N'),         QString(),
            QStringLiteral("'quoted'"), QStringLiteral("History"), QStringLiteral(" \t ")};
        const QStringList names = sheetNames(wanted);
        QCOMPARE(names.size(), wanted.size());
        std::set<QString> folded;
        for (const QString& name : names) {
            QVERIFY(!name.isEmpty() && name.size() <= xlsxNameLength);
            for (const QChar sign : QStringLiteral("[]:*?/\\")) {
                QVERIFY(!name.contains(sign));
            }
            QVERIFY(!name.startsWith(u'\'') && !name.endsWith(u'\''));
            QVERIFY(name.compare(QStringLiteral("history"), Qt::CaseInsensitive) != 0);
            QVERIFY2(folded.insert(name.toCaseFolded()).second, qPrintable(name));
        }
        QCOMPARE(names[0], wanted[0]);
        std::vector<Sheet> sheets;
        for (const QString& name : wanted) {
            sheets.push_back(sheetOf(column(QStringLiteral("x"), {1.0}), name));
        }
        QCOMPARE(reread(bookOf(sheets)).names(), names);
    }

    void theDocumentSaysWhatItIsAndWhoMadeIt() {
        const Book book =
            bookOf({sheetOf(column(QStringLiteral("x"), {1.0}), QStringLiteral("x"))});
        const XlsxReader read = reread(book);
        QCOMPARE(read.text("title"), book.title);
        QCOMPARE(read.text("author"), book.author);
        QCOMPARE(read.text("program"), book.program);
        QCOMPARE(xlsxBytes(book), xlsxBytes(book)); // equal content, equal bytes
    }

    /// openpyxl reads no escapes: of Excel, which does, the standard says what it reads.
    void aTextThatLooksLikeAnEscapeStaysAText() {
        const auto asWritten = [](const char* text) { return xlsx::escaped(text); };
        QCOMPARE(asWritten("_x0041_"), std::string("_x005F_x0041_"));
        QCOMPARE(asWritten("a_x00e9_b"), std::string("a_x005F_x00e9_b"));
        // the second begins where the first ends
        QCOMPARE(asWritten("_x0041_x0042_"), std::string("_x005F_x0041_x005F_x0042_"));
        for (const char* plain : {"_x41_", "x0041_", "_x0041", "_X0041_", "a_b", "_x00g1_"}) {
            QCOMPARE(asWritten(plain), std::string(plain));
        }
        const QString text = QStringLiteral("_x0041_");
        const XlsxReader read =
            reread(bookOf({sheetOf(column(QStringLiteral("x"), {text}), QStringLiteral("s"))}));
        QCOMPARE(read.text(0, 1, 0), text);
    }

    /// Of names of files, which may be any bytes; and no half of a character where a text is cut.
    void whatIsNoUtf8IsMarked() {
        const std::pair<const char*, const char*> texts[] = {{"a\xFF"
                                                              "b",
                                                              "a?b"},
                                                             {"\xC3", "?"},
                                                             {"\xC0\xAF", "??"},
                                                             {"\xED\xA0\x80", "???"},
                                                             {"\xF4\x90\x80\x80", "????"},
                                                             {"é€😀", "é€😀"}};
        for (const auto& [text, written] : texts) {
            QCOMPARE(xlsx::escaped(text), std::string(written));
        }
        const std::string room(xlsx::mostTextLength - 2, 'a');
        QCOMPARE(xlsx::escaped(room + "😀b"), room + "😀");
        QCOMPARE(xlsx::escaped(room + "é😀b"), room + "é?");
        QCOMPARE(xlsx::lengthOf("é€😀"), std::size_t(4));
    }

    void everyTextIsHeldOnce() {
        xlsx::SharedTexts texts;
        QCOMPARE(texts.numberOf("RZ1"), std::size_t(0));
        QCOMPARE(texts.numberOf("NZ"), std::size_t(1));
        QCOMPARE(texts.numberOf("RZ1"), std::size_t(0));
        const QByteArray xml = QByteArray::fromStdString(texts.xml());
        QVERIFY2(xml.contains(" count=\"3\" uniqueCount=\"2\""), xml.constData());
        QCOMPARE(xml.count("<si>"), 2);
    }

    void aTableByPlacesHasASheetForEach() {
        CsvTable table;
        table.header = {QStringLiteral("zone"), QStringLiteral("x")};
        table.rows = {{QStringLiteral("РЗ1"), 1.0},
                      {QStringLiteral("НЗ"), 2.0},
                      {QStringLiteral("РЗ1"), 3.0}};
        table.byPlace = true;
        const XlsxReader read = reread(bookOf(sheetsOf(table, QStringLiteral("Feeds"))));
        QCOMPARE(read.names(), QStringList({QStringLiteral("РЗ1"), QStringLiteral("НЗ")}));
        QCOMPARE(read.number(0, 1, 1).value_or(0), 1.0);
        QCOMPARE(read.number(0, 2, 1).value_or(0), 3.0);
        QCOMPARE(read.number(1, 1, 1).value_or(0), 2.0);
        table.byPlace = false;
        QCOMPARE(sheetsOf(table, QStringLiteral("Feeds")).size(), std::size_t(1));
    }

    void aSheetLongerThanAWorkbookTakesIsKnownBefore() {
        Sheet sheet{QStringLiteral("long"), {{QStringLiteral("x"), QStringLiteral("mm")}}};
        sheet.fill = [](std::size_t row, std::vector<CsvCell>& cells) { cells[0] = double(row); };
        sheet.rows = xlsxRows - 2;
        QVERIFY(!sheetTooLong({sheet}));
        sheet.rows = xlsxRows - 1; // with names and units one too many
        QVERIFY(sheetTooLong({sheet}));
        QCOMPARE(xlsxBytes(bookOf({sheet})), QByteArray());
    }

    void aLongBookTellsItsProgressAndStopsAtOnce() {
        Sheet sheet{QStringLiteral("long"), {{QStringLiteral("x"), {}}}, 100'000};
        std::size_t made = 0;
        sheet.fill = [&made](std::size_t row, std::vector<CsvCell>& cells) {
            made = std::max(made, row);
            cells[0] = double(row);
        };
        for (const bool xlsx : {true, false}) {
            std::vector<double> shares;
            const auto half = [&shares](double share) {
                shares.push_back(share);
                return share < 0.5;
            };
            made = 0;
            const QByteArray bytes = xlsx ? xlsxBytes(bookOf({sheet}), half)
                                          : csvBytes(sheet, CsvDialect::english, half);
            QCOMPARE(bytes, QByteArray());
            QVERIFY(made > 40'000 && made < 52'000);
            QVERIFY(std::ranges::is_sorted(shares));
            QVERIFY(shares.front() == 0 && shares.back() >= 0.5);
        }
    }

    void csvOfASheetIsThatOfItsTable() {
        CsvTable table;
        table.header = {QStringLiteral("zone"), QStringLiteral("actual feed, µm")};
        table.rows = {{QStringLiteral("РЗ1"), 1.25}, {std::monostate(), 1e-7}};
        for (const CsvDialect dialect : {CsvDialect::russianExcel, CsvDialect::english}) {
            QCOMPARE(csvBytes(sheetOf(table, QStringLiteral("x")), dialect),
                     csvBytes(table, dialect));
        }
    }
};

} // namespace sparkout::test_xlsx_book

SPARKOUT_TEST(test_xlsx_book, TestXlsxBook)
#include "test_xlsx_book.moc"
