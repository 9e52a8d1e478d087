// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/search_combo.h"

#include "tests/registry.h"

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>

namespace sparkout::test_search_combo {

struct Bench {
    Bench() {
        combo.addItem(QStringLiteral("нет"));
        const auto add = [this](const char* text, const char* words) {
            combo.addItem(QString::fromUtf8(text));
            combo.setItemData(combo.count() - 1, QString::fromUtf8(words), SearchCombo::wordsRole);
        };
        add("Круг › Затупление", "Dullness\nη_z\nηz\n/wheel/dullness");
        add("Ступень 1 › Припуск на сторону",
            "Stage stock per side\nΠ_z\n/cycle/stages/0/stock_mm");
        add("Ступень 2 › Припуск на сторону",
            "Stage stock per side\nΠ_z\n/cycle/stages/1/stock_mm");
        add("Ступень 2 › Продольная подача",
            "Axial feed\nS_ax\nSax\n/cycle/stages/1/axial_feed_mm_min");
        add("Люнет › Жёсткость", "Stiffness\n/part/shaft/steady_rests/0/stiffness_n_um");
        combo.show();
        QApplication::setActiveWindow(&combo);
        combo.setFocus();
    }
    [[nodiscard]] QLineEdit& search() {
        return *combo.findChild<QLineEdit*>(QStringLiteral("search"));
    }
    [[nodiscard]] QListView& list() {
        for (auto* view : combo.findChildren<QListView*>()) {
            if (view->model() != combo.model()) {
                return *view;
            }
        }
        return *combo.findChild<QListView*>();
    }
    [[nodiscard]] bool isOpen() { return search().isVisible(); }
    [[nodiscard]] QStringList found() {
        QStringList texts;
        for (int i = 0; i < list().model()->rowCount(); ++i) {
            texts << list().model()->index(i, 0).data().toString();
        }
        return texts;
    }
    /// Keys of a test are ASCII: other letters come from the clipboard.
    void write(const QString& text) {
        QApplication::clipboard()->setText(text);
        search().selectAll();
        QTest::keySequence(&search(), QKeySequence::Paste);
    }
    SearchCombo combo;
};

class TestSearchCombo : public QObject {
    Q_OBJECT

private slots:
    void typingInTheClosedBoxSearchesAndEnterChooses() {
        Bench bench;
        const QSignalSpy activated(&bench.combo, &QComboBox::activated);
        QTest::keyClicks(&bench.combo, QStringLiteral("s"));
        QVERIFY(bench.isOpen());
        QCOMPARE(bench.search().text(), QStringLiteral("s"));
        QTest::keyClicks(&bench.search(), QStringLiteral("ax"));
        QCOMPARE(bench.found(), QStringList(QStringLiteral("Ступень 2 › Продольная подача")));
        QTest::keyClick(&bench.search(), Qt::Key_Return);
        QVERIFY(!bench.isOpen());
        QCOMPARE(bench.combo.currentIndex(), 4);
        QCOMPARE(activated.size(), 1);
        QCOMPARE(activated[0][0].toInt(), 4);
    }

    void everyWordIsLookedForInAnyCaseAndEitherLanguage_data() {
        addColumns<QString, int>("text", "count");
        const auto row = [](const char* text, int count) { addRow(text, text, count); };
        row("припуск", 2);
        row("ПРИПУСК 2", 1);
        row("2 припуск", 1);
        row("STOCK", 2);
        row("stock ступень", 2);
        row("π_Z", 2); // a Greek capital folds, too
        row("ηz", 1);
        row("stages/1/", 2);
        row("жесткость", 1); // е for ё
        row("  ", 6);
        row("xyz", 0);
    }
    void everyWordIsLookedForInAnyCaseAndEitherLanguage() {
        QFETCH(QString, text);
        QFETCH(int, count);
        Bench bench;
        bench.combo.showPopup();
        bench.write(text);
        QCOMPARE(bench.found().size(), count);
        QCOMPARE(bench.list().isVisible(), count > 0);
    }

    void nothingFoundIsSaidAndChoosesNothing() {
        Bench bench;
        bench.combo.setCurrentIndex(1);
        const QSignalSpy activated(&bench.combo, &QComboBox::activated);
        QTest::keyClicks(&bench.combo, QStringLiteral("q"));
        QVERIFY(bench.found().isEmpty());
        QTest::keyClick(&bench.search(), Qt::Key_Return);
        QVERIFY(bench.isOpen());
        QTest::keyClick(&bench.search(), Qt::Key_Escape);
        QVERIFY(!bench.isOpen());
        QCOMPARE(bench.combo.currentIndex(), 1);
        QVERIFY(activated.isEmpty());
    }

    void theOpenListStandsAtTheChosenEntryAndGoesByKeysAndMouse() {
        Bench bench;
        bench.combo.setCurrentIndex(3);
        QTest::keyClick(&bench.combo, Qt::Key_Space);
        QVERIFY(bench.isOpen());
        QCOMPARE(bench.list().currentIndex().row(), 3);
        QTest::keyClick(&bench.search(), Qt::Key_Up);
        QTest::keyClick(&bench.search(), Qt::Key_Return);
        QCOMPARE(bench.combo.currentIndex(), 2);
        QTest::mouseClick(&bench.combo, Qt::LeftButton, {}, bench.combo.rect().center());
        QVERIFY(bench.isOpen());
        const QModelIndex last = bench.list().model()->index(5, 0);
        QTest::mouseClick(bench.list().viewport(), Qt::LeftButton, {},
                          bench.list().visualRect(last).center());
        QCOMPARE(bench.combo.currentIndex(), 5);
        QVERIFY(!bench.isOpen());
    }

    void theClosedBoxStepsAsAnyOther() {
        Bench bench;
        QTest::keyClick(&bench.combo, Qt::Key_Down);
        QCOMPARE(bench.combo.currentIndex(), 1);
        QTest::keyClick(&bench.combo, Qt::Key_End);
        QCOMPARE(bench.combo.currentIndex(), 5);
        QTest::keyClick(&bench.combo, Qt::Key_Home);
        QCOMPARE(bench.combo.currentIndex(), 0);
        QVERIFY(!bench.isOpen());
    }
};

} // namespace sparkout::test_search_combo

SPARKOUT_TEST(test_search_combo, TestSearchCombo)
#include "test_search_combo.moc"
