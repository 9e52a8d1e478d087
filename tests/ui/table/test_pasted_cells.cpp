// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "ui/table/pasted_cells.h"

#include "ui/text/number_text.h"

#include "tests/registry.h"

#include <QFile>
#include <QLocale>
#include <QMimeData>
#include <QTemporaryDir>
#include <QUrl>

#include <cmath>
#include <random>

namespace sparkout::test_pasted_cells {

const QList<QLocale> locales{QLocale(QLocale::English, QLocale::UnitedStates),
                             QLocale(QLocale::Russian, QLocale::Russia)};

using Rows = std::vector<QStringList>;

Rows rowsOfText(const char* text) {
    return PastedCells::of(QString::fromUtf8(text)).rows;
}

QStringList cells(std::initializer_list<const char*> texts) {
    QStringList list;
    for (const char* text : texts) {
        list << QString::fromUtf8(text);
    }
    return list;
}

class RandomCells {
public:
    explicit RandomCells(unsigned seed) : m_random(seed) {}

    int upTo(int last) { return std::uniform_int_distribution<>(0, last)(m_random); }

    double number() {
        const double size = std::pow(10.0, std::uniform_real_distribution<>(-6, 6)(m_random));
        return upTo(1) ? size : -size;
    }
    QString text() {
        static const QString letters = QStringLiteral("ab\"\t\n;,. 01\u00a0\u2212ж");
        QString made;
        for (int size = upTo(6); size > 0; --size) {
            made += letters[upTo(int(letters.size()) - 1)];
        }
        return made;
    }

private:
    std::mt19937 m_random;
};

class TestPastedCells : public QObject {
    Q_OBJECT

private slots:
    /// A page may name styles and pictures; a file that is opened for them may be any of the
    /// user's.
    void pastedHtmlOpensNoFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("style.css"));
        QFile style(path);
        QVERIFY(style.open(QIODevice::WriteOnly));
        style.write("td { white-space: pre }"); // as it would show
        style.close();
        for (const QString& name : {QUrl::fromLocalFile(path).toString(), path}) {
            for (const char* way :
                 {"<link rel=\"stylesheet\" href=\"%1\">", "<style>@import url(\"%1\");</style>"}) {
                QMimeData data;
                data.setHtml(QStringLiteral("<html><head>%1</head><body><table><tr><td>a   b</td>"
                                            "</tr></table></body></html>")
                                 .arg(QString::fromLatin1(way).arg(name)));
                QCOMPARE(PastedCells::of(&data).rows, Rows{cells({"a b"})});
            }
        }
    }

    void cellsArePartedAsSpreadsheetsAndFilesPartThem() {
        const Rows two{cells({"0,004", "1800"}), cells({"0,002", "1200"})};
        QCOMPARE(rowsOfText("0,004\t1800\n0,002\t1200\n"), two);     // a spreadsheet
        QCOMPARE(rowsOfText("0,004\t1800\r\n0,002\t1200\r\n"), two); // Excel
        QCOMPARE(rowsOfText("0,004\t1800\r0,002\t1200"), two);
        QCOMPARE(rowsOfText("0,004;1800\n0,002;1200"), two); // Russian CSV
        QCOMPARE(rowsOfText("\"0,004\";\"1800\"\n\"0,002\";\"1200\"\n\n\n"), two);
        QCOMPARE(rowsOfText("0.004,1800\n0.002,1200\n"),
                 (Rows{cells({"0.004", "1800"}), cells({"0.002", "1200"})})); // English CSV
        QCOMPARE(rowsOfText("\"0,004\",1800\n"), (Rows{cells({"0,004", "1800"})}));
    }

    void aCommaThatMayBeADecimalOneIsOne() {
        QCOMPARE(rowsOfText("0,004\n0,002\n"), (Rows{cells({"0,004"}), cells({"0,002"})}));
        QCOMPARE(rowsOfText("1,2"), (Rows{cells({"1,2"})}));
        QCOMPARE(rowsOfText("0,5\n1,2,3"),
                 (Rows{cells({"0,5"}), cells({"1,2,3"})})); // refused later
        QCOMPARE(rowsOfText("a, b"), (Rows{cells({"a, b"})}));
    }

    void quotesHoldWhatWouldPartCells() {
        QCOMPARE(rowsOfText("\"a\tb\"\t1\n"), (Rows{cells({"a\tb", "1"})}));
        QCOMPARE(rowsOfText("\"a\nb\"\t1\n"), (Rows{cells({"a\nb", "1"})}));
        QCOMPARE(rowsOfText("\"a \"\"b\"\"\"\t1"), (Rows{cells({"a \"b\"", "1"})}));
        QCOMPARE(rowsOfText("\"a;b\""), (Rows{cells({"a;b"})}));
        QCOMPARE(rowsOfText("12\"\t1"), (Rows{cells({"12\"", "1"})})); // inches
        QCOMPARE(rowsOfText("\"a\t1"), (Rows{cells({"\"a", "1"})}));   // a quote that is not closed
    }

    void emptyCellsStayAndEmptyRowsAtTheEndGo() {
        QCOMPARE(rowsOfText("1\t\n\t2\n\t\n"), (Rows{cells({"1", ""}), cells({"", "2"})}));
        QCOMPARE(rowsOfText("1\n\n2\n"), (Rows{cells({"1"}), cells({""}), cells({"2"})}));
        QVERIFY(PastedCells::of(QString()).empty());
        QVERIFY(PastedCells::of(QStringLiteral("\n\t\n")).empty());
    }

    void numbersOfACell_data() {
        addColumns<QString, bool, double>("text", "isNumber", "value");
        const auto row = [](const char* text, std::optional<double> value) {
            addRow(text, text, value.has_value(), value.value_or(0));
        };
        row("0,004", 0.004);
        row(" 0.004 ", 0.004);
        row("\u00a00,5\u00a0", 0.5);
        row("−0,5", -0.5);
        row("–3", -3);
        row("1\u00a0800", 1800);
        row("1\u202f234\u202f567,5", 1234567.5);
        row("12\u2009000.25", 12000.25);
        row("−1\u00a0000", -1000);
        row("1e-3", 0.001);
        row("1E+3", 1000);
        row("1 800", {}); // two cells or one: not guessed
        row("1,234.5", {});
        row("1.234,5", {});
        row("1\u00a080", {});
        row("12\u00a0mm", {});
        row("1/2", {});
        row("abc", {});
        row("", {});
        row("—", {});
    }
    void numbersOfACell() {
        QFETCH(QString, text);
        QFETCH(bool, isNumber);
        QFETCH(double, value);
        const std::optional<double> read = pastedNumber(text);
        QCOMPARE(read.has_value(), isNumber);
        QCOMPARE(read.value_or(0), value);
    }

    void anyTableOfNumbersComesBackTheSameInEitherLocale() {
        RandomCells random(5);
        for (const QLocale& locale : locales) {
            for (int i = 0; i < 400; ++i) {
                const int rows = 1 + random.upTo(6), columns = 1 + random.upTo(5);
                std::vector<std::vector<double>> numbers;
                PastedCells copied;
                for (int row = 0; row < rows; ++row) {
                    numbers.emplace_back();
                    copied.rows.emplace_back();
                    for (int column = 0; column < columns; ++column) {
                        numbers.back().push_back(random.number());
                        QString text = showNumber(numbers.back().back(), locale);
                        copied.rows.back() << (random.upTo(1) ? text.replace(u'-', u'−') : text);
                    }
                }
                QString text = copied.text();
                if (random.upTo(1)) {
                    text.replace(QStringLiteral("\n"), QStringLiteral("\r\n"));
                }
                if (random.upTo(1) && columns > 1) { // as a file
                    text.replace(u'\t', u';');
                }
                const PastedCells pasted = PastedCells::of(text);
                QCOMPARE(pasted.rows, copied.rows);
                for (std::size_t row = 0; row < numbers.size(); ++row) {
                    for (std::size_t k = 0; k < numbers[row].size(); ++k) {
                        QCOMPARE(pastedNumber(pasted.rows[row][qsizetype(k)]).value(),
                                 numbers[row][k]);
                    }
                }
            }
        }
    }

    void anyTextsComeBackTheSame() {
        RandomCells random(6);
        for (int i = 0; i < 4000; ++i) {
            PastedCells copied;
            const int columns = 1 + random.upTo(3);
            for (int rows = 1 + random.upTo(4); rows > 0; --rows) {
                copied.rows.emplace_back();
                for (int column = 0; column < columns; ++column) {
                    copied.rows.back() << random.text();
                }
            }
            copied.rows.back().back() = QStringLiteral("end"); // else it may be left out as empty
            const QString text = copied.text();
            QVERIFY2(PastedCells::of(text).rows == copied.rows, qPrintable(text));
        }
    }
};

} // namespace sparkout::test_pasted_cells

SPARKOUT_TEST(test_pasted_cells, TestPastedCells)
#include "test_pasted_cells.moc"
