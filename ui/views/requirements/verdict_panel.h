// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/session/run_controller.h"

#include <QWidget>

#include <optional>
#include <string>

class QLabel;
class QVBoxLayout;

namespace sparkout {

class CopyTable;
class FormSection;
class RemedySection;
class Settings;
class ShopSection;
class ValueModel;

/// The verdict on the cycle: machining time, verdicts for every stock and for the batch, and its
/// mark, always visible; below them, on a scrolling page, remedies, each requirement of the drawing
/// with its predicted value, limit and margin, the form by zone, and the shop's figures. Usable
/// from a width of 300 px.
class VerdictPanel : public QWidget {
    Q_OBJECT
public:
    explicit VerdictPanel(QWidget* parent = nullptr, Settings* settings = nullptr);

    [[nodiscard]] ValueModel* model() const { return m_model; }
    [[nodiscard]] FormSection& form() const { return *m_form; }
    [[nodiscard]] ShopSection* shop() const { return m_shop; }
    [[nodiscard]] RemedySection& remedies() const { return *m_remedies; }
    [[nodiscard]] QSize sizeHint() const override { return {320, 620}; }

public slots:
    void setOutcome(sparkout::OutcomePtr outcome); ///< shown once, later in the event loop
    /// Sets the verdict on an outcome; without it only the part that was run is judged.
    void setJudged(const sparkout::JudgedRun& judged);
    void forget(); ///< before another document
    void retranslate();
    void copy() const; ///< the requirements as tab-separated text to the clipboard
    /// Shows how many fields of the inputs have a text that was not used.
    void setRefusedFields(int n);

signals:
    /// A requirement was clicked, or Enter pressed on it.
    void requirementActivated(const sparkout::ConstraintResult& requirement);
    /// The link to the input that turns a requirement on was clicked.
    void pathAsked(const std::string& path);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void buildHead(QWidget* head);
    QLabel* addText(QVBoxLayout* layout, const char* name);
    void buildTable();
    void buildSaving(Settings* settings); ///< for its tables
    void showOutcome();
    void showTexts();
    void showJudged();
    [[nodiscard]] JudgedRun judgedRun() const; ///< on the shown outcome
    void showRefusedFields();
    void grey(bool on); ///< for outdated results: grey on a hatched background
    /// The requirement to explain: the selected one, otherwise the worst if it is not met.
    [[nodiscard]] const ConstraintResult* explained() const;
    void showRequirements();
    void fitTable();

    QLabel* m_notice = nullptr;
    QLabel* m_refused = nullptr;
    QLabel* m_time = nullptr;
    QLabel* m_status = nullptr;
    QLabel* m_light = nullptr;
    QLabel* m_overall = nullptr;
    QLabel* m_stocks = nullptr;
    QLabel* m_batch = nullptr;
    QLabel* m_why = nullptr;
    QLabel* m_off = nullptr;      ///< what is not checked
    QLabel* m_partOnly = nullptr; ///< above the table, where the headline is not only of this part
    QWidget *m_head = nullptr, *m_page = nullptr;
    QVBoxLayout* m_layout = nullptr;
    RemedySection* m_remedies = nullptr;
    CopyTable* m_table = nullptr;
    ValueModel* m_model = nullptr;
    FormSection* m_form = nullptr;
    ShopSection* m_shop = nullptr;

    OutcomePtr m_latest;
    OutcomePtr m_good;
    JudgedRun m_judged;
    std::optional<ConstraintResult> m_chosen;
    int m_refusedFields = 0;
    bool m_queued = false;
    bool m_fitting = false;
};

} // namespace sparkout
