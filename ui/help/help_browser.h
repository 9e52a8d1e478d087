// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

namespace sparkout {

class HelpBook;

/// Shows pages of a help book, in the colours and the font of the window.
class HelpBrowser : public QTextBrowser {
    Q_OBJECT

public:
    explicit HelpBrowser(QWidget* parent = nullptr);

    void setBook(const HelpBook* book) { m_book = book; } ///< must outlive its use here
    void openTopic(const QString& topic); ///< "feeds#mouse"; an unknown page shows the first
    [[nodiscard]] QString topic() const;  ///< the current one
    void renew();                         ///< reloads the page after a change of book, look or font
    void mark(const QString& words);      ///< every occurrence of each word

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QString styleSheetNow() const;

    const HelpBook* m_book = nullptr;
    QString m_words;
};

} // namespace sparkout
