// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/measured/data_sheet.h"

#include "ui/dialogs/copy_table.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/session/document.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// Editors for the cells of a DataModel: a combo box for choices, otherwise a line.
class DataDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
};

QWidget* DataDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    const auto choices = static_cast<const DataModel*>(index.model())->choices(index);
    const QString name = index.data(Qt::AccessibleTextRole).toString();
    if (choices.empty()) {
        auto* line = new QLineEdit(parent);
        line->setFrame(false);
        line->setAccessibleName(name);
        return line;
    }
    auto* box = new QComboBox(parent);
    for (const auto& [text, value] : choices) {
        box->addItem(text, value);
    }
    box->setAccessibleName(name);
    auto* self = const_cast<DataDelegate*>(this);
    connect(box, &QComboBox::activated, self, [self, box] {
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

void DataDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    if (auto* box = qobject_cast<QComboBox*>(editor)) {
        box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
    } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
        line->setText(index.data(Qt::EditRole).toString());
    }
}

void DataDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                const QModelIndex& index) const {
    if (const auto* box = qobject_cast<QComboBox*>(editor)) {
        model->setData(index, box->currentData(), Qt::EditRole);
    } else if (const auto* line = qobject_cast<QLineEdit*>(editor)) {
        model->setData(index, line->text(), Qt::EditRole);
    }
}

constexpr int rowsMeasured = 50; ///< number used for column widths: a list may have thousands

} // namespace

DataSheet::DataSheet(DataModel::List list, Document& document, Settings* settings, QWidget* parent)
    : QWidget(parent)
    , m_list(list)
    , m_model(new DataModel(list, document, this))
    , m_table(new CopyTable([this] { return tabSeparated(m_model->table(), QLocale()); }, this))
    , m_note(new QLabel(this))
    , m_add(new QPushButton(this))
    , m_remove(new QPushButton(this)) {
    static constexpr std::array tables{"measuredParts", "measuredSummaries", "measuredTraces"};
    const QString name = QLatin1String(tables.at(static_cast<std::size_t>(list)));
    m_table->setObjectName(name);
    m_add->setObjectName(name + QStringLiteral("Add"));
    m_remove->setObjectName(name + QStringLiteral("Remove"));
    m_add->setIcon(themeIcon(u"add"));
    m_remove->setIcon(themeIcon(u"remove"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new DataDelegate(this));
    m_table->setSaving(
        [this] { return m_model->table(); },
        [&document] { return QString::fromStdString(document.project().title).simplified(); },
        settings);
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setShowGrid(true);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setResizeContentsPrecision(rowsMeasured);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_note, 1);
    row->addWidget(m_add);
    row->addWidget(m_remove);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    m_add->setVisible(list != DataModel::List::traces);
    connect(m_add, &QPushButton::clicked, this, &DataSheet::addRow);
    connect(m_remove, &QPushButton::clicked, this, &DataSheet::removeRows);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &DataSheet::showButtons);
    connect(m_model, &QAbstractItemModel::modelReset, this, &DataSheet::showButtons);
    retranslate();
}

void DataSheet::fitRows() {
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height()
                                                     + 2 * metrics::tight);
}

void DataSheet::addRow() {
    m_model->addRow();
    const QModelIndex added = m_model->index(m_model->rowCount() - 1, 0);
    m_table->setCurrentIndex(added);
    m_table->scrollTo(added);
    m_table->setFocus();
}

void DataSheet::removeRows() {
    std::vector<int> rows;
    for (const QModelIndex& cell : m_table->selectionModel()->selectedIndexes()) {
        if (std::ranges::find(rows, cell.row()) == rows.end()) {
            rows.push_back(cell.row());
        }
    }
    m_model->takeAway(std::move(rows));
}

void DataSheet::keyPressEvent(QKeyEvent* event) {
    if (event->keyCombination() == QKeyCombination(Qt::ControlModifier, Qt::Key_Delete)) {
        removeRows();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void DataSheet::showButtons() {
    m_remove->setEnabled(m_table->selectionModel()->hasSelection());
}

void DataSheet::retranslate() {
    const auto tell = [](QPushButton& button, const QString& text, const QString& tip) {
        button.setText(text);
        button.setAccessibleName(text);
        button.setToolTip(tip);
    };
    switch (m_list) {
    case DataModel::List::parts:
        m_table->setAccessibleName(tr("Measured parts"));
        m_note->setText(tr("A row for each zone or section of a part. Double click or F2 edits a "
                           "cell; separate several diameters by semicolons."));
        break;
    case DataModel::List::summaries:
        m_table->setAccessibleName(tr("Measured statistics"));
        m_note->setText(tr("Statistics of parts that are not listed one by one, as in a printed "
                           "table: the mean with the value after ±, and the number of parts."));
        break;
    case DataModel::List::traces:
        m_table->setAccessibleName(tr("Measured traces"));
        m_note->setText(tr("Quantities over the time of one cycle, as they were imported. Place, "
                           "power to current, idle value and note can be edited."));
        break;
    }
    tell(*m_add, tr("Add a row"), tr("Add a row at the end"));
    tell(*m_remove, tr("Remove"), tr("Remove the rows of the selected cells (Ctrl+Del)"));
    fitRows();
    m_model->retranslate();
    m_table->retranslate();
    showButtons();
}

} // namespace sparkout
