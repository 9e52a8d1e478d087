// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/study/batch_edits.h"
#include "ui/form/mark.h"
#include "ui/inputs/page_columns.h"

#include <functional>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace sparkout {

/// A factor of the batch: a tick to enable it, the form of its distribution and the numbers of that
/// form; measured values are read from a CSV file.
class FactorBox : public InputBox {
    Q_OBJECT

public:
    FactorBox(std::string path, const Field& field, int depth, Document& document,
              QWidget* parent = nullptr);

    void showProject(bool replaced) override;
    void setOutcome(const OutcomePtr& outcome) override;
    void retranslate() override;
    void focusPath(const std::string& path) override;

    void readFrom(const QString& path); ///< reads measured values; shows the reason of a failure

private:
    void build();
    void connectParts();
    void chooseForm();
    void setTruncated(bool truncated);
    void askForFile();
    void edit(std::optional<Factor> law); ///< as a step of the history
    [[nodiscard]] const std::optional<Factor>& law() const;
    [[nodiscard]] FactorForm shownForm(const Factor& law) const;
    [[nodiscard]] QString measuredText(const Factor& law) const;
    void showRemark();

    FactorKind m_kind;
    QWidget* m_body;
    QLabel* m_formLabel;
    QComboBox* m_form;
    QCheckBox* m_truncated;
    QLabel* m_measured;
    QPushButton* m_read;
    std::optional<FactorForm> m_shown; ///< keeps the form, as two equal ends are not a constant
    Remark m_issue;
    std::function<QString()> m_fileFault; ///< why the last file was refused, if it was
};

} // namespace sparkout
