// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <memory>
#include <vector>

namespace sparkout {

/// A row of tools like a QHBoxLayout that continues in further lines if needed, preferably breaking
/// at a stretch. It is at least as wide as its widest tool; a box of choices shows its current
/// entry in full.
class ToolRow : public QLayout {
    Q_OBJECT
public:
    explicit ToolRow(QWidget* parent = nullptr);
    ~ToolRow() override;

    void addWidget(QWidget* widget, int stretch = 0); ///< shares the surplus width of a line
    /// Adds a text that wraps: it takes a line of its own unless it has room for this many letters
    /// beside the others.
    void addText(QWidget* widget, int letters, int stretch);
    void addStretch(int stretch = 1);

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    struct Tool {
        std::unique_ptr<QLayoutItem> item;
        int stretch;
        int letters = 0; ///< least width beside others
        [[nodiscard]] int least() const;
    };
    using Line = std::vector<const Tool*>;
    [[nodiscard]] std::vector<Line> lines(int width) const;
    [[nodiscard]] int leastWidth(const Line& line) const;
    [[nodiscard]] std::vector<int> widthsOf(const Line& line, int room) const;
    [[nodiscard]] int heightOf(const Line& line, int room) const;
    void layOut(const Line& line, const QRect& rect) const;

    std::vector<Tool> m_items;
};

} // namespace sparkout
