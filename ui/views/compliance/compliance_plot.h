// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/system_compliance.h"
#include "core/study/outcome.h"
#include "ui/plot/legend_drawing.h"
#include "ui/plot/read_curves.h"
#include "ui/plot/view_plot.h"
#include "ui/tables/csv_table.h"

#include <array>
#include <memory>
#include <vector>

namespace sparkout {

class BandLayer;
struct CursorSubject;
class CouplingCurves;
class GaugeCurves;
class LengthCurves;
class ShaftLayer;
class ShaftScene;

/// What γ(x) is made of, from below; rests are what steady rests take away again.
enum class CompliancePart { wheelHead, headstock, tailstock, bending, rests };

inline constexpr std::array allComplianceParts{CompliancePart::wheelHead, CompliancePart::headstock,
                                               CompliancePart::tailstock, CompliancePart::bending,
                                               CompliancePart::rests};

[[nodiscard]] double valueOf(const ComplianceParts& parts, CompliancePart part); ///< [mm/N]
[[nodiscard]] double sumOf(const ComplianceParts& parts);                        ///< [mm/N]
inline constexpr double nmPerMm = 1e6; ///< γ is drawn in nm/N

/// What stands below the part: γ along it, the diameters over the gauge's place, or those of
/// coupled against independent sections.
enum class ComplianceContent { compliance, gauge, coupling };

/// Above the part on its supports with wheel and gauge, to scale; below γ along it as stacked
/// parts, its sum, and the γ each zone or section is ground with, or diameters in their place. Both
/// over one axis.
class CompliancePlot : public ViewPlot {
    Q_OBJECT
public:
    static constexpr int sumKey = 100, usedKey = 101; ///< of the legend; below: a CompliancePart

    explicit CompliancePlot(QWidget* parent = nullptr);
    ~CompliancePlot() override;

    void setContent(ComplianceContent content); ///< no replot
    [[nodiscard]] ComplianceContent content() const { return m_content; }
    [[nodiscard]] GaugeCurves& gauge() const { return *m_gauge; }
    [[nodiscard]] CouplingCurves& coupling() const { return *m_coupling; }
    /// Where the gauge stands in the run shown, from the headstock end of the ground length [mm].
    [[nodiscard]] double gaugePlace_mm() const;
    void setRun(OutcomePtr outcome); ///< no replot
    void fit();
    void fitValues(); ///< the lower axis alone
    /// The same where what is drawn has grown out of it or is small in it, and nobody has zoomed.
    void refitValues();
    void toggleCurve(int key);
    void showOnly(int key);
    void restyle() override;

    [[nodiscard]] QCPAxisRect* shaftRect() const { return m_shaftRect; }
    [[nodiscard]] QCPAxisRect* curveRect() const { return m_rect; }
    [[nodiscard]] QCPGraph* sum() const { return m_sum; }
    [[nodiscard]] QCPGraph* used() const { return m_used; }
    [[nodiscard]] QCPGraph* stack(CompliancePart part) const; ///< upper edge; rests have none
    [[nodiscard]] const std::vector<CompliantPlace>& places() const { return m_places; }
    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] ReadCurves readCurves() const; ///< the shown ones
    [[nodiscard]] CursorSubject cursorSubject();
    [[nodiscard]] CsvTable table() const;
    /// The axes that wheel, drag and keys move in an axis rect.
    [[nodiscard]] QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const;
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

private:
    void setTexts() override;
    void build();
    void fill();
    [[nodiscard]] LengthCurves* curves() const; ///< below the part; null: γ
    [[nodiscard]] LegendEntries complianceEntries() const;
    [[nodiscard]] CsvTable complianceTable() const;
    [[nodiscard]] ReadCurves complianceCurves() const;
    [[nodiscard]] std::optional<double> groundWith(double x_mm) const; ///< γ [nm/N]
    [[nodiscard]] QString complianceAt(double x_mm) const;
    void labelValues();
    void fillBands();
    void afterLayouting();
    void onMouse(QMouseEvent* event);
    [[nodiscard]] bool has(CompliancePart part) const;
    [[nodiscard]] QColor colourOf(CompliancePart part) const;
    [[nodiscard]] static QString nameOf(CompliancePart part);

    OutcomePtr m_outcome;
    std::vector<CompliantPlace> m_places;
    CurveChoice m_choice;
    QCPAxisRect* m_shaftRect = nullptr;
    QCPAxisRect* m_rect = nullptr;
    BandLayer* m_names = nullptr;
    BandLayer* m_bands = nullptr;
    ShaftLayer* m_body = nullptr;
    ShaftScene* m_scene = nullptr;
    std::array<QCPGraph*, 4> m_stack{}; ///< of the parts up to bending
    QCPGraph* m_base = nullptr;         ///< the axis, for the first fill
    QCPGraph* m_sum = nullptr;
    QCPGraph* m_used = nullptr;
    std::unique_ptr<GaugeCurves> m_gauge;
    std::unique_ptr<CouplingCurves> m_coupling;
    ComplianceContent m_content = ComplianceContent::compliance;
    QCPRange m_fitted;      ///< of the lower axis, as it was fitted last
    QCPRange m_fittedAlong; ///< of the axis along the part, likewise
    bool m_fitting = false; ///< with the next layout
};

} // namespace sparkout
