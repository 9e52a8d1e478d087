// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/part_runs.h"
#include "ui/session/setup_state.h"
#include "ui/table/value_table.h"

#include <QDialog>

#include <functional>
#include <map>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

/// The results of the searches and batches of the surfaces, by the ids of the surfaces.
struct PartStudies {
    std::map<int, SurfaceStudyPtr> searches, batches;

    [[nodiscard]] bool empty() const { return searches.empty() && batches.empty(); }
    void add(int id, const SurfaceStudyPtr& study);
};

enum class PartColumn { surface, diameter, time, verdict, margin, search, batch };

/// A row for each surface: diameter, cycle time, verdict and least margin, followed by the results
/// of its search and batch, if they were run; the batch is otherwise that of the verdict.
[[nodiscard]] ValueTable partTable(const SetupState& state,
                                   const std::vector<SurfaceStatus>& statuses,
                                   const PartStudies& studies);

/// The surfaces side by side: a column for each, a row for the cycle time and for every requirement
/// of any surface, with value and limit at its worst place.
[[nodiscard]] ValueTable surfaceComparison(const SetupState& state,
                                           const std::vector<SurfaceStatus>& statuses);

class CopyTable;
class Document;
class PartRuns;
class SurfaceBars;
class ValueModel;

/// The window of the whole part: verdict and times of all surfaces, their comparison, and batches
/// and searches of all of them.
class PartWindow : public QDialog {
    Q_OBJECT

public:
    /// @param ticks  the ticked options of a search
    PartWindow(Document& document, const PartRuns& runs, std::function<SearchTicks()> ticks,
               QWidget* parent = nullptr);

    [[nodiscard]] ValueModel& model() { return *m_model; }
    [[nodiscard]] PartStudy& study() { return m_study; }
    void retranslate();

signals:
    void surfaceWanted(std::size_t surface);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void fitTables(); ///< to their full height, since the page scrolls
    void showTables();
    void follow();
    void showStudies();
    void begin();
    void startBatches();
    void startSearches();
    void takeOver();                      ///< applies the found cycles, as one step of the history
    [[nodiscard]] bool isCurrent() const; ///< the studies belong to the current inputs

    Document& m_document;
    const PartRuns& m_runs;
    std::function<SearchTicks()> m_ticks;
    QLabel* m_head;
    QLabel* m_times;
    QLabel* m_state;
    ValueModel* m_model;
    ValueModel* m_compared;
    CopyTable* m_table;
    CopyTable* m_comparison;
    SurfaceBars* m_bars;
    QPushButton* m_search;
    QPushButton* m_batch;
    QPushButton* m_take;
    QPushButton* m_stop;
    QProgressBar* m_progress;
    PartStudies m_studies;
    std::vector<SurfaceStudyPtr> m_found; ///< searches with an answer, …
    std::vector<SurfaceStatePtr> m_of;    ///< … of these surfaces
    bool m_stopped = false;
    PartStudy m_study; ///< last member: stopped before the objects it reports to are destroyed
};

} // namespace sparkout
