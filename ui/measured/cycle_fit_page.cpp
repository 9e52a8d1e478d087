// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/cycle_fit_page.h"

#include "core/measured/calibration.h"
#include "core/measured/cycle_response.h"
#include "core/measured/fit_data.h"
#include "core/process/force.h"
#include "core/project/measured.h"
#include "core/project/part.h"
#include "ui/form/number_field.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/measured/fit_result.h"
#include "ui/measured/fit_words.h"
#include "ui/text/names.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDate>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace sparkout {

/// The choice of fitted parameters, with optional prior values.
class ParameterChoice : public QGroupBox {
    Q_DECLARE_TR_FUNCTIONS(sparkout::ParameterChoice)

public:
    explicit ParameterChoice(const Project& project, QWidget* parent = nullptr);

    void setChanged(std::function<void()> changed) { m_changed = std::move(changed); }
    void propose(const FitData& measured); ///< checks the parameters that such data determine,
                                           ///< unchecks the others
    void uncheck(const FittedParameter& parameter) { setChecked(parameter, false); }
    void check(FittedKind kind) { setChecked({kind, {}, {}}, true); }
    [[nodiscard]] std::vector<FittedParameter> parameters() const; ///< the checked ones
    /// Why the prior values are invalid; empty if they are valid.
    [[nodiscard]] QString fault() const;

private:
    void setChecked(const FittedParameter& parameter, bool checked);
    struct Row {
        FittedParameter parameter;
        QCheckBox* box;
        NumberField* mean;
        NumberField* deviation;
    };
    void addHead(QGridLayout& grid);
    void addRow(QGridLayout& grid, const Project& project, const FittedParameter& parameter);

    std::vector<Row> m_rows;
    std::function<void()> m_changed = [] {};
};

namespace {

constexpr int mostPlaceRows = 12; ///< sections with a row each
constexpr int priorWidth = 64;

} // namespace

ParameterChoice::ParameterChoice(const Project& project, QWidget* parent) : QGroupBox(parent) {
    setTitle(tr("Parameters"));
    auto* grid = new QGridLayout(this);
    grid->setHorizontalSpacing(metrics::gap);
    grid->setVerticalSpacing(metrics::row);
    grid->setColumnStretch(0, 1);
    addHead(*grid);
    const int places = placeCount(project);
    for (int i = 0; i < static_cast<int>(FittedKind::count_); ++i) {
        const auto kind = static_cast<FittedKind>(i);
        if (kind == FittedKind::blank_runout && project.part->profile == ProfileForm::measured) {
            continue; // its form is given point by point
        }
        if (hasThreshold(project)
            && (kind == FittedKind::flow_stress || kind == FittedKind::dullness)) {
            continue; // the force does not depend on them
        }
        addRow(*grid, project, {kind, {}, {}});
        const bool byPlace = kind == FittedKind::compliance && hasPlaceCompliances(project)
                             && places > 1 && places <= mostPlaceRows;
        for (int place = 0; byPlace && place < places; ++place) {
            addRow(*grid, project, {kind, place, {}});
        }
    }
}

void ParameterChoice::addHead(QGridLayout& grid) {
    auto* known = new QLabel(tr("known before: mean ± s"), this);
    known->setToolTip(tr("A value known from elsewhere, with its standard deviation, counts as one "
                         "more measurement. Factors refer to the current inputs: 1 ± 0.1 means "
                         "known within about 20 %. Empty: nothing is known."));
    grid.addWidget(known, 0, 1, 1, 4, Qt::AlignLeft);
}

void ParameterChoice::addRow(QGridLayout& grid, const Project& project,
                             const FittedParameter& parameter) {
    const QString name = FitWords::parameter(project, parameter);
    const QString key = QString::fromLatin1(keyOf(parameter.kind))
                        + (parameter.place ? QString::number(*parameter.place) : QString());
    const auto field = [&](const QString& part, const QString& text, const Range& range) {
        NumberSpec spec;
        spec.hard = range;
        spec.optional = true;
        auto* number = new NumberField(spec, this);
        number->setObjectName(key + part);
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        number->setAccessibleName(text.arg(name));
        setTextWidth(*number, priorWidth);
        connect(number, &NumberField::valueEdited, this, [this] { m_changed(); });
        connect(number, &NumberField::remarkChanged, this, [this] { m_changed(); });
        return number;
    };
    const Range positive{.low = 0, .lowOpen = true}, any;
    auto* box = new QCheckBox(name, this);
    box->setObjectName(key);
    Row row{parameter, box,
            field(QStringLiteral("Mean"), tr("%1: mean known before"),
                  isFactor(parameter.kind) ? positive : any),
            field(QStringLiteral("Deviation"), tr("%1: its standard deviation"), positive)};
    const int line = grid.rowCount();
    grid.addWidget(row.box, line, 0);
    grid.addWidget(row.mean, line, 1);
    grid.addWidget(new QLabel(QStringLiteral("±"), this), line, 2);
    grid.addWidget(row.deviation, line, 3);
    grid.addWidget(new QLabel(FitWords::unit(parameter.kind), this), line, 4);
    connect(row.box, &QCheckBox::toggled, this, [this, row](bool fitted) {
        row.mean->setEnabled(fitted);
        row.deviation->setEnabled(fitted);
        m_changed();
    });
    row.mean->setEnabled(false);
    row.deviation->setEnabled(false);
    m_rows.push_back(row);
}

