// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVBoxLayout>

#include <functional>
#include <span>
#include <vector>

namespace sparkout {

/// Lays out the parts of a page or of a box below each other, with their height for the width; in
/// two columns if there is room, in their order and as equal in height as possible.
class PageColumns : public QVBoxLayout {
public:
    using QVBoxLayout::QVBoxLayout;

    void addWide(QWidget* part); ///< across both columns

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] int minimumHeightForWidth(int width) const override;
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    struct Part {
        QLayoutItem* item;
        int height;
    };
    using Items = std::vector<QLayoutItem*>;
    using Put = std::function<void(QLayoutItem&, const QRect&)>;
    /// Places every part, and returns the total height.
    int place(const QRect& room, const Put& put) const;
    int placeColumns(const Items& items, const QRect& room, const Put& put) const;
    int placeColumn(std::span<const Part> parts, QRect room, const Put& put) const;
    [[nodiscard]] bool hasTwo(int width) const;
    [[nodiscard]] bool isWide(const QLayoutItem& item) const;
    [[nodiscard]] int gap(const QLayoutItem& above, const QLayoutItem& below) const;
    [[nodiscard]] int heightOf(std::span<const Part> parts) const;
    [[nodiscard]] std::size_t split(std::span<const Part> parts) const;

    std::vector<const QWidget*> m_wide;
};

} // namespace sparkout
