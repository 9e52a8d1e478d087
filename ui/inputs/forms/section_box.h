// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

namespace sparkout {

class PageColumns;

/// A group of inputs under a bold title, without a frame, so that the fields of all groups of a
/// page stand below each other.
class SectionBox : public QGroupBox {
    Q_OBJECT

public:
    /// `depth` boxes deep in the page, the page's own rows being 0.
    explicit SectionBox(int depth, QWidget* parent = nullptr);

    [[nodiscard]] int depth() const { return m_depth; }
    [[nodiscard]] PageColumns& rows() const { return *m_rows; }
    /// What rows at a depth keep clear left and right to line up with those of the deepest boxes.
    [[nodiscard]] static int inset(int depth);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_depth;
    PageColumns* m_rows;
};

} // namespace sparkout
