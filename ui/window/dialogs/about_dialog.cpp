// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/about_dialog.h"

#include "core/study/engine_info.h"
#include "core/version.h"
#include "core/workbook/zip_writer.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/session/program_log.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFile>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSysInfo>
#include <QVBoxLayout>
#include <qcustomplot.h>
#include <qpdf/DLL.h>

namespace sparkout {

namespace {

constexpr int gathering_ms = 200;

QString kindOf(QtMsgType type) {
    switch (type) {
    case QtDebugMsg:
    case QtInfoMsg: break;
    case QtWarningMsg: return LogDialog::tr("warning: ");
    case QtCriticalMsg:
    case QtFatalMsg: return LogDialog::tr("error: ");
    }
    return {};
}

} // namespace

LogDialog::LogDialog(const ProgramLog* log, QWidget* parent)
    : QDialog(parent), m_log(log), m_text(new QPlainTextEdit(this)) {
    setHelpTopic(*this, QStringLiteral("look#log"));
    m_text->setObjectName(QStringLiteral("logText"));
    m_text->setReadOnly(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* buttons = new QDialogButtonBox(this);
    m_copy = buttons->addButton(QString(), QDialogButtonBox::ActionRole);
    m_copy->setObjectName(QStringLiteral("copyLog"));
    m_close = buttons->addButton(QString(), QDialogButtonBox::RejectRole);
    connect(m_copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text, 1);
    layout->addWidget(buttons);
    resize(720, 400);
    m_pause.setSingleShot(true);
    m_pause.setInterval(gathering_ms);
    connect(&m_pause, &QTimer::timeout, this, &LogDialog::fill);
    if (m_log) {
        connect(
            m_log, &ProgramLog::changed, this, [this] { m_pause.start(); }, Qt::QueuedConnection);
    }
    retranslate();
}

void LogDialog::retranslate() {
    setWindowTitle(tr("Log of this session"));
    m_text->setAccessibleName(windowTitle());
    m_copy->setText(tr("C&opy"));
    m_close->setText(tr("C&lose"));
    fill();
}

void LogDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

QString LogDialog::text() const {
    return m_text->toPlainText();
}

void LogDialog::fill() {
    QStringList lines;
    if (m_log) {
        if (const long long dropped = m_log->dropped(); dropped > 0) {
            lines += tr("%1 earlier lines are no longer kept.").arg(dropped);
        }
        for (const LogLine& line : m_log->lines()) {
            lines +=
                line.when.toString(QStringLiteral("HH:mm:ss ")) + kindOf(line.type) + line.text;
        }
    }
    m_text->setPlainText(lines.isEmpty() ? tr("Nothing was reported.") : lines.join(u'\n'));
    m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->maximum());
}

namespace {

QByteArray resource(const QString& name) {
    QFile file(QStringLiteral(":/licences/") + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The files of a licence: the additions of the LGPL come before the GPL.
QStringList filesOf(QString licence) {
    licence.remove(QStringLiteral("-only")).remove(QStringLiteral("-or-later"));
    const QString file = licence + QStringLiteral(".txt");
    return licence == u"LGPL-3.0" ? QStringList{file, QStringLiteral("GPL-3.0.txt")}
                                  : QStringList{file};
}

} // namespace

LicencesDialog::LicencesDialog(QWidget* parent) : QDialog(parent) {
    setHelpTopic(*this, QStringLiteral("look#about"));
    setWindowTitle(tr("Licences"));
    auto* list = new QListWidget(this);
    list->setObjectName(QStringLiteral("components"));
    list->setAccessibleName(tr("Components"));
    auto* text = new QPlainTextEdit(this);
    text->setObjectName(QStringLiteral("licenceText"));
    text->setAccessibleName(tr("Licence"));
    text->setReadOnly(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    const std::vector<Component> all = components();
    for (const Component& each : all) {
        list->addItem(each.name);
    }
    connect(list, &QListWidget::currentRowChanged, this, [text, all](int row) {
        const Component& each = all[static_cast<std::size_t>(row)];
        text->setPlainText(
            QStringLiteral("%1\n© %2\n%3\n\n%4")
                .arg(each.name, each.copyright, each.licence, textsOf(each.licence)));
    });
    list->setCurrentRow(0);
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* body = new QHBoxLayout;
    body->addWidget(list, 1);
    body->addWidget(text, 3);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(body, 1);
    layout->addWidget(buttons);
    resize(880, 520);
}

std::vector<LicencesDialog::Component> LicencesDialog::components() {
    std::vector<Component> all{{QStringLiteral("Sparkout"), QStringLiteral("GPL-3.0-or-later"),
                                QStringLiteral("2026 Sparkout maintainers")}};
    const QJsonArray rows =
        QJsonDocument::fromJson(resource(QStringLiteral("components.json"))).array();
    for (const auto& row : rows) {
        const QJsonObject object = row.toObject();
        all.push_back({object.value(QStringLiteral("name")).toString(),
                       object.value(QStringLiteral("licence")).toString(),
                       object.value(QStringLiteral("copyright")).toString()});
    }
    return all;
}

QString LicencesDialog::textsOf(const QString& expression) {
    QStringList texts;
    for (const QString& licence : expression.split(QStringLiteral(" AND "))) {
        for (const QString& file : filesOf(licence)) {
            texts += QString::fromUtf8(resource(file));
            if (texts.last().isEmpty()) {
                return {};
            }
        }
    }
    return texts.join(QStringLiteral("\n\n"));
}

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
