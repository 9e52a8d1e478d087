// SPDX-License-Identifier: GPL-3.0-or-later
// Texts from outside in messages and in tables: nothing steers the display, no cell is a formula.
#include "core/build_id.h"
#include "core/printable.h"
#include "tests/registry.h"

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace sparkout::test_printable {

class TestPrintable : public QObject {
    Q_OBJECT

private slots:
    void whatSteersTheDisplayIsShownAsItsCode_data() {
        addColumns<QByteArray, QByteArray>("text", "shown");
        const auto row = [](const char* name, const QByteArray& text, const QByteArray& shown) {
            QTest::newRow(name) << text << shown;
        };
        row("plain", "µm, rz1", "µm, rz1");
        row("tab and line ends", "a\tb\r\n", "a\\u0009b\\u000D\\u000A");
        row("NUL", QByteArray("a\0b", 3), "a\\u0000b");
        row("escape", "\x1b[2J", "\\u001B[2J");
        row("reversed", "a\u202Egpj.exe", "a\\u202Egpj.exe");
        row("isolated", "a\u2067b\u2069c", "a\\u2067b\\u2069c");
        row("beside the isolates", "a\u2065b\u206Ac", "a\u2065b\u206Ac");
        row("no UTF-8", "a\xff", "a\\xFF");
    }
    void whatSteersTheDisplayIsShownAsItsCode() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        QCOMPARE(QByteArray::fromStdString(printable(text.toStdString())), shown);
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

} // namespace sparkout::test_printable

SPARKOUT_TEST(test_printable, TestPrintable)
#include "test_printable.moc"
