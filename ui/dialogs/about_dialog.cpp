// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/about_dialog.h"

#include "core/version.h"
#include "ui/metrics.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QSysInfo>
#include <QVBoxLayout>

#include <qcustomplot.h>

namespace sparkout {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("About Sparkout"));
    auto* icon = new QLabel(this);
    icon->setPixmap(QIcon(QStringLiteral(":/icons/sparkout.svg")).pixmap(metrics::iconProgram, metrics::iconProgram));
    icon->setAlignment(Qt::AlignTop);
    icon->setAccessibleName(tr("Icon of the program"));
    const QStringList paragraphs{
        tr("Sparkout %1").arg(QString::fromUtf8(version)),
        tr("A workbench for cylindrical grinding cycles: computes a cycle pass by pass and holds "
           "it against the drawing."),
        tr("Built with Qt %1, QCustomPlot %2; running on Qt %3, %4.")
            .arg(QStringLiteral(QT_VERSION_STR), QStringLiteral(QCUSTOMPLOT_VERSION_STR),
                 QString::fromUtf8(qVersion()), QSysInfo::prettyProductName()),
        tr("Free software under the GNU General Public License, version 3 or later. It comes "
           "without any warranty."),
    };
    auto* text = new QLabel(paragraphs.join(QStringLiteral("\n\n")), this);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setMinimumWidth(380);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* body = new QHBoxLayout;
    body->setSpacing(metrics::wide);
    body->addWidget(icon);
    body->addWidget(text, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(body);
    layout->addWidget(buttons);
}

} // namespace sparkout
