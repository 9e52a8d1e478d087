// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

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

} // namespace sparkout
