// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/copy_table.h"

#include "ui/form/mark.h"
#include "ui/kit/theme_icon.h"
#include "ui/session/settings.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/texts.h"

#include <QCollator>
#include <QContextMenuEvent>
#include <QFont>
#include <QGuiApplication>
#include <QHeaderView>
#include <QIcon>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPalette>
#include <QTimer>

#include <algorithm>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

template <class List>
const auto& itemOf(const List& list, int index) {
    return list.at(static_cast<std::size_t>(index));
}

/// Marked up so that a tool tip wraps; the index of V_k is lowered. Names by the user or a file
/// stay literal.
QString paragraphs(const QString& named, bool hasSymbols, const QStringList& tips) {
    const auto paragraph = [](const QString& markup) {
        return markup.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(markup);
    };
    QString tip = paragraph(hasSymbols ? withIndices(named) : named.toHtmlEscaped());
    for (const QString& text : tips.join(u'\n').split(u'\n', Qt::SkipEmptyParts)) {
        tip += paragraph(withIndices(text));
    }
    return tip;
}

/// Sorts numbers before words; missing values come last in both directions.
struct SortKey {
    enum Kind { number, word, missing };
    Kind kind = missing;
    double value = 0;
    QString text = {};

    explicit SortKey(const ValueCell& cell) {
        if (const auto* const is = std::get_if<double>(&cell.value)) {
            kind = number;
            value = *is;
            return;
        }
        const auto* const said = std::get_if<QString>(&cell.value);
        text = said ? *said : cell.text;
        kind = text.isEmpty() ? missing : word;
    }
};

} // namespace

void ValueModel::setTable(ValueTable table) {
    beginResetModel();
    m_table = std::move(table);
    arrange();
    endResetModel();
}

void ValueModel::update(ValueTable table) {
    if (table.rows.size() != m_table.rows.size()
        || table.columns.size() != m_table.columns.size()) {
        setTable(std::move(table));
        return;
    }
    m_table = std::move(table);
    sort(m_sorted, m_direction);
    retranslate();
}

void ValueModel::setGreyed(bool grey) {
    if (std::exchange(m_grey, grey) != grey) {
        cellsChanged();
    }
}

QString ValueModel::asTsv() const {
    return tabSeparated(shown(), QLocale());
}

int ValueModel::rowAt(int line) const {
    return line < 0 || line >= rowsShown() ? -1 : static_cast<int>(itemOf(m_order, line));
}

int ValueModel::lineOf(int row) const {
    const auto found = std::ranges::find(m_order, static_cast<std::size_t>(row));
    return found == m_order.end() ? -1 : static_cast<int>(found - m_order.begin());
}

