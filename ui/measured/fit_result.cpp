// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/fit_result.h"

#include "core/measured/fit_data.h"
#include "ui/chart/chart_plot.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/measured/fit_words.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

/// Below it residuals are hardly normal.
constexpr double doubtfulNormality = 0.05;
/// Above it two parameters are barely separable.
constexpr double closeCorrelation = 0.95;
constexpr double residualSize = 3; ///< [px]
constexpr double residualRoom = 0.06;

} // namespace

FitResult::FitResult(const Project& project, QWidget* parent)
    : QWidget(parent)
    , m_project(project)
    , m_words(copyableLabel(this))
    , m_values(new FitTable(tr("Values found"), this))
    , m_correlationsName(copyableLabel(this))
    , m_correlations(new FitTable(tr("Correlations of the values"), this))
    , m_residualsName(copyableLabel(this))
    , m_residuals(new FitTable(tr("Residuals by measurement"), this))
    , m_normality(copyableLabel(this))
    , m_group(new QComboBox(this))
    , m_plot(new ChartPlot(this)) {
    m_words->setObjectName(QStringLiteral("fitWords"));
    m_values->setObjectName(QStringLiteral("fitValues"));
    m_correlations->setObjectName(QStringLiteral("fitCorrelations"));
    m_residuals->setObjectName(QStringLiteral("fitResiduals"));
    m_normality->setObjectName(QStringLiteral("fitNormality"));
    m_group->setObjectName(QStringLiteral("fitGroup"));
    m_group->setAccessibleName(tr("Residuals drawn"));
    m_plot->setObjectName(QStringLiteral("fitPlot"));
    m_plot->setAccessibleName(tr("Measured minus predicted"));
    m_plot->setMinimumSize(atFontSize(260), atFontSize(150));
    m_correlationsName->setText(tr("Correlations of the values"));
    m_residualsName->setText(tr("Measured minus predicted"));
    m_group->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, metrics::gap, 0);
    column->setSpacing(metrics::gap);
    for (QWidget* part : std::initializer_list<QWidget*>{
             m_words, m_values, m_correlationsName, m_correlations, m_residualsName, m_residuals,
             m_group, m_plot, m_normality}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    connect(m_group, &QComboBox::currentIndexChanged, this, &FitResult::drawResiduals);
    clear();
}

void FitResult::clear() {
    m_words->setText(tr("No fit yet. Choose measurements and parameters, then Fit."));
    m_result = {};
    for (QWidget* part : std::initializer_list<QWidget*>{
             m_values, m_correlationsName, m_correlations, m_residualsName, m_residuals, m_group,
             m_plot, m_normality}) {
        part->hide();
    }
}

void FitResult::show(const IdentificationRequest& request, const Identification& result) {
    clear();
    m_request = request;
    m_result = result;
    m_words->setText(words());
    if (result.values.empty()) {
        return;
    }
    showValues();
    showCorrelations();
    showResiduals();
    m_normality->setText(normality());
    m_normality->setVisible(result.normality.has_value());
}

QString FitResult::words() const {
    QStringList lines;
    if (m_result.status == IdentificationStatus::fitted) {
        lines << tr("Found from %n measured value(s).", nullptr, static_cast<int>(m_result.count));
        if (std::ranges::none_of(m_request.parameters, [](const FittedParameter& parameter) {
                return isInput(parameter.kind);
            })) {
            lines << tr(
                "Offsets of the traces are not inputs of the project: there is nothing to apply.");
        }
    } else {
        lines << (m_result.values.empty()
                      ? tr("No values: %1.").arg(FitWords::status(m_result.status))
                      : tr("Not to be used: %1.").arg(FitWords::status(m_result.status)));
    }
    for (const FittedValue& value : m_result.values) {
        if (!value.isUsual()) {
            lines << FitWords::unusual(m_project, value);
        }
    }
    for (const FitResiduals& group : m_result.residuals) {
        for (const QString& fault :
             {FitWords::overRange(m_project, group), FitWords::lack(m_project, group)}) {
            if (!fault.isEmpty()) {
                lines << fault;
            }
        }
    }
    if (m_result.forceLaw) {
        lines << FitWords::forceLaw(*m_result.forceLaw);
    }
    for (const OutOfStep& one : m_result.outOfStep) {
        lines << FitWords::outOfStep(m_project, m_result, one);
    }
    for (const Unidentified& one : m_result.unidentified) {
        lines << FitWords::unidentified(m_project, m_request.parameters, one);
    }
    if (!m_result.withoutFactor.empty()) {
        lines << tr("A current without its factor in kW per A was left out.");
    }
    for (const Issue& issue : m_result.issues) {
        if (m_result.values.empty()) { // otherwise they are beside Apply
            lines << Names::issue(issue);
        }
    }
    return lines.join(u'\n');
}

