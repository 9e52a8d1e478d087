// SPDX-License-Identifier: GPL-3.0-or-later
// The size of the type is one for the whole window; tools that have no room stand in lines.
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/inputs/list_table.h"
#include "ui/inputs/stage_delegate.h"
#include "ui/inputs/stage_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/tool_row.h"
#include "ui/window/view_tabs.h"

#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QPushButton>
#include <QTableView>
#include <qcustomplot.h>

namespace sparkout::test_font_size {

/// What has type of its own, and how large that is, in points.
using Sizes = QMap<QString, double>;

Sizes sizesOf(const MainWindow& window) {
    Sizes sizes;
    int number = 0;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        sizes.insert(
            QStringLiteral("%1 %2 %3")
                .arg(QLatin1String(widget->metaObject()->className()), widget->objectName())
                .arg(quintptr(widget)),
            widget->font().pointSizeF());
        if (const auto* plot = qobject_cast<const QCustomPlot*>(widget)) {
            for (const QCPAxisRect* rect : const_cast<QCustomPlot*>(plot)->axisRects()) {
                for (const QCPAxis* axis : rect->axes()) {
                    if (!axis->visible()) {
                        continue;
                    }
                    ++number;
                    const double size = axis->tickLabelFont().pointSizeF();
                    if (size >= plot->font().pointSizeF()) { // else it is smaller for want of room
                        sizes.insert(
                            QStringLiteral("%1 axis %2").arg(plot->objectName()).arg(number), size);
                    }
                }
            }
        }
    }
    return sizes;
}

/// From the first to the last dark column of a dock's title.
int titleWidth(QDockWidget& dock) {
    const QImage image = dock.grab(QRect(0, 0, dock.width() / 2, dock.widget()->y())).toImage();
    int first = image.width(), last = 0;
    for (int x = 0; x < image.width(); ++x) {
        for (int y = 0; y < image.height(); ++y) {
            if (qGray(image.pixel(x, y)) < 100) {
                first = std::min(first, x);
                last = x;
            }
        }
    }
    return last - first + 1;
}

QPushButton* wide(int width) {
    auto* button = new QPushButton;
    button->setFixedSize(width, 20);
    return button;
}

