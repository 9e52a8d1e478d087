// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_editor.h"

#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/lesson/lesson_file.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/form/struct_form.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_page.h"
#include "ui/lesson/lesson_text.h"
#include "ui/lesson/lessons_dialog.h"
#include "ui/lesson/variant_check_dialog.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int checkPause_ms = 300;
constexpr int faultRole = Qt::UserRole;
const QString editedEnding = QStringLiteral(".sparkout-lesson");

QString lessonFiles() {
    return LessonEditor::tr("Lessons (*%1)").arg(editedEnding);
}

/// The variants refer to steps by their numbers, from 1.
void renumber(Lesson& lesson, const std::function<int(int number)>& of) {
    if (lesson.variants) {
        for (FigureBound& bound : lesson.variants->figures) {
            bound.step = of(bound.step);
        }
    }
}

} // namespace

LessonEditor::LessonEditor(Document& document, Settings& settings, QWidget* window)
    : QDialog(window)
    , m_document(document)
    , m_settings(settings)
    , m_questions(m_file, m_wait, this)
    , m_pages(new QListWidget(this))
    , m_place(new QVBoxLayout)
    , m_faults(new QListWidget(this))
    , m_papers(new QMenu(this)) {
    setObjectName(QStringLiteral("lessonEditor"));
    setHelpTopic(*this, QStringLiteral("lessons#edit"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    m_check.setSingleShot(true);
    m_check.setInterval(checkPause_ms);
    connect(&m_check, &QTimer::timeout, this, &LessonEditor::showFaults);
    connect(&m_draft, &LessonDraft::changed, this, &LessonEditor::showState);
    connect(&m_draft, &LessonDraft::replaced, this, [this] {
        m_pages->setCurrentRow(0);
        showState();
        showPage();
        showFaults();
    });
    build();
    retranslate();
    beginAbout();
    resize(1040, 640);
}

void LessonEditor::build() {
    auto* files = new QHBoxLayout;
    auto* steps = new QGridLayout;
    const auto make = [this](const char* name, QString (*text)(), QString (*tip)(), auto act) {
        auto* button = new QPushButton(this);
        button->setObjectName(QString::fromLatin1(name));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, act);
        m_buttons.push_back({button, text, tip});
        return button;
    };
    files->addWidget(make(
        "editNew", [] { return tr("&New"); },
        [] { return tr("A new laboratory work about the project in the window"); },
        [this] {
            if (mayClose()) {
                beginAbout();
            }
        }));
    files->addWidget(make(
        "editOpen", [] { return tr("&Open…"); }, [] { return tr("Open a laboratory work"); },
        [this] { chooseFile(); }));
    files->addWidget(make(
        "editShipped", [] { return tr("&Copy of…"); },
        [] { return tr("A new laboratory work based on an existing one"); },
        [this] { chooseShipped(); }));
    files->addWidget(make(
        "editSave", [] { return tr("&Save"); }, [] { return tr("Save the laboratory work"); },
        [this] { save(); }));
    files->addWidget(make(
        "editSaveAs", [] { return tr("Save &as…"); },
        [] { return tr("Save the laboratory work in another file"); }, [this] { saveAs(); }));
    auto* papers = make(
        "editPapers", [] { return tr("Printin&g"); },
        [] { return tr("Worksheet, its key and the teaching guide of the laboratory work"); },
        [] {});
    papers->setMenu(m_papers);
    files->addWidget(papers);
    files->addSpacing(metrics::wide);
    m_undo = make(
        "editUndo", [] { return tr("&Undo"); }, [] { return tr("Undo the last change"); },
        [this] { m_draft.history().undo(); });
    m_redo = make(
        "editRedo", [] { return tr("&Redo"); }, [] { return tr("Redo the change"); },
        [this] { m_draft.history().redo(); });
    files->addWidget(m_undo);
    files->addWidget(m_redo);
    files->addStretch(1);
    files->addWidget(make(
        "editTake", [] { return tr("Use the &project"); },
        [] { return tr("The project in the window becomes that of the laboratory work"); },
        [this] { takeProject(); }));
    files->addWidget(make(
        "editShow", [] { return tr("S&how the project"); },
        [] { return tr("Opens the project of the laboratory work in the window for editing"); },
        [this] { emit projectWanted(); }));
    files->addWidget(make(
        "editTry", [] { return tr("&Try as a student"); },
        [] { return tr("Do the laboratory work in the window, beginning with the current step"); },
        [this] { tryOut(); }));
    const auto ofStep = [&](QPushButton* button, int row, int column) {
        steps->addWidget(button, row, column);
        m_ofSteps.push_back(button);
    };
    steps->addWidget(make(
                         "stepAdd", [] { return tr("A&dd a step"); },
                         [] { return tr("Adds a step after the current one"); },
                         [this] { addStep(false); }),
                     0, 0);
    ofStep(make(
               "stepCopy", [] { return tr("Dup&licate"); },
               [] { return tr("Duplicates the step"); }, [this] { addStep(true); }),
           0, 1);
    ofStep(make(
               "stepUp", [] { return tr("Earl&ier"); }, [] { return tr("Moves the step up"); },
               [this] { moveStep(moveUp); }),
           1, 0);
    ofStep(make(
               "stepDown", [] { return tr("Lat&er"); }, [] { return tr("Moves the step down"); },
               [this] { moveStep(moveDown); }),
           1, 1);
    ofStep(make(
               "stepRemove", [] { return tr("Re&move"); }, [] { return tr("Remove the step"); },
               [this] { removeStep(); }),
           2, 0);
    m_pages->setObjectName(QStringLiteral("editPages"));
    m_pages->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_faults->setObjectName(QStringLiteral("editFaults"));
    m_faults->setWordWrap(true);
    auto* left = new QWidget(this);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages, 1);
    column->addLayout(steps);
    auto* right = new QWidget(this);
    right->setLayout(m_place);
    m_place->setContentsMargins(0, 0, 0, 0);
    auto* split = new QSplitter(this);
    split->addWidget(left);
    split->addWidget(right);
    split->setChildrenCollapsible(false);
    split->setStretchFactor(1, 1);
    split->setSizes({230, 800});
    auto* down = new QSplitter(Qt::Vertical, this);
    down->addWidget(split);
    down->addWidget(m_faults);
    down->setChildrenCollapsible(false);
    down->setStretchFactor(0, 1);
    down->setSizes({520, 70});
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::margin);
    layout->addLayout(files);
    layout->addWidget(down, 1);
    connect(m_pages, &QListWidget::currentRowChanged, this, &LessonEditor::showPage);
    connect(m_faults, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        goTo(item->data(faultRole).toString().toStdString());
    });
    for (const auto& [keys, button] :
         {std::pair{QKeySequence::Undo, m_undo}, std::pair{QKeySequence::Redo, m_redo}}) {
        connect(new QShortcut(keys, this), &QShortcut::activated, button, &QPushButton::click);
    }
    connect(new QShortcut(QKeySequence::Save, this), &QShortcut::activated, this,
            [this] { save(); });
}

