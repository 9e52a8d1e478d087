// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/remedies/remedies.h"
#include "core/study/outcome.h"

#include <QWidget>

#include <array>
#include <memory>

class QLabel;
class QPushButton;

namespace sparkout {

/// The verdict's section of what would help: a line and a button for each remedy, or why no single
/// setting helps. Hidden where there is nothing to say.
class RemedySection : public QWidget {
    Q_OBJECT
public:
    explicit RemedySection(QWidget* parent = nullptr);

    /// What was found for an outcome; while it is looked for the rest, with a button to stop.
    void setRemedies(OutcomePtr outcome, std::shared_ptr<const RemedyResult> result, bool running);
    void setStale(); ///< the inputs have changed: nothing of it can be taken any more
    void clear();
    void retranslate();

signals:
    void wanted(const sparkout::Remedy& remedy);
    void endWanted(); ///< of the work that looks for them

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

} // namespace sparkout
