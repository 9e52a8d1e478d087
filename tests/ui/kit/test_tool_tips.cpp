// SPDX-License-Identifier: GPL-3.0-or-later
// Tool tips have lines that can be read, and show what a file says letter by letter.
#include "core/project/material.h"
#include "tests/registry.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/view.h"
#include "ui/inputs/hint_strip.h"
#include "ui/kit/help_topic.h"
#include "ui/text/hint_text.h"
#include "ui/window/view_tabs.h"

#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>
#include <QToolTip>
#include <QVBoxLayout>

namespace sparkout::test_tool_tips {

/// What Qt sends when the mouse rests.
QString tipAt(QWidget& widget, const QPoint& at) {
    QToolTip::hideText();
    QHelpEvent rest(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QCoreApplication::sendEvent(&widget, &rest);
    return QToolTip::isVisible() ? QToolTip::text() : QString();
}

QString tipOf(QWidget& widget) {
    return tipAt(widget, widget.rect().center());
}

bool readable(const QString& tip) {
    if (Qt::mightBeRichText(tip)) {
        return true; // its lines are Qt's
    }
    for (const QString& line : tip.split(u'\n')) {
        if (line.size() > ToolTips::lineLength && line.contains(u' ')) {
            return false;
        }
    }
    return true;
}

/// What is seen of a tip.
QString seen(const QString& tip) {
    QTextDocument document;
    Qt::mightBeRichText(tip) ? document.setHtml(tip) : document.setPlainText(tip);
    return document.toPlainText();
}

const QString longText = QStringLiteral("Shares of the parts that one of the requirements of the "
                                        "drawing, of the wheel or of the machine rejects, in "
                                        "descending order");

class TestToolTips : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { ToolTips::install(); }
    void cleanup() { QToolTip::hideText(); }

    void everyTipOfTheWindowHasReadableLines_data() { addLanguages(); }

    void everyTipOfTheWindowHasReadableLines() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        int given = 0, broken = 0;
        for (View* view : bench.window->views()) {
            bench.window->viewTabs().showView(view);
            bench.settle();
            for (QWidget* widget : bench.window->findChildren<QWidget*>()) {
                if (!widget->isVisible() || widget->toolTip().isEmpty()) {
                    continue;
                }
                const QString tip = tipOf(*widget);
                QVERIFY2(!tip.isEmpty() && readable(tip), qPrintable(tip));
                ++given;
                broken += tip != widget->toolTip() ? 1 : 0;
            }
        }
        QVERIFY(given > 100);
        QVERIFY(broken > 5);
    }

    void cellsHeadingsTabsAndMenusBreakTheirs() {
        QTableView table;
        QStandardItemModel model(1, 1);
        model.setData(model.index(0, 0), longText, Qt::ToolTipRole);
        model.setHeaderData(0, Qt::Horizontal, longText, Qt::ToolTipRole);
        table.setModel(&model);
        table.show();
        QTabBar tabs;
        tabs.addTab(QStringLiteral("tab"));
        tabs.setTabToolTip(0, longText);
        tabs.show();
        QMenu menu;
        menu.setToolTipsVisible(true);
        menu.addAction(QStringLiteral("entry"))->setToolTip(longText);
        menu.popup({100, 100});
        const QList<std::pair<QWidget*, QPoint>> places{
            {table.viewport(), table.visualRect(model.index(0, 0)).center()},
            {table.horizontalHeader()->viewport(), {5, 5}},
            {&tabs, tabs.tabRect(0).center()},
            {&menu, menu.actionGeometry(menu.actions().constFirst()).center()}};
        for (const auto& [widget, at] : places) {
            const QString tip = tipAt(*widget, at);
            QVERIFY2(readable(tip), widget->metaObject()->className());
            QCOMPARE(QString(tip).replace(u'\n', u' '), longText);
            for (const QWidget* top : QApplication::topLevelWidgets()) {
                if (top->inherits("QTipLabel")) { // 60 characters, not a whole screen
                    QVERIFY(top->width() < 70 * top->fontMetrics().averageCharWidth());
                }
            }
        }
        QToolTip::hideText();
        QTRY_VERIFY(!QToolTip::isVisible());
        const QPoint beside(table.viewport()->width() - 2, 5);
        QVERIFY(tipAt(*table.viewport(), beside).isEmpty());
    }

    void textOfAFileIsNoMarkup_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"<b>bold</b>", "<p><img src=\"/etc/passwd\"></p>",
              "<p><a href=\"http://x\">y</a></p>", "<p style=\"font-size:99pt\">big</p>",
              "<html><body>z</body></html>", "a < b & c > d", "/home/<i>user</i>/part.sparkout"}) {
            QTest::newRow(text) << QString::fromUtf8(text);
        }
    }

    void textOfAFileIsNoMarkup() {
        QFETCH(QString, text);
        QWidget widget;
        widget.setToolTip(text);
        widget.show();
        QCOMPARE(seen(tipOf(widget)), text);
    }

    void textOfAFileIsNoMarkupInTheHints_data() { textOfAFileIsNoMarkup_data(); }

    void textOfAFileIsNoMarkupInTheHints() {
        QFETCH(QString, text);
        QWidget panel;
        auto* layout = new QVBoxLayout(&panel);
        auto* field = new QLineEdit;
        auto* hints = new HintStrip;
        layout->addWidget(new QPushButton); // has the focus first
        layout->addWidget(field);
        layout->addWidget(hints);
        field->setToolTip(text);
        panel.show();
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        QTest::mouseClick(field, Qt::LeftButton);
        QTextDocument document; // as the label has it
        document.setHtml(hints->findChild<QLabel*>()->text());
        QCOMPARE(document.toPlainText(), text);
    }

    void hintsKeepTheirMarkup() {
        const Field& friction = *tableOf<Material>().find("friction");
        QWidget widget;
        widget.setToolTip(hintMarkup(friction));
        widget.show();
        QCOMPARE(tipOf(widget), hintMarkup(friction));
        QVERIFY(!seen(tipOf(widget)).contains(u'<'));
    }
};

} // namespace sparkout::test_tool_tips

SPARKOUT_TEST(test_tool_tips, TestToolTips)
#include "test_tool_tips.moc"
