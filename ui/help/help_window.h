// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>

class QLineEdit;
class QToolButton;
class QTreeWidget;

namespace sparkout {

class HelpBook;
class HelpBrowser;

/// The help in a window beside the work: contents or search results on the left, the page on the
/// right.
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    /// `shortcuts` makes the part of the help that depends on the window's commands.
    explicit HelpWindow(std::function<QString()> shortcuts, QWidget* parent = nullptr);
    ~HelpWindow() override;

    void openTopic(const QString& topic);
    void showFront();
    [[nodiscard]] QString topic() const;
    [[nodiscard]] const HelpBook& book() const { return *m_book; }

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void build();
    void connectParts();
    void renew(); ///< in the current language
    void fillList();
    void openListed();
    void showPlace(); ///< in the contents and in the title

    std::function<QString()> m_shortcuts;
    std::unique_ptr<HelpBook> m_book;
    QToolButton* m_back;
    QToolButton* m_forward;
    QLineEdit* m_search;
    QTreeWidget* m_list;
    HelpBrowser* m_browser;
    QString m_page;         ///< the current one
    QTimer m_renewal;       ///< after the language has changed everywhere
    bool m_showing = false; ///< the list follows the page
};

} // namespace sparkout
