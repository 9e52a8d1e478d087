// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/marks_dialog.h"

#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/lesson/best_table.h"
#include "core/lesson/grading.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/work.h"
#include "ui/dialogs/copy_table.h"
#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/dialogs/table_file.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/lesson/lesson_text.h"
#include "ui/session/project_io.h"
#include "ui/session/settings.h"
#include "ui/table/value_table.h"
#include "ui/text/file_error_text.h"
#include "ui/text/goal_text.h"
#include "ui/text/texts.h"
#include "words/lesson_words.h"

#include <QCoreApplication>
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace sparkout {

namespace {

struct MarksTable {
    Q_DECLARE_TR_FUNCTIONS(MarksTable)
};

std::vector<ValueHead> headsOf(const Lesson& lesson) {
    std::vector<ValueHead> heads{
        {.text = MarksTable::tr("Student"), .key = "student", .isText = true},
        {.text = MarksTable::tr("Group"), .key = "group", .isText = true},
        {.text = MarksTable::tr("Variant"), .key = "variant"}};
    for (std::size_t i = 1; i <= lesson.steps.size(); ++i) {
        heads.push_back({.text = QString::number(i), .name = MarksTable::tr("Step %1").arg(i)});
    }
    heads.push_back({.text = MarksTable::tr("Points"), .key = "points"});
    heads.push_back({.text = MarksTable::tr("of"), .key = "most"});
    heads.push_back({.text = MarksTable::tr("To be marked"), .key = "pending"});
    heads.push_back({.text = MarksTable::tr("Time, min"), .key = "time"});
    heads.push_back({.text = MarksTable::tr("Remarks"), .key = "remarks", .isText = true});
    return heads;
}

ValueCell pointsCell(double points) {
    return {.text = LessonText::points(points), .value = points};
}

ValueCell variantCell(const GradedWork& work) {
    return work.variant > 0
               ? ValueCell{.text = QString::number(work.variant), .value = double(work.variant)}
               : ValueCell();
}

ValueCell timeCell(const GradedWork& work) {
    constexpr int decimals = 3;
    return work.time_min ? ValueCell{.text = QLocale().toString(*work.time_min, 'f', decimals),
                                     .value = *work.time_min}
                         : ValueCell();
}

/// The remarks on a work, on one line.
QString workRemarks(const GradedWork& work) {
    QStringList texts;
    for (const WorkFlag flag : work.flags) {
        QString text = QCoreApplication::translate("Grading", flagText(flag));
        if (flag == WorkFlag::copied && !work.copiedFrom.empty()) {
            QStringList others;
            for (const std::string& other : work.copiedFrom) {
                others += QString::fromStdString(other);
            }
            text = MarksTable::tr("%1: %2").arg(text, others.join(QStringLiteral(", ")));
        }
        texts += text;
    }
    return texts.join(QStringLiteral("; "));
}

std::vector<ValueCell> cellsOf(const GradedWork& work, std::size_t steps) {
    std::vector<ValueCell> cells{
        {.text = QString::fromStdString(work.name.empty() ? work.file : work.name)},
        {.text = QString::fromStdString(work.group)},
        variantCell(work)};
    for (std::size_t i = 0; i < steps; ++i) {
        cells.push_back(i < work.steps.size()
                            ? pointsCell(work.steps[i].points)
                            : ValueCell{.text = QStringLiteral("—"), .value = QString()});
    }
    cells.push_back(pointsCell(work.points));
    cells.push_back(pointsCell(work.most));
    cells.push_back(work.pending > 0 ? pointsCell(work.pending) : ValueCell{.value = work.pending});
    cells.push_back(timeCell(work));
    cells.push_back({.text = workRemarks(work)});
    return cells;
}

/// The marks of a class: a row for each work, the points by step, their sum and remarks.
ValueTable marksTable(const Lesson& lesson, const std::vector<GradedWork>& works) {
    ValueTable table{.isList = true};
    if (works.empty()) {
        return table;
    }
    table.columns = headsOf(lesson);
    for (const GradedWork& work : works) {
        std::vector<ValueCell> cells = cellsOf(work, lesson.steps.size());
        const QString name = cells.front().text;
        table.addRow({.text = name}, std::move(cells));
    }
    return table;
}

const QString workSuffix = QStringLiteral("sparkout-work");
const QString lessonSuffix = QStringLiteral("sparkout-lesson");
constexpr qsizetype mostWorks = 5000;

std::optional<std::string> fileContent(const QString& path, QStringList& faults) {
    auto read = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&read)) {
        faults += readErrorText(*error);
        return std::nullopt;
    }
    return std::get<std::string>(std::move(read));
}

