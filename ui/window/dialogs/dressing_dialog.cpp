// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/dressing_dialog.h"

#include "ui/dialogs/watched_work.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/text/dressing_text.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

/// Rows of a name and its value.
QString dressingTable(const DressingText::Facts& facts) {
    QString rows;
    for (const auto& [name, value] : facts) {
        rows +=
            QStringLiteral("<tr><td style=\"padding-right: 1em\">%1</td><td><b>%2</b></td></tr>")
                .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    }
    return QStringLiteral("<table>%1</table>").arg(rows);
}

} // namespace

DressingDialog::DressingDialog(Setup setup, QWidget* parent)
    : QDialog(parent)
    , m_setup(std::move(setup))
    , m_cases(new QComboBox(this))
    , m_result(new QLabel(this)) {
    setWindowTitle(tr("Parts between dressings"));
    setHelpTopic(*this, QStringLiteral("surfaces#dressing"));
    auto* cases = new QLabel(tr("&Each part must be fit for:"), this);
    cases->setBuddy(m_cases);
    m_cases->setObjectName(QStringLiteral("dressingCases"));
    m_cases->addItem(tr("the part as stated"));
    m_cases->addItem(tr("all corners of the batches"), static_cast<int>(Scenarios::corners));
    m_cases->addItem(tr("parts of the batches"), static_cast<int>(Scenarios::latin_hypercube));
    m_cases->setEnabled(std::ranges::any_of(m_setup.surfaces, [](const GroundSurface& surface) {
        return surface.project.batch.has_value();
    }));
    m_cases->setToolTip(
        tr("Batches are set up in the view Batch; the dullness follows from the wear."));
    auto* row = new QHBoxLayout;
    row->addWidget(cases);
    row->addWidget(m_cases);
    row->addStretch();
    m_result->setObjectName(QStringLiteral("dressingResult"));
    m_result->setTextFormat(Qt::RichText);
    m_result->setWordWrap(true);
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_result->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(this);
    auto* wear = buttons->addButton(tr("&Wheel wear…"), QDialogButtonBox::ActionRole);
    auto* close = buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
    wear->setObjectName(QStringLiteral("wheelWear"));
    wear->setAutoDefault(false);
    close->setDefault(true);
    connect(wear, &QPushButton::clicked, this, [this] {
        m_wantsWear = true;
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_cases, &QComboBox::activated, this, &DressingDialog::find);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::wide);
    layout->addLayout(row);
    layout->addWidget(m_result, 1);
    layout->addWidget(buttons);
    resize(atFontSize(620), atFontSize(280));
}

void DressingDialog::find() {
    DressingOptions options;
    if (const QVariant scenarios = m_cases->currentData(); scenarios.isValid()) {
        options.scenarios = static_cast<Scenarios>(scenarios.toInt());
    }
    const std::stop_source stop;
    options.stop = stop.get_token();
    runWatched(
        this, tr("Parts between dressings"),
        [&](const KeepGoing&) { m_interval = dressingInterval(m_setup, options); }, stop);
    showResult();
}

void DressingDialog::showResult() {
    const QString refusal = DressingText::refusal(m_interval);
    m_result->setText(
        m_interval.isStopped ? tr("Stopped before there was a result.").toHtmlEscaped()
        : refusal.isEmpty()  ? dressingTable(DressingText::facts(m_setup, m_interval))
                             : refusal.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
}

} // namespace sparkout
