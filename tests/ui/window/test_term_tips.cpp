// SPDX-License-Identifier: GPL-3.0-or-later
// Where the window shows a term of the glossary, pointing at it explains it.
#include "core/field.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/help/help_book.h"
#include "ui/inputs/inputs_panel.h"

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QLabel>
#include <QTabBar>
#include <QTableView>

#include <algorithm>

namespace sparkout::test_term_tips {

class Terms {
public:
    explicit Terms(bool russian) : m_russian(russian) {}

    [[nodiscard]] bool areIn(const QString& text) const {
        return std::ranges::any_of(m_terms, [&](const Term& term) {
            const QStringList names = m_russian ? term.stems : QStringList{term.english};
            return std::ranges::any_of(names, [&text](const QString& name) {
                return text.contains(name, Qt::CaseInsensitive);
            });
        });
    }

private:
    bool m_russian;
    std::vector<Term> m_terms = glossary();
};

void add(QStringList& into, const QWidget& of, const QString& text) {
    into += of.objectName() + QStringLiteral(": ") + text;
}

/// Cells in front and heads that have a term and no tool tip.
QStringList bareIn(const QTableView& table, const Terms& terms, int& seen) {
    QStringList bare;
    const QAbstractItemModel& model = *table.model();
    const auto look = [&](const QVariant& text, const QVariant& tip) {
        if (terms.areIn(text.toString())) {
            ++seen;
            if (tip.toString().isEmpty()) {
                add(bare, table, text.toString());
            }
        }
    };
    for (int column = 0; column < model.columnCount(); ++column) {
        if (table.horizontalHeader()->isVisible()) {
            look(model.headerData(column, Qt::Horizontal),
                 model.headerData(column, Qt::Horizontal, Qt::ToolTipRole));
        }
    }
    for (int row = 0; row < model.rowCount(); ++row) {
        if (table.columnSpan(row, 0) == 1) { // else the head of a group
            const QModelIndex cell = model.index(row, 0);
            look(cell.data(), cell.data(Qt::ToolTipRole));
        }
    }
    return bare;
}

class TestTermTips : public QObject {
    Q_OBJECT

private slots:
    void everyTermIsExplained_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("ru") << QStringLiteral("ru");
        QTest::newRow("en") << QStringLiteral("en");
    }
    void everyTermIsExplained() {
        QFETCH(QString, language);
        const Terms terms(language == QStringLiteral("ru"));
        OpenBench bench(language, examplePaths().front());
        MainWindow& window = *bench.window;
        int seen = 0;
        QStringList bare;
        for (int page = 0; page < int(Page::none); ++page) {
            window.inputs().showPage(page);
            bench.settle();
            for (const auto* label : window.inputs().findChildren<QLabel*>()) {
                const QWidget* const buddy = label->buddy();
                if (label->isVisible() && buddy && terms.areIn(label->text())) {
                    ++seen;
                    if (label->toolTip().isEmpty() && buddy->toolTip().isEmpty()) {
                        add(bare, *buddy, label->text());
                    }
                }
            }
        }
        for (const auto* table : window.findChildren<QTableView*>()) {
            if (table->isVisible() && table->model()) {
                bare += bareIn(*table, terms, seen);
            }
        }
        for (const auto* tabs : window.findChildren<QTabBar*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                if (terms.areIn(tabs->tabText(i))) {
                    ++seen;
                    if (tabs->tabToolTip(i).isEmpty()) {
                        add(bare, *tabs, tabs->tabText(i));
                    }
                }
            }
        }
        QVERIFY2(seen > 40, qPrintable(QString::number(seen)));
        QVERIFY2(bare.isEmpty(), qPrintable(bare.join(u'\n')));
    }
};

} // namespace sparkout::test_term_tips

SPARKOUT_TEST(test_term_tips, TestTermTips)
#include "test_term_tips.moc"
