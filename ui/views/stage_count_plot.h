// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/csv_table.h"
#include "ui/session/search_runner.h"
#include "ui/views/legend_drawing.h"

#include <qcustomplot.h>

#include <optional>

namespace sparkout {

/// The time of the quickest cycle over its number of stages, above the stepless limit and beside
/// the time of the present cycle. Where a search was stopped also the time that none is below.
class StageCountPlot : public QCustomPlot {
    Q_OBJECT
public:
    enum Key { quickest, proven, present, limit };

    explicit StageCountPlot(QWidget* parent = nullptr);

    /// No replot.
    void setSearch(SearchOutcomePtr outcome, std::optional<double> present_s);
    void setDimmed(bool dim);
    void fit();
    void toggleCurve(int key);
    void showOnly(int key);
    void retranslate();
    void restyle();

    [[nodiscard]] LegendEntries legendEntries() const;
    [[nodiscard]] CsvTable table() const;
    [[nodiscard]] QCPGraph* curve(Key key) const { return m_curves[key]; }

signals:
    void contentChanged();             ///< of the legend
    void pointed(const QString& text); ///< empty: at nothing

protected:
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void show();
    void onMouse(QMouseEvent* event);
    [[nodiscard]] static QString name(Key key);

    SearchOutcomePtr m_outcome;
    std::optional<double> m_present_s;
    CurveChoice m_choice;
    QCPAxisRect* m_rect = nullptr;
    std::array<QCPGraph*, 4> m_curves{}; ///< by Key
    bool m_dim = false;
};

} // namespace sparkout
