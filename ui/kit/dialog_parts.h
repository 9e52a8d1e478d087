// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QString>

class QLabel;
class QWidget;

namespace sparkout {

/// The two answers at the foot of a dialog: one accepts it, by Enter, too, the other rejects it.
class AnswerButtons : public QDialogButtonBox {
public:
    AnswerButtons(const QString& accept, const QString& reject, QDialog* dialog)
        : QDialogButtonBox(dialog)
        , m_accept(addButton(accept, AcceptRole))
        , m_reject(addButton(reject, RejectRole)) {
        m_accept->setDefault(true);
        connect(this, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
        connect(this, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    }

    [[nodiscard]] QPushButton* acceptButton() const { return m_accept; }
    [[nodiscard]] QPushButton* rejectButton() const { return m_reject; }

private:
    QPushButton* m_accept;
    QPushButton* m_reject;
};

/// A plain text that wraps.
[[nodiscard]] QLabel* plainLabel(const QString& text, QWidget* parent);
/// The same, that can be copied.
[[nodiscard]] QLabel* copyableLabel(QWidget* parent, const QString& text = {});

} // namespace sparkout
