// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "ui/table/csv_table.h"

#include "tests/registry.h"

#include <cmath>
#include <limits>
#include <random>

namespace sparkout::test_csv_table {

/// A plain CSV reader: cells of lines, quotation marks undone.
QList<QStringList> cellsOf(const QByteArray& bytes, QChar separator) {
    QList<QStringList> lines{{QString()}};
    bool quoted = false;
    const QString text = QString::fromUtf8(bytes);
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        if (quoted && c == u'"' && i + 1 < text.size() && text[i + 1] == u'"') {
            lines.back().back() += text[++i];
        } else if (c == u'"') {
            quoted = !quoted;
        } else if (!quoted && c == separator) {
            lines.back() << QString();
        } else if (!quoted && text.mid(i, 2) == QStringLiteral("\r\n")) {
            lines << QStringList{QString()};
            ++i;
        } else {
            lines.back().back() += c;
        }
    }
    lines.removeLast(); // after the last line end
    return lines;
}

CsvTable tableOf(std::vector<CsvCell> cells) {
    QStringList header;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        header << QStringLiteral("column %1").arg(i);
    }
    return {header, {std::move(cells)}};
}

class TestCsvTable : public QObject {
    Q_OBJECT

private slots:
    void numbersReadBackAsTheSameDouble() {
        std::mt19937_64 random(20261121);
        std::uniform_real_distribution<double> mantissa(-1, 1);
        std::uniform_int_distribution<int> exponent(-300, 300);
        std::vector<CsvCell> cells;
        for (int i = 0; i < 1000; ++i) {
            cells.emplace_back(std::ldexp(mantissa(random), exponent(random)));
        }
        cells.insert(cells.end(), {0.0, 0.1, 1.0 / 3, -12345678.9, 5e-324});
        const CsvTable table = tableOf(cells);
        for (const CsvDialect dialect : {CsvDialect::russianExcel, CsvDialect::english}) {
            const bool russian = dialect == CsvDialect::russianExcel;
            QByteArray bytes = csvBytes(table, dialect);
            QVERIFY(bytes.startsWith("\xEF\xBB\xBF")); // Excel reads UTF-8 by it
            bytes.remove(0, 3);
            const QStringList read = cellsOf(bytes, russian ? u';' : u',')[1];
            QCOMPARE(read.size(), qsizetype(cells.size()));
            for (qsizetype i = 0; i < read.size(); ++i) {
                QVERIFY(!read[i].contains(russian ? u'.' : u','));
                QString number = read[i];
                QCOMPARE(number.replace(u',', u'.').toDouble(),
                         std::get<double>(cells[std::size_t(i)]));
            }
        }
    }

    void whatIsNoNumberIsAnEmptyCell() {
        const CsvTable table =
            tableOf({std::nan(""), std::numeric_limits<double>::infinity(), std::monostate(), 1.5});
        QCOMPARE(cellsOf(csvBytes(table, CsvDialect::english), u',')[1],
                 QStringList({QString(), QString(), QString(), QStringLiteral("1.5")}));
    }

    void separatorsQuotesAndLineEndsStayWithinTheirCell() {
        const QStringList texts = {QStringLiteral("a;b"),         QStringLiteral("c,d"),
                                   QStringLiteral("say \"so\""),  QStringLiteral("two\nlines"),
                                   QStringLiteral("подача, мкм"), QStringLiteral(" spaced ")};
        const CsvTable table = tableOf({texts.begin(), texts.end()});
        QCOMPARE(cellsOf(csvBytes(table, CsvDialect::english), u',')[1], texts);
        QCOMPARE(cellsOf(csvBytes(table, CsvDialect::russianExcel).mid(3), u';')[1], texts);
    }

    void noTextCellBeginsAFormula_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"=1+1", "+1", "-1", "@SUM(A1)", "\tx", "\rx", "=cmd|' /C calc'!A0"}) {
            QTest::newRow(text) << QString::fromUtf8(text);
        }
    }
    void noTextCellBeginsAFormula() {
        QFETCH(QString, text);
        CsvTable table = tableOf({text});
        table.header = {text};
        for (const CsvDialect dialect : {CsvDialect::russianExcel, CsvDialect::english}) {
            QByteArray bytes = csvBytes(table, dialect);
            bytes.replace("\xEF\xBB\xBF", "");
            for (const QStringList& line :
                 cellsOf(bytes, dialect == CsvDialect::english ? u',' : u';')) {
                QCOMPARE(line[0], u'\'' + text);
            }
        }
        QVERIFY(tabSeparated(table, QLocale::c()).startsWith(u'\''));
    }

    /// What a cell cannot show is written as its code, which the reader takes back.
    void noTextCellHoldsWhatACellCannotShow() {
        CsvTable table;
        table.header << QStringLiteral("a");
        table.rows.push_back({QStringLiteral("x\u202Ey") + QChar(0) + QStringLiteral("z\u0007$1")});
        const QString text = QString::fromUtf8(csvBytes(table, CsvDialect::english));
        QVERIFY2(text.contains(QStringLiteral("x\\u202Ey\\u0000z\\u0007$1")), qPrintable(text));
        TableReader rows("x\\u202Ey\\u0000z\\u0007$1", ',');
        QVERIFY(rows.next());
        QCOMPARE(QString::fromUtf8(rows.cells().front()),
                 std::get<QString>(table.rows.front().front()));
        QVERIFY(
            tabSeparated(table, QLocale::c()).contains(QStringLiteral("x\uFFFDy\uFFFDz\uFFFD$1")));
    }

    void aNegativeNumberIsNoFormula() {
        const CsvTable table = tableOf({-9.6});
        QCOMPARE(cellsOf(csvBytes(table, CsvDialect::russianExcel).mid(3), u';')[1][0],
                 QStringLiteral("-9,6"));
    }

    void theClipboardTakesTheLocalesDecimalAndKeepsItsColumns() {
        const CsvTable table = tableOf({QStringLiteral("a\tb\nc"), 1234.5});
        QCOMPARE(tabSeparated(table, QLocale(QLocale::Russian)),
                 QStringLiteral("column 0\tcolumn 1\na b c\t1234,5\n"));
        QCOMPARE(tabSeparated(table, QLocale::c()),
                 QStringLiteral("column 0\tcolumn 1\na b c\t1234.5\n"));
    }
};

} // namespace sparkout::test_csv_table

SPARKOUT_TEST(test_csv_table, TestCsvTable)
#include "test_csv_table.moc"
