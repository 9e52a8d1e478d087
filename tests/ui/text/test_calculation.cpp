// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "ui/text/calculation.h"

#include "ui/text/number_text.h"

#include "tests/registry.h"

#include <cmath>
#include <random>

namespace sparkout::test_calculation {

__extension__ using Wide = __int128;

/// Whole hundredths with a text of them: what a random sum comes to, exactly.
struct Exact {
    QString text;
    Wide over;
    int decimals;
};

Wide scaled(const Exact& value, int decimals) {
    Wide over = value.over;
    for (int i = value.decimals; i < decimals; ++i) {
        over *= 10;
    }
    return over;
}

class RandomSums {
public:
    explicit RandomSums(unsigned seed) : m_random(seed) {}

    int below(int count) { return std::uniform_int_distribution<>(0, count - 1)(m_random); }

    Exact make(int depth) {
        if (depth == 0 || below(4) == 0) {
            return leaf();
        }
        const Exact left = make(depth - 1), right = make(depth - 1);
        const int decimals = std::max(left.decimals, right.decimals);
        const QString gap = below(2) ? QStringLiteral(" ") : QString();
        const auto joined = [&](const QString& sign) {
            return QStringLiteral("(%1%2%3%2%4)").arg(left.text, gap, sign, right.text);
        };
        switch (below(3)) {
        case 0:
            return {joined(QStringLiteral("+")), scaled(left, decimals) + scaled(right, decimals),
                    decimals};
        case 1:
            return {joined(below(2) ? QStringLiteral("-") : QStringLiteral("−")),
                    scaled(left, decimals) - scaled(right, decimals), decimals};
        default:
            return {joined(below(2) ? QStringLiteral("*") : QStringLiteral("×")),
                    left.over * right.over, left.decimals + right.decimals};
        }
    }

private:
    Exact leaf() {
        const int whole = below(40), hundredths = below(100);
        return {QStringLiteral("%1%2%3")
                    .arg(whole)
                    .arg(QChar(below(2) ? u',' : u'.'))
                    .arg(hundredths, 2, 10, QLatin1Char('0')),
                whole * 100 + hundredths, 2};
    }

    std::mt19937 m_random;
};

QString decimalText(const Exact& exact) {
    Wide rest = exact.over < 0 ? -exact.over : exact.over;
    QString digits;
    for (; rest > 0; rest /= 10) {
        digits.prepend(QChar(u'0' + int(rest % 10)));
    }
    return (exact.over < 0 ? QStringLiteral("-0") : QStringLiteral("0")) + digits
           + QStringLiteral("e-%1").arg(exact.decimals);
}

class TestCalculation : public QObject {
    Q_OBJECT

private slots:
    void whatIsTypedIsWorkedOutExactly_data() {
        addColumns<QString, double>("text", "value");
        const auto row = [](const char* text, double value) { addRow(text, text, value); };
        row("0,25/2", 0.125);
        row("12+0.3", 12.3);
        row("(30-29,6)/2", 0.2); // in doubles 0.1999…93
        row("0.1+0.2", 0.3);
        row("30−29,6", 0.4);
        row("1,1*1.1", 1.21);
        row("1/3", 1.0 / 3);
        row("2+3*4", 14);
        row("12/2/3", 2);
        row("10-4-3", 3);
        row("3--5", 8);
        row("-(2+3)", -5);
        row("2×3", 6);
        row("6÷4", 1.5);
        row(" ( 1 + 2 ) * 3 ", 9);
        row("1\u00a0+\u00a02", 3);
        row("1e-3*2", 0.002);
        row("2*1е-3", 0.002); // a Cyrillic letter
        row("1e3-1", 999);
        row("010+1", 11);
        row("((((7))))", 7);
        row("0*5", 0);
        row("0e-2147483648+1", 1); // zero, whatever its exponent
        row("0.0e-2147483648+1", 1);
        row("1e300*1e300/1e300", 1e300);
    }
    void whatIsTypedIsWorkedOutExactly() {
        QFETCH(QString, text);
        QFETCH(double, value);
        const auto calculation = Calculation::of(text);
        QVERIFY(calculation);
        QCOMPARE(calculation->fault(), QString());
        QVERIFY(calculation->value());
        QVERIFY2(*calculation->value() == value,
                 qPrintable(showNumber(*calculation->value(), QLocale::c())));
    }

