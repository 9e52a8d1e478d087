// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part/profiles_view.h"

#include "core/project/part.h"
#include "core/simulation/feed_series.h"
#include "core/surface/roundness_readings.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_cursors.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/part/longitudinal_plot.h"
#include "ui/views/part/profiles_plot.h"
#include "ui/views/part/profiles_text.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sparkout {

namespace {

constexpr int mostCells = 4; ///< cross-sections side by side
}

ProfilesView::ProfilesView(QWidget* parent, Settings* settings)
    : PlotView(QStringLiteral("profiles"), parent, settings)
    , m_splitter(new QSplitter(Qt::Vertical, this))
    , m_across(new ProfilesPlot(this))
    , m_along(new LongitudinalPlot(this))
    , m_spectrum(new ChartPlot(this)) {
    buildPlots();
    QWidget* bar = buildToolBar();
    QWidget* strokeBar = buildStrokeBar();
    m_splitter->setMinimumSize(200, 120);
    QScrollArea* area = scrolled(*m_splitter);
    area->setObjectName(QStringLiteral("profilesArea"));
    hideUntilDrawn({strokeBar, area});
    disableUntilDrawn({m_parts, m_section, m_magnification, m_reference, m_circles, m_filter,
                       m_measured, m_blank, m_fit});
    addColumn({bar, strokeBar, notice(), legend(), area, strip(), values()}, area)->addStretch();
    nameTools();
    connectTools();
    built();
}

void ProfilesView::buildPlots() {
    share(*m_splitter, {{m_across, 500}, {m_along, 300}, {m_spectrum, 300}});
    PlotSubject across, along, spectrum;
    across.name = [] { return tr("cross-sections"); };
    across.icon = u"export_sections";
    across.heading = [this] { return headingOf(tr("cross-sections")); };
    along.name = [] { return tr("along the axis"); };
    along.icon = u"export_length";
    along.heading = [this] { return headingOf(tr("along the axis")); };
    spectrum.heading = [this] { return headingOf(tr("spectra of the cross-sections")); };
    hideInSpectrum();
    m_spectrum->setGrid([this] { return spectra(); });
    addPlot(*m_across, std::move(across));
    addPlot(*m_along, std::move(along));
    addPlot(*m_spectrum, std::move(spectrum));
    addCursors(*m_along);
    for (ProfilePlot* plot : std::initializer_list<ProfilePlot*>{m_across, m_along}) {
        plot->setHidden(m_hidden);
        plot->keepLegible();
    }
    connect(m_along, &LongitudinalPlot::profileClicked, this, &ProfilesView::choose);
}

QStringList ProfilesView::headingOf(const QString& plot) const {
    QStringList heading = PlotView::heading();
    heading[0] = tr("%1: %2").arg(title(), plot);
    return heading;
}

QStringList ProfilesView::subheading() const {
    return {ProfilesText::moment(m_across->series()), Names::uncutStrips(good()->result.project)};
}

QWidget* ProfilesView::buildToolBar() {
    auto* bar = new QWidget(this);
    auto* row = rowIn<ToolRow>(bar);
    m_parts = new QComboBox(bar);
    m_section = new QComboBox(bar);
    m_alone = new QToolButton(bar);
    m_magnification = new QComboBox(bar);
    m_reference = new QComboBox(bar);
    m_circles = new QComboBox(bar);
    m_filter = new QComboBox(bar);
    m_measured = new QToolButton(bar);
    auto* menu = new QMenu(m_measured);
    m_readMeasured = menu->addAction(QString());
    m_removeMeasured = menu->addAction(QString());
    m_removeMeasured->setEnabled(false);
    m_measured->setMenu(menu);
    m_measured->setPopupMode(QToolButton::InstantPopup);
    m_fit = new QToolButton(bar);
    m_alone->setCheckable(true);
    m_fit->setIcon(themeIcon(u"fit"));
    m_fit->setAutoRaise(true);
    for (QToolButton* button : {m_alone, m_measured, m_fit}) {
        button->setFocusPolicy(Qt::TabFocus);
    }
    addBoxes(*row, {m_parts, m_section});
    row->addWidget(m_alone);
    row->addStretch();
    row->addWidget(m_measured);
    addBoxes(*row, {m_circles, m_filter, m_reference, m_magnification});
    row->addWidget(m_fit);
    m_acrossExport = m_across->tools()->exportButton(bar);
    row->addWidget(m_acrossExport);
    return bar;
}

