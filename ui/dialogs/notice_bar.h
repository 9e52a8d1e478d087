// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/fields/mark.h"

#include <QWidget>

#include <functional>
#include <vector>

class QVBoxLayout;

namespace sparkout {

/// A text made anew whenever the language changes.
using Worded = std::function<QString()>;

/// Something the user should know that need not stop the work.
struct Notice {
    struct Button {
        Worded text;               ///< without a mnemonic: the menus and the forms have theirs
        std::function<void()> act; ///< the notice is gone by then
    };
    QString key; ///< a notice replaces the one of the same key
    Mark mark = Mark::none;
    Worded text;
    std::vector<Button> buttons; ///< beside the one that closes it
};

/// The notices above the views, one a line; hidden while there is none.
class NoticeBar : public QWidget {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget* parent = nullptr);

    void add(Notice notice);
    void remove(const QString& key);
    [[nodiscard]] bool holds(const QString& key) const;
    [[nodiscard]] QString textOf(const QString& key) const; ///< empty: no such notice

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
