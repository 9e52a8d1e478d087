// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QStringList>
#include <QTest>
#include <QTimer>

#include <functional>

/// Answers the dialogs that come up, one after the other, with real clicks and keys: the object
/// name of a button, "Yes", "Escape", "Enter", or "file:PATH" for a file dialog. A dialog that
/// nobody expected, or that does not go away, is an error. The progress of a long work, which shows
/// on a slow machine alone, is waited for, unless the next answer is its "stopWork".
class DialogAnswers : public QObject {
public:
    explicit DialogAnswers(QStringList answers) : m_answers(std::move(answers)) {
        m_poll.setInterval(10);
        connect(&m_poll, &QTimer::timeout, this, &DialogAnswers::look);
        m_poll.start();
    }

    /// Looks at a dialog before it is answered.
    std::function<void(QDialog&)> seen;

    [[nodiscard]] const QStringList& texts() const { return m_texts; } ///< of the message boxes
    [[nodiscard]] QString text() const { return m_texts.value(0); }
    [[nodiscard]] QString fault() const {
        if (!m_fault.isEmpty() || m_next == m_answers.size()) {
            return m_fault;
        }
        return QStringLiteral("not asked: ") + m_answers[m_next];
    }

private:
    void look() {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog || !dialog->isVisible() || m_beingAnswered.contains(dialog)) {
            return;
        }
        const QString stop = QStringLiteral("stopWork");
        if (dialog->findChild<QAbstractButton*>(stop) && m_answers.value(m_next) != stop) {
            return;
        }
        if (const auto* box = qobject_cast<QMessageBox*>(dialog)) {
            m_texts += box->text().remove(QChar(0x200b));
        }
        if (m_next == m_answers.size()) {
            m_fault = QStringLiteral("unexpected: ") + dialog->windowTitle() + u' '
                      + m_texts.value(m_texts.size() - 1);
            dialog->reject();
            return;
        }
        if (seen) {
            seen(*dialog);
        }
        m_beingAnswered += dialog;
        // Not within the timer: a dialog that opens another one would keep it from firing.
        QMetaObject::invokeMethod(
            this,
            [this, dialog, open = QPointer(dialog), what = m_answers[m_next++]] {
                if (open) {
                    answer(*open, what);
                }
                m_beingAnswered.removeOne(dialog); // still there: the next answer is for it too
            },
            Qt::QueuedConnection);
    }

    void answer(QDialog& dialog, const QString& what) {
        if (what == u"Escape" || what == u"Enter") {
            QTest::keyClick(&dialog, what == u"Escape" ? Qt::Key_Escape : Qt::Key_Return);
        } else if (what.startsWith(u"file:")) {
            auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            name->setText(what.mid(5));
            QTest::keyClick(name, Qt::Key_Return);
        } else if (auto* box = qobject_cast<QMessageBox*>(&dialog); box && what == u"Yes") {
            QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
        } else if (auto* button = dialog.findChild<QAbstractButton*>(what)) {
            QTest::mouseClick(button, Qt::LeftButton);
        } else {
            m_fault = QStringLiteral("no button %1 in %2").arg(what, dialog.windowTitle());
            for (const auto* label : dialog.findChildren<QLabel*>()) {
                m_fault += u'|' + label->text();
            }
            for (const auto* list : dialog.findChildren<QListWidget*>()) {
                m_fault += list->count() > 0 ? u'|' + list->item(0)->text() : QString();
            }
            dialog.reject();
        }
    }

    QStringList m_answers;
    QStringList m_texts;
    QString m_fault;
    qsizetype m_next = 0;
    QTimer m_poll;
    QList<QDialog*> m_beingAnswered; ///< they may have opened others meanwhile
};
