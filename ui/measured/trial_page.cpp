// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/trial_page.h"

#include "core/project/cycle.h"
#include "core/project/operation.h"
#include "core/project/validate.h"
#include "core/units.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/metrics.h"
#include "ui/measured/fit_words.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "words/measured_words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>

namespace sparkout {

namespace {

constexpr int recordsAny = -1;

bool canRunTrials(const Project& project) {
    return std::ranges::none_of(
        validate(project), [](const Issue& issue) { return issue.severity == Severity::error; });
}

} // namespace

TrialPage::TrialPage(const Project& project, QWidget* parent)
    : QWidget(parent)
    , m_project(project)
    , m_record(new QComboBox(this))
    , m_table(new FitTable(tr("Trials, most informative first"), this))
    , m_words(copyableLabel(this))
    , m_fault(copyableLabel(this))
    , m_progress(new QProgressBar(this))
    , m_find(new QPushButton(tr("&Compare trials"), this))
    , m_stop(new QPushButton(tr("&Stop"), this)) {
    auto* results = new QWidget(this);
    auto* lines = new QVBoxLayout(results);
    lines->setContentsMargins(0, 0, 0, 0);
    m_words->setObjectName(QStringLiteral("trialWords"));
    m_table->setObjectName(QStringLiteral("trialTable"));
    lines->addWidget(m_words);
    lines->addWidget(m_table);
    lines->addStretch(1);
    auto* area = new QScrollArea(this);
    area->setWidget(results);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->viewport()->setAutoFillBackground(false); // the page's own background is visible
    results->setAutoFillBackground(false);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::wide);
    row->addWidget(buildChoices());
    row->addWidget(area, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(buildButtons());
    connect(m_find, &QPushButton::clicked, this, &TrialPage::start);
    connect(m_stop, &QPushButton::clicked, &m_job, &Job::stop);
    connect(m_record, &QComboBox::currentIndexChanged, this, &TrialPage::showDesign);
    connect(m_table, &CopyTable::rowChosen, this, &TrialPage::showTrial);
    showDesign();
    follow();
}

QWidget* TrialPage::buildChoices() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    auto* box = new QGroupBox(tr("Purpose of the trial"), page);
    auto* list = new QVBoxLayout(box);
    list->setSpacing(metrics::row);
    const bool isSplit = areApplicable(m_project, {{FittedKind::alpha, {}, {}}});
    for (int i = 0; i < static_cast<int>(FittedKind::count_); ++i) {
        const auto kind = static_cast<FittedKind>(i);
        const FittedParameter parameter{kind, {}, {}};
        // Offset, time shift and idle power are found from any trace besides.
        if (!isInput(kind) && kind != FittedKind::chip_power
            && kind != FittedKind::friction_power) {
            continue;
        }
        // No recorded trial determines the gauge's setting.
        if (!areApplicable(m_project, {parameter}) || kind == FittedKind::gauge_setting) {
            continue;
        }
        auto* choice = new QCheckBox(FitWords::parameter(m_project, parameter), box);
        choice->setObjectName(QStringLiteral("trial_") + QString::fromLatin1(keyOf(kind)));
        choice->setChecked(isSplit ? kind == FittedKind::alpha || kind == FittedKind::beta
                                   : kind == FittedKind::compliance);
        list->addWidget(choice);
        connect(choice, &QCheckBox::toggled, this, &TrialPage::follow);
        m_kinds.emplace_back(kind, choice);
    }
    column->addWidget(box);
    m_record->setObjectName(QStringLiteral("trialRecord"));
    m_record->addItem(tr("anything"), recordsAny);
    for (int i = 0; i < static_cast<int>(TrialRecord::count_); ++i) {
        m_record->addItem(FitWords::trial(wordsOf(static_cast<TrialRecord>(i))), i);
    }
    auto* label = new QLabel(tr("&Can be recorded:"), page);
    label->setBuddy(m_record);
    column->addWidget(label);
    column->addWidget(m_record);
    column->addStretch(1);
    return page;
}

QWidget* TrialPage::buildButtons() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_find->setObjectName(QStringLiteral("trialFind"));
    m_stop->setObjectName(QStringLiteral("trialStop"));
    m_fault->setObjectName(QStringLiteral("trialFault"));
    m_progress->setRange(0, 0);
    m_progress->setAccessibleName(tr("Progress"));
    row->addWidget(m_find);
    row->addWidget(m_stop);
    row->addWidget(m_progress);
    row->addWidget(m_fault, 1);
    return bar;
}

std::vector<FittedParameter> TrialPage::parameters() const {
    std::vector<FittedParameter> list;
    for (const auto& [kind, box] : m_kinds) {
        if (box->isChecked()) {
            list.push_back({kind, {}, {}});
        }
    }
    return list;
}