QWidget* ProfilesView::buildStrokeBar() {
    auto* bar = new QWidget(this);
    auto* row = rowIn<ToolRow>(bar);
    m_strokeLabel = new QLabel(bar);
    m_previous = new QToolButton(bar);
    m_slider = new QSlider(Qt::Horizontal, bar);
    m_next = new QToolButton(bar);
    m_number = new QSpinBox(bar);
    m_blank = new QCheckBox(bar);
    m_quantity = new QComboBox(bar);
    m_toScale = new QCheckBox(bar);
    m_logarithmic = new QCheckBox(bar);
    m_logarithmic->setChecked(true);
    m_strokeLabel->setTextFormat(Qt::PlainText);
    m_previous->setArrowType(Qt::LeftArrow);
    m_next->setArrowType(Qt::RightArrow);
    for (QToolButton* button : {m_previous, m_next}) {
        button->setFocusPolicy(Qt::TabFocus);
        button->setAutoRepeat(true);
    }
    m_slider->setMinimumWidth(60);
    m_number->setKeyboardTracking(false);
    m_quantity->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    row->addWidget(m_strokeLabel);
    row->addWidget(m_previous);
    row->addWidget(m_slider, 1);
    for (QWidget* w : std::initializer_list<QWidget*>{m_next, m_number, m_blank, m_quantity,
                                                      m_toScale, m_logarithmic}) {
        row->addWidget(w);
    }
    m_cursorsButton = PlotTools::button(cursors()->toggle, bar);
    row->addWidget(m_cursorsButton);
    m_alongExport = m_along->tools()->exportButton(bar);
    row->addWidget(m_alongExport);
    m_spectrumExport = m_spectrum->tools()->exportButton(bar);
    row->addWidget(m_spectrumExport);
    return bar;
}

void ProfilesView::nameTools() {
    nameObjects({{m_parts, "parts"},
                 {m_section, "section"},
                 {m_alone, "alone"},
                 {m_blank, "blank"},
                 {m_reference, "reference"},
                 {m_circles, "circles"},
                 {m_filter, "filter"},
                 {m_measured, "measuredProfile"},
                 {m_logarithmic, "logarithmicSpectrum"},
                 {m_magnification, "magnification"},
                 {m_fit, "fit"},
                 {m_slider, "strokeSlider"},
                 {m_number, "stroke"},
                 {m_previous, "previous"},
                 {m_next, "next"},
                 {m_quantity, "quantity"},
                 {m_toScale, "toScale"},
                 {m_strokeLabel, "moment"}});
}

void ProfilesView::connectTools() {
    connect(m_parts, &QComboBox::currentIndexChanged, this, [this] {
        showParts();
        showSpectrum();
        showLegend();
        replotAll();
    });
    connect(m_section, &QComboBox::currentIndexChanged, this, &ProfilesView::onSection);
    connect(m_alone, &QToolButton::toggled, this, [this] { onSection(m_section->currentIndex()); });
    connect(m_magnification, &QComboBox::currentIndexChanged, this, &ProfilesView::onMagnification);
    connect(m_reference, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_across->setReference(index == 1 ? RadiusReference::mean : RadiusReference::target);
        fillMagnifications();
        showDescription();
        replotAll();
    });
    connectCircles();
    connect(m_logarithmic, &QCheckBox::toggled, this, [this] {
        m_spectrum->remake();
        m_spectrum->fit();
        m_spectrum->replot();
        m_spectrum->tools()->navigation().forgetViews(); // they are ranges of the other scale
    });
    connect(m_blank, &QCheckBox::toggled, this,
            [this] { toggleCurve(static_cast<int>(ProfileLine::blank)); });
    connect(m_fit, &QToolButton::clicked, this, [this] {
        for (ViewPlot* plot : plots()) {
            plot->tools()->navigation().fit();
        }
    });
    connect(m_slider, &QSlider::valueChanged, this, &ProfilesView::setStroke);
    connect(m_number, &QSpinBox::valueChanged, this, &ProfilesView::setStroke);
    connect(m_previous, &QToolButton::clicked, m_number, &QSpinBox::stepDown);
    connect(m_next, &QToolButton::clicked, m_number, &QSpinBox::stepUp);
    connect(m_quantity, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_along->setDiameters(index == 1);
        replotAll();
    });
    connect(m_toScale, &QCheckBox::toggled, this, [this](bool on) {
        m_along->setToScale(on);
        showParts();
        replotAll();
    });
}

