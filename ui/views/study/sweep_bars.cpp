// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/sweep_bars.h"

#include "core/file/project_file.h"
#include "core/project/wheel.h"
#include "ui/chart/plot_view.h"
#include "ui/form/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/search_combo.h"
#include "ui/kit/tool_row.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"
#include "ui/views/study/sweep_shown.h"

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
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
               + (m_phases->project.wheel->runout
                      ? u' ' + tr("Decided at four angles of the wheel, which runs out of true.")
                      : QString())
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

namespace {

constexpr int sweepFieldWidth = 74; ///< [px]

} // namespace

SweepAxisBox::SweepAxisBox(std::size_t place, QWidget* parent)
    : QWidget(parent)
    , m_place(place)
    , m_input(new SearchCombo(this))
    , m_from(new NumberField({}, this))
    , m_to(new NumberField({}, this))
    , m_dash(new QLabel(QStringLiteral("…"), this))
    , m_unit(new QLabel(this))
    , m_points(new QSpinBox(this))
    , m_ratios(new QCheckBox(this)) {
    m_input->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_unit->setTextFormat(Qt::PlainText);
    const Field& points = *tableOf<SweepAxis>().find("points");
    m_points->setRange(static_cast<int>(points.hard.low), static_cast<int>(points.hard.high));
    m_points->setKeyboardTracking(false);
    auto* row = new ToolRow(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::tight);
    row->addWidget(m_input, 1);
    for (NumberField* field : {m_from, m_to}) {
        setTextWidth(*field, sweepFieldWidth);
        row->addWidget(field);
        connect(field, &QLineEdit::editingFinished, this, &SweepAxisBox::onRange);
        if (field == m_from) {
            row->addWidget(m_dash);
        }
    }
    row->addWidget(m_unit);
    row->addWidget(m_points);
    row->addWidget(m_ratios);
    const QString name = QStringLiteral("sweep%1").arg(m_place + 1);
    m_input->setObjectName(name + QStringLiteral("Input"));
    m_from->setObjectName(name + QStringLiteral("From"));
    m_to->setObjectName(name + QStringLiteral("To"));
    m_points->setObjectName(name + QStringLiteral("Points"));
    m_ratios->setObjectName(name + QStringLiteral("Ratios"));
    connect(m_input, &QComboBox::activated, this, &SweepAxisBox::onInput);
    connect(m_points, &QSpinBox::valueChanged, this, &SweepAxisBox::onRange);
    connect(m_ratios, &QCheckBox::clicked, this, &SweepAxisBox::onRange);
    m_input->addItem(QString());
    showAxis({});
}

void SweepAxisBox::show(const Project& project) {
    const auto* const axes = project.sweep ? &project.sweep->inputs : nullptr;
    m_axis = axes && m_place < axes->size() ? std::optional((*axes)[m_place]) : std::nullopt;
    m_of = m_axis ? numberInput(project, m_axis->input) : std::nullopt;
    fillInputs(numberInputs(project));
    m_input->setEnabled(m_place == 0 || axes);
    showAxis(m_of);
}

/// Its English name in any language, its symbol and its key.
QString SweepAxisBox::wordsOf(const NumberInput& input) {
    const QString symbol = QString::fromUtf8(input.field->symbol);
    return QStringList{QString::fromUtf8(input.field->label), symbol, QString(symbol).remove(u'_'),
                       QString::fromStdString(input.path)}
        .join(u'\n');
}

