// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/part/part_table.h"
#include "ui/session/part_study.h"
#include "ui/session/setup_state.h"

#include <QDialog>

#include <functional>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;

namespace sparkout {

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
