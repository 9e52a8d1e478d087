// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/plot/chart_plot.h"
#include "ui/views/compliance/compliance_curves.h"
#include "ui/views/compliance/coupling_curves.h"
#include "ui/views/compliance/gauge_curves.h"

namespace sparkout {

class BandLayer;
class ShaftLayer;
class ShaftScene;

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
    void restyle() override;

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
