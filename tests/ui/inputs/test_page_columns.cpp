// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a page in one column and in two.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/form_row.h"
#include "ui/session/document.h"

#include <QLabel>
#include <QScrollBar>

#include <algorithm>

namespace sparkout::test_page_columns {

constexpr int high = 3000; ///< nothing is scrolled

/// With a batch and a search.
QString fullExample() {
    const QStringList paths = examplePaths();
    return *std::ranges::find_if(
        paths, [](const QString& path) { return path.contains(u"shaft-30h6-factory"); });
}

QRect inPage(const FormPage& page, const QWidget& widget) {
    return {widget.mapTo(page.widget(), QPoint()), widget.size()};
}

std::vector<QRect> fieldsOf(const FormPage& page) {
    std::vector<QRect> fields;
    for (const FormRow* row : page.rows()) {
        if (row->editor().widget()->isVisible()) {
            fields.push_back(inPage(page, *row->editor().widget()));
        }
    }
    return fields;
}

/// The widgets of the page that hold no other one.
std::vector<const QWidget*> leavesOf(const FormPage& page) {
    std::vector<const QWidget*> leaves;
    for (const QWidget* widget : page.widget()->findChildren<QWidget*>()) {
        const bool holdsNone = widget->findChildren<QWidget*>().isEmpty();
        if (holdsNone && widget->isVisible() && !widget->size().isEmpty()) {
            leaves.push_back(widget);
        }
    }
    return leaves;
}

int bottomOf(const std::vector<QRect>& all) {
    return std::ranges::max(all, {}, &QRect::bottom).bottom();
}

void show(FormPage& page, int width, int height = high) {
    page.resize(width, height);
    page.show();
    QTest::qWait(10);
}

class TestPageColumns : public QObject {
    Q_OBJECT

private slots:
    void twoColumnsWhereThereIsRoom_data() {
        QTest::addColumn<int>("page");
        for (const Page page :
             {Page::part, Page::material, Page::wheel, Page::machine, Page::batch, Page::search}) {
            QTest::addRow("%d", int(page)) << int(page);
        }
    }

    void twoColumnsWhereThereIsRoom() {
        QFETCH(int, page);
        Document document;
        QVERIFY(document.open(fullExample()).opened());
        FormPage form(static_cast<Page>(page), document);
        show(form, panelWidth());
        const std::vector<QRect> below = fieldsOf(form);
        QVERIFY(below.size() > 4);
        for (std::size_t i = 1; i < below.size(); ++i) {
            QVERIFY2(below[i].top() > below[i - 1].top(), "one column");
        }
        show(form, 2 * panelWidth());
        const std::vector<QRect> beside = fieldsOf(form);
        QCOMPARE(beside.size(), below.size());
        const int middle = form.width() / 2;
        const auto right = std::ranges::find_if(
            beside, [middle](const QRect& field) { return field.left() > middle; });
        QVERIFY2(right != beside.begin() && right != beside.end(), "two columns");
        for (auto field = beside.begin(); field != beside.end(); ++field) {
            const bool isLeft = field < right;
            QVERIFY2(isLeft ? field->right() < middle : field->left() > middle, "in their order");
        }
        QVERIFY2(bottomOf(beside) < 0.75 * bottomOf(below), "lower than one column");
    }

    // As a look at the page would say: nothing over another, nothing pressed.
    void nothingOverlapsOrIsPressed_data() {
        addColumns<int, int>("page", "width");
        for (int page = int(Page::part); page <= int(Page::search); ++page) {
            for (const int columns : {1, 2, 3}) {
                QTest::addRow("%d, %d", page, columns) << page << columns * panelWidth();
            }
        }
    }

    void nothingOverlapsOrIsPressed() {
        QFETCH(int, page);
        QFETCH(int, width);
        Document document;
        QVERIFY(document.open(fullExample()).opened());
        FormPage form(static_cast<Page>(page), document);
        show(form, width);
        const std::vector<const QWidget*> leaves = leavesOf(form);
        QVERIFY(leaves.size() > 2);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const QWidget& one = *leaves[i];
            const QByteArray name = one.objectName().toUtf8() + ' ' + one.metaObject()->className();
            QVERIFY2(form.widget()->rect().contains(inPage(form, one)), name);
            QVERIFY2(one.height() >= one.minimumSizeHint().height(), name);
            if (const auto* label = qobject_cast<const QLabel*>(&one); label && label->wordWrap()) {
                QVERIFY2(label->height() >= label->heightForWidth(label->width()), name);
            }
            for (std::size_t j = i + 1; j < leaves.size(); ++j) {
                const QWidget& other = *leaves[j];
                if (one.parentWidget() == other.parentWidget()) {
                    QVERIFY2(!one.geometry().intersects(other.geometry()), name);
                }
            }
        }
    }

    void aPageThatIsTooHighIsScrolled() {
        Document document;
        QVERIFY(document.open(fullExample()).opened());
        FormPage form(Page::machine, document);
        show(form, panelWidth(), 300);
        const int one = form.verticalScrollBar()->maximum();
        QVERIFY(one > 300);
        const FormRow* last = form.rows().back();
        form.showPath(last->editor().path(), true);
        QTest::qWait(10);
        QVERIFY(!last->editor().widget()->visibleRegion().isEmpty());
        show(form, 2 * panelWidth(), 300);
        QVERIFY(form.verticalScrollBar()->maximum() < one / 2);
    }
};

} // namespace sparkout::test_page_columns

SPARKOUT_TEST(test_page_columns, TestPageColumns)
#include "test_page_columns.moc"