QStringList worksIn(const QString& folder) {
    QStringList paths;
    const QDir dir(folder);
    for (const QString& name :
         dir.entryList({QStringLiteral("*.") + workSuffix}, QDir::Files, QDir::Name)) {
        paths += dir.filePath(name);
    }
    return paths;
}

} // namespace

MarksDialog::MarksDialog(Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_model(new ValueModel(this))
    , m_inputs(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_table(new CopyTable(*m_model, this))
    , m_detail(new QTextBrowser(this)) {
    setHelpTopic(*this, QStringLiteral("lessons#mark"));
    setWindowTitle(tr("Mark works"));
    setAcceptDrops(true);
    build();
    showInputs();
    resize(1000, 600);
}

MarksDialog::~MarksDialog() {
    m_marking.request_stop();
    m_job.stop();
}

void MarksDialog::build() {
    m_inputs->setObjectName(QStringLiteral("marksInputs"));
    m_inputs->setTextFormat(Qt::PlainText);
    m_inputs->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("marksTable"));
    m_table->setAccessibleName(tr("Marks"));
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setUniformRows();
    m_table->setArrangeable(&m_settings);
    m_table->retranslate();
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_detail->setObjectName(QStringLiteral("marksDetail"));
    m_detail->setAccessibleName(tr("The work by its steps"));
    m_detail->setOpenLinks(false);
    m_progress->setVisible(false);
    auto* buttons = new QHBoxLayout;
    const auto button = [&](const QString& text, const char* name, auto act) {
        auto* made = new QPushButton(text, this);
        made->setObjectName(QString::fromLatin1(name));
        made->setAutoDefault(false);
        connect(made, &QPushButton::clicked, this, act);
        buttons->addWidget(made);
        return made;
    };
    button(tr("&Lesson…"), "marksLesson", [this] { addLesson(); });
    button(tr("&Work…"), "marksWork", [this] { addWorks(false); });
    button(tr("Works of a &folder…"), "marksFolder", [this] { addWorks(true); });
    button(tr("List or &table…"), "marksList", [this] { addList(); });
    buttons->addStretch(1);
    m_mark = button(tr("&Mark"), "marksMark", [this] { mark(); });
    m_mark->setDefault(true);
    m_stop = button(tr("&Stop"), "marksStop", [this] {
        m_marking.request_stop(); // the finished part is shown
        m_stop->setEnabled(false);
    });
    m_export = button(tr("&Export CSV…"), "marksExport", [this] { exportCsv(); });
    m_book = button(tr("Export &XLSX…"), "marksBook", [this] {
        saveTable(this, &m_settings, {{m_lessonName, tr("marks")}, m_model->table().asTable()},
                  TableFormat::xlsx);
    });
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::margin);
    layout->addWidget(m_inputs);
    layout->addLayout(buttons);
    layout->addWidget(m_progress);
    layout->addWidget(m_table, 3);
    layout->addWidget(m_detail, 2);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &MarksDialog::showWork);
}

void MarksDialog::showInputs() {
    QStringList lines;
    lines += m_lesson ? tr("Lesson: %1").arg(LessonText::of(m_lesson->title))
                      : tr("Lesson: none yet. Drop it here, or choose it.");
    lines += m_works.isEmpty() ? tr("Works: none yet. Drop files or a folder here, or choose them.")
                               : tr("Works: %1").arg(m_works.size());
    if (!m_wish.group.empty()) {
        lines += tr("List of students: %1").arg(m_wish.group.size());
    }
    if (!m_wish.best.empty()) {
        lines += tr("Table of best answers: %1 variants").arg(m_wish.best.size());
    }
    m_inputs->setText(lines.join(u'\n'));
    setBusy(m_isBusy);
}