void ValueModel::arrange() {
    m_order.resize(m_table.rows.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    if (m_sorted < 0 || m_sorted >= columnsShown() || !m_table.isList
        || std::ranges::any_of(m_table.rows, &ValueHead::isGroup)) {
        return;
    }
    std::vector<SortKey> keys;
    for (const std::vector<ValueCell>& row : m_table.cells) {
        keys.emplace_back(itemOf(row, m_sorted));
    }
    QCollator words;
    words.setNumericMode(true);
    const bool falls = m_direction == Qt::DescendingOrder;
    std::ranges::stable_sort(m_order, [&](std::size_t one, std::size_t other) {
        const SortKey &a = keys[one], &b = keys[other];
        if (a.kind != b.kind) {
            return a.kind < b.kind;
        }
        const SortKey &first = falls ? b : a, &second = falls ? a : b;
        return a.kind == SortKey::number ? first.value < second.value
                                         : words.compare(first.text, second.text) < 0;
    });
}

void ValueModel::sort(int column, Qt::SortOrder order) {
    emit layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
    const std::vector<std::size_t> before = m_order;
    m_sorted = column;
    m_direction = order;
    arrange();
    const QModelIndexList from = persistentIndexList();
    QModelIndexList to;
    for (const QModelIndex& each : from) {
        to << index(lineOf(static_cast<int>(itemOf(before, each.row()))), each.column());
    }
    changePersistentIndexList(from, to);
    emit layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

const ValueHead& ValueModel::headOf(int line) const {
    return itemOf(m_table.rows, rowAt(line));
}

Qt::ItemFlags ValueModel::flags(const QModelIndex& index) const {
    return index.isValid() && headOf(index.row()).isGroup ? Qt::ItemFlags(Qt::ItemIsEnabled)
                                                          : TableModel::flags(index);
}

QString ValueModel::spoken(int line, int column) const {
    const ValueHead &row = headOf(line), &head = itemOf(m_table.columns, column);
    const ValueCell& cell = itemOf(itemOf(m_table.cells, rowAt(line)), column);
    if (row.isGroup) {
        return cell.text;
    }
    if (m_table.isList && column == 0 && head.isText) { // it names the row
        return cell.said.isEmpty() ? row.fullName()
                                   : QStringLiteral("%1: %2").arg(row.fullName(), cell.said);
    }
    const QString said =
        QStringLiteral("%1, %2: %3")
            .arg(head.fullName(), row.fullName(), cell.said.isEmpty() ? cell.text : cell.said);
    return cell.remark.isEmpty() ? said : said + QStringLiteral("; ") + cell.remark;
}

QVariant ValueModel::inkOf(const ValueCell& cell) const {
    if (!cell.fault.isEmpty()) {
        return markColor(Mark::error, QGuiApplication::palette());
    }
    return m_grey ? QVariant(QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text))
                  : QVariant();
}

QVariant ValueModel::cell(int line, int column, int role) const {
    const ValueHead& row = headOf(line);
    const ValueCell& cell = itemOf(itemOf(m_table.cells, rowAt(line)), column);
    switch (role) {
    case Qt::DisplayRole: return cell.text;
    case Qt::DecorationRole:
        return !cell.fault.isEmpty()    ? QVariant(markIcon(Mark::error))
               : !cell.remark.isEmpty() ? QVariant(themeIcon(u"warning"))
               : cell.icon.isNull()     ? QVariant()
                                        : QVariant(cell.icon);
    case Qt::TextAlignmentRole: {
        const bool right = !itemOf(m_table.columns, column).isText;
        const Qt::Alignment side = right ? Qt::AlignRight : Qt::AlignLeft;
        return m_table.atTop ? static_cast<int>(side | Qt::AlignTop) : aligned(right);
    }
    case Qt::FontRole: {
        QFont font;
        font.setBold(true);
        const bool isBold = row.isStrong && !itemOf(m_table.columns, column).isPlain;
        return isBold || row.isGroup ? QVariant(font) : QVariant();
    }
    case Qt::ForegroundRole: return inkOf(cell);
    case Qt::AccessibleTextRole: return spoken(line, column);
    case Qt::AccessibleDescriptionRole: return cell.fault;
    case Qt::ToolTipRole:
        return row.isGroup ? QVariant()
                           : paragraphs(spoken(line, column), !m_table.isList,
                                        {cell.fault, cell.tip, row.tip});
    default: return {};
    }
}

QVariant ValueModel::side(int line, int role) const {
    return line < rowsShown() ? headData(headOf(line), role, false) : QVariant();
}

QVariant ValueModel::head(int column, int role) const {
    if (column >= columnsShown()) {
        return {};
    }
    const ValueHead& of = itemOf(m_table.columns, column);
    return role == Qt::TextAlignmentRole
               ? aligned(!of.isText).toInt() | static_cast<int>(Qt::TextWordWrap)
               : headData(of, role, !of.isText);
}

QVariant ValueModel::headData(const ValueHead& head, int role, bool right) const {
    switch (role) {
    case Qt::DisplayRole: return head.text;
    case Qt::AccessibleTextRole: return head.fullName();
    case Qt::ToolTipRole: return paragraphs(head.fullName(), !m_table.isList, {head.tip});
    case Qt::TextAlignmentRole: return aligned(right);
    default: return {};
    }
}

namespace {

/// In a submenu of its own each format names itself as CSV.
QString savingText(TableFormat format) {
    switch (format) {
    case TableFormat::csvRussian:
        return CopyTable::tr("CSV for &Russian Excel: semicolons, decimal commas…");
    case TableFormat::csvEnglish: return CopyTable::tr("&English CSV: commas, decimal points…");
    case TableFormat::xlsx: break;
    }
    return tableFormatText(format);
}

const QKeySequence copyAllKey(Qt::CTRL | Qt::SHIFT | Qt::Key_C);

} // namespace

CopyTable::CopyTable(std::function<QString()> text, QWidget* parent)
    : QTableView(parent), m_text(std::move(text)) {
    setShowGrid(false);
    setAlternatingRowColors(true);
    setCornerButtonEnabled(false);
    setTabKeyNavigation(false);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setMinimumSectionSize(20);
    horizontalHeader()->setSectionsClickable(false);
    connect(this, &QTableView::clicked, this,
            [this](const QModelIndex& index) { emit rowChosen(rowOf(index)); });
    connect(this, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { emit rowEntered(rowOf(index)); });
}

CopyTable::CopyTable(ValueModel& model, QWidget* parent, std::function<QString()> text)
    : CopyTable(
        text ? std::move(text) : [&model] { return model.asTsv(); }, parent) {
    m_values = &model;
    setModel(&model);
}

int CopyTable::rowOf(const QModelIndex& index) const {
    return m_values ? m_values->rowAt(index.row()) : index.row();
}

void CopyTable::copy() const {
    CopiedCells::toClipboard(m_text());
}

void CopyTable::copySelected() const {
    if (m_values) {
        copySelectedRows();
        return;
    }
    const QString text = m_text();
    const QStringList lines = text.split(u'\n', Qt::SkipEmptyParts);
    const int rows = model() ? model()->rowCount() : 0;
    QString selected;
    qsizetype line = 0; // the headings; group headings have none
    for (int row = 0; row < rows; ++row) {
        if (!(model()->index(row, 0).flags() & Qt::ItemIsSelectable)) {
            continue;
        }
        ++line;
        if (line < lines.size() && selectionModel()->isRowSelected(row)) {
            selected += lines[line] + u'\n';
        }
    }
    CopiedCells::toClipboard(selected.isEmpty() ? text : selected);
}

void CopyTable::copySelectedRows() const {
    std::vector<std::size_t> rows;
    for (int line = 0; line < m_values->rowCount(); ++line) {
        if (selectionModel()->isRowSelected(line)) {
            rows.push_back(static_cast<std::size_t>(m_values->rowAt(line)));
        }
    }
    const QString selected = tabSeparated(m_values->table().inOrder(rows), QLocale());
    CopiedCells::toClipboard(rows.empty() ? m_text() : selected.mid(selected.indexOf(u'\n') + 1));
}

void CopyTable::setSaving(std::function<CsvTable()> table, std::function<QString()> project,
                          Settings* settings) {
    m_table = std::move(table);
    m_project = std::move(project);
    m_settings = settings;
}

void CopyTable::retranslate() {
    setToolTip(tr("Ctrl+C copies the selected rows, Ctrl+Shift+C the table; its menu saves it"));
}

void CopyTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy) || event->keyCombination() == copyAllKey[0]) {
        event->matches(QKeySequence::Copy) ? copySelected() : copy();
        event->accept();
        return;
    }
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && currentIndex().isValid()) {
        emit rowChosen(rowOf(currentIndex()));
        emit rowEntered(rowOf(currentIndex()));
        event->accept();
        return;
    }
    QTableView::keyPressEvent(event);
}

