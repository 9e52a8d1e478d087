// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/list_table.h"

#include "core/project/member.h"
#include "ui/form/number_field.h"
#include "ui/inputs/column_header.h"
#include "ui/inputs/hint_strip.h"
#include "ui/inputs/list_model.h"
#include "ui/inputs/list_paste.h"
#include "ui/inputs/row_sliders.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/hint_text.h"
#include "ui/text/texts.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr int shownRows = 8;
constexpr qsizetype shownFaults = 5; ///< number of reported paste faults
constexpr int shownRemarks = 8;      ///< number of reported remarks
const QKeySequence copyTableKey(Qt::CTRL | Qt::SHIFT | Qt::Key_C);

bool isCopyTable(const QKeyEvent& key) {
    return key.keyCombination() == copyTableKey[0];
}

void setUpView(QTableView& view) {
    view.setSelectionBehavior(QAbstractItemView::SelectItems);
    view.setSelectionMode(QAbstractItemView::ContiguousSelection);
    // Not SelectedClicked: it waits for a double click, during which typed keys would search.
    view.setEditTriggers(QAbstractItemView::AnyKeyPressed | QAbstractItemView::DoubleClicked
                         | QAbstractItemView::EditKeyPressed);
    view.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view.setTabKeyNavigation(true);
    view.setWordWrap(false);
    view.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
}

} // namespace

ListTable::ListTable(const std::string& path, const Field& list, Document& document,
                     QWidget* parent)
    : ListTable(path, list, document, new ListModel(path, list, document),
                new ListDelegate(document), parent) {}

ListTable::ListTable(const std::string& path, const Field& list, Document& document,
                     ListModel* model, ListDelegate* delegate, QWidget* parent)
    : QWidget(parent)
    , m_path(path)
    , m_list(list)
    , m_document(document)
    , m_model(model)
    , m_delegate(delegate)
    , m_view(new QTableView(this))
    , m_header(new ColumnHeader(m_view))
    , m_sliders(new RowSliders(*model, document, *m_view, this))
    , m_title(new QLabel(this))
    , m_reasons(new QLabel(this)) {
    model->setParent(this);
    delegate->setParent(this);
    m_view->setModel(model);
    m_view->setItemDelegate(delegate);
    m_view->setObjectName(QString::fromStdString(path));
    setUp();
    select(0, 0);
    ListTable::retranslate();
}

void ListTable::setUp() {
    m_view->installEventFilter(this);
    m_view->setHorizontalHeader(m_header);
    setUpView(*m_view);
    ListTable::fitRows();
    m_title->setTextFormat(Qt::PlainText);
    m_title->setBuddy(m_view);
    m_reasons->setObjectName(QStringLiteral("reasons"));
    m_reasons->setTextFormat(Qt::RichText);
    m_reasons->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, metrics::tight, 0, metrics::tight);
    layout->setSpacing(metrics::gap);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    buildButtons(*head);
    layout->addLayout(head);
    layout->addWidget(m_view);
    layout->addWidget(m_sliders);
    layout->addWidget(m_reasons); // below, so that a dragged slider does not move
    connect(&m_document, &Document::projectReplaced, this, [this] { m_replaced = true; });
    connect(&m_document, &Document::changed, this, &ListTable::takeProject);
    connect(&m_document, &Document::saved, this, &ListTable::forgetPaste);
    connect(m_model, &ListModel::refusalsChanged, this, [this] {
        updateReasons();
        emit refusalsChanged();
    });
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &ListTable::showCurrent);
    connect(m_model, &QAbstractItemModel::modelReset, this, &ListTable::showCurrent);
}

void ListTable::showCurrent() {
    updateButtons();
    const QModelIndex current = m_view->currentIndex();
    m_sliders->showRow(current.isValid() ? current.row() : -1);
    setHintField(*m_view, m_model->isField(current) ? m_model->field(current) : m_list);
    emit currentFieldChanged();
}

void ListTable::takeProject() {
    const int row = m_wanted.value_or(m_replaced ? 0 : std::max(0, currentRow()));
    const int column = m_view->currentIndex().column();
    forgetPaste();
    m_model->update(m_replaced || m_wanted);
    m_replaced = false;
    m_wanted.reset();
    if (currentRow() < 0 || currentRow() != row) {
        select(row, column);
    }
    showCurrent();
    fitHeight();
}

