// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/judgement.h"
#include "ui/results/verdict_table.h"
#include "ui/session/kept_runs.h"

#include <QAbstractListModel>
#include <QPixmap>
#include <QSize>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QListView;

namespace sparkout {

/// The current run and the kept ones below it, each with a sample of its line, its light, a summary
/// line, and a check mark that draws it over the current one.
class RunsModel : public QAbstractListModel {
    Q_OBJECT
public:
    struct Run {
        QString name;
        QString detail;      ///< the lines below
        QString description; ///< for the tool tip
        std::optional<Light> light;
        int number = 0; ///< number of its dash; negative: not drawn
        bool chosen = true;
        bool isOwn = true;                   ///< otherwise its name is not editable here
        std::optional<JudgedState> judged{}; ///< its mark replaces the light
        friend bool operator==(const Run&, const Run&) = default;
    };
    using QAbstractListModel::QAbstractListModel;

    static constexpr QSize sample{42, 12}; ///< size of a line sample, and of the light beside it

    void setRuns(std::vector<Run> runs); ///< the current one first; it cannot be unchecked
    void setPresent(Run run);            ///< the others stay

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void chosen(int run, bool isChosen); ///< of the kept ones, from 0
    void renamed(int run, const QString& name);

private:
    [[nodiscard]] static QPixmap markOf(const Run& run, const QColor& text,
                                        const QColor& behindLight);

    std::vector<Run> m_runs;
};

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
