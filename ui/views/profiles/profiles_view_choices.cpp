// SPDX-License-Identifier: GPL-3.0-or-later
// What the user can choose in the view of zone profiles.
#include "core/simulation/feed_series.h"
#include "ui/text/names.h"
#include "ui/views/profiles/longitudinal_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"
#include "ui/views/profiles/profiles_view.h"
#include "ui/views/profiles/spectrum_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace sparkout {

namespace {
constexpr int mostCells = 4; ///< cross-sections side by side
}

std::vector<int> ProfilesView::shownProfiles() const {
    const SimulationResult& result = m_good->result;
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
    if (!m_good) {
        return;
    }
    const auto& sections = m_good->result.sections;
    const bool zones = m_good->result.project.operation->hasZones;
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

/// A section clicked along the axis joins those shown, where not all have room.
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

ProfileLines ProfilesView::hiddenAcross() const {
    ProfileLines hidden = m_hidden;
    if (m_across->circles() != ReferenceCircles::leastSquares) {
        hidden.insert(ProfileLine::leastSquares);
    }
    if (m_across->circles() != ReferenceCircles::minimumZone) {
        hidden.insert(ProfileLine::minimumZone);
    }
    return hidden;
}

void ProfilesView::toggle(ProfileLine line) {
    if (!m_hidden.erase(line)) {
        m_hidden.insert(line);
    }
    showHidden();
}

/// Hides all other lines; asked again, shows all.
void ProfilesView::showOnly(ProfileLine line) {
    const std::vector<ProfileLine> all = legendLines();
    ProfileLines others(all.begin(), all.end());
    others.erase(line);
    const bool alone = m_hidden == others;
    m_hidden = alone ? ProfileLines() : others;
    showHidden();
}

void ProfilesView::showHidden() {
    const QSignalBlocker blocker(m_blank);
    m_blank->setChecked(!m_hidden.contains(ProfileLine::blank));
    m_across->setHidden(m_hidden);
    m_along->setHidden(m_hidden);
    m_spectrum->setHidden(m_hidden);
    fillMagnifications();
    showLegend();
    replotAll();
}

} // namespace sparkout
