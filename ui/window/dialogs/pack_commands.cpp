// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/pack_commands.h"

#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/pack.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/dialog_parts.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/report/logo.h"
#include "ui/session/background.h"
#include "ui/session/own_lessons.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

enum LineColumn { partColumn, nameColumn, stateColumn, choiceColumn };

QTreeWidget* newTree(const char* name, const QString& accessible, const QStringList& heads,
                     QWidget* parent) {
    auto* tree = new QTreeWidget(parent);
    tree->setObjectName(QString::fromLatin1(name));
    tree->setAccessibleName(accessible);
    tree->setHeaderLabels(heads);
    tree->setRootIsDecorated(false);
    tree->setAllColumnsShowFocus(true);
    tree->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    return tree;
}

void fitColumns(QTreeWidget& tree) {
    for (int column = 0; column < tree.columnCount(); ++column) {
        tree.resizeColumnToContents(column);
    }
}

} // namespace

PackImportDialog::PackImportDialog(Pack pack, Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_plan(std::move(pack), settings)
    , m_lines(newTree("packLines", tr("Contents of the pack"),
                      {tr("Item"), tr("Name"), tr("You have"), tr("Action")}, this))
    , m_differences(newTree("packDifferences", tr("The chosen line in detail"),
                            {tr("Input"), tr("Yours"), tr("In the pack")}, this))
    , m_state(plainLabel({}, this)) {
    setWindowTitle(tr("Import a pack"));
    setHelpTopic(*this, QStringLiteral("packs#import"));
    m_state->setObjectName(QStringLiteral("packState"));
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new AnswerButtons(tr("&Import"), tr("&Cancel"), this);
    m_take = buttons->acceptButton();
    m_take->setObjectName(QStringLiteral("importPack"));
    buttons->rejectButton()->setAutoDefault(false);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(buildHead());
    layout->addWidget(buildLines(), 1);
    layout->addWidget(m_state);
    layout->addWidget(buttons);
    resize(atFontSize(860), atFontSize(560));
    showChosen();
    m_lines->setFocus();
}

QWidget* PackImportDialog::buildHead() {
    const Pack& pack = m_plan.pack();
    auto* head = new QWidget(this);
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    for (const std::string* text : {&pack.title, &pack.note}) {
        if (text->empty()) {
            continue;
        }
        auto* label = plainLabel(QString::fromStdString(*text), head);
        if (text == &pack.title) {
            QFont bold = label->font();
            bold.setBold(true);
            label->setFont(bold);
        }
        column->addWidget(label);
    }
    if (const QString fault = m_plan.logoFault(); !fault.isEmpty()) {
        auto* label = plainLabel(tr("The logo of the pack is left out. %1").arg(fault), head);
        label->setObjectName(QStringLiteral("packLogoFault"));
        column->addWidget(label);
    }
    column->addWidget(plainLabel(tr("Your own data are replaced only if you choose so here. A pack "
                                    "contains only data: nothing in it is executed."),
                                 head));
    return head;
}

QWidget* PackImportDialog::buildLines() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_lines);
    splitter->addWidget(m_differences);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    for (std::size_t line = 0; line < m_plan.lines().size(); ++line) {
        addLine(line);
    }
    fitColumns(*m_lines);
    m_lines->header()->setStretchLastSection(false);
    m_lines->header()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
    connect(m_lines, &QTreeWidget::currentItemChanged, this, &PackImportDialog::showDifferences);
    const auto conflict =
        std::ranges::find(m_plan.lines(), PackPlan::State::different, &PackPlan::Line::state);
    const bool found = conflict != m_plan.lines().end();
    m_lines->setCurrentItem(
        m_lines->topLevelItem(found ? static_cast<int>(conflict - m_plan.lines().begin()) : 0));
    return splitter;
}

void PackImportDialog::addLine(std::size_t line) {
    const PackPlan::Line& at = m_plan.lines()[line];
    auto* item = new QTreeWidgetItem(
        m_lines, {PackParts::name(at.part), printableText(at.name), stateText(at.state)});
    item->setToolTip(nameColumn, printableText(at.note));
    const std::vector<PackPlan::Choice> choices = m_plan.choices(line);
    if (choices.size() == 1) {
        item->setText(choiceColumn, choiceText(choices.front(), at.state));
        return;
    }
    auto* box = new QComboBox(m_lines);
    box->setObjectName(QStringLiteral("packChoice%1").arg(line + 1));
    box->setAccessibleName(tr("Action for “%1”").arg(printableText(at.name)));
    for (const PackPlan::Choice choice : choices) {
        box->addItem(choiceText(choice, at.state), static_cast<int>(choice));
    }
    box->setCurrentIndex(box->findData(static_cast<int>(at.choice)));
    m_lines->setItemWidget(item, choiceColumn, box);
    item->setSizeHint(choiceColumn, box->sizeHint());
    connect(box, &QComboBox::currentIndexChanged, this, [this, box, line, item] {
        m_plan.choose(line, static_cast<PackPlan::Choice>(box->currentData().toInt()));
        m_lines->setCurrentItem(item);
        showChosen();
    });
}

