// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/stiffness_trial.h"
#include "core/project/project.h"

#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace sparkout {

class FitTable;
class StiffnessModel;
class StiffnessSheet;

/// The stiffness trial: its sheet to print, the readings, and the resulting stiffnesses of
/// headstock, tailstock and wheel head.
class StiffnessPage : public QWidget {
    Q_OBJECT

public:
    explicit StiffnessPage(const Project& project, QWidget* parent = nullptr);
    ~StiffnessPage() override;

signals:
    void taken(const sparkout::Project& project); ///< the project with the found stiffnesses

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* buildSheet();
    QWidget* buildReadings();
    QWidget* buildResult();
    void evaluate();
    [[nodiscard]] StiffnessRequest request() const;
    [[nodiscard]] Project calibrated() const;
    void showFound();
    void showCompliance(const Project& after);

    const Project& m_project;
    std::unique_ptr<StiffnessSheet> m_sheet;
    StiffnessModel* m_model;
    QTableView* m_table;
    QComboBox* m_indicator;
    QLabel* m_words;
    FitTable* m_found;
    FitTable* m_compliance;
    QPushButton* m_take;
    bool m_isMeasurable; ///< an external surface, a shaft with steps and no steady rests
    bool m_isComplete;   ///< no input is wrong or missing except the compliance
    StiffnessTrial m_trial;
};

} // namespace sparkout