QString FitResult::normality() const {
    if (!m_result.normality) {
        return {};
    }
    const double probability = m_result.normality->probability;
    const QString share = Names::significant(probability, 2);
    return probability < doubtfulNormality
               ? tr("The residuals are hardly normal (probability %1): they may contain more than "
                    "noise, and the intervals are too narrow.")
                     .arg(share)
               : tr("The residuals do not contradict a normal distribution (probability %1).")
                     .arg(share);
}

void FitResult::showValues() {
    std::vector<QStringList> rows;
    for (const FittedValue& value : m_result.values) {
        const QString unit = FitWords::unit(value.parameter.kind);
        rows.push_back({FitWords::parameter(m_project, value.parameter),
                        FitWords::number(value.parameter.kind, value.value),
                        FitWords::interval(value.parameter.kind, value.interval95),
                        unit.isEmpty() ? tr("×", "unit of a factor") : unit});
    }
    m_values->setCells({tr("Parameter"), tr("Value"), tr("95 % interval"), tr("Unit")}, rows);
    m_values->show();
}

void FitResult::showCorrelations() {
    const std::size_t count = m_result.values.size();
    if (count < 2 || m_result.correlation.size() != count) {
        return;
    }
    QStringList head{tr("Parameter")};
    std::vector<QStringList> rows;
    QString worst;
    double most = closeCorrelation;
    for (std::size_t i = 0; i < count; ++i) {
        head << QString::number(i + 1);
        const QString name = FitWords::parameter(m_project, m_result.values[i].parameter);
        QStringList row{QStringLiteral("%1. %2").arg(i + 1).arg(name)};
        for (std::size_t k = 0; k < count; ++k) {
            const double value = m_result.correlation[i][k];
            row << Names::fixed(value, 2);
            if (k < i && std::abs(value) > most) {
                most = std::abs(value);
                worst =
                    tr("Barely separable: %1 and %2.")
                        .arg(FitWords::parameter(m_project, m_result.values[k].parameter), name);
            }
        }
        rows.push_back(row);
    }
    m_correlations->setCells(head, rows);
    m_correlationsName->setText(worst.isEmpty() ? tr("Correlations of the values")
                                                : tr("Correlations of the values")
                                                      + QStringLiteral(". ") + worst);
    m_correlationsName->show();
    m_correlations->show();
}

void FitResult::showResiduals() {
    std::vector<QStringList> rows;
    m_group->clear();
    for (const FitResiduals& group : m_result.residuals) {
        const QString name = FitWords::group(m_project, group);
        rows.push_back({name, FitWords::number(group.rms),
                        group.noise ? FitWords::number(std::sqrt(group.noise->variance()))
                                    : QStringLiteral("—"),
                        FitWords::unit(group.source)});
        m_group->addItem(name);
    }
    m_residuals->setCells({tr("Measurement"), tr("RMS"), tr("Noise"), tr("Unit")}, rows);
    m_residualsName->show();
    m_residuals->show();
    m_group->setVisible(m_group->count() > 1);
    m_plot->setVisible(m_group->count() > 0);
    drawResiduals(m_group->currentIndex());
}

void FitResult::drawResiduals(int group) {
    if (group >= 0 && group < static_cast<int>(m_result.residuals.size())) {
        const FitResiduals& residuals = m_result.residuals[static_cast<std::size_t>(group)];
        m_plot->setChart([chart = chartOf(residuals)] { return chart; });
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

LineChart FitResult::chartOf(const FitResiduals& residuals) const {
    const FitData fitted = fitDataOf(m_project, m_request.traces, m_request.withParts);
    const auto of = std::ranges::find_if(fitted.groups, [&](const FitGroup& one) {
        return one.source == residuals.source && one.trace == residuals.trace;
    });
    const bool isTrace = of != fitted.groups.end() && of->time_s.size() == residuals.values.size();
    ChartSeries points{.kind = ChartSeries::Kind::points,
                       .colour = style::Drawn::actualFeed,
                       .mark = ChartSeries::Mark::disc,
                       .markSize = residualSize};
    for (std::size_t i = 0; i < residuals.values.size(); ++i) {
        points.points.push_back(
            {isTrace ? of->time_s[i] : static_cast<double>(i + 1), residuals.values[i]});
    }
    LineChart chart;
    chart.across = {isTrace ? tr("Time of the trace, s") : tr("Number of the value")};
    chart.up = {tr("Difference, %1").arg(FitWords::unit(residuals.source))};
    chart.across.room = residualRoom;
    chart.up.room = residualRoom / 2;
    chart.up.isSymmetric = chart.isFramed = true;
    chart.series = {std::move(points)};
    chart.rules = {{.isUpright = false, .pen = linePen(1, Qt::DashLine)}};
    return chart;
}

} // namespace sparkout
