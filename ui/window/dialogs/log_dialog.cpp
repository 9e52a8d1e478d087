// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/log_dialog.h"

#include "ui/kit/help_topic.h"
#include "ui/session/program_log.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

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

} // namespace sparkout
