// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

namespace sparkout {

class PageColumns;

/// A group of inputs under a bold title, without a frame, so that the fields of all groups of a
/// page are aligned.
class SectionBox : public QGroupBox {
    Q_OBJECT

public:
    /// `depth`: number of boxes around it; the page's own rows are at 0.
    explicit SectionBox(int depth, QWidget* parent = nullptr);

    [[nodiscard]] int depth() const { return m_depth; }
    [[nodiscard]] PageColumns& rows() const { return *m_rows; }
    /// The left and right margin that aligns rows at a depth with those of the deepest boxes.
    [[nodiscard]] static int inset(int depth);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_depth;
    PageColumns* m_rows;
};

} // namespace sparkout
