// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/plot/view_plot.h"

#include <memory>

namespace sparkout {

class BandLayer;
class ComplianceCurves;
class CouplingCurves;
class GaugeCurves;
class LengthCurves;
class ShaftLayer;
class ShaftScene;

/// What stands below the part: γ along it, the diameters over the gauge's place, or those of
/// coupled against independent sections.
enum class ComplianceContent { compliance, gauge, coupling };

/// Above the part on its supports with wheel and gauge, to scale; below, over one axis, the curves
/// of what was chosen.
class CompliancePlot : public ViewPlot {
    Q_OBJECT
public:
    explicit CompliancePlot(QWidget* parent = nullptr);
    ~CompliancePlot() override;

    void setContent(ComplianceContent content); ///< no replot
    [[nodiscard]] ComplianceContent content() const { return m_content; }
    [[nodiscard]] ComplianceCurves& gamma() const { return *m_gamma; }
    [[nodiscard]] GaugeCurves& gauge() const { return *m_gauge; }
    [[nodiscard]] CouplingCurves& coupling() const { return *m_coupling; }
    /// Where the gauge stands in the run shown, from the headstock end of the ground length [mm].
    [[nodiscard]] double gaugePlace_mm() const;
    void setRun(OutcomePtr outcome); ///< no replot
    void fit() override;
    void fitValues(); ///< the lower axis alone
    /// The same where what is drawn has grown out of it or is small in it, and nobody has zoomed.
    void refitValues();
    void toggleCurve(int key) override;
    void showOnly(int key) override;
    void restyle() override;

    [[nodiscard]] QCPAxisRect* shaftRect() const { return m_shaftRect; }
    [[nodiscard]] QCPAxisRect* curveRect() const { return m_rect; }
    [[nodiscard]] LegendEntries legendEntries() const override;
    [[nodiscard]] ReadCurves readCurves() const override;
    [[nodiscard]] QCPRange readSpan() const override;
    [[nodiscard]] CsvTable table() const override;
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

private:
    void setTexts() override;
    [[nodiscard]] QString valuesAt(const QPointF& at) const override;
    void build();
    [[nodiscard]] LengthCurves& curves() const; ///< below the part
    void labelValues();
    void fillBands();
    void afterLayouting();

    OutcomePtr m_outcome;
    QCPAxisRect* m_shaftRect = nullptr;
    QCPAxisRect* m_rect = nullptr;
    BandLayer* m_names = nullptr;
    BandLayer* m_bands = nullptr;
    ShaftLayer* m_body = nullptr;
    ShaftScene* m_scene = nullptr;
    std::unique_ptr<ComplianceCurves> m_gamma;
    std::unique_ptr<GaugeCurves> m_gauge;
    std::unique_ptr<CouplingCurves> m_coupling;
    ComplianceContent m_content = ComplianceContent::compliance;
    QCPRange m_fitted;      ///< of the lower axis, as it was fitted last
    QCPRange m_fittedAlong; ///< of the axis along the part, likewise
    bool m_fitting = false; ///< with the next layout
};

} // namespace sparkout
