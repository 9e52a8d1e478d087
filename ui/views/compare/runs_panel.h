// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/runs_model.h"
#include "ui/session/kept_runs.h"

#include <QWidget>

#include <optional>

class QAction;
class QListView;

namespace sparkout {

/// The list of the view "Compare": the present run and the kept ones, each with what came out. A
/// check mark chooses a kept run; buttons and keys keep, restore, rename and delete.
class RunsPanel : public QWidget {
    Q_OBJECT
public:
    explicit RunsPanel(KeptRuns& kept, QWidget* parent = nullptr);

    /// The kept ones of now and the present one; null: none is computed.
    void setRuns(const ReadSummary* present, const Project* inputs);
    /// Of the present run, whose mark and words stand in place of the light by its summary; null:
    /// it is not known.
    void setJudgement(const Judgement* judgement);
    void retranslate();

    [[nodiscard]] QListView* list() const { return m_list; }
    [[nodiscard]] QAction* keep() const { return m_keep; }
    [[nodiscard]] QString nameOf(int run) const; ///< with that of another surface

private:
    QAction* makeAction(const char* name, const char16_t* icon, const QKeySequence& keys = {});
    void build();
    void connectParts();
    void enableActions();
    [[nodiscard]] int selected() const; ///< of the kept ones; −1: none
    [[nodiscard]] RunsModel::Run presentRow() const;
    /// The summary as kept, of the present run for −1; null: there is none.
    [[nodiscard]] const ReadSummary* summaryOf(int run) const;
    [[nodiscard]] std::optional<Light> lightOf(int run) const;
    [[nodiscard]] QString detailOf(int run) const;
    [[nodiscard]] QString descriptionOf(int run) const;

    KeptRuns& m_kept;
    const ReadSummary* m_present = nullptr;
    std::optional<Light> m_presentLight;
    const Judgement* m_judgement = nullptr;
    QListView* m_list;
    RunsModel* m_runs;
    QAction *m_keep, *m_restore, *m_rename, *m_delete;
};

} // namespace sparkout