void ParameterChoice::propose(const FitData& measured) {
    const bool isOfSources =
        std::ranges::any_of(m_rows, [](const Row& row) { // otherwise the row does not exist
            return row.parameter.kind == FittedKind::dullness;
        });
    const std::vector<FittedKind> kinds = proposedParameters(measured, !isOfSources);
    for (const Row& row : m_rows) {
        row.box->setChecked(!row.parameter.place
                            && std::ranges::find(kinds, row.parameter.kind) != kinds.end());
    }
}

void ParameterChoice::setChecked(const FittedParameter& parameter, bool checked) {
    for (const Row& row : m_rows) {
        if (row.parameter.kind == parameter.kind && row.parameter.place == parameter.place) {
            row.box->setChecked(checked);
        }
    }
}

std::vector<FittedParameter> ParameterChoice::parameters() const {
    std::vector<FittedParameter> list;
    for (const Row& row : m_rows) {
        if (!row.box->isChecked()) {
            continue;
        }
        FittedParameter parameter = row.parameter;
        if (row.mean->value() && row.deviation->value()) {
            parameter.prior = Prior{*row.mean->value(), *row.deviation->value()};
        }
        list.push_back(parameter);
    }
    return list;
}

QString ParameterChoice::fault() const {
    for (const Row& row : m_rows) {
        if (!row.box->isChecked()) {
            continue;
        }
        for (const NumberField* field : {row.mean, row.deviation}) {
            if (field->refused()) {
                return tr("%1: %2").arg(row.box->text(), field->refusal());
            }
        }
        if (row.mean->value().has_value() != row.deviation->value().has_value()) {
            return tr("%1: a mean known before needs its standard deviation, and vice versa.")
                .arg(row.box->text());
        }
    }
    return {};
}

namespace {

/// The number of no trace: an empty list would mean all.
constexpr int noTrace = -1;

QScrollArea* scrolledPart(QWidget* content, QWidget* parent) {
    auto* area = new QScrollArea(parent);
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->viewport()->setAutoFillBackground(false); // the page's own background is visible
    content->setAutoFillBackground(false);
    return area;
}

} // namespace

/// The choice of measurements for a fit: traces, and the diameters of the parts.
class DataChoice : public QGroupBox {
    Q_DECLARE_TR_FUNCTIONS(sparkout::DataChoice)

public:
    explicit DataChoice(const Project& project, QWidget* parent = nullptr);

    [[nodiscard]] std::vector<int> traces() const; ///< indices in the project
    [[nodiscard]] bool withParts() const;

private:
    QCheckBox* add(const QString& text, const QString& name);

    std::vector<QCheckBox*> m_traces;
    std::vector<int> m_numbers;   ///< numbers of the traces
    QCheckBox* m_parts = nullptr; ///< null: no part has a diameter
};

DataChoice::DataChoice(const Project& project, QWidget* parent) : QGroupBox(parent) {
    setTitle(tr("Measurements"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(metrics::row);
    if (!project.measured) {
        return;
    }
    const std::vector<MeasuredTrace>& traces = project.measured->traces;
    const FitData all = fitDataOf(project, {}, true);
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const int number = static_cast<int>(i);
        QCheckBox* const box = add(FitWords::trace(traces[i]), QStringLiteral("trace%1").arg(i));
        const bool isUsable =
            std::ranges::find(all.groups, number, &FitGroup::trace) != all.groups.end();
        box->setEnabled(isUsable);
        box->setChecked(isUsable);
        if (std::ranges::find(all.withoutFactor, number) != all.withoutFactor.end()) {
            box->setToolTip(tr("A current is used once its factor in kW per A is given."));
        }
        m_traces.push_back(box);
        m_numbers.push_back(number);
    }
    const auto parts = std::ranges::find(all.groups, FitSource::parts, &FitGroup::source);
    if (parts != all.groups.end()) {
        m_parts =
            add(tr("diameters of parts (n = %1)").arg(parts->measured), QStringLiteral("parts"));
        m_parts->setChecked(all.groups.size() == 1); // their cycles may differ from that of a trace
    }
}

QCheckBox* DataChoice::add(const QString& text, const QString& name) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(name);
    layout()->addWidget(box);
    return box;
}