/// Updates only after a change, since the list may be open. A removed input stays while it is
/// varied.
void SweepAxisBox::fillInputs(const std::vector<NumberInput>& inputs) {
    std::vector<std::string> paths;
    for (const NumberInput& input : inputs) {
        paths.push_back(input.path);
    }
    if (m_axis && !m_of) {
        paths.push_back(m_axis->input);
    }
    const QSignalBlocker blocker(m_input);
    if (paths != m_paths || m_input->count() != static_cast<int>(paths.size()) + 1) {
        m_paths = std::move(paths);
        m_input->clear();
        m_input->addItem(m_place == 0 ? tr("Choose an input to vary") : tr("no second input"));
        for (std::size_t i = 0; i < m_paths.size(); ++i) {
            const std::string& path = m_paths[i];
            const bool there = i < inputs.size();
            m_input->addItem(there ? SweepText::input(path)
                                   : tr("%1 (not in this project)").arg(SweepText::input(path)));
            if (there) {
                m_input->setItemData(int(i) + 1, wordsOf(inputs[i]), SearchCombo::wordsRole);
            }
        }
    }
    const auto at = m_axis ? std::ranges::find(m_paths, m_axis->input) : m_paths.end();
    m_input->setCurrentIndex(at == m_paths.end() ? 0 : static_cast<int>(at - m_paths.begin()) + 1);
    m_input->setToolTip(m_axis ? m_input->currentText() : m_input->accessibleName());
}

void SweepAxisBox::showAxis(const std::optional<NumberInput>& input) {
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_from, m_dash, m_to, m_unit, m_points, m_ratios}) {
        part->setVisible(m_axis.has_value());
    }
    if (!m_axis) {
        return;
    }
    NumberSpec spec;
    if (input) {
        spec.hard = input->allowed;
        spec.soft = input->field->soft;
        spec.unit = input->field->unit;
        spec.integer = input->integer;
        spec.scale = ShownScale::of(*input->field);
    }
    const QSignalBlocker points(m_points), ratios(m_ratios);
    const auto set = [&spec](NumberField& field, double value) {
        if (!field.typing()) { // otherwise typed text is applied when complete
            field.setSpec(spec);
            field.setValue(value);
        }
    };
    set(*m_from, m_axis->from);
    set(*m_to, m_axis->to);
    m_unit->setText(unitText(spec.unit));
    m_unit->setVisible(*spec.unit);
    m_points->setValue(m_axis->points);
    m_ratios->setChecked(m_axis->spacing == SweepSpacing::logarithmic);
}

void SweepAxisBox::onInput() {
    const auto index = static_cast<std::size_t>(m_input->currentIndex());
    const std::string path = index == 0 ? std::string() : m_paths[index - 1];
    if (path != (m_axis ? m_axis->input : std::string())) {
        emit inputChosen(path);
    }
}

void SweepAxisBox::onRange() {
    if (!m_axis) {
        return;
    }
    SweepAxis axis = *m_axis;
    axis.from = m_from->value().value_or(axis.from);
    axis.to = m_to->value().value_or(axis.to);
    axis.points = m_points->value();
    axis.spacing = m_ratios->isChecked() ? SweepSpacing::logarithmic : SweepSpacing::linear;
    if (axis.from != m_axis->from || axis.to != m_axis->to || axis.points != m_axis->points
        || axis.spacing != m_axis->spacing) {
        m_axis = axis;
        emit axisEdited(axis);
    }
}

void SweepAxisBox::retranslate() {
    const bool first = m_place == 0;
    const auto name = [](QWidget& widget, const QString& text) {
        widget.setAccessibleName(text);
        widget.setToolTip(text);
    };
    name(*m_input, first ? tr("First input varied") : tr("Second input varied"));
    name(*m_from, first ? tr("First input: from") : tr("Second input: from"));
    name(*m_to, first ? tr("First input: to") : tr("Second input: to"));
    name(*m_points,
         first ? tr("First input: number of points") : tr("Second input: number of points"));
    name(*m_ratios, first ? tr("First input: points at equal ratios instead of equal steps")
                          : tr("Second input: points at equal ratios instead of equal steps"));
    m_points->setPrefix(tr("points: "));
    m_ratios->setText(tr("log", "scale of a sweep"));
    m_paths.clear(); // their names have changed
    m_from->retranslate();
    m_to->retranslate();
}

} // namespace sparkout
