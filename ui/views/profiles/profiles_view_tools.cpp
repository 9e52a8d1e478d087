// SPDX-License-Identifier: GPL-3.0-or-later
// The widgets of the view of zone profiles: building, naming and connecting.
#include "ui/views/profiles/profiles_view.h"

#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"
#include "ui/kit/tool_row.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/names.h"
#include "ui/views/profiles/longitudinal_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_table.h"
#include "ui/views/profiles/profiles_text.h"
#include "ui/views/profiles/spectrum_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace sparkout {

namespace {}

ProfilesView::ProfilesView(QWidget* parent, Settings* settings) : View(parent) {
    setObjectName(QStringLiteral("profiles"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(4);
    auto* bar = new QWidget(this);
    m_strokeBar = new QWidget(this);
    m_notice = new QLabel(this);
    m_values = new QLabel(this);
    m_legend = new LegendStrip(this);
    m_splitter = new QSplitter(Qt::Vertical, this);
    m_across = new ProfilesPlot(m_splitter);
    m_along = new LongitudinalPlot(m_splitter);
    m_spectrum = new SpectrumPlot(m_splitter);
    m_across->setMinimumSize(200, 120);
    m_along->setMinimumSize(200, 110);
    m_spectrum->setMinimumSize(200, 110);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setStretchFactor(0, 5);
    m_splitter->setStretchFactor(1, 3);
    m_splitter->setStretchFactor(2, 3);
    m_splitter->setSizes({500, 300, 300});
    buildPlotTools(settings);
    buildSpectrumTools(settings);
    buildToolBar(bar);
    buildStrokeBar(m_strokeBar);
    setUpNotice(*m_notice);
    setUpReadout(*m_values);
    layout->addWidget(bar);
    layout->addWidget(m_strokeBar);
    layout->addWidget(m_notice);
    layout->addWidget(m_legend);
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_strip);
    layout->addWidget(m_values);
    layout->addStretch();
    nameObjects();
    m_across->setHidden(m_hidden);
    m_along->setHidden(m_hidden);
    m_spectrum->setHidden(m_hidden);
    connectTools();
    connectPlots();
    built();
}

QStringList ProfilesView::headingOf(const QString& plot) const {
    QStringList heading{tr("%1: %2").arg(title(), plot)};
    if (m_good) {
        heading << QString::fromStdString(m_good->result.project.title).simplified()
                << ProfilesText::moment(m_across->series())
                << Names::uncutStrips(m_good->result.project);
    }
    heading.removeAll(QString());
    return heading;
}

void ProfilesView::buildPlotTools(Settings* settings) {
    PlotSubject across, along;
    across.name = [] { return tr("cross-sections"); };
    across.icon = u"export_sections";
    along.name = [] { return tr("along the axis"); };
    along.icon = u"export_length";
    across.heading = [this] { return headingOf(tr("cross-sections")); };
    across.legend = [this] { return entriesOf(acrossLines(), m_across->palette()); };
    across.table = [this] {
        return ProfilesTable::across(m_across->series(), m_across->shown(), hiddenAcross());
    };
    across.navigation.fit = [this] { m_across->fit(); };
    across.navigation.state = [this] { return m_across->sight(); };
    across.navigation.setState = [this](const auto& state) { m_across->setSight(state); };
    along.heading = [this] { return headingOf(tr("along the axis")); };
    along.legend = [this] {
        using enum ProfileLine;
        return entriesOf({profile, spread, target, field, blank, gauge}, m_along->palette());
    };
    along.table = [this] {
        return ProfilesTable::along(m_across->series(), m_along->quantity(), m_hidden);
    };
    along.navigation.fit = [this] { m_along->fit(); };
    along.navigation.state = [this] { return m_along->sight(); };
    along.navigation.setState = [this](const auto& state) { m_along->setSight(state); };
    m_acrossTools = new PlotTools(*m_across, std::move(across));
    m_alongTools = new PlotTools(*m_along, std::move(along));
    m_acrossTools->setSettings(settings);
    m_alongTools->setSettings(settings);
    m_cursors = new PlotCursors(*m_along, m_along->cursorSubject());
    m_strip = new CursorStrip(*m_cursors, this);
    m_alongTools->addTool(m_cursors->toggle);
}

void ProfilesView::buildSpectrumTools(Settings* settings) {
    PlotSubject subject;
    subject.heading = [this] { return headingOf(tr("spectra of the cross-sections")); };
    subject.legend = [this] {
        return entriesOf({ProfileLine::profile, ProfileLine::blank}, m_spectrum->palette());
    };
    subject.table = [this] { return m_spectrum->table(); };
    subject.navigation.fit = [this] { m_spectrum->fit(); };
    m_spectrumTools = new PlotTools(*m_spectrum, std::move(subject));
    m_spectrumTools->setSettings(settings);
}

void ProfilesView::buildToolBar(QWidget* bar) {
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    m_parts = new QComboBox(bar);
    m_section = new QComboBox(bar);
    m_alone = new QToolButton(bar);
    m_magnification = new QComboBox(bar);
    m_reference = new QComboBox(bar);
    m_circles = new QComboBox(bar);
    m_fit = new QToolButton(bar);
    m_alone->setCheckable(true);
    m_fit->setIcon(themeIcon(u"fit"));
    m_fit->setAutoRaise(true);
    for (QToolButton* button : {m_alone, m_fit}) {
        button->setFocusPolicy(Qt::TabFocus);
    }
    for (QComboBox* box : {m_parts, m_section, m_circles, m_magnification, m_reference}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    }
    for (QWidget* w : std::initializer_list<QWidget*>{m_parts, m_section, m_alone}) {
        row->addWidget(w);
    }
    row->addStretch();
    m_acrossExport = m_acrossTools->exportButton(bar);
    for (QWidget* w : std::initializer_list<QWidget*>{m_circles, m_reference, m_magnification,
                                                      m_fit, m_acrossExport}) {
        row->addWidget(w);
    }
}

void ProfilesView::buildStrokeBar(QWidget* bar) {
    auto* row = new ToolRow(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
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
    for (QWidget* w : std::initializer_list<QWidget*>{m_strokeLabel, m_previous}) {
        row->addWidget(w);
    }
    row->addWidget(m_slider, 1);
    for (QWidget* w : std::initializer_list<QWidget*>{m_next, m_number, m_blank, m_quantity,
                                                      m_toScale, m_logarithmic}) {
        row->addWidget(w);
    }
    m_cursorsButton = PlotTools::button(m_cursors->toggle, bar);
    row->addWidget(m_cursorsButton);
    m_alongExport = m_alongTools->exportButton(bar);
    row->addWidget(m_alongExport);
    m_spectrumExport = m_spectrumTools->exportButton(bar);
    row->addWidget(m_spectrumExport);
}

void ProfilesView::nameObjects() {
    const std::pair<QWidget*, const char*> names[] = {
        {m_parts, "parts"},
        {m_section, "section"},
        {m_alone, "alone"},
        {m_blank, "blank"},
        {m_reference, "reference"},
        {m_circles, "circles"},
        {m_logarithmic, "logarithmicSpectrum"},
        {m_magnification, "magnification"},
        {m_fit, "fit"},
        {m_slider, "strokeSlider"},
        {m_number, "stroke"},
        {m_previous, "previous"},
        {m_next, "next"},
        {m_quantity, "quantity"},
        {m_toScale, "toScale"},
        {m_notice, "notice"},
        {m_values, "values"},
        {m_strokeLabel, "moment"},
    };
    for (const auto& [widget, name] : names) {
        widget->setObjectName(QLatin1String(name));
    }
}

/// Fills a box with texts in the present language and keeps the choice.
void ProfilesView::fillChoice(QComboBox* box, const std::vector<QString>& texts) {
    const QSignalBlocker blocker(box);
    const int index = std::max(box->currentIndex(), 0);
    box->clear();
    for (const QString& text : texts) {
        box->addItem(text);
    }
    box->setCurrentIndex(index);
}

void ProfilesView::buildLabels() {
    setAccessibleName(tr("Zone profiles"));
    m_across->setAccessibleName(tr("Cross-sections with magnified deviations"));
    m_along->setAccessibleName(tr("Profile along the axis"));
    m_spectrum->setAccessibleName(tr("Spectra of the cross-sections"));
    m_legend->setAccessibleName(tr("Legend of the curves"));
    m_notice->setAccessibleName(tr("State of the profiles"));
    m_values->setAccessibleName(tr("Values under the pointer"));
    fillChoice(m_parts, {tr("Sections and length"), tr("Sections only"), tr("Length only"),
                         tr("Sections and spectrum"), tr("Spectrum only")});
    fillChoice(m_circles, {tr("LSCI"), tr("MZCI"), tr("none")});
    fillChoice(m_reference, {tr("from target"), tr("from own mean")});
    fillChoice(m_quantity, {tr("Radii"), tr("Diameters")});
    m_alone->setText(tr("Only this"));
    m_blank->setText(tr("Blank"));
    m_toScale->setText(tr("To scale"));
    m_logarithmic->setText(tr("Logarithmic"));
    const auto tell = [](QWidget* widget, const QString& name) {
        widget->setAccessibleName(name);
        widget->setToolTip(name);
    };
    tell(m_parts, tr("What is in sight"));
    tell(m_section, tr("Zone or section to look at"));
    tell(m_alone, tr("Only the chosen section, large"));
    tell(m_magnification, tr("Magnification of the deviations, the same for all; "
                             "×1 is the true shape"));
    tell(m_reference, tr("Radius the deviations are counted from: the target shows size and "
                         "form, the own mean shows form alone"));
    tell(m_circles, tr("Reference circles of the roundness (ISO 12181): LSCI, the least-squares "
                       "circle, or MZCI, the two circles of the minimum zone"));
    tell(m_logarithmic, tr("Amplitudes on a logarithmic axis"));
    tell(m_blank, tr("The profile before the first touch"));
    tell(m_fit, tr("Show all in both plots; in one of them: Home, or a double click in it. "
                   "Wheel: zoom. Drag: move."));
    tell(m_previous, tr("Previous"));
    tell(m_next, tr("Next"));
    tell(m_quantity, tr("Along the axis: deviations of radii from the target, or of diameters "
                        "from nominal"));
    tell(m_toScale, tr("The part along its axis with nothing exaggerated"));
    m_slider->setAccessibleName(tr("Moment of the cycle"));
    m_number->setAccessibleName(tr("Moment of the cycle"));
    m_number->setSpecialValueText(tr("blank", "before the first stroke"));
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
    connect(m_circles, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_across->setCircles(static_cast<ReferenceCircles>(index));
        fillMagnifications();
        showLegend();
        replotAll();
    });
    connect(m_logarithmic, &QCheckBox::toggled, this, [this](bool on) {
        m_spectrum->setLogarithmic(on);
        m_spectrum->replot();
        m_spectrumTools->navigation().forgetViews(); // ranges of the other scale
    });
    connect(m_blank, &QCheckBox::toggled, this, [this] { toggle(ProfileLine::blank); });
    connect(m_fit, &QToolButton::clicked, this, &ProfilesView::fit);
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

void ProfilesView::connectPlots() {
    connect(m_legend, &LegendStrip::toggled, this,
            [this](int key) { toggle(static_cast<ProfileLine>(key)); });
    connect(m_legend, &LegendStrip::onlyAsked, this,
            [this](int key) { showOnly(static_cast<ProfileLine>(key)); });
    connect(m_across, &ProfilesPlot::pointed, this, &ProfilesView::readOut);
    connect(m_along, &LongitudinalPlot::pointed, this, &ProfilesView::readOut);
    connect(m_spectrum, &SpectrumPlot::pointed, this, &ProfilesView::readOut);
    connect(m_along, &LongitudinalPlot::profileClicked, this, &ProfilesView::choose);
}

} // namespace sparkout
