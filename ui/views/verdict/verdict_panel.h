// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/session/cycle_judge.h"

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

/// What the cycle comes to: machining time, how it stands for every stock and the batch, and its
/// mark, always in sight; below them, on a page that
/// scrolls, what would help, each requirement of the drawing with its predicted value, limit and
/// margin, the form by zone, and the shop's numbers. Works from 300 px width on.
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
    /// How an outcome stands; without it the part that was run is judged alone.
    void setJudged(const sparkout::JudgedRun& judged);
    void forget(); ///< another document comes
    void retranslate();
    void copy() const; ///< the requirements as tab-separated text to the clipboard
    /// Says that so many fields of the inputs show a text that is not what was computed.
    void setRefusedFields(int n);

signals:
    /// A requirement was clicked, or Enter pressed on it.
    void requirementActivated(const sparkout::ConstraintResult& requirement);
    /// The input was asked for that turns a requirement on.
    void pathAsked(const std::string& path);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void buildHead(QWidget* head);
    QLabel* addText(QVBoxLayout* layout, const char* name);
    void buildTable();
    void buildSaving(Settings* settings); ///< of its tables
    void showOutcome();
    void showTexts();
    void showJudged();
    [[nodiscard]] JudgedRun judgedRun() const; ///< of the outcome that is shown
    void showRefusedFields();
    void grey(bool on); ///< of the inputs before the last edit: grey on a hatched ground
    /// The requirement that is explained: the one chosen, else the worst when it fails.
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
    QLabel* m_off = nullptr; ///< what is not checked
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
