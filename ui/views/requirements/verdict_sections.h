// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "core/study/remedies.h"
#include "ui/dialogs/copy_table.h"
#include "words/remedy_words.h"

#include <QWidget>

#include <array>
#include <memory>

class QLabel;
class QPushButton;

namespace sparkout {

class ValueModel;

/// A table of numbers for a narrow panel: a row for each quantity, with little space between the
/// columns. It is as high as its rows and scrolls sideways if its columns are too wide.
class NarrowTable : public CopyTable {
    Q_OBJECT
public:
    explicit NarrowTable(ValueModel& model, QWidget* parent = nullptr);

    void fit(); ///< fits columns and height to the model

private:
    bool m_fitting = false;
};

/// The verdict's section on the form of each zone; hidden where a zone is one section.
class FormSection : public QWidget {
    Q_OBJECT
public:
    explicit FormSection(QWidget* parent = nullptr);

    void setOutcome(const OutcomePtr& outcome);
    void setGreyed(bool grey, const QPalette& palette); ///< of the labels
    void retranslate();

    [[nodiscard]] ValueModel* model() const { return m_model; }
    [[nodiscard]] NarrowTable* table() const { return m_table; }

private:
    void showTitle();
    void showTable();

    OutcomePtr m_outcome;
    QLabel* m_title;
    ValueModel* m_model;
    NarrowTable* m_table;
};

/// The verdict's section on the shop's figures: title, table, and values outside their band.
class ShopSection : public QWidget {
    Q_OBJECT
public:
    explicit ShopSection(QWidget* parent = nullptr);

    void setOutcome(const OutcomePtr& outcome);
    void setGreyed(bool grey, const QPalette& palette); ///< of the labels
    void retranslate();

    [[nodiscard]] ValueModel* model() const { return m_model; }
    [[nodiscard]] NarrowTable* table() const { return m_table; }

private:
    void showTable();

    QLabel* m_title;
    ValueModel* m_model;
    NarrowTable* m_table;
    QWidget* m_remarksLine;
    QLabel* m_icon;
    QLabel* m_remarks;
    OutcomePtr m_outcome;
};

/// The verdict's section on remedies: a line and a button for each, or the reason why no single
/// setting helps. Hidden if there is nothing to show.
class RemedySection : public QWidget {
    Q_OBJECT
public:
    explicit RemedySection(QWidget* parent = nullptr);

    /// Sets the result for an outcome, or the partial result of a running search, with a button to
    /// stop.
    void setRemedies(OutcomePtr outcome, std::shared_ptr<const RemedyResult> result, bool running);
    void setStale(); ///< the inputs have changed: nothing can be applied
    void clear();
    void retranslate();

signals:
    void wanted(const sparkout::Remedy& remedy);
    void endWanted(); ///< stop the search

private:
    struct Line {
        QWidget* line = nullptr;
        QLabel* text = nullptr;
        QPushButton* take = nullptr;
    };

    void build();
    void showResult();
    void showLine(std::size_t index);
    [[nodiscard]] const Project& project() const { return m_outcome->result.project; }
    [[nodiscard]] QString note() const;

    QLabel* m_title;
    std::array<Line, RemedyResult::most> m_lines{};
    QLabel* m_note;
    QPushButton* m_end;
    OutcomePtr m_outcome;
    std::shared_ptr<const RemedyResult> m_result;
    bool m_running = false;
};

/// Remedies in the current language, with the window's number format and names.
class RemedyText : public RemedyWording {
protected:
    [[nodiscard]] std::string translated(const char* text) const override;
    [[nodiscard]] std::string number(double value) const override;
    [[nodiscard]] std::string unit(const char* unit) const override;
    [[nodiscard]] std::string input(const char* label, const char* symbol) const override;
    [[nodiscard]] std::string requirement(ConstraintKind kind) const override;
};

} // namespace sparkout
