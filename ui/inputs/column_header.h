// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>

#include <vector>

class QTextDocument;

namespace sparkout {

/// The head of a table with rich titles (the model's markupRole) of several lines. Each column is
/// at least as wide as the longest word of its title and gets a share of the remaining width.
class ColumnHeader : public QHeaderView {
    Q_OBJECT

public:
    static constexpr int markupRole = Qt::UserRole + 1;

    explicit ColumnHeader(QWidget* parent = nullptr);

    void fit(int width); ///< distributes a width over the columns and adapts the height
    [[nodiscard]] QSize needOf(int section) const; ///< size of its title, wrapped to its width

protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override;

private:
    void prepare(QTextDocument& title, int section) const;
    [[nodiscard]] std::vector<int> titleWidths() const; ///< widths of the longest words

    int m_margin;      ///< margin of a title, left and right
    double m_size = 1; ///< scale of the titles' font, below 1 if width is short
};

} // namespace sparkout
