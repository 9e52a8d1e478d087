// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <memory>
#include <vector>

namespace sparkout {

/// Tools side by side, as in a QHBoxLayout; where they have no room they go on in further lines,
/// at a stretch if that is enough. As wide as its widest tool at least; a box of choices shows the
/// present one in full, not each.
class ToolRow : public QLayout {
    Q_OBJECT
public:
    explicit ToolRow(QWidget* parent = nullptr);
    ~ToolRow() override;

    void addWidget(QWidget* widget, int stretch = 0); ///< shares what a line has to spare
    /// A text that wraps: with a line to itself unless it is at least so many letters wide beside
    /// the others, that it be no column of words.
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
        int letters = 0; ///< wide at least beside others
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