void TrialPage::follow() {
    const bool runs = m_job.running();
    QString fault;
    if (!canRunTrials(m_project)) {
        fault = tr("Inputs of the project are missing or wrong: first correct the faults in the "
                   "messages.");
    } else if (parameters().empty()) {
        fault = tr("No parameter is chosen.");
    }
    m_fault->setText(runs ? tr("Trials are being run …") : fault);
    m_find->setEnabled(!runs && fault.isEmpty());
    m_stop->setEnabled(runs);
    m_progress->setVisible(runs);
    for (const auto& [kind, box] : m_kinds) {
        box->setEnabled(!runs);
    }
}

void TrialPage::start() {
    m_requested = {parameters(), {}};
    m_design.reset();
    showDesign();
    m_job.start(
        0,
        [project = m_project, wanted = m_requested](const Job::Means& means) {
            return std::make_shared<const TrialDesign>(designTrial(project, wanted, means.stop));
        },
        [this](const TrialDesignPtr& design) {
            m_design = design;
            showDesign();
            follow();
        });
    follow();
}

QStringList TrialPage::cellsOf(const Trial& trial) const {
    QStringList cells{FitWords::number(trial.radialFeed),
                      trial.sparkOut == TrialSparkOut::none ? tr("no") : tr("yes"),
                      FitWords::trial(wordsOf(trial.record)), Names::fixed(trial.duration_s, 0)};
    for (const FittedParameter& parameter : m_requested.parameters) {
        const auto found =
            std::ranges::find(trial.expected, parameter, &TrialExpectation::parameter);
        cells << (found == trial.expected.end()
                      ? tr("undetermined")
                      : FitWords::interval(Interval{found->low, found->high}));
    }
    return cells;
}

void TrialPage::showDesign() {
    m_shown.clear();
    if (!m_design) {
        m_table->hide();
        m_words->setText(
            tr("Before the machine grinds a trial, this compares 24 of them: a third, one and "
               "three times the feed of the first stage, without and with a spark-out, by the "
               "recorded quantities. The best one narrows the chosen parameters down most."));
        return;
    }
    if (m_design->status != TrialStatus::designed) {
        m_table->hide();
        m_words->setText(tr("No trials: %1.").arg(FitWords::trial(wordsOf(m_design->status))));
        return;
    }
    const Field& feed = *tableOf<Stage>().find(m_project.operation->radial().key);
    QStringList head{tr("Feed,\n%1").arg(unitText(feed.unit)), tr("Spark-\nout"), tr("Recorded"),
                     tr("Time,\ns")};
    for (const FittedParameter& parameter : m_requested.parameters) {
        QString name = FitWords::parameter(m_project, parameter);
        head << name.replace(name.indexOf(u' '), 1, QChar(u'\n'));
    }
    const int record = m_record->currentData().toInt();
    std::vector<QStringList> rows;
    for (const Trial& trial : m_design->trials) {
        if (record == recordsAny || static_cast<int>(trial.record) == record) {
            m_shown.push_back(&trial);
            rows.push_back(cellsOf(trial));
        }
    }
    m_table->setCells(head, rows);
    m_table->show();
    showTrial(0);
}

QString TrialPage::stepsOf(const Trial& trial) const {
    const Field& feed = *tableOf<Stage>().find(m_project.operation->radial().key);
    const QString steps =
        trial.sparkOut == TrialSparkOut::none || trial.stepsByStage.empty()
            ? tr("without spark-out")
        : m_project.operation->travels
            ? tr("then %n double stroke(s) of spark-out", nullptr, trial.stepsByStage.back())
            : tr("then %n revolution(s) of spark-out", nullptr, trial.stepsByStage.back());
    return tr("All the stock at %1 %2, %3, about %4 s; record: %5.")
        .arg(FitWords::number(trial.radialFeed), unitText(feed.unit), steps,
             Names::fixed(trial.duration_s, 0), FitWords::trial(wordsOf(trial.record)));
}

void TrialPage::showTrial(int row) {
    if (row < 0 || static_cast<std::size_t>(row) >= m_shown.size()) {
        m_words->setText(tr("None of the trials records this."));
        return;
    }
    const Trial& trial = *m_shown[static_cast<std::size_t>(row)];
    const TrialNoise& noise = m_requested.noise;
    QStringList words{row == 0 ? tr("Most informative trial:") : tr("The chosen trial:"),
                      stepsOf(trial)};
    if (!trial.cannotTell.empty()) {
        QStringList names;
        for (const FittedParameter& parameter : trial.cannotTell) {
            names << FitWords::parameter(m_project, parameter);
        }
        words << tr("Undetermined: %1.").arg(names.join(QStringLiteral("; ")));
    }
    words << tr("The intervals are those expected at 95 % about the current inputs, for %1 values "
                "a second with a scatter of %2 µm, %3 kW or %4 % of the maximum force. Then "
                "import the trace and calibrate on the page Cycle.")
                 .arg(FitWords::number(noise.hertz),
                      FitWords::number(noise.size_mm * units::umPerMm),
                      FitWords::number(noise.power_kw), FitWords::number(noise.force_share * 100));
    m_words->setText(words.join(u'\n'));
}

} // namespace sparkout
