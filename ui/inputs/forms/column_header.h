// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>

#include <vector>

class QTextDocument;

namespace sparkout {

/// The head of a table with rich titles (the model's markupRole) of several lines. Each column is
/// at least as wide as the longest word of its title; what is left is shared.
class ColumnHeader : public QHeaderView {
    Q_OBJECT

public:
    static constexpr int markupRole = Qt::UserRole + 1;

    explicit ColumnHeader(QWidget* parent = nullptr);

    void fit(int width); ///< shares a width among the columns and takes the height they need
    [[nodiscard]] QSize needOf(int section) const; ///< of its title, in lines of its width

protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override;

private:
    void prepare(QTextDocument& title, int section) const;
    [[nodiscard]] std::vector<int> titleWidths() const; ///< of their longest words

    int m_margin;      ///< of a title, left and right
    double m_size = 1; ///< of the type of titles, where they have no room less
};

} // namespace sparkout
