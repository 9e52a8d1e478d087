// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/inputs/forms/form_page.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QHBoxLayout;
class QStackedWidget;
class QToolButton;

namespace sparkout {

class HintStrip;
class Settings;

/// All inputs: a row of page buttons above the page in view.
class InputsPanel : public QWidget {
    Q_OBJECT

public:
    explicit InputsPanel(Document& document, QWidget* parent = nullptr,
                         Settings* settings = nullptr);
    ~InputsPanel() override;

    [[nodiscard]] QSize minimumSizeHint() const override;

    void setOutcome(const sparkout::OutcomePtr& outcome);
    void forgetResults(); ///< that it tells beside the inputs
    /// What may be changed, and what is shown; a page without inputs goes.
    void setAccess(const FormAccessPtr& access);
    void retranslate();
    void showPage(int index);
    void showCycle();
    void focusPath(const std::string& path);
    void endTyping(); ///< takes what stands in the field one types in
    /// Brings the field at a path into sight. The focus goes there only from another input.
    void revealPath(const std::string& path);
    [[nodiscard]] std::vector<Refusal> refusals() const;
    /// Shows the document's value in place of the text refused last; false when there is none.
    /// What undo does first.
    bool dropNewestRefusal();
    [[nodiscard]] const std::vector<FormPage*>& pages(); ///< built, all of them

signals:
    void refusalsChanged();

private:
    void showPath(const std::string& path, bool focus);
    void hintAtCells(const FormPage& page); ///< what the chosen one of a table takes
    void noteRefusals();                    ///< in the order in which they came

    QHBoxLayout* m_strip; ///< the buttons of the pages
    QButtonGroup* m_group;
    QStackedWidget* m_stack;
    std::vector<QToolButton*> m_buttons;
    std::vector<FormPage*> m_pages;
    HintStrip* m_hint;
    std::vector<std::string> m_refused; ///< paths, oldest first
};

} // namespace sparkout
