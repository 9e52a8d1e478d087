// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/part/part_outline.h"

#include <QStringList>
#include <QWidget>

#include <cstddef>
#include <optional>

namespace sparkout {

/// The part from the side, to scale: its steps in thin lines, ground surfaces in bold ones with
/// their numbers. Clicks report their place; the keyboard uses the list beside it.
class PartDrawing : public QWidget {
    Q_OBJECT

public:
    explicit PartDrawing(QWidget* parent = nullptr);

    void setOutline(PartOutline outline);
    void setPresent(std::optional<std::size_t> surface); ///< drawn as the current one
    void setChosenStep(std::optional<std::size_t> step); ///< where a surface is to be added
    void setTips(QStringList tips);                      ///< tool tips of the surfaces
    [[nodiscard]] const PartOutline& outline() const { return m_outline; }
    [[nodiscard]] double xOf(double place_mm) const; ///< in widget coordinates
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void surfaceClicked(std::size_t surface);
    void stepClicked(std::size_t step);
    void freeStepEntered(std::size_t step); ///< by a double click

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] double scale() const; ///< pixels a millimetre
    [[nodiscard]] double placeAt(double x) const;
    [[nodiscard]] QRectF box(const PartOutline::Step& step) const;
    void drawBody(QPainter& painter) const;
    void drawSurface(QPainter& painter, std::size_t surface) const;
    void drawNumbers(QPainter& painter) const;

    PartOutline m_outline;
    std::optional<std::size_t> m_present;
    std::optional<std::size_t> m_step;
    QStringList m_tips;
};

} // namespace sparkout