// --- the lesson and its file --------------------------------------------------------------------

void LessonEditor::beginAbout() {
    m_file.follow({}, {});
    m_draft.begin(LessonDraft::about(m_document.setup()), {});
}

/// The lesson of a file or a shipped one; empty, after showing the faults, if it is invalid.
std::optional<Lesson> LessonEditor::readFrom(const QString& path, QByteArray& hash) {
    std::string text;
    if (QFile file(path); path.startsWith(u':') && file.open(QIODevice::ReadOnly)) {
        text = file.readAll().toStdString();
    } else {
        auto read = readFile(systemPath(path), limits::fileBytes);
        if (const auto* error = std::get_if<FileError>(&read)) {
            showFailure(this, tr("The file was not opened"), readErrorText(*error));
            return {};
        }
        text = std::get<std::string>(std::move(read));
    }
    ReadLesson read = readLesson(text);
    if (!read.lesson) {
        FaultsDialog(path, read.issues, this).exec();
    }
    hash = contentHash(text);
    return std::move(read.lesson);
}

bool LessonEditor::openLesson(const QString& given) {
    const bool isShipped = given.startsWith(u':');
    const QString path = isShipped ? given : QFileInfo(given).absoluteFilePath();
    const auto opening =
        isShipped ? GuardQuestions::Opening::copy : m_questions.wayToOpen(path); // first
    if (!opening) {
        return false;
    }
    QByteArray hash;
    auto lesson = readFrom(path, hash);
    if (!lesson) {
        m_file.dropClaim();
        return false;
    }
    const bool isCopy = *opening == GuardQuestions::Opening::copy;
    m_file.follow(isCopy ? QString() : path, isCopy ? QByteArray() : hash,
                  *opening == GuardQuestions::Opening::readOnly);
    m_draft.begin(std::move(*lesson), m_file.path());
    return true;
}

