// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/packs/pack_export_dialog.h"

#include "core/files/safe_file.h"
#include "core/format/project_file.h"
#include "core/lesson/lesson_file.h"
#include "ui/files/own_lessons.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/report/card/logo.h"
#include "ui/session/background.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

/// A text cut to this number of UTF-8 bytes, between characters.
std::string upTo(std::size_t bytes, const QString& text) {
    QString cut = text;
    while (static_cast<std::size_t>(cut.toUtf8().size()) > bytes) {
        cut.chop(1);
    }
    return cut.toStdString();
}

} // namespace

PackExportDialog::PackExportDialog(Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_title(new QLineEdit(this))
    , m_note(new QPlainTextEdit(this))
    , m_tree(new QTreeWidget(this))
    , m_forStudents(new QCheckBox(tr("Works &for students: without right answers and rules of "
                                     "variants"),
                                  this))
    , m_state(plainLabel({}, this)) {
    setWindowTitle(tr("Export a pack"));
    setHelpTopic(*this, QStringLiteral("packs#export"));
    m_title->setObjectName(QStringLiteral("packTitle"));
    m_note->setObjectName(QStringLiteral("packNote"));
    m_note->setTabChangesFocus(true);
    m_note->setFixedHeight(m_note->fontMetrics().lineSpacing() * 4);
    m_state->setObjectName(QStringLiteral("packState"));
    m_forStudents->setObjectName(QStringLiteral("packForStudents"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Title:"), m_title);
    form->addRow(tr("&Note:"), m_note);
    auto* add = new QPushButton(tr("&Add laboratory works…"), this);
    add->setObjectName(QStringLiteral("addLessons"));
    add->setAutoDefault(false);
    auto* buttons = new AnswerButtons(tr("&Save…"), tr("&Cancel"), this);
    m_save = buttons->acceptButton();
    m_save->setObjectName(QStringLiteral("savePack"));
    buttons->rejectButton()->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_tree, 1);
    layout->addWidget(add, 0, Qt::AlignLeft);
    layout->addWidget(m_forStudents);
    layout->addWidget(m_state);
    layout->addWidget(buttons);
    buildTree();
    connect(add, &QPushButton::clicked, this, &PackExportDialog::chooseLessons);
    connect(m_tree, &QTreeWidget::itemChanged, this, &PackExportDialog::showChosen);
    resize(atFontSize(620), atFontSize(560));
    showChosen();
}

void PackExportDialog::buildTree() {
    m_tree->setObjectName(QStringLiteral("packParts"));
    m_tree->setAccessibleName(tr("Contents of the new pack"));
    m_tree->setHeaderHidden(true);
    for (const PackPart part : {PackPart::machine, PackPart::wheel, PackPart::material}) {
        const auto store = CatalogueStore::make(kindOf(part), m_settings.folder());
        for (const CatalogueItem& item : store->items()) {
            if (item.own) {
                addItem(part, entryName(item.entry),
                        [entry = item.entry](Pack& pack) { PackParts::add(entry, pack); });
            }
        }
    }
    if (const Company company = m_settings.company(); company != Company()) {
        const QString name =
            company.name.empty() ? tr("Heads of documents") : QString::fromStdString(company.name);
        const QString fault = report::Logo::fault(company.logo);
        addItem(PackPart::company, fault.isEmpty() ? name : tr("%1, without the logo").arg(name),
                [company](Pack& pack) { PackParts::setCompany(company, pack); });
        m_items.back().row->setToolTip(0, fault);
    }
    addLessons(ownLessons(m_settings.folder()));
}

QTreeWidgetItem* PackExportDialog::group(PackPart part) {
    const QString name = PackParts::name(part);
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        if (m_tree->topLevelItem(i)->text(0) == name) {
            return m_tree->topLevelItem(i);
        }
    }
    auto* made = new QTreeWidgetItem(m_tree, {name});
    made->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable
                   | Qt::ItemIsAutoTristate);
    made->setExpanded(true);
    return made;
}

void PackExportDialog::addItem(PackPart part, const QString& name, std::function<void(Pack&)> put) {
    auto* row = new QTreeWidgetItem(group(part), {printableText(name)});
    row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable
                  | Qt::ItemNeverHasChildren);
    row->setCheckState(0, Qt::Checked);
    m_items.push_back({row, std::move(put)});
}

void PackExportDialog::addLessons(const QStringList& paths) {
    QStringList faults;
    for (const QString& path : paths) {
        const QString file = QFileInfo(path).fileName();
        std::variant<std::string, FileError> bytes;
        ReadLesson read;
        runAside([&] {
            bytes = readFile(systemPath(path), limits::fileBytes);
            if (const auto* text = std::get_if<std::string>(&bytes)) {
                read = readLessonOfAnybody(*text);
            }
        });
        if (const auto* error = std::get_if<FileError>(&bytes)) {
            faults += readErrorText(*error);
        } else if (!read.lesson) {
            faults += tr("“%1” is not a laboratory work: %2")
                          .arg(printableText(file), issueText(read.issues.front()));
        } else if (!isLessonFileName(file.toStdString())) {
            faults += tr("“%1” is too long for a file name or has characters that some systems do "
                         "not allow.")
                          .arg(printableText(file));
        } else if (m_files.contains(file, Qt::CaseInsensitive)) {
            faults += tr("There is a “%1” in the list already.").arg(printableText(file));
        } else {
            m_files += file;
            addItem(PackPart::lesson, PackParts::title(*read.lesson) + QStringLiteral(" — ") + file,
                    [this, packed = PackedLesson{file.toStdString(), *read.lesson}](Pack& pack) {
                        pack.lessons.push_back(packed);
                        if (m_forStudents->isChecked()) {
                            pack.lessons.back().lesson = forStudents(packed.lesson);
                        }
                    });
        }
    }
    showChosen();
    if (!faults.empty()) {
        m_state->setText(faults.join(u'\n'));
    }
}

void PackExportDialog::chooseLessons() {
    const QString path =
        FileDialog::openPath(this, tr("Add a laboratory work"), m_settings.lastFolder(),
                             tr("Laboratory works (*.sparkout-lesson)"));
    if (!path.isEmpty()) {
        addLessons({path});
    }
}

void PackExportDialog::showChosen() {
    const auto chosen = static_cast<int>(std::ranges::count_if(
        m_items, [](const Item& item) { return item.row->checkState(0) == Qt::Checked; }));
    m_forStudents->setEnabled(!m_files.empty());
    if (m_save) {
        m_save->setEnabled(chosen > 0);
    }
    m_state->setText(m_items.empty()
                         ? tr("There is nothing of your own yet: no entry in the catalogues, no "
                              "company and no laboratory work.")
                     : chosen == 0 ? tr("Nothing is chosen.")
                                   : tr("To go into the pack: %1.").arg(chosen));
}

Pack PackExportDialog::pack() const {
    Pack pack;
    pack.title = upTo(limits::packText, m_title->text().simplified());
    pack.note = upTo(limits::packNote, m_note->toPlainText().trimmed());
    for (const Item& item : m_items) {
        if (item.row->checkState(0) == Qt::Checked) {
            item.put(pack);
        }
    }
    return pack;
}

} // namespace sparkout
