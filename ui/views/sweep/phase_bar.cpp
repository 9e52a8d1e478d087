// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/phase_bar.h"

#include "core/format/project_file.h"
#include "core/project/number_input.h"
#include "ui/fields/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/plot/plot_view.h"
#include "ui/plot/run_bar.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr int phaseFieldWidth = 74;  ///< [px]
constexpr double fineness_mm = 1e-6; ///< resolution of the usual range

double roundedStock(double stock_mm) {
    return std::round(stock_mm / fineness_mm) / std::round(1 / fineness_mm);
}

} // namespace

PhaseBar::PhaseBar(QWidget* parent)
    : QWidget(parent)
    , m_job(new Job(this))
    , m_from(new NumberField({}, this))
    , m_to(new NumberField({}, this))
    , m_dash(new QLabel(QStringLiteral("…"), this))
    , m_unit(new QLabel(this))
    , m_bar(new RunBar(QStringLiteral("phases"), this, PhaseText::progress)) {
    m_from->setObjectName(QStringLiteral("phasesFrom"));
    m_to->setObjectName(QStringLiteral("phasesTo"));
    m_unit->setTextFormat(Qt::PlainText);
    m_bar->layOut({m_from, m_dash, m_to, m_unit}, {});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_bar);
    addEnd(*m_from, &PhaseBar::m_ownFrom_mm, &StockRange::from_mm);
    addEnd(*m_to, &PhaseBar::m_ownTo_mm, &StockRange::to_mm);
    m_bar->follow(*m_job);
    connect(m_bar->run(), &QPushButton::clicked, this, [this] {
        run();
        emit changed();
    });
}

void PhaseBar::addEnd(NumberField& field, std::optional<double> PhaseBar::*own,
                      double StockRange::*end) {
    setTextWidth(field, phaseFieldWidth);
    connect(&field, &QLineEdit::editingFinished, this, [this, &field, own, end] {
        if (m_project && !field.refused() && field.value() != range().*end) {
            this->*own = field.value(); // empty: the usual one
            showRange();
            decide();
            emit changed();
        }
    });
}

// --- deciding -----------------------------------------------------------------------------------

StockRange PhaseBar::range() const {
    const StockRange usual = usualPhases(*m_project);
    return {m_ownFrom_mm.value_or(roundedStock(usual.from_mm)),
            m_ownTo_mm.value_or(roundedStock(usual.to_mm))};
}

bool PhaseBar::canRun() const {
    return m_project && canDecidePhases(*m_project) && range().from_mm <= range().to_mm;
}

void PhaseBar::follow(const Project& project) {
    m_project = project;
    showRange();
    decide();
    emit changed();
}

void PhaseBar::forget() {
    m_job->drop();
    m_project.reset();
    m_ownFrom_mm.reset();
    m_ownTo_mm.reset();
    m_phases.reset();
    m_stale = true;
    emit changed();
}

void PhaseBar::noteStale() {
    m_stale = !m_phases || m_phases->decision.range != range()
              || !sameProject(m_phases->project, *m_project);
}

void PhaseBar::decide() {
    noteStale();
    if (!canRun()) {
        m_job->drop();
        m_phases.reset();
        m_stale = true;
        return;
    }
    const bool runs = m_job->running() && m_running && m_running->decision.range == range()
                      && sameProject(m_running->project, *m_project);
    if (!m_stale) {
        m_job->drop();
    } else if (!runs) {
        run();
    }
}

void PhaseBar::run() {
    m_running = PhaseOutcome{*m_project, {}};
    m_running->decision.range = range();
    m_bar->showProgress(0, 1);
    m_job->start(
        1,
        [project = *m_project, stocks = range()](const Job::Means& means) {
            return std::make_shared<const PhaseOutcome>(
                PhaseOutcome{project, decidePhases(project, stocks, means.stop)});
        },
        [this](const PhaseOutcomePtr& outcome) { take(outcome); });
}

void PhaseBar::take(const PhaseOutcomePtr& phases) {
    if (phases->decision.isDecided || phases->decision.hasTooMany) {
        m_phases = phases;
        noteStale();
    }
    emit changed();
}

// --- showing ------------------------------------------------------------------------------------

void PhaseBar::showRange() {
    const auto input = numberInput(*m_project, "/part/stock_mm");
    NumberSpec spec;
    spec.hard = input->allowed;
    spec.soft = input->field->soft;
    spec.unit = input->field->unit;
    spec.optional = true;
    spec.scale = ShownScale::of(*input->field);
    m_unit->setText(unitText(spec.unit));
    for (const auto& [field, value] :
         {std::pair{m_from, range().from_mm}, std::pair{m_to, range().to_mm}}) {
        if (!field->typing()) { // otherwise typed text is applied when complete
            field->setSpec(spec);
            field->setValue(value);
        }
    }
}

QString PhaseBar::remark() const {
    if (!m_project) {
        return {};
    }
    if (!canDecidePhases(*m_project)) {
        return PhaseText::undecidable();
    }
    if (range().from_mm > range().to_mm) {
        return tr("The upper end of the range must lie above the lower end: it begins at %1 mm and "
                  "ends at %2 mm.")
            .arg(PhaseText::millimetres(range().from_mm), PhaseText::millimetres(range().to_mm));
    }
    if (m_phases && !m_stale) {
        const QString share = PhaseText::share(*m_project, m_phases->decision);
        return PhaseText::verdict(m_phases->decision)
               + (share.isEmpty() ? QString() : u'\n' + share);
    }
    if (busy()) {
        return m_phases ? StudyView::staleText(true, {}) : QString();
    }
    return m_phases ? StudyView::staleText(false, m_bar->run()->text())
                    : tr("Stopped before there was a result. Press “Run”.");
}

void PhaseBar::showState(bool accepted) {
    const bool decidable = m_project && canDecidePhases(*m_project);
    for (QWidget* part : {static_cast<QWidget*>(m_from), static_cast<QWidget*>(m_to)}) {
        part->setEnabled(accepted && decidable);
    }
    m_bar->showRunning(busy(), accepted && canRun());
    m_bar->state()->setText(m_phases ? PhaseText::counted(m_phases->decision) : QString());
}

void PhaseBar::retranslate() {
    const auto name = [](QWidget& widget, const QString& text) {
        widget.setAccessibleName(text);
        widget.setToolTip(text);
    };
    name(*m_from, tr("Minimum stock per side to check; empty: half the maximum infeed below the "
                     "given stock"));
    name(*m_to, tr("Maximum stock per side to check; empty: half the maximum infeed above the "
                   "given stock"));
    m_bar->run()->setText(tr("Run"));
    name(*m_bar->run(),
         tr("Check all stocks of the range; this also starts by itself after an edit"));
    m_bar->stop()->setText(tr("Stop"));
    name(*m_bar->stop(), tr("Stop the run; the results so far are kept"));
    m_bar->state()->setAccessibleName(tr("Result"));
    m_bar->progress()->setAccessibleName(tr("Progress of the check"));
    m_from->retranslate();
    m_to->retranslate();
    if (m_project) {
        showRange();
    }
}

} // namespace sparkout
