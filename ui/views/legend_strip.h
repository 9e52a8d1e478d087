// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include <vector>

namespace sparkout {

/// One entry of a legend: a line sample or a filled swatch, and its text.
struct LegendEntry {
    QColor colour;
    Qt::PenStyle pen = Qt::SolidLine; ///< NoPen: a swatch
    QString text;
    int key = -1;      ///< what a click hides or shows; below 0: nothing
    bool shown = true; ///< false: hidden by the user, drawn faintly
};

/// A legend beside the plot that wraps its entries over as many lines as it needs.
class LegendStrip : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setEntries(std::vector<LegendEntry> entries);
    [[nodiscard]] const std::vector<LegendEntry>& entries() const { return m_entries; }
    [[nodiscard]] QRect entryRect(int index) const; ///< in the widget

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void toggled(int key);   ///< hide or show this curve
    void onlyAsked(int key); ///< Ctrl+click: show only this one

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] std::vector<QRect> layOut(int width) const;

    std::vector<LegendEntry> m_entries;
};

} // namespace sparkout