    void aNumberIsNoCalculation() {
        for (const char* text : {"", "5", "-5", "−0,5", "1e-5", "-1.5E+3", "+7", "abc", "1 000",
                                 "12 mm", "1.2.3", "0,5е−3"}) {
            QVERIFY2(!Calculation::of(QString::fromUtf8(text)), text);
        }
    }

    void aFaultIsNamed_data() {
        addColumns<QString, QString>("text", "fault");
        const auto row = [](const char* text, const char* fault) { addRow(text, text, fault); };
        row("12+", "a number is missing at the end");
        row("*3", "a number is missing before “*3”");
        row("2**3", "a number is missing before “*3”");
        row("--5", "a number is missing before “-5”");
        row("()", "a number is missing before “)”");
        row("(1+2", "a bracket is not closed");
        row("1+2)", "a closing bracket has no opening one");
        row("1/0", "division by zero");
        row("5/(2-2)", "division by zero");
        row("1 2+3", "an operator is missing before “2+3”");
        row("2(3)", "an operator is missing before “(3)”");
        row("(1 2)", "an operator is missing before “2)”");
        row("1+x", "“x” is not a number");
        row("1.2.3+4", "“1.2.3” is not a number");
        row("12 mm/2", "an operator is missing before “mm/2”");
        row("1e300*1e300", "the result is too large or too small");
        row("1e-300*1e-300", "the result is too large or too small");
    }
    void aFaultIsNamed() {
        QFETCH(QString, text);
        QFETCH(QString, fault);
        const auto calculation = Calculation::of(text);
        QVERIFY(calculation);
        QVERIFY(!calculation->value());
        QCOMPARE(calculation->fault(), fault);
    }

    void randomSumsAndProductsAreRoundedOnce() {
        RandomSums random(11);
        int worked = 0;
        for (int i = 0; i < 4000; ++i) {
            const Exact exact = random.make(3);
            const auto calculation = Calculation::of(exact.text);
            if (!calculation) { // a single number
                QVERIFY(parseNumber(exact.text));
                continue;
            }
            QVERIFY2(calculation->value(), qPrintable(exact.text));
            QVERIFY2(*calculation->value() == *parseNumber(decimalText(exact)),
                     qPrintable(exact.text));
            ++worked;
        }
        QVERIFY(worked > 2000);
    }

    /// The quotient of two whole numbers that doubles hold is rounded once by the processor, too.
    void randomQuotientsAreRoundedOnce() {
        std::mt19937_64 random(12);
        std::uniform_int_distribution<long long> whole(1, 1LL << 53);
        for (int i = 0; i < 4000; ++i) {
            const long long over = whole(random) >> (i % 40), under = whole(random) >> (i % 37);
            const auto calculation = Calculation::of(
                QStringLiteral("%1/%2").arg(std::max(over, 1LL)).arg(std::max(under, 1LL)));
            QCOMPARE(*calculation->value(),
                     double(std::max(over, 1LL)) / double(std::max(under, 1LL)));
        }
    }

    void anyTextHasAValueOrAFault() {
        const QString letters = QStringLiteral("0123456789.,+-*/()eE \u2212\u0435x");
        std::mt19937 random(13);
        std::uniform_int_distribution<qsizetype> letter(0, letters.size() - 1);
        std::uniform_int_distribution<> length(0, 24);
        int values = 0, faults = 0;
        for (int i = 0; i < 50'000; ++i) {
            QString text;
            for (int size = length(random); size > 0; --size) {
                text += letters[letter(random)];
            }
            const auto calculation = Calculation::of(text);
            if (!calculation) {
                continue;
            }
            QVERIFY2(calculation->value().has_value() == calculation->fault().isEmpty(),
                     qPrintable(text));
            QVERIFY(!calculation->value() || std::isfinite(*calculation->value()));
            ++(calculation->value() ? values : faults);
        }
        QVERIFY(values > 100 && faults > 100);
    }

    void bracketsAsDeepAsATextIsLongAreRead() {
        const QString deep = QString(199, u'(') + u'1' + QString(199, u')');
        QCOMPARE(*Calculation::of(deep)->value(), 1.0);
        QVERIFY(!Calculation::of(QString(500, u'(')));
    }
};

} // namespace sparkout::test_calculation

SPARKOUT_TEST(test_calculation, TestCalculation)
#include "test_calculation.moc"