void ListTable::buildButtons(QHBoxLayout& into) {
    const auto button = [&](const char16_t* icon, auto action) {
        auto* made = new QToolButton(this);
        made->setIcon(themeIcon(icon));
        made->setAutoRaise(true);
        made->setFocusPolicy(Qt::TabFocus);
        into.addWidget(made);
        connect(made, &QToolButton::clicked, this, action);
        return made;
    };
    m_add = button(u"add", [this] { addRow(); });
    m_remove = button(u"remove", [this] { removeRow(); });
    m_up = button(u"up", [this] { moveRow(-1); });
    m_down = button(u"down", [this] { moveRow(1); });
    setTabOrder(m_down, m_view); // from top to bottom, the visual order
}

void ListTable::showTitleBold() {
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
}

int ListTable::currentRow() const {
    return m_view->currentIndex().row();
}

int ListTable::rows() const {
    return m_model->rowCount();
}

void ListTable::select(int row, int column) {
    m_view->setCurrentIndex(m_model->index(
        std::min(row, rows() - 1), std::clamp(column, 0, std::max(0, m_model->columnCount() - 1))));
}

void ListTable::apply(Project project, EditText text, int selected) {
    m_wanted = selected;
    m_document.edit(std::move(project), text);
    m_wanted.reset();
    (rows() > 0 ? static_cast<QWidget*>(m_view) : m_add)->setFocus();
}

void ListTable::change(const std::function<void(void* owner)>& set, int selected) {
    Project project = m_document.project();
    set(findMember(project, m_path).owner);
    apply(std::move(project), {"Input", m_list.label}, selected);
}

void ListTable::addRow() {
    const int at = currentRow() + 1; // a copy of the preceding row
    change([&](void* owner) { m_list.insert(owner, std::size_t(at)); }, at);
}

void ListTable::removeRow() {
    if (canRemove()) {
        const int at = currentRow();
        change([&](void* owner) { m_list.erase(owner, std::size_t(at)); },
               std::min(at, rows() - 2));
    }
}

void ListTable::moveRow(int by) {
    if (canMove(by)) {
        const int from = currentRow(), to = from + by;
        change([&](void* owner) { m_list.swap(owner, std::size_t(from), std::size_t(to)); }, to);
    }
}

bool ListTable::canRemove() const {
    return currentRow() >= 0;
}

bool ListTable::canMove(int by) const {
    const int to = currentRow() + by;
    return currentRow() >= 0 && to >= 0 && to < rows();
}

bool ListTable::mayHaveOtherRows() const {
    return m_model->mayHaveOtherRows();
}

void ListTable::setAccess(const FormAccessPtr& access) {
    m_model->setAccess(access);
    updateButtons();
    m_sliders->showRow(currentRow());
}

void ListTable::updateButtons() {
    const bool mayChange = mayHaveOtherRows();
    m_add->setEnabled(mayChange);
    m_remove->setEnabled(mayChange && canRemove());
    m_up->setEnabled(mayChange && canMove(-1));
    m_down->setEnabled(mayChange && canMove(1));
}

void ListTable::setIssues(const Issues& issues) {
    m_issues = issues;
    m_model->setIssues(issues);
    updateReasons();
}

void ListTable::forgetPaste() {
    if (m_refusedCells) {
        m_refusedCells.reset();
        m_notPasted.clear();
        updateReasons();
    }
}

void ListTable::updateReasons() {
    QStringList lines;
    const QPalette colors = m_title->palette();
    const auto line = [&colors](Mark mark, const QString& text) {
        return QStringLiteral("<span style=\"color:%1\">%2</span>")
            .arg(markColor(mark, colors).name(), text.toHtmlEscaped());
    };
    const auto add = [&](Mark mark, const std::string& path, const QString& reason) {
        lines += line(mark, tr("%1: %2").arg(inputLocation(path), reason));
    };
    for (qsizetype i = 0; i < std::min(m_notPasted.size(), shownFaults); ++i) {
        lines += line(Mark::error, tr("Not pasted: %1").arg(m_notPasted[i]));
    }
    if (m_notPasted.size() > shownFaults) {
        lines += line(Mark::error, tr("Not pasted: %n further cell(s)", nullptr,
                                      static_cast<int>(m_notPasted.size() - shownFaults)));
    }
    for (const Refusal& refusal : m_model->refusals()) {
        add(Mark::error, refusal.path, refusal.reason);
    }
    int remarks = 0;
    for (const Issue& issue : m_issues) { // the message panel has all of them
        if ((issue.path == m_path || issue.path.starts_with(m_path + "/"))
            && ++remarks <= shownRemarks) {
            add(markOf(issue), issue.path, issueText(issue));
        }
    }
    if (remarks > shownRemarks) {
        lines += tr("%n further remark(s) among the messages", nullptr, remarks - shownRemarks);
    }
    m_reasons->setText(lines.join(QStringLiteral("<br>")));
    m_reasons->setVisible(!lines.isEmpty());
}