void LessonEditor::chooseFile() {
    if (!mayClose()) {
        return;
    }
    const QString path = FileDialog::openPath(this, tr("Open a laboratory work"),
                                              m_settings.lastFolder(), lessonFiles());
    if (!path.isEmpty()) {
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
        openLesson(path);
    }
}

void LessonEditor::chooseShipped() {
    if (!mayClose()) {
        return;
    }
    LessonsDialog dialog(m_settings.folder(), this);
    if (dialog.exec() != QDialog::Accepted || dialog.chosen().isEmpty()) {
        return;
    }
    QByteArray hash;
    if (auto lesson = readFrom(dialog.chosen(), hash)) {
        m_file.follow({}, {});
        m_draft.begin(std::move(*lesson), {});
    }
}

/// A lesson that could not be opened again is not written.
bool LessonEditor::isWhole() {
    showFaults();
    const bool isWhole = m_draft.faults().empty() && StructForm::refusals(*this).empty();
    if (!isWhole) {
        showFailure(this, tr("The laboratory work has faults"),
                    tr("They are listed below the pages; a double click leads to each of them."));
    }
    return isWhole;
}

bool LessonEditor::save() {
    return m_draft.path().isEmpty() || m_file.isReadOnly() ? saveAs()
                                                           : isWhole() && write(m_draft.path());
}

bool LessonEditor::saveAs() {
    if (!isWhole()) {
        return false;
    }
    const QString name = m_draft.path().isEmpty()
                             ? m_settings.lastFolder() + u'/'
                                   + fileNameOf({LessonText::of(m_draft.lesson().title)})
                                   + editedEnding
                             : m_draft.path();
    const QString path = FileDialog::savePath(this, tr("Save the laboratory work"), name,
                                              lessonFiles(), editedEnding);
    return !path.isEmpty() && write(path);
}

bool LessonEditor::write(const QString& path) {
    const auto text = [lesson = m_draft.lesson()]() -> std::optional<std::string> {
        std::string written = writeLesson(lesson);
        return readLesson(written).lesson ? std::optional(std::move(written)) : std::nullopt;
    };
    switch (m_questions.save(path, Reloading::offered, text)) {
    case GuardQuestions::Outcome::saved:
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
        m_draft.markSaved(path);
        return true;
    case GuardQuestions::Outcome::elsewhere: return saveAs();
    case GuardQuestions::Outcome::reload: reload(); break;
    case GuardQuestions::Outcome::cancelled: break;
    case GuardQuestions::Outcome::failed:
        m_file.dropClaim();
        showFailure(this, tr("The laboratory work is not saved"),
                    saveErrorText(*m_questions.error()));
    }
    return false;
}

