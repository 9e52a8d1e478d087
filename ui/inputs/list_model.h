// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "ui/form/mark.h"
#include "ui/inputs/form_row.h"

#include <QAbstractTableModel>
#include <QMap>
#include <QModelIndexList>
#include <QStyledItemDelegate>

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

class Document;

/// Edits the numbers of a ListModel in place; every valid value goes to the document while typing.
class ListDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    explicit ListDelegate(Document& document, QObject* parent = nullptr);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
    /// Discards a refused text in the open editor of a view.
    static void dropRefusal(const QAbstractItemView& view);
    void destroyEditor(QWidget* editor, const QModelIndex& index) const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    [[nodiscard]] Document& document() const { return m_document; }
    static void setCell(QWidget& editor, const QModelIndex& cell); ///< required by all below
    /// Whether the view still has the editor: it drops an editor before taking its focus.
    [[nodiscard]] static bool isOpen(const QWidget& editor);
    void commit(QWidget* editor); ///< if open
    void close(QWidget* editor);  ///< commits it, if open

private:
    Document& m_document;
};

/// A list of structs in the document as a table: a row for each item, a column for each member of
/// the item that the project reads. A refused text is kept, with its reason, beside the unchanged
/// value. Without subclassing it serves lists of numbers only.
class ListModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// Shows the list at `path`, described by `list` (Kind::objectList).
    ListModel(std::string path, const Field& list, Document& document);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

    [[nodiscard]] const char* itemName() const; ///< name of the struct of a row, for structText()
    /// Whether a column shows a member; further columns show results and are not editable.
    [[nodiscard]] bool isField(const QModelIndex& index) const;
    [[nodiscard]] const Field& field(const QModelIndex& index) const;
    [[nodiscard]] std::optional<double> number(const QModelIndex& index) const;
    void setNumber(const QModelIndex& index, std::optional<double> value);
    /// Whether a number would violate no rule that is currently met.
    [[nodiscard]] bool fits(const QModelIndex& index, std::optional<double> value) const;
    [[nodiscard]] const void* item(const QModelIndex& index) const; ///< the struct of a row

    void refuse(const QModelIndex& index, const QString& text, const QString& reason);
    void accept(const QModelIndex& index);
    [[nodiscard]] QString refusedText(const QModelIndex& index) const;
    [[nodiscard]] std::vector<Refusal> refusals() const;
    [[nodiscard]] Remark remark(const QModelIndex& index) const;
    [[nodiscard]] std::string path(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexAt(const std::string& path) const;

    void setIssues(const Issues& issues);
    void setAccess(const FormAccessPtr& access);
    /// The access to a cell, and to the number of rows.
    [[nodiscard]] Access access(const QModelIndex& index) const;
    [[nodiscard]] bool mayHaveOtherRows() const { return m_access->at(m_path) == Access::free; }
    [[nodiscard]] QString tableText() const; ///< with headings, tab-separated, for spreadsheets
    [[nodiscard]] QString cellsText(const QModelIndexList& cells) const; ///< a block of cells

    // For pasting.
    [[nodiscard]] const std::vector<const Field*>& columns() const { return m_columns; }
    /// Number of rows that stay at the end when rows with these columns are added.
    [[nodiscard]] virtual std::size_t lastRowsKept(const std::vector<const Field*>& given) const;
    /// Resizes the list of a project; the last `last` rows stay at the end. A new row is a copy of
    /// the one before it.
    virtual void resizeRows(Project& project, std::size_t rows, std::size_t last) const;
    /// Puts the text of a cell into a project; returns the reason of a refusal.
    [[nodiscard]] virtual QString takeText(Project& project, int row, const Field& column,
                                           const QString& text) const;

    void update(bool replaced); ///< reads the document's items; replaced: drops refused texts
    void retranslate();

signals:
    void refusalsChanged();

protected:
    [[nodiscard]] virtual bool relevant(const QModelIndex& index) const;
    /// Whether a column that the project may read is shown.
    [[nodiscard]] virtual bool shows(const Field&) const { return true; }
    /// The refused text or the value; a dash if it is not used or hidden.
    [[nodiscard]] QString shown(const QModelIndex& index) const;
    [[nodiscard]] virtual QString valueShown(const QModelIndex& index) const;
    [[nodiscard]] virtual int resultColumns() const { return 0; } ///< after the fields
    [[nodiscard]] virtual QVariant resultData(const QModelIndex& index, int role) const;
    [[nodiscard]] virtual QVariant resultHeader(int column, int role) const;
    [[nodiscard]] Document& document() const { return m_document; }
    [[nodiscard]] const Field& list() const { return m_list; }
    [[nodiscard]] std::string rowPath(int row) const;

private:
    struct Refused {
        QString text;
        QString reason;
    };
    using Cell = std::pair<int, const Field*>;

    [[nodiscard]] QVariant fieldData(const QModelIndex& index, int role) const;
    [[nodiscard]] Project withNumber(const QModelIndex& index, std::optional<double> value) const;
    [[nodiscard]] std::vector<const Field*> relevantColumns() const;

    std::string m_path;
    const Field& m_list;
    Document& m_document;
    std::vector<const Field*> m_columns;
    int m_rows = 0;
    QMap<Cell, Refused> m_refused;
    Issues m_issues;
    FormAccessPtr m_access = std::make_shared<const FormAccess>();
};

} // namespace sparkout
