// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/form/mark.h"
#include "ui/inputs/form_page.h"

#include <QListWidget>

namespace sparkout {

/// Errors and unusual values of the inputs, one per line. Activating a line shows its field; a line
/// below unmatched stocks fits them by one click or Enter.
class MessagesPanel : public QListWidget {
    Q_OBJECT

public:
    explicit MessagesPanel(QWidget* parent = nullptr);

    void setOutcome(const sparkout::OutcomePtr& outcome);
    void setRefusals(std::vector<Refusal> refusals);
    void offerStockFit(bool offers); ///< false where the stages are locked
    void retranslate();
    /// The inputs the lines are of, the same in any language; none while all is in order.
    [[nodiscard]] QStringList paths() const;
    [[nodiscard]] Mark worst() const; ///< worst mark of the lines

signals:
    void messagesChanged();
    void pathActivated(const std::string& path);
    void stockFitAsked();

private:
    void fill();
    void activate(const QListWidgetItem& item);
    void addStockFit();
    void addLine(Mark mark, const std::string& path, const QString& sentence);

    OutcomePtr m_outcome;
    std::vector<Refusal> m_refusals;
    Mark m_worst = Mark::none;
    bool m_offersFit = true;
};

} // namespace sparkout
