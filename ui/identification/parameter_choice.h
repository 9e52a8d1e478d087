// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/identification/fitted_parameter.h"
#include "core/project/project.h"

#include <QGroupBox>

#include <vector>

class QCheckBox;
class QGridLayout;

namespace sparkout {

class NumberField;

/// The choice of fitted parameters, with optional prior values.
class ParameterChoice : public QGroupBox {
    Q_OBJECT

public:
    explicit ParameterChoice(const Project& project, QWidget* parent = nullptr);

    void propose(const FitData& measured); ///< checks the parameters that such data determine,
                                           ///< unchecks the others
    void uncheck(const FittedParameter& parameter) { setChecked(parameter, false); }
    void check(FittedKind kind) { setChecked({kind, {}, {}}, true); }
    [[nodiscard]] std::vector<FittedParameter> parameters() const; ///< the checked ones
    /// Why the prior values are invalid; empty if they are valid.
    [[nodiscard]] QString fault() const;

signals:
    void changed();

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
};

} // namespace sparkout
