// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "ui/inputs/form_page.h"
#include "ui/inputs/mark.h"
#include "ui/session/document.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QTableView;
class QToolButton;

namespace sparkout {

class StageModel;

/// The cycle's stages: a table to edit in place, with buttons and keys to add (Ins), remove (Del)
/// and move (Ctrl+Up, Ctrl+Down) a stage.
class StageTable : public QWidget {
    Q_OBJECT

public:
    explicit StageTable(Document& document, QWidget* parent = nullptr);

    void setIssues(const Issues& issues);
    void retranslate();
    [[nodiscard]] std::vector<Refusal> refusals() const;
    bool focusPath(const std::string& path);
    [[nodiscard]] QTableView& view() const { return *m_view; }

    void addStage();
    void removeStage();
    void moveStage(int by);

signals:
    void refusalsChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildButtons(QHBoxLayout& into);
    [[nodiscard]] int currentStage() const;
    void select(int stage);
    void apply(std::vector<Stage> stages, EditText text, int selected);
    [[nodiscard]] bool canMove(int by) const;
    void updateButtons();
    void updateReasons();
    void fitColumns();
    void fitHeight();

    Document& m_document;
    StageModel* m_model;
    QTableView* m_view;
    QLabel* m_title;
    QLabel* m_reasons;
    QToolButton* m_add = nullptr;
    QToolButton* m_remove = nullptr;
    QToolButton* m_up = nullptr;
    QToolButton* m_down = nullptr;
    Issues m_issues;
    bool m_replaced = false;
    int m_wanted = 0; ///< stage to select once the table has its rows
};

} // namespace sparkout
