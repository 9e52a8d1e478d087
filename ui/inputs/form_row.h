// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/lesson.h"
#include "core/project/project.h"
#include "ui/form/field_editor.h"

#include <QCoreApplication>
#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class QWidget;

class QGridLayout;
class QLabel;
class QMenu;

namespace sparkout {

/// The allowed access to inputs: all of them, or what a step of a lesson allows.
class FormAccess {
    Q_DECLARE_TR_FUNCTIONS(FormAccess)
public:
    FormAccess() = default; ///< every input is free
    /// Locks all inputs while a prediction is awaited.
    FormAccess(const LessonStep& step, bool isAwaited);

    [[nodiscard]] bool isFree() const { return !m_step && !m_isAwaited; } ///< every input is
    [[nodiscard]] Access at(std::string_view path) const;
    /// Whether it, or something below it, may be changed or is shown.
    [[nodiscard]] bool hasFree(std::string_view path) const;
    [[nodiscard]] bool hasShown(std::string_view path) const;
    [[nodiscard]] QString lockText() const; ///< why an input is locked

    /// Locks a widget, or undoes that; what this did not lock stays unchanged.
    static void lock(QWidget& widget, bool locked);
    static bool hide(QWidget& widget, bool hidden); ///< hides or undoes that; true if it was undone

private:
    [[nodiscard]] Access given(std::string_view path) const;

    std::optional<LessonStep> m_step; ///< only its access rules
    bool m_isAwaited = false;
};

using FormAccessPtr = std::shared_ptr<const FormAccess>;

/// Which inputs of a page are shown: all, or the usual ones and those of the others that matter in
/// this project.
class InputRank {
public:
    bool showsAll = false;
    std::vector<std::string> wanted;    ///< paths requested by a message or by the search
    std::optional<Project> asCatalogue; ///< project with the values of the chosen catalogue entry

    /// Whether the input at a path is shown whatever its rank: it, or something below it, was
    /// requested, is calibrated, or differs from both a new project and the chosen catalogue entry.
    [[nodiscard]] bool isNews(const Project& project, const std::string& path) const;
    [[nodiscard]] bool shows(const Project& project, const Field& field,
                             const std::string& path) const {
        return showsAll || field.usual || isNews(project, path);
    }
};

class CalibratedMark;
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
