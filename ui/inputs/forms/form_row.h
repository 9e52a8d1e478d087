// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/field_editor.h"
#include "ui/inputs/forms/form_access.h"

#include <QObject>

class QGridLayout;
class QLabel;
class QMenu;

namespace sparkout {

class CalibratedMark;
class InputRank;
class ReasonLabel;
class ResetMark;
class SharedMark;

/// One row of a form: label with symbol, mark of a change from the default, field, unit, slider,
/// and the reason of a mark below them.
class FormRow : public QObject {
    Q_OBJECT

public:
    FormRow(std::unique_ptr<FieldEditor> editor, QGridLayout& grid, QWidget* parent);

    [[nodiscard]] FieldEditor& editor() const { return *m_editor; }
    [[nodiscard]] ResetMark* resetMark() const { return m_mark; }
    void show(const Project& project, bool replaced, const InputRank& rank);
    /// Whether it is to be seen only on demand, and whether it is seen.
    [[nodiscard]] bool isOnDemand() const { return m_isRelevant && !m_editor->field().usual; }
    [[nodiscard]] bool isShown() const { return m_isShown; }
    void setShared(bool shared);              ///< shared with the other surfaces of the set-up
    void setAccess(const FormAccess& access); ///< applied by the next show()
    void setIssues(const Issues& issues);
    void retranslate(const Project& project);
    /// Adds the commands of the input to a context menu.
    void fillMenu(QMenu& menu);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addTo(QGridLayout& grid);
    void fitWide();
    void showRemark();
    void showCalibration(const Project& project);
    void showHint();
    [[nodiscard]] bool meaningIsLong() const; ///< too long for the field
    [[nodiscard]] QString caption() const;    ///< text below the field without a remark

    std::unique_ptr<FieldEditor> m_editor;
    QWidget* m_head; ///< label and mark
    QLabel* m_label;
    QLabel* m_unit;
    QLabel* m_reason;
    ResetMark* m_mark = nullptr; ///< null without a default
    SharedMark* m_shared;
    CalibratedMark* m_calibrated;
    QString m_calibration; ///< short text; empty: not calibrated
    bool m_isShared = false;
    Access m_access = Access::free;
    QString m_lock;           ///< why the input is locked
    bool m_isRelevant = true; ///< used by the model, and not hidden by a lesson
    bool m_isShown = true;    ///< also by its rank
};

} // namespace sparkout
