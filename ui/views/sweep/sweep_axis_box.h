// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/number_input.h"
#include "core/project/sweep.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;
class QSpinBox;

namespace sparkout {

class NumberField;
class SearchCombo;

/// One varied input: its choice, its range and the number of points.
class SweepAxisBox : public QWidget {
    Q_OBJECT
public:
    /// @param place 0 or 1, the index of the varied input
    explicit SweepAxisBox(std::size_t place, QWidget* parent = nullptr);

    /// Shows the sweep of a project and the inputs that it could vary.
    void show(const Project& project);
    void retranslate();

signals:
    void inputChosen(const std::string& path); ///< empty: none
    void axisEdited(const sparkout::SweepAxis& axis);

private:
    static QString wordsOf(const NumberInput& input); ///< words by which it is found
    void fillInputs(const std::vector<NumberInput>& inputs);
    void showAxis(const std::optional<NumberInput>& input);
    void onInput();
    void onRange();

    std::size_t m_place;
    SearchCombo* m_input;
    NumberField *m_from, *m_to;
    QLabel *m_dash, *m_unit;
    QSpinBox* m_points;
    QCheckBox* m_ratios;
    std::vector<std::string> m_paths; ///< paths of the entries after the first
    std::optional<SweepAxis> m_axis;
    std::optional<NumberInput> m_of; ///< the varied input
};

} // namespace sparkout
