// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace sparkout {

class Document;

/// Edits the numbers of a ListModel in place; every good value goes to the document as it is typed.
class ListDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    explicit ListDelegate(Document& document, QObject* parent = nullptr);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
    /// Takes back a refused text in the editor that is open in a view.
    static void dropRefusal(const QAbstractItemView& view);
    void destroyEditor(QWidget* editor, const QModelIndex& index) const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    [[nodiscard]] Document& document() const { return m_document; }
    static void setCell(QWidget& editor, const QModelIndex& cell); ///< needed by all below
    /// Whether the view still holds it: it forgets an editor before taking the focus from it.
    [[nodiscard]] static bool isOpen(const QWidget& editor);
    void commit(QWidget* editor); ///< when open
    void close(QWidget* editor);  ///< with a commit, when open

private:
    Document& m_document;
};

} // namespace sparkout
