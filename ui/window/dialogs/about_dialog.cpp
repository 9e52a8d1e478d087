// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/about_dialog.h"

#include "core/study/engine_info.h"
#include "core/version.h"
#include "core/workbook/zip_writer.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/window/dialogs/licences_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

#include <qcustomplot.h>
#include <qpdf/DLL.h>

namespace sparkout {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
    setHelpTopic(*this, QStringLiteral("look#about"));
    setWindowTitle(tr("About Sparkout"));
    auto* icon = new QLabel(this);
    icon->setPixmap(QIcon(QStringLiteral(":/icons/sparkout.svg"))
                        .pixmap(metrics::iconProgram, metrics::iconProgram));
    icon->setAlignment(Qt::AlignTop);
    icon->setAccessibleName(tr("Icon of the program"));
    const QStringList paragraphs{
        tr("Sparkout %1").arg(QString::fromUtf8(version)),
        tr("A workbench for cylindrical grinding cycles: it computes a cycle pass by pass and "
           "checks it against the drawing."),
        versions(),
        tr("Free software under the GNU General Public License, version 3 or later. It comes "
           "without any warranty."),
    };
    auto* text = new QLabel(paragraphs.join(QStringLiteral("\n\n")), this);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setMinimumWidth(420);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* buttons = new QDialogButtonBox(this);
    auto* copy = buttons->addButton(tr("C&opy the versions"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copyVersions"));
    auto* licences = buttons->addButton(tr("&Licences…"), QDialogButtonBox::ActionRole);
    licences->setObjectName(QStringLiteral("licences"));
    buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
    connect(licences, &QPushButton::clicked, this, [this] { LicencesDialog(this).exec(); });
    connect(copy, &QPushButton::clicked, this,
            [] { QGuiApplication::clipboard()->setText(versions()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* body = new QHBoxLayout;
    body->setSpacing(metrics::wide);
    body->addWidget(icon);
    body->addWidget(text, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(body);
    layout->addWidget(buttons);
}

QString AboutDialog::versions() {
    const EngineInfo engine = engineInfo();
    const auto text = [](const std::string& part) { return QString::fromStdString(part); };
    return QStringList{
        tr("Program and engine: %1").arg(QString::fromUtf8(version)),
        tr("Vector unit of the processor in use: %1").arg(text(engine.vectorUnit)),
        tr("Qt: %1, built with %2")
            .arg(QString::fromUtf8(qVersion()), QStringLiteral(QT_VERSION_STR)),
        tr("Libraries: %1")
            .arg(QStringLiteral("QCustomPlot " QCUSTOMPLOT_VERSION_STR ", Eigen %1, JSON %2, "
                                "Boost %3, NLopt %4, qpdf " QPDF_VERSION ", zlib %5, "
                                "Snowball")
                     .arg(text(engine.eigen), text(engine.json), text(engine.boost),
                          text(engine.nlopt), QString::fromUtf8(ZipWriter::libraryVersion()))),
        tr("Compiler: %1").arg(text(engine.compiler)),
        tr("System: %1, %2").arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture()),
    }
        .join(u'\n');
}

} // namespace sparkout
