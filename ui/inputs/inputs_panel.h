// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/inputs/form_page.h"

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
    void forgetResults(); ///< removes results shown beside the inputs
    /// Sets which inputs may be changed and which are shown; a page without inputs is hidden.
    void setAccess(const FormAccessPtr& access);
    void retranslate();
    void showPage(int index);
    void showCycle();
    void focusPath(const std::string& path);
    void endTyping(); ///< commits the text of the field with the focus
    /// Scrolls to the field at a path. It gets the focus only if another input had it.
    void revealPath(const std::string& path);
    [[nodiscard]] std::vector<Refusal> refusals() const;
    /// Restores the document's value in the last refused field; false if there is none. Undo does
    /// this first.
    bool dropNewestRefusal();
    [[nodiscard]] const std::vector<FormPage*>& pages(); ///< builds and returns all of them

signals:
    void refusalsChanged();

private:
    void showPath(const std::string& path, bool focus);
    void hintAtCells(const FormPage& page); ///< shows the hint of the current cell of a table
    void noteRefusals();                    ///< in the order of their refusal

    QHBoxLayout* m_strip; ///< page buttons
    QButtonGroup* m_group;
    QStackedWidget* m_stack;
    std::vector<QToolButton*> m_buttons;
    std::vector<FormPage*> m_pages;
    HintStrip* m_hint;
    std::vector<std::string> m_refused; ///< paths, oldest first
};

} // namespace sparkout
