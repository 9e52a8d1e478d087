// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/study/outcome.h"
#include "ui/inputs/list_table.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace sparkout {

class StageModel;

/// The cycle's stages. Adding, removing and moving keep the sum of the stocks and leave a spark-out
/// at the end; where the stocks do not add up to the part's, a button fits them. In traverse
/// grinding a box adds a continuous infeed.
class StageTable : public ListTable {
    Q_OBJECT

public:
    explicit StageTable(Document& document, QWidget* parent = nullptr);

    void setOutcome(const sparkout::OutcomePtr& outcome);
    void forgetResults();
    void setAccess(const FormAccessPtr& access) override;
    void addRow() override;
    void removeRow() override;
    void moveRow(int by) override;
    void clearCell() override;
    void retranslate() override;

protected:
    void fitRows() override;
    [[nodiscard]] Texts texts() const override;
    [[nodiscard]] bool canRemove() const override;
    [[nodiscard]] bool canMove(int by) const override;

private:
    StageTable(Document& document, StageModel* model, QWidget* parent);
    void applyStages(std::vector<Stage> stages, EditText text, int selected);

    void showFit();
    void showFollows();
    [[nodiscard]] QString roughDepthText() const;
    [[nodiscard]] QString wheelText() const;
    void showSparkOut();
    void addSparkOut();
    void showContinuous();
    void setContinuous(bool stated);

    StageModel* m_stages;
    QCheckBox* m_continuous; ///< whether the stages have a continuous infeed, with its column
    QPushButton* m_sparkOut; ///< shown without a spark-out
    QPushButton* m_start;    ///< inserts a starting cycle
    QPushButton* m_fit;
    QLabel* m_follows; ///< whether the cycle follows the drawing
    bool m_hasFollowed = false;
};

} // namespace sparkout
