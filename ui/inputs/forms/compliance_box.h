// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/forms/input_box.h"

#include <string>

class QCheckBox;
class QLabel;

namespace sparkout {

/// The compliance: a field with a slider for each zone (traverse) or section (plunge), or a tick to
/// compute it from stiffness and shaft, which sets missing ones of these to usual values.
class ComplianceBox : public InputBox {
    Q_OBJECT

public:
    ComplianceBox(std::string path, const Field& field, Document& document,
                  QWidget* parent = nullptr);

    void showProject(bool replaced) override;
    void forgetResults() override;
    void setOutcome(const OutcomePtr& outcome) override; ///< the computed γ, for display
    void retranslate() override;
    void focusPath(const std::string& path) override;

private:
    void setIssues(const Issues& issues);
    [[nodiscard]] NumberLines::Line lineOf(const std::string& key, std::size_t index) const;
    void showComputed();
    void showCalibration(const Project& project);

    QCheckBox* m_computed;
    QLabel* m_gammas;      ///< computed, greyed
    QLabel* m_calibration; ///< data from which the values were found
    Issues m_issues;
    OutcomePtr m_good; ///< outcome of the last accepted inputs
};

} // namespace sparkout
