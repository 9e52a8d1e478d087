// SPDX-License-Identifier: GPL-3.0-or-later
// Encodings of table files: by byte order mark and by evidence; any bytes become valid UTF-8.
#include "core/file/text_encoding.h"

#include "core/lesson/work.h"
#include "core/sha256.h"
#include "tests/registry.h"

#include <QStringConverter>

#include <random>

namespace sparkout::test_text_encoding {

/// А…я of Windows-1251 and what else Russian tables have.
QByteArray windows1251(const QString& text) {
    QByteArray bytes;
    for (const QChar c : text) {
        const ushort code = c.unicode();
        bytes += code < 0x80                      ? static_cast<char>(code)
                 : code >= 0x410 && code <= 0x44F ? static_cast<char>(code - 0x410 + 0xC0)
                 : c == u'ё'                      ? '\xB8'
                 : c == u'Ё'                      ? '\xA8'
                 : c == u'№'                      ? '\xB9'
                                                  : '\xB5'; // µ
    }
    return bytes;
}

QByteArray encoded(const QString& text, QStringConverter::Encoding encoding, bool hasMark) {
    QStringEncoder encoder(encoding, hasMark ? QStringConverter::Flag::WriteBom
                                             : QStringConverter::Flag::Default);
    return encoder(text);
}

std::string textOf(const QByteArray& bytes) {
    return std::string(TableText(bytes.toStdString()).utf8());
}

class TestTextEncoding : public QObject {
    Q_OBJECT

private slots:
    void textIsReadInEveryEncoding_data() {
        QTest::addColumn<QString>("text");
        addRow("list of students", "ФИО;Группа\r\nИванов Пётр;ТМ-31\r\nЁлкина Анна;ТМ-31\r\n");
        addRow("names alone", "Иванов\nПетров\nСидоров\n");
        addRow("one word", "Иванов");
        addRow("measured values", "№ детали;Диаметр, мм\n1;29,991\n2;29,993\n");
        addRow("tabs", "t, с\tРазмер, мм\n0,1\t0,4001\n");
        addRow("one letter", "я");
    }
    void textIsReadInEveryEncoding() {
        QFETCH(QString, text);
        const std::string expected = text.toStdString();
        using E = QStringConverter::Encoding;
        for (const bool hasMark : {true, false}) {
            for (const E encoding : {E::Utf8, E::Utf16LE, E::Utf16BE}) {
                QCOMPARE(textOf(encoded(text, encoding, hasMark)), expected);
            }
        }
        QCOMPARE(textOf(encoded(text, E::Utf32LE, true)), expected);
        QCOMPARE(textOf(encoded(text, E::Utf32BE, true)), expected);
        QCOMPARE(textOf(windows1251(text)), expected);
    }

    void westernTextIsNotTakenForRussian() {
        const TableText text("Pr\xFC"
                             "fer;Ma\xDF\nM\xFCller;gr\xF6\xDF"
                             "er\n");
        QVERIFY(text.encoding() == TextEncoding::windows1252);
        QCOMPARE(text.utf8(), std::string_view("Prüfer;Maß\nMüller;größer\n"));
    }

    void textWithOneDamagedCharacterStaysUtf8() {
        const TableText text("ФИО\nИванов\nПе\xD1ров\nСидоров\n");
        QVERIFY(text.encoding() == TextEncoding::utf8);
        QCOMPARE(text.utf8(), std::string_view("ФИО\nИванов\nПе\uFFFDров\nСидоров\n"));
    }

    void digestIsOfTheBytesOfTheFile() {
        const std::string bytes = windows1251(QStringLiteral("Время, с\n1\n")).toStdString();
        QCOMPARE(TableText(bytes).sha256(), sha256(bytes));
        QCOMPARE(TableText("\xEF\xBB\xBFt\n").sha256(), sha256("\xEF\xBB\xBFt\n"));
        QCOMPARE(TableText(bytes).bytes(), bytes.size());
    }

    /// Whatever the bytes are, what is read of them can be written into JSON.
    void anyBytesBecomeValidUtf8() {
        std::mt19937 random(1);
        std::uniform_int_distribution<int> byte(0, 255), size(0, 40), kind(0, 3);
        for (int i = 0; i < 4'000; ++i) {
            std::string bytes = kind(random) == 0   ? "\xFF\xFE"
                                : kind(random) == 0 ? "\xEF\xBB\xBF"
                                                    : "";
            const int count = size(random);
            for (int k = 0; k < count; ++k) {
                bytes += static_cast<char>(byte(random));
            }
            const TableText text(bytes);
            QVERIFY(isUtf8(text.utf8()));
            for (const Student& student : readGroup(text).students) {
                QVERIFY(isUtf8(student.name) && isUtf8(student.group));
            }
        }
    }
};

} // namespace sparkout::test_text_encoding

SPARKOUT_TEST(test_text_encoding, TestTextEncoding)
#include "test_text_encoding.moc"
