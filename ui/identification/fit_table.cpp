// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/fit_table.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QStandardItemModel>

namespace sparkout {

FitTable::FitTable(const QString& name, QWidget* parent)
    : CopyTable([this] { return text(); }, parent), m_model(new QStandardItemModel(this)) {
    setAccessibleName(name);
    setModel(m_model);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setWordWrap(false);
    verticalHeader()->setVisible(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    CopyTable::retranslate();
    connect(this, &CopyTable::resized, this, &FitTable::fitHeight);
}

void FitTable::setCells(const QStringList& head, const std::vector<QStringList>& rows) {
    m_model->clear();
    m_model->setHorizontalHeaderLabels(head);
    for (const QStringList& cells : rows) {
        QList<QStandardItem*> items;
        for (qsizetype i = 0; i < cells.size(); ++i) {
            auto* item = new QStandardItem(cells[i]);
            item->setTextAlignment((i == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            items << item;
        }
        m_model->appendRow(items);
    }
    fitHeight();
}

void FitTable::fitHeight() {
    int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth()
                 + horizontalScrollBar()->sizeHint().height();
    for (int row = 0; row < m_model->rowCount(); ++row) {
        height += rowHeight(row);
    }
    setFixedHeight(height);
}

QString FitTable::text() const {
    QString lines;
    for (int row = -1; row < m_model->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < m_model->columnCount(); ++column) {
            cells << (row < 0 ? m_model->headerData(column, Qt::Horizontal).toString()
                              : m_model->index(row, column).data().toString());
        }
        lines += cells.join(u'\t') + u'\n';
    }
    return lines;
}

} // namespace sparkout