ListTable::Texts ListTable::texts() const {
    const QString title = inputText(m_list.label);
    const auto of = [&title](const QString& text) { return tr("%1: %2").arg(title, text); };
    return {title,
            title,
            of(tr("add a row")),
            of(tr("remove the row")),
            of(tr("move the row up")),
            of(tr("move the row down"))};
}

void ListTable::retranslate() {
    const Texts shown = texts();
    m_title->setText(shown.title);
    m_title->setToolTip(hintMarkup(m_list));
    m_view->setAccessibleName(shown.name);
    const auto name = [](QToolButton& button, const QString& text, const QString& keys) {
        button.setToolTip(tr("%1 (%2)").arg(text, keys));
        button.setAccessibleName(text);
    };
    name(*m_add, shown.add, tr("Ins"));
    name(*m_remove, shown.remove, tr("Ctrl+Del"));
    name(*m_up, shown.up, tr("Ctrl+Up"));
    name(*m_down, shown.down, tr("Ctrl+Down"));
    m_model->retranslate();
    m_sliders->retranslate();
    if (m_refusedCells) { // the reasons in the current language
        ListPaste again(*m_model, m_path, m_list, m_document.project());
        again.paste(m_refusedCells->first, m_refusedCells->second);
        m_notPasted = again.faults();
    }
    updateReasons();
    updateButtons();
    fitHeight();
}

std::vector<Refusal> ListTable::refusals() const {
    return m_model->refusals();
}

bool ListTable::dropRefusal(const std::string& path) {
    const QModelIndex index = m_model->indexAt(path);
    if (!index.isValid() || m_model->refusedText(index).isNull()) {
        return false;
    }
    if (index == m_view->currentIndex()) {
        m_delegate->dropRefusal(*m_view);
    }
    m_model->accept(index);
    return true;
}

bool ListTable::holds(const std::string& path) const {
    return path == m_path || path.starts_with(m_path + "/");
}

void ListTable::showPath(const std::string& path, bool focus) {
    const QModelIndex index = m_model->indexAt(path);
    if (focus) {
        (index.isValid() ? static_cast<QWidget*>(m_view) : m_add)->setFocus(Qt::OtherFocusReason);
    }
    if (index.isValid()) {
        m_view->setCurrentIndex(index);
    }
}

void ListTable::fitRows() {
    setRowHeight(m_view->fontMetrics().height() + 10);
}

void ListTable::setRowHeight(int height) {
    m_view->verticalHeader()->setDefaultSectionSize(height);
}