void ProfilesView::connectCircles() {
    connect(m_circles, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_across->setCircles(static_cast<ReferenceCircles>(index));
        fillMagnifications();
        showLegend();
        showDescription();
        replotAll();
    });
    connect(m_filter, &QComboBox::currentIndexChanged, this, [this](int index) {
        const auto chosen = static_cast<std::size_t>(index - 1);
        m_across->setFilter(chosen < roundnessCutoffs_upr.size()
                                ? std::optional(roundnessCutoffs_upr.at(chosen))
                                : std::nullopt);
        fillMagnifications();
        showDescription();
        replotAll();
    });
    connect(m_readMeasured, &QAction::triggered, this, [this] {
        if (auto section = MeasuredSection::ask(
                window(), good() ? good()->result.project.part->diameter_mm / 2 : 1)) {
            showMeasured(std::move(section));
        }
    });
    connect(m_removeMeasured, &QAction::triggered, this, [this] { showMeasured(std::nullopt); });
}

void ProfilesView::showMeasured(std::optional<MeasuredSection> measured) {
    m_removeMeasured->setEnabled(measured.has_value());
    m_across->setMeasured(std::move(measured));
    fillMagnifications();
    showDescription();
    replotAll();
}

// --- displayed profiles -------------------------------------------------------------------------

void ProfilesView::takeOutcome(const OutcomePtr& before) {
    if (hasOtherPlaces(before)) {
        m_chosen.reset();
    }
    if (before
        && before->result.project.part->diameter_mm != good()->result.project.part->diameter_mm) {
        showMeasured(std::nullopt); // it belonged to another part
    }
    fillStrokes();
    fillSections();
    showSeries();
}

bool ProfilesView::recorded() const {
    return good() && !good()->trajectory.passes.empty();
}

int ProfilesView::stroke() const {
    const CycleCursor* const at = cycleIn(good());
    return at && !at->atEnd() ? at->stroke() : good() ? good()->result.cycleCount : 0;
}

void ProfilesView::showSeries() {
    if (!good()) {
        return;
    }
    const CycleCursor* const at = cycleIn(good());
    ProfileSeries series =
        makeProfileSeries(good()->result, good()->trajectory,
                          at && !at->atEnd() ? std::optional(at->progress()) : std::nullopt);
    if (!series.zoneSections.empty()) {
        series.zoneForms = good()->accuracy.zones;
    }
    const std::vector<int> shown = shownProfiles();
    m_across->setSeries(series, shown);
    m_along->setSeries(series, shaftSteps(good()->result.project), shown);
    showSpectrum();
    fillMagnifications();
    showStroke();
    showDescription();
}

/// Shows the spectra of the profiles in the cross-sections; nothing is computed while it is hidden.
void ProfilesView::showSpectrum() {
    if (good() && showsSpectrum()) {
        m_spectrum->remake();
        m_spectrum->refit();
    }
}

ChartGrid ProfilesView::spectra() const {
    if (!good() || !showsSpectrum()) {
        return {};
    }
    return SpectrumCharts::of(m_across->series(), m_across->shown(), m_logarithmic->isChecked(),
                              [this](ProfileLine line) { return !m_hidden.contains(line); });
}

void ProfilesView::hideInSpectrum() {
    for (const ProfileLine line : SpectrumCharts::lines) {
        if (m_spectrum->shows(static_cast<int>(line)) == m_hidden.contains(line)) {
            m_spectrum->toggleCurve(static_cast<int>(line));
        }
    }
}

