// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/plot_view.h"
#include "ui/chart/profiles_look.h"
#include "ui/views/part/profiles_plot.h"

#include <optional>
#include <vector>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;
class QSplitter;
class QToolButton;

namespace sparkout {

class ChartPlot;
class LongitudinalPlot;
struct ChartGrid;

/// The view "Zone profiles": cross-sections with magnified deviations above, the part along its
/// axis or the spectra of the cross-sections below, all after any double stroke or revolution of
/// the cycle.
class ProfilesView : public PlotView {
    Q_OBJECT
public:
    explicit ProfilesView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ProfilesPlot* across() const { return m_across; }
    [[nodiscard]] LongitudinalPlot* along() const { return m_along; }
    [[nodiscard]] ChartPlot* spectrum() const { return m_spectrum; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool showsMoment() const override { return true; }
    [[nodiscard]] QString brief() const override;

    /// Brings the cycle to the end of a double stroke or revolution; 0: to the blank.
    void setStroke(int number);
    [[nodiscard]] int stroke() const;
    void showSection(int section); ///< at the end of the cycle; negative: all
    /// Shows a measured profile beside the predicted ones; empty: removes it.
    void showMeasured(std::optional<MeasuredSection> measured);

protected:
    [[nodiscard]] QString hint() const override;
    void takeOutcome(const OutcomePtr& before) override;
    void followCycle() override;
    void showState() override;
    void showLegend() override;
    void toggleCurve(int key) override;
    void showOnly(int key) override;
    void nameParts() override;
    [[nodiscard]] QString noticeText() const override;
    [[nodiscard]] QString keptText() const override;
    [[nodiscard]] QString remark() const override;
    [[nodiscard]] QStringList subheading() const override;

private:
    /// The visible plots, as listed in the box of parts.
    enum class Parts { sectionsAndLength, sections, length, sectionsAndSpectrum, spectrum };
    [[nodiscard]] Parts parts() const;
    [[nodiscard]] bool showsAcross() const;
    [[nodiscard]] bool showsAlong() const;
    [[nodiscard]] bool showsSpectrum() const;

    void buildPlots();
    QWidget* buildToolBar();
    QWidget* buildStrokeBar();
    void nameTools();
    void connectTools();
    void connectCircles();
    void nameCircles();
    void showSeries();
    void showSpectrum();
    void hideInSpectrum();
    [[nodiscard]] ChartGrid spectra() const;
    void showStroke();
    void showParts();
    void showDescription();
    void fillStrokes();
    void fillSections();
    void fillMagnifications();
    void onSection(int index);
    void choose(int profile);
    void onMagnification(int index);
    void showHidden();
    [[nodiscard]] std::vector<int> shownProfiles() const;
    [[nodiscard]] std::vector<ProfileLine> legendLines() const;
    [[nodiscard]] QStringList headingOf(const QString& plot) const;
    [[nodiscard]] bool recorded() const;

    QSplitter* m_splitter;
    ProfilesPlot* m_across;
    LongitudinalPlot* m_along;
    ChartPlot* m_spectrum;
    QWidget* m_cursorsButton = nullptr;
    QWidget* m_acrossExport = nullptr;
    QWidget* m_alongExport = nullptr;
    QWidget* m_spectrumExport = nullptr;
    QComboBox* m_parts = nullptr;
    QComboBox* m_section = nullptr;
    QToolButton* m_alone = nullptr;
    QComboBox* m_magnification = nullptr;
    QComboBox* m_reference = nullptr;
    QComboBox* m_circles = nullptr;
    QComboBox* m_filter = nullptr;
    QToolButton* m_measured = nullptr;
    QAction *m_readMeasured = nullptr, *m_removeMeasured = nullptr;
    QCheckBox* m_blank = nullptr;
    QToolButton* m_fit = nullptr;
    QLabel* m_strokeLabel = nullptr;
    QToolButton* m_previous = nullptr;
    QSlider* m_slider = nullptr;
    QToolButton* m_next = nullptr;
    QSpinBox* m_number = nullptr;
    QComboBox* m_quantity = nullptr;
    QCheckBox* m_toScale = nullptr;
    QCheckBox* m_logarithmic = nullptr;

    std::optional<int> m_chosen; ///< requested zone or section
    std::optional<double> m_wantedMagnification;
    ProfileLines m_hidden{ProfileLine::blank};
};

} // namespace sparkout