void ListTable::fitHeight() {
    m_view->setVisible(rows() > 0);
    // Uses fixed quantities: the viewport changes with each scroll bar.
    const bool scrolls = rows() > shownRows;
    m_view->setVerticalScrollBarPolicy(scrolls ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    m_header->fit(m_view->width() - 2 * m_view->frameWidth()
                  - m_view->verticalHeader()->sizeHint().width()
                  - (scrolls ? m_view->verticalScrollBar()->sizeHint().width() : 0));
    m_view->setFixedHeight(m_header->height()
                           + std::min(rows(), shownRows)
                                 * m_view->verticalHeader()->defaultSectionSize()
                           + 2 * m_view->frameWidth());
}

bool ListTable::takeKey(const QKeyEvent& key) {
    const bool control = key.modifiers() & Qt::ControlModifier;
    if (takeClipboardKey(key)) {
        return true;
    }
    const bool movesRows = key.key() == Qt::Key_Insert
                           || (control
                               && (key.key() == Qt::Key_Delete || key.key() == Qt::Key_Up
                                   || key.key() == Qt::Key_Down));
    if (movesRows && !mayHaveOtherRows()) {
        return true; // the keys still belong to the table
    }
    if (key.key() == Qt::Key_Escape && !m_notPasted.isEmpty()) {
        forgetPaste();
    } else if (key.key() == Qt::Key_Insert && key.modifiers() == Qt::NoModifier) {
        addRow();
    } else if (key.key() == Qt::Key_Delete) {
        control ? removeRow() : clearCell();
    } else if (control && (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down)) {
        moveRow(key.key() == Qt::Key_Up ? -1 : 1);
    } else {
        return false;
    }
    return true;
}

bool ListTable::takeClipboardKey(const QKeyEvent& key) {
    if (isCopyTable(key)) {
        copyTable();
    } else if (key.matches(QKeySequence::Copy)) {
        copyCells();
    } else if (key.matches(QKeySequence::Paste)) {
        paste();
    } else {
        return false;
    }
    return true;
}

/// A cell needs a number: the next one is typed over the old.
void ListTable::clearCell() {
    if (!(m_model->flags(m_view->currentIndex()) & Qt::ItemIsEditable)) {
        return;
    }
    const auto field = [this]() -> NumberField* {
        for (auto* each : m_view->viewport()->findChildren<NumberField*>()) {
            if (each->isVisible()) {
                return each;
            }
        }
        return nullptr;
    };
    if (!field()) { // otherwise it is being edited
        m_view->edit(m_view->currentIndex());
    }
    if (NumberField* const open = field()) {
        open->clearText();
    }
}

void ListTable::copyCells() const {
    const QModelIndexList cells = m_view->selectionModel()->selectedIndexes();
    if (!cells.isEmpty()) {
        CopiedCells::toClipboard(m_model->cellsText(cells));
    }
}

void ListTable::paste() {
    PastedCells cells = PastedCells::of(QGuiApplication::clipboard()->mimeData());
    forgetPaste();
    if (cells.empty()) {
        return;
    }
    const QModelIndexList selected = m_view->selectionModel()->selectedIndexes();
    const QModelIndex at = selected.isEmpty() ? m_view->currentIndex()
                                              : *std::min_element(selected.begin(), selected.end());
    const int pastedRows = static_cast<int>(cells.rows.size());
    const int column = std::max(0, at.column());
    const int width = static_cast<int>(cells.rows.front().size());
    ListPaste pasted(*m_model, m_path, m_list, m_document.project());
    pasted.paste(cells, at);
    if (pasted.project()) {
        apply(*pasted.project(), {"Edit", QT_TRANSLATE_NOOP("Edit", "Paste")}, pasted.firstRow());
        selectBlock(pasted.firstRow(), column, pastedRows, width);
        return;
    }
    m_refusedCells.emplace(std::move(cells), at);
    m_notPasted = pasted.faults();
    updateReasons();
}

/// Selects the pasted block, with its first cell as the current one.
void ListTable::selectBlock(int row, int column, int rows, int columns) {
    const int lastRow = std::min(row + rows, this->rows()) - 1;
    const int lastColumn = std::min(column + columns, m_model->columnCount()) - 1;
    if (row <= lastRow && column <= lastColumn) {
        m_view->selectionModel()->setCurrentIndex(m_model->index(row, column),
                                                  QItemSelectionModel::NoUpdate);
        m_view->selectionModel()->select(
            {m_model->index(row, column), m_model->index(lastRow, lastColumn)},
            QItemSelectionModel::ClearAndSelect);
    }
}

void ListTable::copyTable() const {
    CopiedCells::toClipboard(m_model->tableText());
}

void ListTable::showMenu(const QPoint& at) {
    auto* menu = new QMenu(m_view);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (QToolButton* button : {m_add, m_remove, m_up, m_down}) {
        QAction* action = menu->addAction(button->icon(), button->accessibleName());
        action->setEnabled(button->isEnabled());
        connect(action, &QAction::triggered, button, &QToolButton::click);
    }
    menu->addSeparator();
    const auto add = [menu](const QString& text, const QKeySequence& key) {
        QAction* action = menu->addAction(text);
        action->setShortcut(key); // displayed, and while the menu is open
        return action;
    };
    connect(add(tr("Copy the &selected cells"), QKeySequence::Copy), &QAction::triggered, this,
            &ListTable::copyCells);
    connect(add(tr("&Paste"), QKeySequence::Paste), &QAction::triggered, this, &ListTable::paste);
    connect(add(tr("&Copy the table"), copyTableKey), &QAction::triggered, this,
            &ListTable::copyTable);
    menu->popup(at);
}

bool ListTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view && event->type() == QEvent::FontChange) {
        fitRows();
        fitHeight();
    }
    if (watched == m_view && event->type() == QEvent::Resize) {
        const auto* resize = static_cast<const QResizeEvent*>(event);
        if (resize->size().width() != resize->oldSize().width()) {
            fitHeight();
        }
    }
    if (watched == m_view && event->type() == QEvent::ShortcutOverride) {
        // The table handles copying and pasting while it has the focus.
        const auto& key = *static_cast<QKeyEvent*>(event);
        event->setAccepted(key.matches(QKeySequence::Copy) || key.matches(QKeySequence::Paste)
                           || isCopyTable(key));
        return event->isAccepted();
    }
    if (watched == m_view && event->type() == QEvent::KeyPress
        && takeKey(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    if (watched == m_view && event->type() == QEvent::ContextMenu) {
        showMenu(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace sparkout
