// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/plot/painted_layer.h"

#include <QString>

#include <vector>

namespace sparkout {

struct Stiffness;

/// Draws the objects around the body that ShaftLayer draws, to the same scale: centres or chuck,
/// steady rests, the wheel, a quill, each with its stiffness, and the gauge.
class ShaftScene : public PaintedLayer {
    Q_OBJECT
public:
    explicit ShaftScene(QCPAxisRect* rect);

    /// @param body bounds of the body drawn by ShaftLayer
    /// @param gauge_mm place of the gauge from the headstock end of the ground length
    void setProject(const Project& project, const QRectF& body, double gauge_mm);
    [[nodiscard]] QRectF bounds() const { return m_bounds; } ///< [mm], y upwards

    /// A text beside an object, in pixels.
    struct Note {
        QRectF place;
        QString text;
    };
    [[nodiscard]] const std::vector<Note>& notes() const { return m_notes; } ///< as last drawn
    [[nodiscard]] QRectF wheelBox() const { return m_wheelBox; } ///< in pixels, as last drawn

protected:
    void draw(QCPPainter* painter) override;

private:
    [[nodiscard]] QPointF at(double x_mm, double y_mm) const;
    [[nodiscard]] QRectF box(double from_mm, double to_mm, double low_mm, double high_mm) const;
    void drawSupport(QCPPainter* painter, bool tailstock);
    void drawRests(QCPPainter* painter);
    void drawWheel(QCPPainter* painter);
    void drawGauge(QCPPainter* painter);
    void placeWheel();
    /// Writes a note beside an object, clear of the earlier notes.
    void note(QCPPainter* painter, const QPointF& where, int flags, const QString& text,
              const QColor& colour);
    void note(QCPPainter* painter, const QPointF& where, int flags, const QString& text);
    [[nodiscard]] QString stiffness(double Stiffness::*unit, const QString& name) const;

    Project m_project;
    double m_gauge_mm = 0;
    double m_from_mm = 0, m_to_mm = 0; ///< ends of the shaft
    double m_high_mm = 0;              ///< largest radius of the shaft
    QRectF m_bounds;
    std::vector<Note> m_notes;
    QRectF m_wheelBox;
};

} // namespace sparkout
