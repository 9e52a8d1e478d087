// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace sparkout {

/// A small plot on which a curve is drawn by points: a click puts the point of the nearest place at
/// that height, dragging moves it; by keys, Left and Right choose a place, Up and Down move its
/// point, Delete removes it. The engine's curve can be drawn beside the prediction.
class CurveSketch : public QWidget {
    Q_OBJECT

public:
    using Values = std::vector<std::optional<double>>;

    /// The places in their order, at these distances.
    CurveSketch(std::vector<double> at, QWidget* parent);

    void setLabels(QStringList places, QString along, QString value);
    void setCurveNames(QString said, QString found);
    void setSaid(const Values& values);
    void setFound(const Values& values);
    void setTop(double top); ///< least upper end of the axis
    void setEditable(bool editable);
    [[nodiscard]] double top() const; ///< upper end of the axis as drawn
    [[nodiscard]] QPointF pointAt(std::size_t place, double value) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void placed(std::size_t place, std::optional<double> value);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] int headHeight() const;
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] double bottom() const;
    [[nodiscard]] double tick() const;
    void place(const QPointF& at);
    void drawAxes(QPainter& painter) const;
    void drawCurve(QPainter& painter, const Values& values, bool isFound) const;
    void drawNames(QPainter& painter) const;

    std::vector<double> m_at;
    QStringList m_places;
    QString m_along, m_value, m_saidName, m_foundName;
    Values m_said, m_found;
    double m_top = 10;
    bool m_isEditable = true;
    std::size_t m_current = 0;
};

} // namespace sparkout
