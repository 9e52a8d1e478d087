// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of text: what is written is read back equal, whatever its cells hold; rows and quotation
// marks as other programs write them.
#include "core/file/text_table.h"

#include "core/file/csv_line.h"
#include "core/file/text_encoding.h"
#include "tests/processor_time.h"
#include "tests/registry.h"

#include <cmath>
#include <random>

namespace sparkout::test_table_reader {

using Rows = std::vector<std::vector<std::string>>;

Rows rowsOf(std::string_view text, char delimiter) {
    Rows rows;
    TableReader reader(text, delimiter);
    while (reader.next()) {
        rows.emplace_back(reader.cells().begin(), reader.cells().end());
    }
    return rows;
}

/// Texts of what makes cells hard to write.
class RandomText {
public:
    explicit RandomText(unsigned seed) : m_random(seed) {}

    std::size_t upTo(std::size_t last) {
        return std::uniform_int_distribution<std::size_t>(0, last)(m_random);
    }
    std::string text() {
        static const std::vector<std::string> pieces{
            "\"",     "\"\"",       ";",       ",",       "\t",      "\n",     "\r",
            "\r\n",   " ",          "'",       "=",       "+",       "-",      "@",
            "\\",     "\\\\",       "u202E",   "\\u202E", "\\u0009", "\u202E", "\u2067",
            "\u200F", "\u2028",     "\x1b[2J", "\x01",    "\x7f",    "\u0085", "Иванов",
            "ё",      "1,5",        "2.5",     "|",       "x",       "\u00A0", "Ø",
            "\uFEFF", "\U0001F600", "A1",      "\\x41",   "#",       "−",      "º"};
        std::string text;
        for (std::size_t count = upTo(5); count > 0; --count) {
            text += pieces[upTo(pieces.size() - 1)];
        }
        return text;
    }
    double number() {
        const auto exponent = static_cast<int>(upTo(600)) - 300;
        return std::ldexp(std::uniform_real_distribution<>(-1, 1)(m_random), exponent);
    }

private:
    std::mt19937 m_random;
};

class TestTableReader : public QObject {
    Q_OBJECT

private slots:
    void tenThousandCellsComeBackEqual_data() {
        addColumns<char, char>("delimiter", "decimal");
        QTest::newRow("comma, point") << ',' << '.';
        QTest::newRow("semicolon, decimal comma") << ';' << ',';
        QTest::newRow("tab, decimal comma") << '\t' << ',';
        QTest::newRow("comma, decimal comma") << ',' << ',';
    }
    void tenThousandCellsComeBackEqual() {
        QFETCH(char, delimiter);
        QFETCH(char, decimal);
        RandomText random(7);
        Rows texts;
        std::vector<double> numbers;
        CsvLine line({delimiter, decimal});
        std::string written;
        for (int row = 0; row < 2500; ++row) {
            numbers.push_back(random.number());
            auto& cells = texts.emplace_back();
            for (int column = 0; column < 4; ++column) {
                cells.push_back(random.text());
                line.text(cells.back());
            }
            written += line.number(numbers.back()).end(row % 2 == 0 ? "\n" : "\r\n");
        }
        const TableText text(written);
        QVERIFY(text.encoding() == TextEncoding::utf8);
        const Rows read = rowsOf(text.utf8(), delimiter);
        QCOMPARE(read.size(), texts.size());
        for (std::size_t row = 0; row < texts.size(); ++row) {
            QCOMPARE(read[row].size(), std::size_t{5});
            for (std::size_t column = 0; column < 4; ++column) {
                QCOMPARE(read[row][column], texts[row][column]);
            }
            QCOMPARE(cellNumber(read[row][4], decimal), std::optional(numbers[row]));
        }
    }

    void cellsHoldNoFormulaAndNothingThatSteersTheTerminal() {
        RandomText random(8);
        for (int i = 0; i < 10'000; ++i) {
            const std::string cell = csvCell(random.text());
            const std::string_view inside = std::string_view(cell).substr(cell[0] == '"' ? 1 : 0);
            QVERIFY2(!readsAsFormula(inside), cell.c_str());
            for (const QChar c : QString::fromStdString(cell)) {
                QVERIFY(c == u'\n' || c == u'\r' || c == u'\t' || c.unicode() >= 0x20);
                QVERIFY(c != QChar(0x202E) && c != QChar(0x2067) && c != QChar(0x7F));
            }
        }
    }

