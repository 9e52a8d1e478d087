// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "core/lesson/make_variants.h"
#include "ui/session/job.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace sparkout {

/// Makes some variants of a lesson, those drawn by number, and lists every try: the varied inputs,
/// the best time and its margin, or the reason for rejecting it. Writes nothing.
class VariantCheckDialog : public QDialog {
    Q_OBJECT

public:
    explicit VariantCheckDialog(const Lesson& lesson, QWidget* parent);
    ~VariantCheckDialog() override;

    [[nodiscard]] bool isBusy() const { return m_isBusy; }

private:
    void build();
    void start();
    void stop();
    void setBusy(bool busy);
    void add(const VariantTry& tried);
    void finish(const MadeVariants& made);
    [[nodiscard]] QString levelText(std::size_t input, std::size_t level) const;

    Lesson m_lesson;
    bool m_isBusy = false;
    QSpinBox* m_count;
    QPushButton* m_start;
    QPushButton* m_stop;
    QProgressBar* m_progress;
    QTableWidget* m_table;
    QLabel* m_state;
    NewestJob m_job; ///< last member: stopped before the objects it uses are destroyed
};

} // namespace sparkout
