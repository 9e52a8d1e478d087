// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

class QFrame;
class QLabel;
class QLineEdit;
class QListView;
class QSortFilterProxyModel;

namespace sparkout {

/// A combo box with a long list: text typed in the closed box or above its open list filters the
/// entries by words, ignoring case.
class SearchCombo : public QComboBox {
    Q_OBJECT

public:
    /// Additional search words of an entry: a symbol, a key, its name in another language.
    static constexpr int wordsRole = Qt::UserRole + 50;

    explicit SearchCombo(QWidget* parent = nullptr);

    void showPopup() override;
    void hidePopup() override;

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void open(const QString& text);
    void place();
    void search(const QString& text);
    bool takeKey(QKeyEvent& key);
    void choose(const QModelIndex& found);

    QSortFilterProxyModel* m_found;
    QFrame* m_popup;
    QLineEdit* m_search;
    QListView* m_list;
    QLabel* m_nothing;
};

} // namespace sparkout
