// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/forms/input_box.h"
#include "ui/tables/pasted_cells.h"

#include <QString>

#include <string>
#include <vector>

namespace sparkout {

/// The correlations of the batch's factors: a number for every two random factors.
class CorrelationBox : public InputBox {
    Q_OBJECT

public:
    CorrelationBox(std::string path, const Field& field, int depth, Document& document,
                   QWidget* parent = nullptr);

    void showProject(bool replaced) override;
    void setOutcome(const OutcomePtr& outcome) override;
    void retranslate() override;

private:
    [[nodiscard]] std::vector<QString> orderOf(const PastedCells& cells, QString& fault) const;
};

} // namespace sparkout