void CopyTable::addSaving(QMenu& menu) {
    if (!m_table) {
        return;
    }
    QMenu* formats = menu.addMenu(tr("Save the table as"));
    formats->setToolTipsVisible(true);
    formats->setEnabled(!m_table().empty());
    for (const TableFormat format : allTableFormats) {
        QAction* action = formats->addAction(savingText(format));
        action->setToolTip(tableFormatHint(format));
        connect(action, &QAction::triggered, this, [this, format] { save(format); });
    }
}

void CopyTable::setArrangeable(Settings* settings) {
    Q_ASSERT(m_values);
    m_arrangeable = true;
    m_settings = settings;
    m_hidden = settings ? settings->hiddenColumns(objectName()) : QStringList();
    QHeaderView& head = *horizontalHeader();
    head.setSectionsClickable(true);
    head.setSortIndicatorClearable(true);
    head.setSortIndicator(-1, Qt::AscendingOrder); // otherwise it would be sorted at once
    setSortingEnabled(true);
    head.setSortIndicatorShown(false); // it takes space in every column
    connect(&head, &QHeaderView::sortIndicatorChanged, &head,
            [&head](int column) { head.setSortIndicatorShown(column >= 0); });
    head.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&head, &QHeaderView::customContextMenuRequested, this,
            [this, &head](const QPoint& at) { openMenu(head.viewport()->mapToGlobal(at)); });
    connect(m_values, &QAbstractItemModel::modelReset, this, &CopyTable::hideColumns);
    hideColumns();
}