std::vector<int> DataChoice::traces() const {
    std::vector<int> chosen;
    for (std::size_t i = 0; i < m_traces.size(); ++i) {
        if (m_traces[i]->isChecked()) {
            chosen.push_back(m_numbers[i]);
        }
    }
    return chosen;
}

bool DataChoice::withParts() const {
    return m_parts && m_parts->isChecked();
}

CycleFitPage::CycleFitPage(const Project& project, QWidget* parent)
    : QWidget(parent)
    , m_project(project)
    , m_data(new DataChoice(project))
    , m_parameters(new ParameterChoice(project))
    , m_loss(new QComboBox)
    , m_fault(new QLabel)
    , m_shown(new FitResult(project))
    , m_progress(new QProgressBar)
    , m_fit(new QPushButton(tr("&Fit")))
    , m_stop(new QPushButton(tr("&Stop")))
    , m_leaveOut(new QPushButton(tr("&Leave these out")))
    , m_fitTimes(new QPushButton(tr("Fit &this too")))
    , m_take(new QPushButton(tr("&Apply"))) {
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::wide);
    QWidget* const choices = buildChoices();
    QScrollArea* const left = scrolledPart(choices, this);
    left->setMinimumWidth(choices->minimumSizeHint().width()
                          + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    left->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    row->addWidget(left);
    row->addWidget(scrolledPart(m_shown, this), 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(buildButtons());
    for (const QCheckBox* box : m_data->findChildren<QCheckBox*>()) {
        connect(box, &QCheckBox::toggled, this, &CycleFitPage::propose);
    }
    m_parameters->setChanged([this] { follow(); });
    connect(m_fit, &QPushButton::clicked, this, &CycleFitPage::start);
    connect(m_stop, &QPushButton::clicked, &m_job, &Job::stop);
    connect(m_leaveOut, &QPushButton::clicked, this, &CycleFitPage::leaveOut);
    connect(m_fitTimes, &QPushButton::clicked, this, &CycleFitPage::fitTimes);
    connect(m_take, &QPushButton::clicked, this, &CycleFitPage::take);
    propose();
}

QWidget* CycleFitPage::buildChoices() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, metrics::gap, 0);
    column->addWidget(m_data);
    column->addWidget(m_parameters);
    m_loss->setObjectName(QStringLiteral("loss"));
    m_loss->addItem(tr("all values alike"), static_cast<int>(RobustLoss::none));
    m_loss->addItem(tr("outliers weigh less (Huber)"), static_cast<int>(RobustLoss::huber));
    m_loss->addItem(tr("outliers hardly count (Tukey)"), static_cast<int>(RobustLoss::tukey));
    auto* label = new QLabel(tr("&Outliers:"), page);
    label->setBuddy(m_loss);
    auto* line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(m_loss, 1);
    column->addLayout(line);
    column->addStretch(1);
    return page;
}

QWidget* CycleFitPage::buildButtons() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_fit->setObjectName(QStringLiteral("fit"));
    m_stop->setObjectName(QStringLiteral("fitStop"));
    m_leaveOut->setObjectName(QStringLiteral("fitLeaveOut"));
    m_leaveOut->setToolTip(tr("Clears undetermined parameters"));
    m_fitTimes->setObjectName(QStringLiteral("fitTimes"));
    m_fitTimes->setToolTip(tr("Checks the omitted parameters, and fits again"));
    m_take->setObjectName(QStringLiteral("fitTake"));
    m_take->setToolTip(tr("Applies the values found to the inputs, as one edit that can be undone, "
                          "and marks them as calibrated"));
    m_fault->setObjectName(QStringLiteral("fitFault"));
    m_fault->setTextFormat(Qt::PlainText);
    m_fault->setWordWrap(true);
    m_progress->setRange(0, 0); // the number of cycles is not known
    m_progress->setAccessibleName(tr("Progress"));
    m_fit->setDefault(true);
    row->addWidget(m_fit);
    row->addWidget(m_stop);
    row->addWidget(m_progress);
    row->addWidget(m_fault, 1);
    row->addWidget(m_leaveOut);
    row->addWidget(m_fitTimes);
    row->addWidget(m_take);
    return bar;
}

IdentificationRequest CycleFitPage::request() const {
    IdentificationRequest request;
    request.parameters = m_parameters->parameters();
    request.traces = m_data->traces();
    if (request.traces.empty()) {
        request.traces = {noTrace};
    }
    request.withParts = m_data->withParts();
    request.loss = static_cast<RobustLoss>(m_loss->currentData().toInt());
    return request;
}

