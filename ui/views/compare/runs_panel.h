// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/runs_model.h"
#include "ui/session/kept_runs.h"

#include <QWidget>

#include <optional>

class QAction;
class QListView;

namespace sparkout {

/// The list of the view "Compare": the current run and the kept ones, each with its results. A
/// check mark chooses a kept run; buttons and keys keep, restore, rename and delete.
class RunsPanel : public QWidget {
    Q_OBJECT
public:
    explicit RunsPanel(KeptRuns& kept, QWidget* parent = nullptr);

    /// Sets the current run, which may be null, and updates the kept ones.
    void setRuns(const ReadSummary* present, const Project* inputs);
    /// Sets the judgement of the current run, whose mark and text replace the light of its summary;
    /// null if unknown.
    void setJudgement(const Judgement* judgement);
    void retranslate();

    [[nodiscard]] QListView* list() const { return m_list; }
    [[nodiscard]] QAction* keep() const { return m_keep; }
    [[nodiscard]] QString nameOf(int run) const; ///< including the name of another surface

private:
    QAction* makeAction(const char* name, const char16_t* icon, const QKeySequence& keys = {});
    void build();
    void connectParts();
    void enableActions();
    [[nodiscard]] int selected() const; ///< index of a kept run; −1: none
    [[nodiscard]] RunsModel::Run presentRow() const;
    /// The stored summary, or that of the current run for −1; null if there is none.
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
