// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/reports/report_actions.h"

#include "ui/kit/keyboard.h"
#include "ui/kit/theme_icon.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ReportActions)
};

} // namespace

ReportActions makeReportActions(const QByteArray& key, QWidget* owner) {
    auto* menu = new QMenu(owner);
    const auto make = [&](const char* command, const char16_t* icon) {
        QAction* action = menu->addAction(QString());
        action->setObjectName(QString::fromLatin1(QByteArray(command) + '-' + key));
        if (const QStringView drawing(icon); !drawing.isEmpty()) {
            action->setIcon(themeIcon(drawing));
        }
        return action;
    };
    QAction* const preview = make("preview", u"report");
    QAction* const print = make("print", u"print");
    menu->addSeparator();
    return {menu,
            preview,
            print,
            make("pdf", u"export"),
            make("html", u""),
            make("markdown", u""),
            make("odt", u"")};
}

void ReportActions::name(const QString& title) const {
    menu->setTitle(title);
    preview->setText(Words::tr("Print previe&w…"));
    print->setText(Words::tr("&Print…"));
    pdf->setText(Words::tr("Export P&DF…"));
    html->setText(Words::tr("Export &HTML…"));
    markdown->setText(Words::tr("Export &Markdown…"));
    odt->setText(Words::tr("Export &ODT…"));
    for (QAction* action : all()) {
        nameShortcut(*action);
    }
}

} // namespace sparkout
