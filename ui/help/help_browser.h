// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

namespace sparkout {

class HelpBook;

/// Shows pages of a help book, in the colours and the type of the window.
class HelpBrowser : public QTextBrowser {
    Q_OBJECT

public:
    explicit HelpBrowser(QWidget* parent = nullptr);

    void setBook(const HelpBook* book) { m_book = book; } ///< outlives what is shown of it
    void openTopic(const QString& topic); ///< "feeds#mouse"; a page that is none shows the first
    [[nodiscard]] QString topic() const;  ///< that is shown
    void renew();                         ///< the same page anew: of another book, look or type
    void mark(const QString& words);      ///< every place of each of the words

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QString styleSheetNow() const;

    const HelpBook* m_book = nullptr;
    QString m_words;
};

} // namespace sparkout