void MarksDialog::setBusy(bool busy) {
    m_isBusy = busy;
    m_progress->setVisible(busy);
    m_stop->setVisible(busy);
    m_stop->setEnabled(busy);
    m_mark->setVisible(!busy);
    m_mark->setEnabled(m_lesson && (!m_works.isEmpty() || !m_wish.group.empty()));
    m_export->setEnabled(!busy && !m_marks.empty());
    m_book->setEnabled(m_export->isEnabled());
}

void MarksDialog::addFile(const QString& path, QStringList& faults) {
    const QFileInfo file(path);
    if (file.isDir()) {
        m_works += worksIn(path);
        for (const QString& name : QDir(path).entryList({QStringLiteral("*.csv")}, QDir::Files)) {
            if (name.startsWith(QStringLiteral("teacher-best-answers"))) {
                addFile(QDir(path).filePath(name), faults);
            }
        }
        return;
    }
    if (file.suffix() == workSuffix) {
        m_works += path;
        return;
    }
    const auto content = fileContent(path, faults);
    if (!content) {
        return;
    }
    if (file.suffix() == lessonSuffix) {
        ReadLesson read = readLesson(*content);
        if (read.lesson) {
            m_lesson = std::move(read.lesson);
            m_lessonName = file.completeBaseName();
        } else {
            FaultsDialog(path, read.issues, this).exec();
        }
        return;
    }
    if (ReadBestTable table = readBestTable(*content); table.faultLine == 0) {
        m_wish.best = std::move(table.rows);
        return;
    }
    GroupList list = readGroup(*content);
    if (list.faults.empty()) {
        m_wish.group = std::move(list.students);
        return;
    }
    const GroupFault& fault = list.faults.front();
    faults += tr("%1, line %2: %3.")
                  .arg(printableText(file.fileName()))
                  .arg(fault.line)
                  .arg(QCoreApplication::translate("Grading", groupFaultText(fault.kind)));
}

void MarksDialog::add(const QStringList& paths) {
    QStringList faults;
    for (const QString& path : paths) {
        addFile(QFileInfo(path).absoluteFilePath(), faults);
    }
    m_works.removeDuplicates();
    m_works.sort();
    if (m_works.size() > mostWorks) {
        m_works = m_works.mid(0, mostWorks);
        faults +=
            tr("There are more than %1 works; only the first ones are marked.").arg(mostWorks);
    }
    showInputs();
    if (!faults.isEmpty()) {
        showFailure(this, tr("Not accepted"), faults.join(u'\n'));
    }
}

void MarksDialog::addLesson() {
    const QString path = FileDialog::openPath(this, tr("The lesson"), m_settings.lastFolder(),
                                              tr("Lessons (*.%1)").arg(lessonSuffix));
    if (!path.isEmpty()) {
        add({path});
    }
}

void MarksDialog::addWorks(bool wholeFolder) {
    const QString path = FileDialog::openPath(
        this, wholeFolder ? tr("One of the works of the folder") : tr("A work"),
        m_settings.lastFolder(), tr("Works (*.%1)").arg(workSuffix));
    if (!path.isEmpty()) {
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
        add({wholeFolder ? QFileInfo(path).absolutePath() : path});
    }
}

void MarksDialog::addList() {
    const QString path =
        FileDialog::openPath(this, tr("List of students or table of best answers"),
                             m_settings.lastFolder(), tr("Tables (*.csv);;All files (*)"));
    if (!path.isEmpty()) {
        add({path});
    }
}

