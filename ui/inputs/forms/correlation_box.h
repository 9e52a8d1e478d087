// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inputs/forms/input_box.h"
#include "ui/tables/pasted_cells.h"

#include <QString>

#include <string>
#include <vector>

namespace sparkout {

class Document;
class NumberLines;
class ReasonLabel;

/// The correlations of the batch's factors: a number for every two random factors.
class CorrelationBox : public InputBox {
    Q_OBJECT

public:
    CorrelationBox(std::string path, const Field& field, int depth, Document& document,
                   QWidget* parent = nullptr);

    void showProject(bool replaced) override;
    void setOutcome(const OutcomePtr& outcome) override;
    void retranslate() override;
    [[nodiscard]] std::vector<Refusal> refusals() const override;
    bool dropRefusal(const std::string& path) override;
    [[nodiscard]] bool holds(const std::string& path) const override;
    void focusPath(const std::string& path) override;

private:
    [[nodiscard]] std::vector<QString> orderOf(const PastedCells& cells, QString& fault) const;

    std::string m_path;
    const Field& m_field;
    Document& m_document;
    NumberLines* m_numbers;
    ReasonLabel* m_reason;
};

} // namespace sparkout
