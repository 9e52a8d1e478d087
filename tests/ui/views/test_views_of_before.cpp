// SPDX-License-Identifier: GPL-3.0-or-later
// Another document came and was refused: the views are empty. What can still be chosen in them, or
// is chosen by a key that was on its way, leads nowhere.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/window/view_tabs.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>

namespace sparkout::test_views_of_before {

/// Every row, entry and box of a view, as if by a user.
void chooseAll(const View& view) {
    for (QAbstractItemView* table : view.findChildren<QAbstractItemView*>()) {
        for (int row = 0; table->model() && row < table->model()->rowCount(); ++row) {
            table->setCurrentIndex(table->model()->index(row, 0));
        }
    }
    for (QComboBox* box : view.findChildren<QComboBox*>()) {
        for (int i = 0; i < box->count(); ++i) {
            box->setCurrentIndex(i);
        }
    }
    for (QCheckBox* box : view.findChildren<QCheckBox*>()) {
        if (box->isEnabled()) {
            box->click();
            box->click();
        }
    }
}

class TestViewsOfBefore : public QObject {
    Q_OBJECT

private slots:
    void nothingOfBeforeCanBeUsed_data() {
        QTest::addColumn<QString>("view");
        const Bench bench(QStringLiteral("en"));
        for (const View* view : bench.window->views()) {
            QTest::addRow("%s", qPrintable(view->objectName())) << view->objectName();
        }
    }
    void nothingOfBeforeCanBeUsed() {
        QFETCH(QString, view);
        WarningCatcher warnings;
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        QVERIFY(bench.window->showView(view));
        bench.settle();
        View* const shown = bench.window->viewTabs().currentView();
        QTRY_VERIFY_WITH_TIMEOUT(!shown->busy(), 60'000);
        chooseAll(*shown);
        shown->forget();
        fixtures::draw(*shown, fixtures::refused());
        chooseAll(*shown);
        for (const char* language : {"russian", "english"}) {
            bench.action(language)->trigger(); // every text anew
            bench.settle();
            chooseAll(*shown);
        }
        const QStringList warned = warnings.take();
        QVERIFY2(warned.isEmpty(), qPrintable(warned.join(u'\n')));
    }
};

} // namespace sparkout::test_views_of_before

SPARKOUT_TEST(test_views_of_before, TestViewsOfBefore)
#include "test_views_of_before.moc"