void MarksDialog::mark() {
    if (m_isBusy || !m_lesson) {
        return;
    }
    m_progress->setRange(0, static_cast<int>(m_works.size()));
    m_progress->setValue(0);
    setBusy(true);
    m_marking = std::stop_source();
    m_job.start(
        [this, lesson = *m_lesson, paths = m_works, wish = m_wish,
         stop = m_marking.get_token()](const std::stop_token&, const NewestJob::Post& post) {
            const ClassWorks works(static_cast<std::size_t>(paths.size()), [&paths](std::size_t i) {
                const QString& path = paths[static_cast<qsizetype>(i)];
                QStringList faults; // it is marked as unreadable
                return HandedIn{QFileInfo(path).fileName().toStdString(),
                                fileContent(path, faults).value_or(std::string())};
            });
            auto marked = gradeClass(lesson, works, wish, stop, [&](std::size_t done) {
                post([this, done] { m_progress->setValue(static_cast<int>(done)); });
            });
            post([this, marked = std::move(marked)] { take(marked); });
        });
}

void MarksDialog::take(std::vector<GradedWork> works) {
    const auto marks = static_cast<qsizetype>(works.size());
    const bool isStopped = m_marking.stop_requested() && marks < m_works.size();
    m_marks = std::move(works);
    m_marked = *m_lesson;
    m_model->setTable(marksTable(m_marked, m_marks));
    setBusy(false);
    showInputs();
    if (isStopped) {
        m_inputs->setText(
            m_inputs->text() + u'\n'
            + tr("Stopped: %1 of %2 works are marked.").arg(marks).arg(m_works.size()));
    }
    m_table->resizeColumnsToContents();
    if (!m_marks.empty()) {
        m_table->selectRow(0);
    }
    showWork();
    emit marked();
}

QString MarksDialog::detail(const GradedWork& work) const {
    const QString name = QString::fromStdString(work.name.empty() ? work.file : work.name);
    QString text = QStringLiteral("<p><b>%1</b>, %2</p>")
                       .arg(name.toHtmlEscaped(), tr("%1 of %2 points")
                                                      .arg(LessonText::points(work.points),
                                                           LessonText::points(work.most)));
    if (const QString remarks = workRemarks(work); !remarks.isEmpty()) {
        text += QStringLiteral("<p>%1</p>").arg(remarks.toHtmlEscaped());
    }
    for (const QString& line : FaultsDialog::lines(work.issues)) {
        text += QStringLiteral("<p>%1</p>").arg(line.toHtmlEscaped());
    }
    for (std::size_t i = 0; i < work.steps.size(); ++i) {
        const GradedStep& step = work.steps[i];
        QString line = tr("Step %1, points: %2 of %3. %4")
                           .arg(i + 1)
                           .arg(LessonText::points(step.points), LessonText::points(step.most),
                                GoalText::found(m_marked.steps[i].goal, step.result,
                                                projectOf(m_marked, i), true));
        if (step.hints > 0) {
            line += u' ' + tr("Hints: −%1.").arg(LessonText::points(step.hints));
        }
        text += QStringLiteral("<p>%1</p>").arg(line.toHtmlEscaped());
        if (!step.answer.text.empty()) {
            text += QStringLiteral("<blockquote>%1</blockquote>")
                        .arg(harmlessText(QString::fromStdString(step.answer.text))
                                 .toHtmlEscaped()
                                 .replace(u'\n', QStringLiteral("<br>")));
        }
    }
    return text;
}

void MarksDialog::showWork() {
    const int row = m_model->rowAt(m_table->currentIndex().row());
    m_detail->setHtml(row < 0 ? QString() : detail(m_marks[std::size_t(row)]));
}

void MarksDialog::exportCsv() {
    saveWithDialog(this, &m_settings,
                   {tr("Export the marks"), fileNameOf({m_lessonName, tr("marks")}),
                    QStringLiteral("csv"), tr("Tables (*.csv)"),
                    [csv = QByteArray::fromStdString(gradesCsv(m_marked, m_marks))] {
                        return [csv] { return csv; };
                    }});
}

void MarksDialog::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MarksDialog::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            paths += url.toLocalFile();
        }
    }
    event->acceptProposedAction();
    // Later: the source of the drag must not wait for an answer.
    QMetaObject::invokeMethod(
        this, [this, paths] { add(paths); }, Qt::QueuedConnection);
}

} // namespace sparkout