    void cellsOfTexts_data() {
        addColumns<QByteArray, QByteArray>("text", "cell");
        const auto row = [](const char* name, const QByteArray& text, const QByteArray& cell) {
            QTest::newRow(name) << text << cell;
        };
        row("plain", "rz1", "rz1");
        row("empty", "", "");
        row("unit", "µm", "µm");
        row("inner signs", "a=b+c-d@e", "a=b+c-d@e");
        row("equals", "=1+1", "'=1+1");
        row("plus", "+1", "'+1");
        row("minus", "-1", "'-1");
        row("at", "@SUM(A1)", "'@SUM(A1)");
        row("tab", "\t=1", "\"'\t=1\"");
        row("return", "\r=1", "\"'\r=1\"");
        row("line end", "a\nb", "\"a\nb\"");
        row("NUL", QByteArray("a\0b", 3), "a\\u0000b");
        row("escape", "\x1b[2J", "\\u001B[2J");
        row("reversed", "a\u202Egpj.exe", "a\\u202Egpj.exe");
        row("override ended", "a\u202Cb", "a\\u202Cb");
        row("isolated", "a\u2067b\u2069c", "a\\u2067b\\u2069c");
        row("beside the isolates", "a\u2065b\u206Ac", "a\u2065b\u206Ac");
        row("no UTF-8", "a\xff", "a\\xFF");
        row("comma", "a,b", "\"a,b\"");
        row("semicolon", "a;b", "a;b");
        row("spaces", " a", "\" a\"");
        row("as an escape", "\\u202E", "\\\\u202E");
        row("quotation marks", "=\"a\"", "\"'=\"\"a\"\"\"");
    }
    void cellsOfTexts() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, cell);
        QCOMPARE(QByteArray::fromStdString(csvCell(text.toStdString())), cell);
        QCOMPARE(csvCell("a;b,", ';'), std::string("\"a;b,\""));
    }

    void rowOfOneEmptyCellIsNoBlankLine() {
        CsvLine line;
        QCOMPARE(rowsOf("a\n" + line.text("").end() + "b\n", ','), (Rows{{"a"}, {""}, {"b"}}));
    }

    void quotationMarksAreReadAsOtherProgramsWriteThem_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("cells"); // of the first row, parted by |
        const auto row = [](const char* name, const char* text, const char* cells) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(cells);
        };
        row("doubled", "\"Иванов \"\"Ваня\"\"\";А1\n", "Иванов \"Ваня\"|А1");
        row("in the middle", "12\" wheel;1\n", "12\" wheel|1");
        row("spaces around", "  \"a\"  ; b \n", "a|b");
        row("spaces inside", "\" a \";b\n", " a |b");
        row("delimiter inside", "\"a;b\";c\n", "a;b|c");
        row("line ends inside", "\"a\r\nb\";c\n", "a\r\nb|c");
        row("not closed", "\"a;b\nc;d\n", "\"a|b");
        row("text behind", "\"a\"b;c\n", "\"a\"b|c");
        row("empty", "\"\";\"\"\"\";c", "|\"|c");
        row("at the end", "a;\"b", "a|\"b");
        row("apostrophe of a spreadsheet", "'=1;'a;'-5;O'Neil\n", "=1|'a|-5|O'Neil");
        row("as versions before wrote tabs", "a\\u0009b;c\n", "a\tb|c");
    }
    void quotationMarksAreReadAsOtherProgramsWriteThem() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, cells);
        QByteArray joined;
        const std::string table = text.toStdString();
        TableReader reader(table, ';');
        QVERIFY(reader.next());
        for (const std::string_view cell : reader.cells()) {
            joined += QByteArray::fromStdString(std::string(cell)) + '|';
        }
        QCOMPARE(joined, cells + '|');
    }

    void rowsEndAsAnySystemWritesThemAndKeepTheirLines() {
        const Rows expected{{"a", "1"}, {"b", "2"}};
        for (const char* text :
             {"a;1\nb;2", "a;1\r\nb;2\r\n", "a;1\rb;2\r", "a;1\r\r\nb;2\r\r\n"}) {
            QCOMPARE(rowsOf(text, ';'), expected);
        }
        TableReader rows("a\n\"b\nc\r\nd\"\ne\r\n\nf\n", ';');
        std::vector<std::size_t> lines;
        while (rows.next()) {
            lines.push_back(rows.line());
        }
        QCOMPARE(lines, (std::vector<std::size_t>{1, 2, 5, 6, 7}));
    }

    void headingsOfOneColumnMakeNoDelimiterOfACommaInACell() {
        QVERIFY((dialectOf("ФИО\nСмит, Джон\nИванов\n").delimiter == ';'));
        QVERIFY((dialectOf("stock_mm\n0,141\n0,147\n") == TableDialect{';', ','}));
        QVERIFY((dialectOf("\"name; first\",\"note\"\n\"x; y\",\"b\"\n").delimiter == ','));
        QVERIFY((dialectOf("name;note\n\"a\nb\";\"c\nd\"\n").delimiter == ';'));
    }

    /// Marks that are never closed take no more than a look at each byte.
    void hostileTextsAreReadInLinearTime() {
        const double start_ms = processorTime_ms();
        const auto repeated = [](const std::string& piece) {
            std::string text;
            while (text.size() < 500'000) {
                text += piece;
            }
            return text;
        };
        for (const char* piece :
             {"\"a\n", "\"\"a,\"", "\"", "\r", "\\\\", ",\"\"\"", "\"a,\"\"b,"}) {
            (void)rowsOf(repeated(piece), ',');
        }
        const double took_ms = processorTime_ms() - start_ms;
        QVERIFY2(took_ms < 5'000, qPrintable(QString::number(took_ms)));
    }
};

} // namespace sparkout::test_table_reader

SPARKOUT_TEST(test_table_reader, TestTableReader)
#include "test_table_reader.moc"