void CycleFitPage::propose() {
    const IdentificationRequest now = request();
    m_parameters->propose(fitDataOf(m_project, now.traces, now.withParts));
    follow();
}

void CycleFitPage::follow() {
    const bool runs = m_job.running();
    QString fault = m_parameters->fault();
    if (fault.isEmpty() && m_data->traces().empty() && !m_data->withParts()) {
        fault = tr("No measurement is chosen.");
    } else if (fault.isEmpty() && m_parameters->parameters().empty()) {
        fault = tr("No parameter is chosen.");
    }
    m_fault->setText(runs                          ? tr("Cycles are being run and compared …")
                     : fault.isEmpty() && m_result ? consequences()
                                                   : fault);
    m_fit->setEnabled(!runs && fault.isEmpty());
    m_stop->setEnabled(runs);
    m_progress->setVisible(runs);
    m_data->setEnabled(!runs);
    m_parameters->setEnabled(!runs);
    m_loss->setEnabled(!runs);
    m_leaveOut->setVisible(m_result && !m_result->unidentified.empty() && !runs);
    m_fitTimes->setVisible(m_result && !m_result->outOfStep.empty() && !runs);
    m_take->setEnabled(!runs && m_result && m_result->status == IdentificationStatus::fitted
                       && std::ranges::any_of(m_result->values, [](const FittedValue& value) {
                              return isInput(value.parameter.kind);
                          }));
}

void CycleFitPage::start() {
    m_requested = request();
    m_result.reset();
    m_shown->clear();
    m_job.start(
        0, // the number of cycles is not known in advance
        [project = m_project, wanted = m_requested](const Job::Means& means) {
            return std::make_shared<const Identification>(identify(project, wanted, means.stop));
        },
        [this](const IdentificationPtr& result) { showResult(result); });
    follow();
}

void CycleFitPage::showResult(const IdentificationPtr& result) {
    m_result = result;
    m_shown->show(m_requested, *result);
    follow();
}

/// Leaves out one of several inseparable parameters: the chips' share, which is much smaller than
/// that of the wear flats, otherwise the last one.
void CycleFitPage::leaveOut() {
    for (const Unidentified& one : m_result->unidentified) {
        std::size_t left = one.parameters.back();
        for (const std::size_t i : one.parameters) {
            const FittedKind kind = m_requested.parameters.at(i).kind;
            if (kind == FittedKind::alpha || kind == FittedKind::chip_power) {
                left = i;
            }
        }
        m_parameters->uncheck(m_requested.parameters.at(left));
    }
}

void CycleFitPage::fitTimes() {
    for (const OutOfStep& one : m_result->outOfStep) {
        m_parameters->check(one.kind);
    }
    start();
}

Project CycleFitPage::calibrated() const {
    return withCalibration(m_project, *m_result,
                           FitWords::data(m_project, m_requested.traces, m_requested.withParts),
                           QDate::currentDate().toString(Qt::ISODate).toStdString());
}

/// A good fit may give unusual values: then another input of the project is not as it was at the
/// machine, or the data hardly separate its parameters.
QString CycleFitPage::consequences() const {
    QStringList refused, unusual;
    bool isOfDullness = false;
    for (const Issue& issue : m_result->issues) {
        (issue.severity == Severity::error ? refused : unusual) << Names::issue(issue);
        isOfDullness = isOfDullness || issue.path == dullnessPath(*m_project.wheel);
    }
    const bool hasBeta =
        std::ranges::find(m_requested.parameters, FittedKind::beta, &FittedParameter::kind)
        != m_requested.parameters.end();
    const QString advice =
        isOfDullness && hasBeta
            ? tr("Sizes determine only the product of compliance and dullness: with the compliance "
                 "fitted in place of β, the dullness stays as it is.")
            : tr("Check that gauge, feeds and blank of the project match the recording. Fewer "
                 "parameters, or values known before, also help.");
    if (m_result->values.empty()) {
        return {};
    }
    if (!refused.isEmpty()) {
        return tr("These values cannot be applied. %1. %2")
            .arg(refused.join(QStringLiteral("; ")), advice);
    }
    if (!m_result->outOfStep.empty()) {
        return tr(
            "These values cannot be applied: an omitted parameter distorts them. Fit it too.");
    }
    if (m_result->status == IdentificationStatus::doesNotFit) {
        return tr("These values cannot be applied: the model does not fit. %1").arg(advice);
    }
    return unusual.isEmpty()
               ? QString()
               : tr("Unusual: %1. %2").arg(unusual.join(QStringLiteral("; ")), advice);
}

void CycleFitPage::take() {
    emit taken(calibrated());
}

} // namespace sparkout
