// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/profiles_look.h"
#include "ui/plot/view.h"

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;
class QSplitter;
class QToolButton;

namespace sparkout {

class LegendStrip;
class LongitudinalPlot;
class CursorStrip;
class PlotCursors;
class PlotTools;
class ProfilesPlot;
class Settings;
class SpectrumPlot;
struct LegendEntry;
struct ProfileSeries;

/// The view "Zone profiles": cross-sections with magnified deviations above, the part along its
/// axis or the spectra of the cross-sections below, all after any double stroke or revolution of
/// the cycle.
class ProfilesView : public View {
    Q_OBJECT
public:
    explicit ProfilesView(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ProfilesPlot* across() const { return m_across; }
    [[nodiscard]] LongitudinalPlot* along() const { return m_along; }
    [[nodiscard]] SpectrumPlot* spectrum() const { return m_spectrum; }
    [[nodiscard]] LegendStrip* legend() const { return m_legend; }
    [[nodiscard]] PlotTools* acrossTools() const { return m_acrossTools; }
    [[nodiscard]] PlotTools* alongTools() const { return m_alongTools; }
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }
    [[nodiscard]] PlotTools* spectrumTools() const { return m_spectrumTools; }
    [[nodiscard]] double lastUpdate_ms() const { return m_lastUpdate_ms; } ///< series and replot
    [[nodiscard]] QSize sizeHint() const override { return {700, 620}; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString brief() const override;
    void retranslate() override;

    /// Brings the cycle to the end of a double stroke or revolution; 0: to the blank.
    void setStroke(int number);
    [[nodiscard]] int stroke() const;
    void showSection(int section); ///< at the end of the cycle; below 0 all of them

protected:
    [[nodiscard]] QString hint() const override;
    void recolour() override;
    void showOutcome() override;
    void followCycle() override;

private:
    /// What the view shows of its three plots, as the box of parts lists it.
    enum class Parts { sectionsAndLength, sections, length, sectionsAndSpectrum, spectrum };
    [[nodiscard]] Parts parts() const;
    [[nodiscard]] bool showsAcross() const;
    [[nodiscard]] bool showsAlong() const;
    [[nodiscard]] bool showsSpectrum() const;

    void buildPlotTools(Settings* settings);
    void buildSpectrumTools(Settings* settings);
    void buildToolBar(QWidget* bar);
    void buildStrokeBar(QWidget* bar);
    void nameObjects();
    void buildLabels();
    void connectTools();
    void connectPlots();
    void showSeries();
    void showSpectrum();
    void showState();
    void showStroke();
    void showLegend();
    void showParts();
    void showDescription();
    void fillStrokes();
    void fillSections();
    void fillMagnifications();
    void fillChoice(QComboBox* box, const std::vector<QString>& texts);
    void onSection(int index);
    void choose(int profile);
    void onMagnification(int index);
    void toggle(ProfileLine line);
    void showOnly(ProfileLine line);
    void showHidden();
    void fit();
    void replotAll();
    [[nodiscard]] std::vector<int> shownProfiles() const;
    [[nodiscard]] std::vector<ProfileLine> legendLines() const;
    [[nodiscard]] std::vector<ProfileLine> acrossLines() const;
    /// What the user hid, and the circles that were not chosen.
    [[nodiscard]] ProfileLines hiddenAcross() const;
    [[nodiscard]] std::vector<LegendEntry> entriesOf(const std::vector<ProfileLine>& lines,
                                                     const QPalette& palette) const;
    [[nodiscard]] QStringList headingOf(const QString& plot) const;
    [[nodiscard]] bool recorded() const;

    ProfilesPlot* m_across = nullptr;
    LongitudinalPlot* m_along = nullptr;
    SpectrumPlot* m_spectrum = nullptr;
    PlotTools* m_acrossTools = nullptr;
    PlotTools* m_alongTools = nullptr;
    PlotCursors* m_cursors = nullptr;
    CursorStrip* m_strip = nullptr;
    QWidget* m_cursorsButton = nullptr;
    PlotTools* m_spectrumTools = nullptr;
    QWidget* m_acrossExport = nullptr;
    QWidget* m_alongExport = nullptr;
    QWidget* m_spectrumExport = nullptr;
    QSplitter* m_splitter = nullptr;
    LegendStrip* m_legend = nullptr;
    QLabel* m_notice = nullptr;
    QLabel* m_values = nullptr;
    QComboBox* m_parts = nullptr;
    QComboBox* m_section = nullptr;
    QToolButton* m_alone = nullptr;
    QComboBox* m_magnification = nullptr;
    QComboBox* m_reference = nullptr;
    QComboBox* m_circles = nullptr;
    QCheckBox* m_blank = nullptr;
    QToolButton* m_fit = nullptr;
    QWidget* m_strokeBar = nullptr;
    QLabel* m_strokeLabel = nullptr;
    QToolButton* m_previous = nullptr;
    QSlider* m_slider = nullptr;
    QToolButton* m_next = nullptr;
    QSpinBox* m_number = nullptr;
    QComboBox* m_quantity = nullptr;
    QCheckBox* m_toScale = nullptr;
    QCheckBox* m_logarithmic = nullptr;

    OutcomePtr m_good;           ///< what the plots show
    std::optional<int> m_chosen; ///< zone or section asked for
    std::optional<double> m_wantedMagnification;
    ProfileLines m_hidden{ProfileLine::blank};
    double m_lastUpdate_ms = 0;
};

} // namespace sparkout