/// The history keeps the previous contents.
void LessonEditor::reload() {
    const QString path = m_draft.path();
    QByteArray hash;
    if (auto lesson = readFrom(path, hash)) {
        m_draft.edit({}, [&lesson](Lesson& now) { now = std::move(*lesson); });
        m_file.follow(path, hash);
        m_draft.markSaved(path);
    }
}

bool LessonEditor::mayClose() {
    if (!m_draft.isChanged()) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("The laboratory work “%1” has changes that are not saved.").arg(fileName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setTextFormat(Qt::PlainText);
    box.button(QMessageBox::Save)->setText(tr("&Save"));
    box.button(QMessageBox::Discard)->setText(tr("&Do not save"));
    box.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
    for (const auto& [which, name] : {std::pair{QMessageBox::Save, "keepLesson"},
                                      std::pair{QMessageBox::Discard, "discardLesson"}}) {
        box.button(which)->setObjectName(QString::fromLatin1(name));
    }
    box.setDefaultButton(QMessageBox::Save);
    box.setEscapeButton(QMessageBox::Cancel);
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void LessonEditor::reject() {
    if (mayClose()) {
        beginAbout(); // discarded changes are not restored
        QDialog::reject();
    }
}

QString LessonEditor::fileName() const {
    if (!m_draft.path().isEmpty()) {
        return printableText(QFileInfo(m_draft.path()).fileName());
    }
    const QString title = LessonText::of(m_draft.lesson().title);
    return title.isEmpty() ? tr("not saved yet") : title;
}

void LessonEditor::tryOut() {
    if (isWhole()) {
        emit trialWanted(m_draft.lesson(), static_cast<std::size_t>(std::max(step(), 0)));
    }
}

void LessonEditor::checkVariants() {
    if (isWhole()) {
        VariantCheckDialog(m_draft.lesson(), this).exec();
    }
}

void LessonEditor::takeProject() {
    m_draft.edit(
        {}, [this](Lesson& lesson) { lesson.base = LessonDraft::about(m_document.setup()).base; });
    showPage(); // other inputs
}

// --- pages --------------------------------------------------------------------------------------

int LessonEditor::step() const {
    return m_pages->currentRow() - 1;
}

void LessonEditor::showPage() {
    if (m_page) {
        m_page->hide();
        m_page->setParent(nullptr);
        m_page->deleteLater();
        m_page = nullptr;
    }
    const int number = step();
    m_shown = number;
    if (number >= static_cast<int>(m_draft.lesson().steps.size())) {
        return; // the list follows in a moment
    }
    m_page = number < 0 ? new LessonPage(m_draft, this)
                        : new LessonPage(m_draft, static_cast<std::size_t>(number), this);
    m_page->setObjectName(QStringLiteral("editPage"));
    m_page->setAccessibleName(m_pages->currentItem()->text());
    m_place->addWidget(m_page);
    connect(m_page, &LessonPage::checkWanted, this, &LessonEditor::checkVariants);
    showState();
}

void LessonEditor::showState() {
    const auto& steps = m_draft.lesson().steps;
    const int row = std::clamp(m_pages->currentRow(), 0, static_cast<int>(steps.size()));
    {
        const QSignalBlocker quiet(m_pages);
        while (m_pages->count() > static_cast<int>(steps.size()) + 1) {
            delete m_pages->takeItem(m_pages->count() - 1);
        }
        while (m_pages->count() < static_cast<int>(steps.size()) + 1) {
            m_pages->addItem(QString());
        }
        m_pages->item(0)->setText(tr("The work as a whole"));
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const auto kind = static_cast<std::size_t>(steps[i].goal.kind());
            m_pages->item(static_cast<int>(i) + 1)
                ->setText(tr("Step %1. %2")
                              .arg(i + 1)
                              .arg(inputText(tableOf<Goal>().fields[kind].label)));
        }
    }
    m_pages->setCurrentRow(row);
    if (m_page && m_shown != step()) { // the dropped text was not reported
        showPage();
    }
    for (QPushButton* button : m_ofSteps) {
        button->setEnabled(row > 0);
    }
    m_undo->setEnabled(m_draft.history().canUndo());
    m_redo->setEnabled(m_draft.history().canRedo());
    setWindowTitle(m_file.isReadOnly() ? tr("Laboratory work: %1[*] (read-only)").arg(fileName())
                                       : tr("Laboratory work: %1[*]").arg(fileName()));
    setWindowModified(m_draft.isChanged());
    m_check.start();
}

void LessonEditor::showFaults() {
    m_check.stop();
    m_faults->clear();
    for (const Refusal& refused : StructForm::refusals(*this)) {
        m_faults->addItem(
            QStringLiteral("%1: %2").arg(LessonDraft::location(refused.path), refused.reason));
    }
    for (const Issue& issue : m_draft.faults()) {
        auto* item = new QListWidgetItem(
            QStringLiteral("%1: %2").arg(LessonDraft::location(issue.path), fileIssueText(issue)),
            m_faults);
        item->setData(faultRole, QString::fromStdString(issue.path));
    }
    if (m_faults->count() == 0) {
        m_faults->addItem(tr("No faults: the laboratory work can be saved and tried."));
    }
}

void LessonEditor::goTo(const std::string& path) {
    constexpr std::string_view steps = "/steps/";
    const bool isOfStep = path.starts_with(steps);
    m_pages->setCurrentRow(isOfStep ? std::atoi(path.c_str() + steps.size()) + 1 : 0);
    if (m_page && !path.empty()) {
        m_page->goTo(path);
    }
}

// --- steps --------------------------------------------------------------------------------------

void LessonEditor::addStep(bool copies) {
    const auto at = static_cast<std::size_t>(step() + 1);
    m_draft.edit({}, [&](Lesson& lesson) {
        LessonStep added = LessonDraft::about({}).steps.front();
        if (copies) {
            added = lesson.steps[at - 1];
        }
        lesson.steps.insert(lesson.steps.begin() + static_cast<std::ptrdiff_t>(at),
                            std::move(added));
        renumber(lesson, [at](int number) { return number > int(at) ? number + 1 : number; });
    });
    m_pages->setCurrentRow(static_cast<int>(at) + 1);
}

void LessonEditor::moveStep(Move by) {
    const int from = step(), to = from + by;
    if (to < 0 || to >= static_cast<int>(m_draft.lesson().steps.size())) {
        return;
    }
    m_draft.edit({}, [from, to](Lesson& lesson) {
        std::swap(lesson.steps[static_cast<std::size_t>(from)],
                  lesson.steps[static_cast<std::size_t>(to)]);
        renumber(lesson, [from, to](int number) {
            return number == from + 1 ? to + 1 : number == to + 1 ? from + 1 : number;
        });
    });
    m_pages->setCurrentRow(to + 1);
}

void LessonEditor::removeStep() {
    const auto at = static_cast<std::ptrdiff_t>(step());
    m_draft.edit({}, [at](Lesson& lesson) {
        lesson.steps.erase(lesson.steps.begin() + at);
        if (lesson.variants) {
            std::erase_if(lesson.variants->figures,
                          [at](const FigureBound& bound) { return bound.step == at + 1; });
        }
        renumber(lesson, [at](int number) { return number > int(at) + 1 ? number - 1 : number; });
    });
    showPage();
}

void LessonEditor::retranslate() {
    for (const Button& each : m_buttons) {
        each.button->setText(each.text());
        each.button->setToolTip(each.tip());
    }
    m_pages->setAccessibleName(tr("The work and its steps"));
    m_faults->setAccessibleName(tr("Faults of the laboratory work"));
    if (m_page) {
        showPage();
        showFaults();
    }
}

} // namespace sparkout