QString ProfilesView::keptText() const {
    return tr("The inputs are refused; the profiles are those of the last valid inputs.");
}

QString ProfilesView::remark() const {
    const RunStatus status = good()->result.status;
    return status == RunStatus::completed ? QString() : Names::status(status);
}

QString ProfilesView::noticeText() const {
    QStringList lines{PlotView::noticeText()};
    if (good() && !recorded()) {
        lines << tr("The cycle is too long to be recorded: only its end is shown.");
    }
    if (good()) {
        lines << Names::uncutStrips(good()->result.project);
    }
    return joined(lines, QStringLiteral("\n"));
}

void ProfilesView::showState() {
    PlotView::showState();
    showParts();
}

ProfilesView::Parts ProfilesView::parts() const {
    return static_cast<Parts>(std::max(m_parts->currentIndex(), 0));
}

bool ProfilesView::showsAcross() const {
    return parts() != Parts::length && parts() != Parts::spectrum;
}

bool ProfilesView::showsAlong() const {
    return parts() == Parts::sectionsAndLength || parts() == Parts::length;
}

bool ProfilesView::showsSpectrum() const {
    return parts() == Parts::sectionsAndSpectrum || parts() == Parts::spectrum;
}

/// Hides the tools of hidden plots, too.
void ProfilesView::showParts() {
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_across, m_acrossExport, m_magnification, m_reference,
                                         m_circles, m_filter, m_measured}) {
        w->setVisible(showsAcross());
    }
    for (QWidget* w : std::initializer_list<QWidget*>{m_along, m_alongExport, m_cursorsButton,
                                                      m_quantity, m_toScale}) {
        w->setVisible(showsAlong());
    }
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_spectrum, m_spectrumExport, m_logarithmic}) {
        w->setVisible(showsSpectrum());
    }
    m_quantity->setEnabled(good() && !m_toScale->isChecked());
}

// --- the moment ---------------------------------------------------------------------------------

void ProfilesView::fillStrokes() {
    const int count = good()->result.cycleCount;
    const QSignalBlocker sliderBlocker(m_slider);
    const QSignalBlocker numberBlocker(m_number);
    m_slider->setRange(0, count);
    m_slider->setPageStep(std::max(count / 10, 1));
    m_number->setRange(0, count);
}

void ProfilesView::showStroke() {
    const QSignalBlocker sliderBlocker(m_slider);
    const QSignalBlocker numberBlocker(m_number);
    const int number = stroke();
    m_slider->setValue(number);
    m_number->setValue(number);
    const bool strokes = !good() || good()->result.project.operation->travels;
    m_strokeLabel->setText(strokes ? tr("Double stroke") : tr("Revolution"));
    m_number->setSuffix(tr(" of %1").arg(m_slider->maximum()));
    const bool can = recorded();
    m_previous->setEnabled(can && number > 0);
    m_next->setEnabled(can && number < m_slider->maximum());
    const QString moment = good() ? ProfilesText::moment(m_across->series()) : QString();
    for (QWidget* w : std::initializer_list<QWidget*>{m_slider, m_number}) {
        w->setEnabled(can);
        w->setToolTip(moment);
        w->setAccessibleDescription(moment);
    }
}

void ProfilesView::setStroke(int number) {
    if (good() && number >= good()->result.cycleCount) {
        cycle().setPosition(cycle().count());
    } else if (good()) {
        cycle().toStroke(number);
    }
}

void ProfilesView::followCycle() {
    showSeries();
    replotAll();
}

void ProfilesView::showSection(int section) {
    redraw();
    if (good()) {
        setStroke(good()->result.cycleCount);
        m_section->setCurrentIndex(std::max(m_section->findData(section), 0));
    }
}

// --- choices of the user ------------------------------------------------------------------------

std::vector<int> ProfilesView::shownProfiles() const {
    const SimulationResult& result = good()->result;
    const int count = static_cast<int>(result.sections.size());
    const bool many = count > mostCells;
    if (m_chosen && (!many || m_alone->isChecked())) {
        return {std::clamp(*m_chosen, 0, count - 1)};
    }
    return shownSections(count, gaugeProfile(result), m_chosen, mostCells);
}