void CopyTable::hideColumns() {
    const std::vector<ValueHead>& columns = m_values->table().columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        setColumnHidden(static_cast<int>(i),
                        i > 0 && m_hidden.contains(QLatin1String(columns[i].key)));
    }
}

void CopyTable::chooseColumn(const QString& key, bool shown) {
    m_hidden.removeAll(key);
    if (!shown) {
        m_hidden << key;
    }
    hideColumns();
    if (m_settings) {
        m_settings->setHiddenColumns(objectName(), m_hidden);
    }
}

/// The first column names the rows and stays.
void CopyTable::addColumns(QMenu& menu) {
    if (!m_arrangeable || m_values->table().columns.empty()) {
        return;
    }
    QMenu* const columns = menu.addMenu(tr("Columns"));
    const std::vector<ValueHead>& heads = m_values->table().columns;
    for (std::size_t i = 1; i < heads.size(); ++i) {
        const QString key = QString::fromLatin1(heads[i].key);
        if (key.isEmpty()) {
            continue; // similar ones are offered once: the points of a step
        }
        QAction* const action = columns->addAction(heads[i].fullName());
        action->setCheckable(true);
        action->setChecked(!m_hidden.contains(key));
        connect(action, &QAction::toggled, this,
                [this, key](bool shown) { chooseColumn(key, shown); });
    }
}

void CopyTable::setUniformRows() {
    m_uniform = true;
    setWordWrap(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    connect(model(), &QAbstractItemModel::modelReset, this, &CopyTable::fitUniformRows);
    fitUniformRows();
}

void CopyTable::fitUniformRows() {
    if (m_uniform && model()->rowCount() > 0) {
        verticalHeader()->setDefaultSectionSize(
            std::max(sizeHintForRow(0), verticalHeader()->sectionSizeHint(0)));
    }
}

void CopyTable::save(TableFormat format) {
    QStringList heading{accessibleName(), m_project()};
    heading.removeAll(QString());
    (void)saveTable(window(), m_settings, {heading, m_table()}, format);
}

void CopyTable::contextMenuEvent(QContextMenuEvent* event) {
    openMenu(event->globalPos());
    event->accept();
}

void CopyTable::openMenu(const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* rows = menu->addAction(tr("Copy the selected rows"));
    rows->setShortcut(QKeySequence::Copy); // displayed, and while the menu is open
    rows->setEnabled(selectionModel() && !selectionModel()->selectedRows().isEmpty());
    connect(rows, &QAction::triggered, this, [this] { copySelected(); });
    QAction* action = menu->addAction(tr("Copy the table"));
    action->setShortcut(copyAllKey);
    connect(action, &QAction::triggered, this, [this] { copy(); });
    addSaving(*menu);
    addColumns(*menu);
    menu->popup(at);
}

/// Measures sections that fit their contents again, with the current font.
void CopyTable::measure(QHeaderView& header) {
    for (int i = 0; i < header.count(); ++i) {
        if (header.sectionResizeMode(i) == QHeaderView::ResizeToContents) {
            header.setSectionResizeMode(i, QHeaderView::ResizeToContents); // measures all, soon
            return;
        }
    }
}

/// Aligns a picture with the first line of its text.
void CopyTable::initViewItemOption(QStyleOptionViewItem* option) const {
    QTableView::initViewItemOption(option);
    option->decorationAlignment = Qt::AlignLeft | (wordWrap() ? Qt::AlignTop : Qt::AlignVCenter);
}

/// In order of dependence: texts wrap after columns have their widths.
void CopyTable::changeEvent(QEvent* event) {
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fitUniformRows();
        QTimer::singleShot(0, this, [this] {
            measure(*horizontalHeader());
            QTimer::singleShot(0, this, [this] {
                measure(*verticalHeader());
                QTimer::singleShot(0, this, &CopyTable::resized);
            });
        });
    }
}

void CopyTable::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    if (wordWrap() && event->oldSize().width() != event->size().width()) {
        QTimer::singleShot(0, this, [this] { measure(*verticalHeader()); });
    }
    emit resized();
}

} // namespace sparkout
