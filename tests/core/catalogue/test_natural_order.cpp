// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/catalogue/catalogue.h"
#include "tests/registry.h"

#include <cstring>
#include <random>
#include <string>

namespace sparkout::test_natural_order {

class TestNaturalOrder : public QObject {
    Q_OBJECT
private slots:
    void numbersAreOrderedByValue() {
        QVERIFY(naturalOrder("50x20", "400x50") < 0);
        QVERIFY(naturalOrder("wheel 10", "wheel 9") > 0);
        QVERIFY(naturalOrder("a", "b") < 0);
        QCOMPARE(naturalOrder("same 12", "same 12"), 0);
        QVERIFY(naturalOrder("same", "same 12") < 0);
    }

    void decimalsAreOrderedAsSuch() {
        QVERIFY(naturalOrder("1.05", "1.5") < 0);
        QVERIFY(naturalOrder("00", "0") < 0);
    }

    void theOrderIsThatOfTheLibrary() {
#ifdef __GLIBC__
        const auto sign = [](int value) { return (value > 0) - (value < 0); };
        std::mt19937 random(1);
        constexpr char letters[] = "0019a.-2";
        const auto extend = [&](std::string text, unsigned most) {
            for (auto left = random() % most; left > 0; --left) {
                text += letters[random() % 8];
            }
            return text;
        };
        for (int i = 0; i < 200'000; ++i) {
            const std::string head = extend({}, 4);
            const std::string a = extend(head, 5), b = extend(head, 5);
            QVERIFY2(sign(naturalOrder(a, b)) == sign(strverscmp(a.c_str(), b.c_str())),
                     qPrintable(QString::fromStdString(a + " | " + b)));
        }
#else
        QSKIP("the library has no such function");
#endif
    }
};

} // namespace sparkout::test_natural_order

SPARKOUT_TEST(test_natural_order, TestNaturalOrder)
#include "test_natural_order.moc"