void ProfilesView::fillSections() {
    const QSignalBlocker blocker(m_section);
    m_section->clear();
    if (!good()) {
        return;
    }
    const auto& sections = good()->result.sections;
    const bool zones = good()->result.project.operation->travels;
    const int count = static_cast<int>(sections.size());
    m_section->addItem(zones               ? tr("All zones")
                       : count > mostCells ? tr("Evenly chosen")
                                           : tr("All sections"),
                       -1);
    for (int i = 0; i < count; ++i) {
        m_section->addItem(Names::zone(sections[static_cast<std::size_t>(i)].zone, i), i);
    }
    m_section->setCurrentIndex(std::clamp(m_chosen.value_or(-1) + 1, 0, count));
    m_alone->setVisible(count > mostCells);
    m_alone->setEnabled(m_chosen.has_value());
}

void ProfilesView::onSection(int index) {
    const int chosen = m_section->itemData(index).toInt();
    m_chosen = chosen < 0 ? std::nullopt : std::optional<int>(chosen);
    m_alone->setEnabled(m_chosen.has_value());
    showSeries();
    m_across->fit();
    replotAll();
}

/// Adds a section clicked along the axis to those shown if not all fit.
void ProfilesView::choose(int profile) {
    if (m_section->count() > mostCells + 1) {
        m_section->setCurrentIndex(m_section->findData(profile));
    }
}

void ProfilesView::fillMagnifications() {
    const QSignalBlocker blocker(m_magnification);
    m_magnification->clear();
    const QString used = ProfilesText::magnification(m_across->magnification());
    m_magnification->addItem(m_wantedMagnification ? tr("Auto") : tr("Auto: %1").arg(used), 0.0);
    for (const double value : m_across->magnifications()) {
        m_magnification->addItem(ProfilesText::magnification(value), value);
        if (m_wantedMagnification && value <= *m_wantedMagnification) {
            m_magnification->setCurrentIndex(m_magnification->count() - 1);
        }
    }
}

void ProfilesView::onMagnification(int index) {
    const double value = m_magnification->itemData(index).toDouble();
    m_wantedMagnification = value > 0 ? std::optional<double>(value) : std::nullopt;
    m_across->setMagnification(m_wantedMagnification);
    fillMagnifications();
    replotAll();
}

void ProfilesView::toggleCurve(int key) {
    const auto line = static_cast<ProfileLine>(key);
    if (!m_hidden.erase(line)) {
        m_hidden.insert(line);
    }
    showHidden();
}

/// Hides all other lines; called again, shows all.
void ProfilesView::showOnly(int key) {
    const std::vector<ProfileLine> all = legendLines();
    ProfileLines others(all.begin(), all.end());
    others.erase(static_cast<ProfileLine>(key));
    const bool alone = m_hidden == others;
    m_hidden = alone ? ProfileLines() : others;
    showHidden();
}

void ProfilesView::showHidden() {
    const QSignalBlocker blocker(m_blank);
    m_blank->setChecked(!m_hidden.contains(ProfileLine::blank));
    m_across->setHidden(m_hidden);
    m_along->setHidden(m_hidden);
    hideInSpectrum();
    fillMagnifications();
    showLegend();
    replotAll();
}

// --- texts --------------------------------------------------------------------------------------

std::vector<ProfileLine> ProfilesView::legendLines() const {
    using enum ProfileLine;
    std::vector<ProfileLine> lines;
    switch (parts()) {
    case Parts::sections:
    case Parts::sectionsAndSpectrum: return m_across->lines();
    case Parts::length: return m_along->lines();
    case Parts::spectrum: return {profile, blank};
    case Parts::sectionsAndLength:
        lines = m_across->lines();
        lines.insert(lines.begin() + 1, spread);
        lines.push_back(gauge);
    }
    return lines;
}

void ProfilesView::showLegend() {
    legend()->setEntries(m_across->entriesOf(legendLines()));
}