void PackImportDialog::showDifferences() {
    m_differences->clear();
    const int line = m_lines->indexOfTopLevelItem(m_lines->currentItem());
    if (line < 0) {
        return;
    }
    const auto at = static_cast<std::size_t>(line);
    if (m_plan.lines()[at].state == PackPlan::State::same) {
        new QTreeWidgetItem(m_differences, {tr("No difference.")});
        m_differences->resizeColumnToContents(0);
        return;
    }
    for (const PackPlan::Difference& difference : m_plan.differences(at)) {
        new QTreeWidgetItem(m_differences, {difference.what, printableText(difference.yours),
                                            printableText(difference.packs)});
    }
    fitColumns(*m_differences);
}

void PackImportDialog::showChosen() {
    const int chosen = m_plan.chosen();
    m_take->setEnabled(chosen > 0);
    m_state->setText(m_plan.lines().empty() ? tr("The pack is empty.")
                     : chosen == 0          ? tr("Nothing is chosen.")
                                            : tr("To be imported: %1.").arg(chosen));
}

void PackImportDialog::accept() {
    const QStringList faults = m_plan.carryOut(m_settings);
    if (faults.empty()) {
        QDialog::accept();
        return;
    }
    m_state->setText(tr("Not everything could be kept: %1").arg(faults.join(u' ')));
}

QString PackImportDialog::stateText(PackPlan::State state) {
    switch (state) {
    case PackPlan::State::fresh: return tr("nothing of that name");
    case PackPlan::State::shipped: return tr("the one that comes with the program");
    case PackPlan::State::same: return tr("the same");
    case PackPlan::State::different: return tr("another of that name");
    }
    return {};
}

QString PackImportDialog::choiceText(PackPlan::Choice choice, PackPlan::State state) {
    switch (choice) {
    case PackPlan::Choice::leave:
        return state == PackPlan::State::same        ? tr("stays as it is")
               : state == PackPlan::State::different ? tr("Keep yours")
                                                     : tr("Do not import");
    case PackPlan::Choice::take:
        return state == PackPlan::State::different ? tr("Replace yours") : tr("Take");
    case PackPlan::Choice::takeBeside: return tr("Keep both");
    }
    return {};
}

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
            faults += tr("“%1” is already in the list.").arg(printableText(file));
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
    m_state->setText(m_items.empty() ? tr("You have nothing to export yet: no entry in the "
                                          "catalogues, no company and no laboratory work.")
                     : chosen == 0   ? tr("Nothing is chosen.")
                                     : tr("To be exported: %1.").arg(chosen));
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

namespace {

const QString suffix = QStringLiteral("sparkout-pack");

} // namespace

PackCommands::PackCommands(Settings& settings, QWidget* window)
    : QObject(window)
    , m_settings(settings)
    , m_window(window)
    , m_questions(m_file, m_wait, window) {}

bool PackCommands::isPack(const QString& path) {
    return path.endsWith(u'.' + suffix, Qt::CaseInsensitive);
}

void PackCommands::exportPack() {
    PackExportDialog dialog(m_settings, m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const Pack pack = dialog.pack();
    const QString title = QString::fromStdString(pack.title);
    SaveRequest request{tr("Export a pack"),
                        fileNameOf({title.isEmpty() ? tr("Pack") : title}),
                        suffix,
                        tr("Packs (*.sparkout-pack)"),
                        {}};
    request.content = [&pack]() -> std::optional<std::string> {
        std::string text = writePack(pack);
        return readPack(text).pack ? std::optional(std::move(text)) : std::nullopt;
    };
    request.guard = &m_questions;
    (void)saveWithDialog(m_window, &m_settings, request);
    m_file.dropClaim();
    m_file.unlock(); // nobody works in a pack
}

void PackCommands::importPack() {
    const QString path =
        FileDialog::openPath(m_window, tr("Import a pack"), m_settings.lastFolder(),
                             tr("Packs (*.sparkout-pack);;All files (*)"));
    if (!path.isEmpty()) {
        importFile(path);
    }
}

void PackCommands::importFile(const QString& path) {
    std::variant<std::string, FileError> bytes;
    ReadPack read;
    runAside([&] {
        bytes = readFile(systemPath(path), limits::fileBytes);
        if (const auto* text = std::get_if<std::string>(&bytes)) {
            read = readPack(*text);
        }
    });
    if (const auto* error = std::get_if<FileError>(&bytes)) {
        QMessageBox box(QMessageBox::Warning, tr("Import a pack"), readErrorText(*error),
                        QMessageBox::Ok, m_window);
        box.setTextFormat(Qt::PlainText);
        box.exec();
        return;
    }
    const QString file = QFileInfo(path).fileName();
    if (!read.pack) {
        FaultsDialog(file, read.issues, m_window).exec();
        return;
    }
    m_settings.setLastFolder(QFileInfo(path).absolutePath());
    if (PackImportDialog(*read.pack, m_settings, m_window).exec() != QDialog::Accepted) {
        return;
    }
    if (auto* notices = m_window->findChild<NoticeBar*>()) {
        notices->add({QStringLiteral("packTaken"),
                      Mark::none,
                      [file] { return tr("Imported from “%1”.").arg(printableText(file)); },
                      {}});
    }
}

} // namespace sparkout
