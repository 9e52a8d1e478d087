// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/constraints/constraints_view.h"

#include "core/process/coupled_sections.h"
#include "core/quality/constraint_sheet.h"
#include "ui/charts/light_icon.h"
#include "ui/charts/margin_model.h"
#include "ui/charts/verdict_why.h"
#include "ui/dialogs/copy_table.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/plot/cursor_strip.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/estimate_names.h"
#include "ui/text/formula_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/views/constraints/constraints_plot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>

#include <algorithm>

namespace sparkout {

namespace {

constexpr int leastColumn = 60; ///< of the margins, at the usual size of type

/// Stock left by the newest cut of a group at a moment of the cycle, at its deepest radius [mm].
std::optional<double> stockAt(const Outcome& outcome, int group, const Progress& moment) {
    const Trajectory& trajectory = outcome.trajectory;
    for (std::size_t i = moment.end; i-- > 0;) {
        const Pass& pass = trajectory.passes[i];
        if (limitGroupAt(outcome.limits, pass.place) != group) {
            continue;
        }
        const int radii = i < moment.open ? trajectory.radii : moment.radius + 1;
        const auto first = trajectory.visits.begin() + static_cast<std::ptrdiff_t>(pass.firstVisit);
        const auto deepest = std::ranges::max_element(first, first + radii, {}, &Visit::actual_mm);
        if (deepest->actual_mm > 0) {
            const LayerSeries& layers = outcome.layers;
            return layers.removalSign * (deepest->radius_mm - layers.target_mm);
        }
    }
    return std::nullopt;
}

/// Whether a limit that binds every cut is on.
bool feedIsLimited(const Outcome& outcome) {
    return std::ranges::any_of(outcome.limits.on, [](ConstraintKind kind) {
        return requirementOf(kind).bindsEveryPass();
    });
}

/// The same of the cuts of one zone or section: coupled sections share the power.
bool groupsAreLimited(const Outcome& outcome) {
    const bool coupled = isCoupled(outcome.result.project);
    return std::ranges::any_of(outcome.limits.on, [coupled](ConstraintKind kind) {
        const Requirement& row = requirementOf(kind);
        return row.bindsEveryPass() && !(coupled && row.sharedBySections);
    });
}

} // namespace

QString ConstraintsView::title() const {
    return tr("Constraints");
}

void ConstraintsView::forget() {
    m_plot->fitNext();
}

void ConstraintsView::showOutcome() {
    const bool ran = latest() && latest()->ran() && !latest()->result.sections.empty();
    if (ran) {
        const auto kind = [](const OutcomePtr& o) {
            return std::pair(o->result.project.operation, o->result.sections.size());
        };
        if (!m_good || kind(m_good) != kind(latest())) {
            m_group.reset();
            m_chosen.reset();
            m_plot->fitNext();
        }
        m_good = latest();
        m_model->setOutcome(m_good);
        fillGroups();
        showGroup(wantedGroup());
        selectChosen();
    }
    m_plot->setDimmed(m_good && !ran);
    showState();
    showSheet();
    m_plot->replot();
    m_tools->navigation().amendView();
    emit updated();
}

// --- zones --------------------------------------------------------------------------------------

void ConstraintsView::fillGroups() {
    const QSignalBlocker blocker(m_zone);
    const int current = m_zone->currentIndex();
    m_zone->clear();
    if (!m_good) {
        return;
    }
    const bool limited = groupsAreLimited(*m_good);
    for (const LimitGroup& group : m_good->limits.groups) {
        const QString name = LimitNames::group(group);
        m_zone->addItem(limited ? tr("%1 — %2").arg(name, LimitNames::percent(group.worst.usage))
                                : name);
    }
    m_zone->setCurrentIndex(std::min(current, m_zone->count() - 1));
}

ConstraintsView::GroupKey ConstraintsView::keyOf(const LimitGroup& group) {
    return {group.zone, group.section, group.standing};
}

/// The one the user chose, else the one that comes nearest to its limit.
int ConstraintsView::wantedGroup() const {
    const auto& groups = m_good->limits.groups;
    const auto same = [this](const LimitGroup& group) { return keyOf(group) == m_group; };
    const auto chosen = std::ranges::find_if(groups, same);
    if (chosen != groups.end() || groups.empty()) {
        return groups.empty() ? -1 : static_cast<int>(chosen - groups.begin());
    }
    const auto nearest = [](const LimitGroup& group) {
        return std::pair(group.worst.usage, group.worst.depth_mm);
    };
    return static_cast<int>(std::ranges::max_element(groups, {}, nearest) - groups.begin());
}

void ConstraintsView::followCycle() {
    const CycleCursor* const at = cycleIn(m_good);
    m_plot->setMoment(at && !at->atEnd() ? stockAt(*m_good, m_plot->group(), at->progress())
                                         : std::nullopt);
}

void ConstraintsView::showGroup(int group) {
    m_plot->setRun(m_good, group);
    followCycle();
    const QSignalBlocker blocker(m_zone);
    m_zone->setCurrentIndex(group);
}

// --- requirements -------------------------------------------------------------------------------

/// The chosen requirement with the numbers of this run.
std::optional<ConstraintResult> ConstraintsView::chosen() const {
    const int row = m_chosen ? m_model->rowOf(*m_chosen) : -1;
    return row >= 0 ? std::optional(m_model->at(row)) : std::nullopt;
}

void ConstraintsView::selectChosen() {
    const int row = m_chosen ? m_model->rowOf(*m_chosen) : -1;
    if (row >= 0) {
        const QSignalBlocker blocker(m_table->selectionModel());
        m_table->selectRow(row);
    }
    m_plot->setMarked(chosen());
}

void ConstraintsView::choose(int row) {
    m_chosen = m_model->at(row);
    if (m_chosen->at || m_chosen->section >= 0) {
        Place place;
        place.zone = m_chosen->zone;
        place.section = std::max(m_chosen->section, 0);
        place = m_chosen->at.value_or(place);
        const int group = limitGroupAt(m_good->limits, place);
        if (group >= 0) {
            m_group = keyOf(m_good->limits.groups[static_cast<std::size_t>(group)]);
            showGroup(group);
        }
    }
    m_plot->setMarked(m_chosen);
    m_plot->replot();
    m_tools->navigation().amendView();
    showSheet();
    emit requirementChosen(*m_chosen);
}

void ConstraintsView::showSheet() {
    const std::optional<ConstraintResult> about = m_good ? chosen() : std::nullopt;
    m_goTo->setEnabled(about.has_value());
    QStringList text;
    if (!about) {
        text << tr("Choose a requirement to see where it was worst and how its number came about.");
    } else {
        text << verdict::why(*m_good, *about);
        if (text.back().isEmpty()) {
            text.back() = tr("%1, %2: a setting held against its range.")
                              .arg(Names::constraint(about->kind), Names::where(*about));
        }
        if (const auto sheet = constraintSheet(m_good->result, m_good->accuracy, *about)) {
            text << QString() << formulaText(*sheet);
        }
        if (const QString estimates = EstimateNames::behind(about->kind); !estimates.isEmpty()) {
            text << QString() << estimates;
        }
    }
    m_sheet->setPlainText(text.join(u'\n'));
}

// --- texts --------------------------------------------------------------------------------------

void ConstraintsView::showState() {
    const bool refused = latest() && !latest()->ran();
    const bool drawn = m_good && !m_good->limits.groups.empty();
    QString text;
    if (refused) {
        text =
            (m_good ? tr("The inputs are refused; the curves are those of the last accepted ones.")
                    : tr("The inputs are refused:"))
            + QLatin1Char('\n') + Names::refusal(latest()->issues, 2);
    } else if (!m_good) {
        text = tr("No result yet.");
    } else if (!drawn) {
        text = tr("The cycle is too long to be recorded: its cuts are not drawn. Fewer radii or "
                  "sections help; the requirements below are of the whole cycle.");
    } else if (!feedIsLimited(*m_good)) {
        text = tr("No limit of the feed is on, so any feed is allowed: enter what burns the "
                  "material, or the power of a drive. The links below lead to the fields.");
    } else if (m_good->result.status != RunStatus::completed) {
        text = Names::status(m_good->result.status);
    } else if (!groupsAreLimited(*m_good)) {
        text = tr("Coupled sections share the power of the drives, so it limits no section's feed "
                  "by itself. The requirements below hold it against the whole length.");
    }
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    m_off->clear(); // links take the palette's colour when the text is another
    m_off->setText(m_good ? LimitNames::missingLinks(m_good->result.project) : QString());
    m_off->setVisible(m_good && !m_off->text().isEmpty());
    m_splitter->setVisible(m_good != nullptr);
    for (QWidget* part : std::initializer_list<QWidget*>{m_plot, m_legend, m_values}) {
        part->setVisible(drawn);
    }
    for (QWidget* tool : std::initializer_list<QWidget*>{m_zone, m_logarithmic}) {
        tool->setEnabled(drawn);
    }
    m_tools->setEnabled(drawn);
    m_legend->setEntries(m_plot->legendEntries());
}

void ConstraintsView::nameParts() {
    setAccessibleName(tr("Constraints"));
    m_plot->setAccessibleName(tr("Actual feed under its limits"));
    m_legend->setAccessibleName(tr("Legend of the curves"));
    m_notice->setAccessibleName(tr("State of the curves"));
    m_values->setAccessibleName(tr("Values under the mouse"));
    m_off->setAccessibleName(tr("Requirements that are not checked"));
    m_table->setAccessibleName(tr("Requirements by how much of their limit they use up"));
    m_sheet->setAccessibleName(tr("How the number came about"));
    m_logarithmic->setText(tr("Logarithmic"));
    m_places->setText(tr("Every place"));
    m_goTo->setText(tr("Show where"));
    const auto tell = [](QWidget* widget, const QString& text) {
        widget->setAccessibleName(text);
        widget->setToolTip(text);
    };
    m_table->retranslate();
    m_table->horizontalHeader()->setMinimumSectionSize(atFontSize(leastColumn));
    tell(m_zone, tr("Zone or section; in a reversal zone the wheel stands or travels, which "
                    "differ in the width of cut. With the share of its limit it comes to."));
    tell(m_logarithmic, tr("Actual feeds on a logarithmic axis: sparking out and far limits in "
                           "one picture"));
    tell(m_places, tr("Every zone, section and stage; else the worst of each requirement"));
    tell(m_goTo, tr("To the passes, the profile or the field behind the requirement; also Enter "
                    "or a double click on its row"));
    readOut();
}

void ConstraintsView::retranslate() {
    nameParts();
    m_tools->retranslate();
    m_strip->retranslate();
    m_legend->retranslate();
    m_plot->retranslate();
    m_model->retranslate();
    drawIcons();
    fillGroups();
    showState();
    showSheet();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ConstraintsView::drawIcons() {
    const auto icon = [this](Light light) {
        return QIcon(lightPixmap(light, metrics::iconSmall, devicePixelRatioF(), false));
    };
    m_model->setIcons({icon(Light::holds), icon(Light::close), icon(Light::fails)});
}

QString ConstraintsView::hint() const {
    return tr("Point at the curve to read the values.");
}

void ConstraintsView::recolour() {
    drawIcons();
    showState();
}

} // namespace sparkout