void ProfilesView::showDescription() {
    const QString measured = m_across->describeMeasured();
    const QString text = ProfilesText::summary(m_across->series(), m_across->shown())
                         + (measured.isEmpty() ? QString() : QStringLiteral(". ") + measured);
    setAccessibleDescription(text);
    m_across->setAccessibleDescription(text + QStringLiteral(". ") + m_across->caption());
    m_along->setAccessibleDescription(text);
    m_spectrum->setAccessibleDescription(text);
}

QString ProfilesView::brief() const {
    return tr("Profiles", "the view's tab");
}

QString ProfilesView::title() const {
    return tr("Zone profiles");
}

void ProfilesView::nameParts() {
    nameAround(tr("Legend of the curves"), tr("State of the profiles"),
               tr("Values under the pointer"));
    m_across->setAccessibleName(tr("Cross-sections with magnified deviations"));
    m_along->setAccessibleName(tr("Profile along the axis"));
    m_spectrum->setAccessibleName(tr("Spectra of the cross-sections"));
    fillChoice(*m_parts, {tr("Sections and length"), tr("Sections only"), tr("Length only"),
                          tr("Sections and spectrum"), tr("Spectrum only")});
    nameCircles();
    fillChoice(*m_reference, {tr("from target"), tr("from own mean")});
    fillChoice(*m_quantity, {tr("Radii"), tr("Diameters")});
    m_alone->setText(tr("Only this"));
    m_blank->setText(tr("Blank"));
    m_toScale->setText(tr("To scale"));
    m_logarithmic->setText(tr("Logarithmic"));
    tell(*m_parts, tr("Displayed content"));
    tell(*m_section, tr("Zone or section to show"));
    tell(*m_alone, tr("Only the chosen section, large"));
    tell(*m_magnification, tr("Magnification of the deviations, the same for all; "
                              "×1 is the true shape"));
    tell(*m_reference, tr("Radius from which deviations are measured: the target shows size and "
                          "form, the own mean shows only form"));
    tell(*m_logarithmic, tr("Amplitudes on a logarithmic axis"));
    tell(*m_blank, tr("The profile before the first touch"));
    tell(*m_fit, tr("Show all in both plots; in one of them: Home, or a double click in it. "
                    "Wheel: zoom. Drag: move."));
    tell(*m_previous, tr("Previous"));
    tell(*m_next, tr("Next"));
    tell(*m_quantity, tr("Along the axis: deviations of radii from the target, or of diameters "
                         "from nominal"));
    tell(*m_toScale, tr("The part along its axis without exaggeration"));
    m_slider->setAccessibleName(tr("Moment of the cycle"));
    m_number->setAccessibleName(tr("Moment of the cycle"));
    m_number->setSpecialValueText(tr("blank", "before the first stroke"));
    if (good()) {
        fillSections();
        fillMagnifications();
        showStroke();
        showDescription();
    }
}

void ProfilesView::nameCircles() {
    fillChoice(*m_circles, {tr("LSCI"), tr("MZCI"), tr("MICI"), tr("MCCI"), tr("none")});
    QStringList filters{ProfilesText::filter(std::nullopt)};
    for (const int cutoff : roundnessCutoffs_upr) {
        filters << tr("%1 UPR").arg(cutoff);
    }
    fillChoice(*m_filter, filters);
    m_measured->setText(tr("Measured"));
    m_readMeasured->setText(tr("&Read a measured profile…"));
    m_removeMeasured->setText(tr("&Remove profile"));
    tell(*m_circles, tr("Reference circles of the roundness (ISO 12181): LSCI, the least-squares "
                        "circle; MZCI, the two circles of the minimum zone; MICI, the maximum "
                        "inscribed, or MCCI, the minimum circumscribed circle"));
    tell(*m_filter,
         tr("Gaussian filter of the cross-sections (ISO 16610-21): keeps waves up to about this "
            "number of undulations per revolution, as on roundness machines"));
    tell(*m_measured, tr("A profile recorded by a roundness machine, beside the predicted ones: a "
                         "table of the angle in ° and the radius in mm or its deviation in µm"));
}

QString ProfilesView::hint() const {
    return tr("Point at a profile to read its values.");
}

} // namespace sparkout
