// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/mark.h"
#include "ui/inputs/form_page.h"
#include "ui/session/document.h"
#include "ui/table/pasted_cells.h"

#include <QModelIndex>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QHBoxLayout;
class QKeyEvent;
class QLabel;
class QTableView;
class QToolButton;

namespace sparkout {

class ColumnHeader;
class ListDelegate;
class ListModel;
class RowSliders;

/// A list of structs: a table to edit in place, with buttons and keys to add (Ins), remove
/// (Ctrl+Del) and move (Ctrl+Up, Ctrl+Down) a row, to clear a cell (Del), to copy the selected
/// cells (Ctrl+C) or the table with its heads (Ctrl+Shift+C) and to paste cells (Ctrl+V); below it
/// the sliders of the selected row. Without subclassing it serves lists of numbers only.
class ListTable : public QWidget {
    Q_OBJECT

public:
    /// Edits the list at `path`, described by `list` (Kind::objectList).
    ListTable(const std::string& path, const Field& list, Document& document,
              QWidget* parent = nullptr);

    [[nodiscard]] const std::string& path() const { return m_path; }
    void setIssues(const Issues& issues);
    virtual void setAccess(const FormAccessPtr& access);
    virtual void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    bool dropRefusal(const std::string& path);
    [[nodiscard]] bool holds(const std::string& path) const;
    void showPath(const std::string& path, bool focus); ///< makes the cell current
    [[nodiscard]] QTableView& view() const { return *m_view; }

    virtual void addRow();
    virtual void removeRow();
    virtual void moveRow(int by);
    virtual void clearCell();
    void copyCells() const; ///< copies the selected cells for spreadsheets
    void copyTable() const; ///< with headings
    void paste();           ///< pastes from the selected cell on: all cells or, with reasons, none

signals:
    void refusalsChanged();
    void currentFieldChanged(); ///< the hint field of the view may have changed

protected:
    struct Texts {
        QString title, name, add, remove, up, down;
    };

    /// A table with its own model and delegate; takes ownership of both.
    ListTable(const std::string& path, const Field& list, Document& document, ListModel* model,
              ListDelegate* delegate, QWidget* parent);

    [[nodiscard]] virtual Texts texts() const;
    [[nodiscard]] virtual bool canRemove() const;
    [[nodiscard]] virtual bool canMove(int by) const;

    virtual void fitRows(); ///< adapts to the font size
    void showTitleBold();   ///< for a table that is a group by itself
    [[nodiscard]] int currentRow() const;
    [[nodiscard]] int rows() const;
    [[nodiscard]] bool mayHaveOtherRows() const; ///< whether rows may be added and removed
    [[nodiscard]] Document& document() const { return m_document; }
    /// Passes to the document a project with other rows, or another order of them.
    void apply(Project project, EditText text, int selected);

    bool eventFilter(QObject* watched, QEvent* event) override;

    void setRowHeight(int height);

private:
    void setUp();
    void buildButtons(QHBoxLayout& into);
    void takeProject();
    void showCurrent(); ///< shows the parts for the selected cell
    bool takeKey(const QKeyEvent& key);
    bool takeClipboardKey(const QKeyEvent& key);
    void selectBlock(int row, int column, int rows, int columns);
    void showMenu(const QPoint& at);
    void select(int row, int column);
    /// Changes the struct with the list, as one edit, and selects a row.
    void change(const std::function<void(void* owner)>& set, int selected);
    void updateButtons();
    void updateReasons();
    void forgetPaste(); ///< drops the message about refused cells
    void fitHeight();

    std::string m_path;
    const Field& m_list;
    Document& m_document;
    ListModel* m_model;
    ListDelegate* m_delegate;
    QTableView* m_view;
    ColumnHeader* m_header;
    RowSliders* m_sliders;
    QLabel* m_title;
    QLabel* m_reasons;
    QToolButton* m_add = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_up = nullptr;
    QToolButton* m_down = nullptr;
    Issues m_issues;
    QStringList m_notPasted; ///< reasons, until the next action
    std::optional<std::pair<PastedCells, QModelIndex>> m_refusedCells; ///< with their position
    bool m_replaced = false;
    std::optional<int> m_wanted; ///< row to select after the next update
};

} // namespace sparkout
