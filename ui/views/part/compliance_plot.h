// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/outcome.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/painted_layer.h"
#include "ui/views/part/compliance_curves.h"

#include <QString>

#include <vector>

namespace sparkout {

class BandLayer;
class ShaftLayer;
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

/// The chart below the part: γ along it, the diameters over the gauge's place, or those with
/// coupled and with independent sections.
enum class ComplianceContent { compliance, gauge, coupling };

/// The part on its supports with wheel and gauge, to scale, above the chosen curves on the same
/// axis.
class CompliancePlot : public ChartPlot {
    Q_OBJECT
public:
    explicit CompliancePlot(QWidget* parent = nullptr);

    void setContent(ComplianceContent content); ///< no replot
    [[nodiscard]] ComplianceContent content() const { return m_content; }
    [[nodiscard]] const ComplianceCurves& gamma() const { return m_gamma; }
    [[nodiscard]] const GaugeCurves& gauge() const { return m_gauge; }
    [[nodiscard]] const CouplingCurves& coupling() const { return m_coupling; }
    /// The gauge's position in the shown run, from the headstock end of the ground length [mm].
    [[nodiscard]] double gaugePlace_mm() const;
    void setRun(OutcomePtr outcome);                                ///< no replot
    void setGauge(GaugePlacementPtr placement, OutcomePtr outcome); ///< no replot
    void setCoupling(CouplingPtr comparison);                       ///< no replot
    void fit() override;
    /// Fits the values again if the curves exceed the range or fill little of it, unless the user
    /// has zoomed.
    void refitValues();

    [[nodiscard]] QCPAxisRect* shaftRect() const { return m_shaftRect; }
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void build();
    [[nodiscard]] LineChart made() const; ///< the chart below the part
    void fillBands();
    void afterLayouting();

    OutcomePtr m_outcome;
    QCPAxisRect* m_shaftRect = nullptr;
    BandLayer* m_names = nullptr;
    BandLayer* m_bands = nullptr;
    ShaftLayer* m_body = nullptr;
    ShaftScene* m_scene = nullptr;
    ComplianceCurves m_gamma;
    GaugeCurves m_gauge;
    CouplingCurves m_coupling;
    ComplianceContent m_content = ComplianceContent::compliance;
    QCPRange m_fittedAlong; ///< range of the axis along the part in the last fit
    bool m_fitting = false; ///< whether the next layout fits
};

} // namespace sparkout
