// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/slider_scale.h"
#include "ui/text/shown_scale.h"

#include <QTimer>
#include <QWidget>

#include <optional>

namespace sparkout {

/// A thin slider for a number, beside its field. It stops at round values; Escape during a drag
/// restores the value; the wheel scrolls the page unless the slider has the focus.
class ValueSlider : public QWidget {
    Q_OBJECT

public:
    explicit ValueSlider(QWidget* parent = nullptr);

    /// Shows a value on the scale of a spec; the value may be outside. A drag keeps its scale as
    /// long as the value is the one it set.
    void display(const SliderSpec& spec, std::optional<double> value, const QString& unit,
                 const ShownScale& shown = {});

    [[nodiscard]] std::optional<double> value() const { return m_value; }
    [[nodiscard]] const SliderScale& scale() const { return m_scale; }
    [[nodiscard]] const QString& unit() const { return m_unit; }
    [[nodiscard]] const ShownScale& shown() const {
        return m_shown;
    } ///< converts values to displayed numbers
    [[nodiscard]] bool dragging() const { return m_dragged.has_value(); }
    void setByHand(double value); ///< as if moved there

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QPoint handle() const; ///< its middle

signals:
    void valueEdited(double value);
    void settled(); ///< edits before and after are separate steps of the history

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF groove() const;
    [[nodiscard]] double shareAt(double x) const;
    void move(double value);
    void endDrag();

    SliderSpec m_spec;
    SliderScale m_scale;
    std::optional<double> m_value;
    QString m_unit;
    ShownScale m_shown;
    std::optional<double> m_dragged; ///< the value before the running drag
    double m_grip = 0;               ///< position of the grip relative to the handle's middle
    int m_wheel = 0;                 ///< turned, but not yet a step
    QTimer m_pause;                  ///< for keys and wheel: ends their step of the history
};

} // namespace sparkout
