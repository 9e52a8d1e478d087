// SPDX-License-Identifier: GPL-3.0-or-later
// Texts from outside in messages and in tables: nothing steers the display, no cell is a formula.
#include "core/build_id.h"
#include "core/printable.h"
#include "tests/registry.h"

#include <QTest>

#include <string>
#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace test_printable {

using namespace sparkout;

class TestPrintable : public QObject {
    Q_OBJECT

private slots:
    void cellsOfTexts_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("cell");
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
        row("tab", "\t=1", "'\\u0009=1");
        row("return", "\r=1", "'\\u000D=1");
        row("line end", "a\nb", "a\\u000Ab");
        row("NUL", QByteArray("a\0b", 3), "a\\u0000b");
        row("escape", "\x1b[2J", "\\u001B[2J");
        row("reversed", "a\u202Egpj.exe", "a\\u202Egpj.exe");
        row("override ended", "a\u202Cb", "a\\u202Cb");
        row("isolated", "a\u2067b\u2069c", "a\\u2067b\\u2069c");
        row("beside the isolates", "a\u2065b\u206Ac", "a\u2065b\u206Ac");
        row("no UTF-8", "a\xff", "a\\xFF");
        row("comma", "a,b", "\"a,b\"");
        row("semicolon", "a;b", "a;b");
        row("quotation marks", "=\"a\"", "\"'=\"\"a\"\"\"");
    }
    void cellsOfTexts() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, cell);
        QCOMPARE(QByteArray::fromStdString(csvCell(text.toStdString())), cell);
        QCOMPARE(csvCell("a;b,", ';'), std::string("\"a;b,\""));
    }

    /// What makes other bits: sources, compiler, C library, options of optimisation.
    void theBuildIsNamedByAllThatMakesOtherBits() {
        const QString build = QString::fromStdString(buildId());
        const QStringList named = build.split(QStringLiteral(", "));
        QCOMPARE(named.size(), 5);
        QCOMPARE(named[0].size(), 16);
#if defined(__clang__)
        const QString compiler = QStringLiteral("Clang " __clang_version__);
#else
        const QString compiler = QStringLiteral("GCC " __VERSION__);
#endif
        QCOMPARE(named[1], compiler);
#ifdef __GLIBC__
        QCOMPARE(named[2], QStringLiteral("glibc %1").arg(QLatin1String(gnu_get_libc_version())));
#endif
        QVERIFY2(named[3].startsWith(QStringLiteral("Eigen 3.")), qPrintable(build));
        for (const char* option : {"-ffp-contract=off", "-fno-signed-zeros", " -O"}) {
            QVERIFY2(named[4].contains(QLatin1String(option)), option);
        }
        QVERIFY2(!build.contains(QStringLiteral("-Wall")), qPrintable(build));
    }
};

} // namespace test_printable

SPARKOUT_TEST(test_printable, TestPrintable)
#include "test_printable.moc"
