// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/fields/number_field.h"
#include "ui/inputs/forms/input_box.h"

#include <string>
#include <vector>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace sparkout {

class CalibratedMark;
class Document;
class ReasonLabel;
class ValueSlider;

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
    [[nodiscard]] std::vector<Refusal> refusals() const override;
    bool dropRefusal(const std::string& path) override;
    [[nodiscard]] bool holds(const std::string& path) const override {
        return path.starts_with(m_path);
    }
    void focusPath(const std::string& path) override;

private:
    struct Line {
        std::string key; ///< last key of the path
        QLabel* label;
        CalibratedMark* calibrated;
        NumberField* field;
        ValueSlider* slider;
        QLabel* unit;
        ReasonLabel* reason;
    };

    void setIssues(const Issues& issues);
    void build(const std::vector<std::string>& keys);
    void addLine(const std::string& key);
    void place(const Line& line);
    void connectLine(std::size_t index);
    [[nodiscard]] std::string pathOf(const Line& line) const { return m_path + "/" + line.key; }
    void store(std::size_t index, double value);
    void showReason(const Line& line);
    void retranslate(const Line& line);
    void showComputed();
    void showCalibration(const Project& project);

    std::string m_path;
    const Field& m_field;
    Document& m_document;
    QCheckBox* m_computed;
    ReasonLabel* m_reason;
    QWidget* m_body;
    QLabel* m_gammas;      ///< computed, greyed
    QLabel* m_calibration; ///< data from which the values were found
    QGridLayout* m_grid = nullptr;
    std::vector<Line> m_lines;
    Issues m_issues;
    OutcomePtr m_good; ///< outcome of the last accepted inputs
};

} // namespace sparkout
