// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/messages_panel.h"

#include "ui/kit/help_topic.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr int fitRole = Qt::UserRole + 1; ///< whether the line fits the stocks

} // namespace

MessagesPanel::MessagesPanel(QWidget* parent) : QListWidget(parent) {
    setHelpTopic(*this, QStringLiteral("messages"));
    setWordWrap(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { activate(*item); });
    connect(this, &QListWidget::itemDoubleClicked, this, [this](const QListWidgetItem* item) {
        if (!item->data(fitRole).toBool()) {
            activate(*item);
        }
    });
    connect(this, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
        if (item->data(fitRole).toBool()) {
            activate(*item);
        }
    });
    retranslate();
}

/// Later, since the action replaces the lines, including this one.
void MessagesPanel::activate(const QListWidgetItem& item) {
    if (item.data(fitRole).toBool()) {
        QMetaObject::invokeMethod(this, &MessagesPanel::stockFitAsked, Qt::QueuedConnection);
    } else {
        emit pathActivated(item.data(Qt::UserRole).toString().toStdString());
    }
}

void MessagesPanel::setOutcome(const OutcomePtr& outcome) {
    m_outcome = outcome;
    fill();
}

void MessagesPanel::setRefusals(std::vector<Refusal> refusals) {
    m_refusals = std::move(refusals);
    fill();
}

void MessagesPanel::offerStockFit(bool offers) {
    if (m_offersFit != offers) {
        m_offersFit = offers;
        fill();
    }
}

void MessagesPanel::fill() {
    clear();
    m_worst = Mark::none;
    for (const Refusal& refusal : m_refusals) {
        addLine(Mark::error, refusal.path,
                tr("%1; the last good value is used").arg(refusal.reason));
    }
    for (const Mark mark : {Mark::error, Mark::missing, Mark::warning}) {
        for (const Issue& issue : m_outcome ? m_outcome->issues : Issues{}) {
            if (markOf(issue) == mark) {
                addLine(mark, issue.path, issueText(issue));
                if (issue.code == IssueCode::stocksDoNotSumUp && m_offersFit) {
                    addStockFit();
                }
            }
        }
    }
    if (count() == 0) {
        auto* item = new QListWidgetItem(tr("No messages: all inputs are in order."), this);
        item->setFlags(Qt::ItemIsEnabled);
    }
    emit messagesChanged();
}

QStringList MessagesPanel::paths() const {
    QStringList paths;
    for (int i = 0; m_worst != Mark::none && i < count(); ++i) {
        if (!item(i)->data(fitRole).toBool()) { // an action, not a message
            paths << item(i)->data(Qt::UserRole).toString();
        }
    }
    return paths;
}

Mark MessagesPanel::worst() const {
    return m_worst;
}

void MessagesPanel::addStockFit() {
    auto* item = new QListWidgetItem(themeIcon(u"fit"), tr("Fit the stocks of the stages"), this);
    QFont underlined = font();
    underlined.setUnderline(true);
    item->setFont(underlined);
    item->setForeground(palette().link());
    item->setData(fitRole, true);
    item->setToolTip(tr("The first stage takes the stock that the later ones leave; if they leave "
                        "none, all keep their share"));
}

void MessagesPanel::addLine(Mark mark, const std::string& path, const QString& sentence) {
    m_worst = std::max(m_worst, mark);
    const QString where = inputLocation(path);
    auto* item = new QListWidgetItem(
        markIcon(mark), where.isEmpty() ? sentence : tr("%1: %2").arg(where, sentence), this);
    item->setData(Qt::UserRole, QString::fromStdString(path));
    item->setToolTip(tr("Double-click to go to the field"));
}

void MessagesPanel::retranslate() {
    setAccessibleName(tr("Messages"));
    fill();
}

} // namespace sparkout