class TestFontSize : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { applyFontSize(usualFontSize); }

    void everyTypeOfTheWindowFollowsAtOnce() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        for (View* view : bench.window->views()) { // each as it is when it was seen
            bench.window->viewTabs().showView(view);
            bench.settle();
        }
        const Sizes before = sizesOf(*bench.window);
        for (const int percent : {130, 90}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            bench.settle();
            const Sizes after = sizesOf(*bench.window);
            int seen = 0;
            for (auto it = before.begin(); it != before.end(); ++it) {
                if (after.contains(it.key())) { // menus and editors may come and go
                    const double wanted = it.value() * percent / usualFontSize;
                    QVERIFY2(std::abs(after[it.key()] - wanted) < 0.02 * wanted,
                             qPrintable(QStringLiteral("%1: %2 pt at %3 %")
                                            .arg(it.key())
                                            .arg(after[it.key()])
                                            .arg(percent)));
                    ++seen;
                }
            }
            QVERIFY(seen > 300);
            QCOMPARE(bench.settings.fontSize(), percent);
        }
        bench.action("fontSize-100")->trigger();
        bench.settle();
        const Sizes again = sizesOf(*bench.window);
        for (auto it = before.begin(); it != before.end(); ++it) {
            QVERIFY(!again.contains(it.key()) || std::abs(again[it.key()] - it.value()) < 0.01);
        }
    }

    /// As painted: a dock keeps the type of its title.
    void titlesOfDocksFollow() {
        Bench bench(QStringLiteral("en"));
        auto* dock = bench.window->findChild<QDockWidget*>(QStringLiteral("inputs"));
        QVERIFY(dock);
        const int usual = titleWidth(*dock);
        QVERIFY(usual > 20);
        for (const int percent : {130, 115, 100}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            bench.settle();
            const double wanted = usual * percent / 100.0;
            QVERIFY2(std::abs(titleWidth(*dock) - wanted) <= 0.05 * wanted + 2,
                     qPrintable(QString::number(titleWidth(*dock))));
        }
    }

    // A comma cut at its foot reads as a point.
    void rowsOfTablesFollowTheType() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        for (const int percent : {100, 130, 90, 115}) {
            bench.action(("fontSize-" + QByteArray::number(percent)).constData())->trigger();
            bench.settle();
            int rows = 0;
            for (const auto* table : bench.window->findChildren<ListTable*>()) {
                const QTableView& view = table->view();
                const bool stages = qobject_cast<const StageTable*>(table) != nullptr;
                const QFontMetrics font = view.fontMetrics();
                const int wanted = stages ? StageDelegate::rowHeight(font) : font.height() + 10;
                for (int row = 0; row < view.model()->rowCount(); ++row, ++rows) {
                    QCOMPARE(view.rowHeight(row), wanted);
                }
                if (stages) { // and the table shows its rows in full
                    QVERIFY(view.viewport()->height() >= wanted * view.model()->rowCount());
                }
            }
            QVERIFY(rows > 0);
        }
    }

    void aNewWindowComesUpInTheSizeThatWasSet() {
        const double usual = QApplication::font().pointSizeF();
        applyFontSize(115);
        const Bench bench(QStringLiteral("ru"));
        QVERIFY(bench.action("fontSize-115")->isChecked());
        QVERIFY(std::abs(bench.window->font().pointSizeF() - 1.15 * usual) < 0.01);
        QCOMPARE(fontSizeFrom(107), usualFontSize); // none of those that are offered
    }

    void toolsWithoutRoomStandInFurtherLines_data() {
        addColumns<int, QList<QPoint>>("width", "corners");
        using Corners = QList<QPoint>;
        // Two of 100, a stretch, two of 80; 10 between what stands beside each other.
        addRow("all in one, the last at the right", 500,
               Corners{{0, 0}, {110, 0}, {330, 0}, {420, 0}});
        addRow("the stretch begins a line", 300, Corners{{0, 0}, {110, 0}, {130, 30}, {220, 30}});
        addRow("each has room", 120, Corners{{0, 0}, {0, 30}, {40, 60}, {0, 90}});
    }

    void toolsWithoutRoomStandInFurtherLines() {
        QFETCH(int, width);
        QFETCH(QList<QPoint>, corners);
        QWidget bar;
        auto* row = new ToolRow(&bar);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(10);
        const QList<QPushButton*> tools{wide(100), wide(100), wide(80), wide(80)};
        row->addWidget(tools[0]);
        row->addWidget(tools[1]);
        row->addStretch();
        row->addWidget(tools[2]);
        row->addWidget(tools[3]);
        bar.show();
        bar.resize(width, row->heightForWidth(width));
        QCOMPARE(bar.height(), corners.last().y() + 20);
        QCOMPARE(row->minimumSize().width(), 100); // asks for no more of the window
        row->activate();
        for (int i = 0; i < tools.size(); ++i) {
            QCOMPARE(tools[i]->pos(), corners[i]);
        }
    }

    void aBoxInARowIsAsWideAsItsPresentText() {
        QWidget bar;
        auto* row = new ToolRow(&bar);
        auto* box = new QComboBox;
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->addItems({QStringLiteral("short"), QStringLiteral("a choice of very many words")});
        row->addWidget(box);
        bar.show();
        const int ofShort = row->minimumSize().width();
        box->setCurrentIndex(1);
        const int ofLong = row->minimumSize().width();
        const auto advance = [&](int i) {
            return box->fontMetrics().horizontalAdvance(box->itemText(i));
        };
        QVERIFY(ofShort > advance(0));
        QVERIFY(ofShort < advance(1));
        QVERIFY(ofLong > advance(1));
    }
};

} // namespace sparkout::test_font_size

SPARKOUT_TEST(test_font_size, TestFontSize)
#include "test_font_size.moc"
