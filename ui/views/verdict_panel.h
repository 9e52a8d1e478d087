// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/outcome.h"

#include <QWidget>

class QLabel;
class QTableView;
class QVBoxLayout;

namespace sparkout {

class VerdictModel;

/// What the cycle comes to: machining time, each requirement of the drawing with its predicted
/// value, limit, margin and light, stages, peaks. Works from 300 px width on.
class VerdictPanel : public QWidget {
    Q_OBJECT
public:
    explicit VerdictPanel(QWidget* parent = nullptr);

    [[nodiscard]] VerdictModel* model() const { return m_model; }
    [[nodiscard]] QSize sizeHint() const override { return {320, 620}; }

public slots:
    void setOutcome(sparkout::OutcomePtr outcome); ///< shown once, later in the event loop
    void retranslate();
    void copy() const; ///< the table as tab-separated text to the clipboard

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void setUpFonts();
    void buildTable();
    void showOutcome();
    void showTexts();
    void grey(bool on);
    void drawIcons();
    void fitTable();

    QLabel* m_notice = nullptr;
    QLabel* m_time = nullptr;
    QLabel* m_status = nullptr;
    QLabel* m_light = nullptr;
    QLabel* m_overall = nullptr;
    QLabel* m_stages = nullptr;
    QLabel* m_unchecked = nullptr;
    QLabel* m_peaks = nullptr;
    QVBoxLayout* m_layout = nullptr;
    QTableView* m_table = nullptr;
    VerdictModel* m_model = nullptr;

    OutcomePtr m_latest;
    OutcomePtr m_good;
    bool m_queued = false;
    bool m_fitting = false;
};

} // namespace sparkout
