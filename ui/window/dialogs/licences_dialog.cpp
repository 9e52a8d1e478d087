// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/licences_dialog.h"

#include "ui/kit/help_topic.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace sparkout {

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

} // namespace sparkout
