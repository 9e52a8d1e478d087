// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/form/mark.h"

#include <QWidget>

#include <functional>
#include <vector>

class QVBoxLayout;

namespace sparkout {

/// A text composed again whenever the language changes.
using Worded = std::function<QString()>;

/// A message that need not interrupt the work.
struct Notice {
    struct Button {
        Worded text;               ///< without a mnemonic, since menus and forms have them
        std::function<void()> act; ///< called after the notice is removed
    };
    QString key; ///< a notice replaces an earlier one with the same key
    Mark mark = Mark::none;
    Worded text;
    std::vector<Button> buttons; ///< beside the close button
};

/// The notices above the views, one per line; hidden if there are none.
class NoticeBar : public QWidget {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget* parent = nullptr);

    void add(Notice notice);
    void remove(const QString& key);
    [[nodiscard]] bool holds(const QString& key) const;
    [[nodiscard]] QString textOf(const QString& key) const; ///< empty without such a notice

    /// A widget with this bar above `content`.
    [[nodiscard]] QWidget* above(QWidget* content);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QWidget* makeRow(const Notice& notice);

    std::vector<Notice> m_notices;
    QVBoxLayout* m_rows;
};

} // namespace sparkout
