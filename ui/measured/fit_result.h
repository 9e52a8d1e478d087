// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/identification.h"
#include "core/project/project.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace sparkout {

class ChartPlot;
class FitTable;
struct LineChart;

/// The result of a fit: values, correlations, residuals; or the undetermined parameters, and the
/// measurement that would determine them.
class FitResult : public QWidget {
    Q_OBJECT

public:
    explicit FitResult(const Project& project, QWidget* parent = nullptr);

    void clear();
    void show(const IdentificationRequest& request, const Identification& result);

private:
    [[nodiscard]] QString words() const;
    [[nodiscard]] QString normality() const;
    void showValues();
    void showCorrelations();
    void showResiduals();
    void drawResiduals(int group);
    [[nodiscard]] LineChart chartOf(const FitResiduals& residuals) const;

    const Project& m_project;
    IdentificationRequest m_request;
    Identification m_result;
    QLabel* m_words;
    FitTable* m_values;
    QLabel* m_correlationsName;
    FitTable* m_correlations;
    QLabel* m_residualsName;
    FitTable* m_residuals;
    QLabel* m_normality;
    QComboBox* m_group;
    ChartPlot* m_plot; ///< what one group of measured values leaves over
};

} // namespace sparkout
