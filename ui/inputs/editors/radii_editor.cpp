// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/radii_editor.h"

#include "core/files/safe_file.h"
#include "core/study/operation.h"
#include "ui/kit/file_dialog.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/tables/profile_csv.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace sparkout {

namespace {

constexpr std::size_t largestFile = 1u << 20; // bytes; 360 lines need a hundredth of this

} // namespace

RadiiEditor::RadiiEditor(const std::string& path, const Field& field, ProjectModel& model,
                         QWidget* parent)
    : FieldEditor(path, field, model)
    , m_document(model.document())
    , m_body(new QWidget(parent))
    , m_summary(new QLabel(m_body))
    , m_read(new QPushButton(m_body))
    , m_clear(new QPushButton(m_body)) {
    auto* layout = new QGridLayout(m_body);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_summary, 0, 0, 1, 3);
    layout->addWidget(m_read, 1, 0);
    layout->addWidget(m_clear, 1, 1);
    layout->setColumnStretch(2, 1);
    m_summary->setTextFormat(Qt::PlainText);
    m_body->setFocusProxy(m_read);
    for (QPushButton* button : {m_read, m_clear}) {
        button->setAutoDefault(false);
    }
    connect(m_read, &QPushButton::clicked, this, &RadiiEditor::askForFile);
    connect(m_clear, &QPushButton::clicked, this, &RadiiEditor::clear);
}

void RadiiEditor::askForFile() {
    const QString path =
        FileDialog::openPath(m_body->window(), tr("Read a measured profile"), {},
                             tr("Tables (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (!path.isEmpty()) {
        readFrom(path);
    }
}

void RadiiEditor::readFrom(const QString& path) {
    const QString name = printableText(QFileInfo(path).fileName());
    const auto read = readFile(systemPath(path), largestFile);
    if (const auto* error = std::get_if<FileError>(&read)) {
        m_refused = readErrorText(*error);
        emit remarkChanged();
        return;
    }
    const auto parsed = readProfileCsv(std::get<std::string>(read));
    if (const auto* fault = std::get_if<ProfileCsvFault>(&parsed)) {
        refuse(name, profileCsvFaultText(*fault));
        return;
    }
    refuse({}, {});
    m_document.edit(withRadii(m_document.project(), std::get<std::vector<double>>(parsed)),
                    {"Input", field().label});
}

void RadiiEditor::refuse(const QString& file, const QString& reason) {
    m_refused = reason.isEmpty() ? QString() : tr("“%1” was not read: %2").arg(file, reason);
    emit remarkChanged();
}

void RadiiEditor::clear() {
    m_read->setFocus(); // the button becomes disabled
    change([this](void* to) { field().as<std::optional<std::vector<double>>>(to).reset(); });
    model().endMerge();
}

QString RadiiEditor::summary() const {
    const auto& radii = field().as<std::optional<std::vector<double>>>(owner());
    if (!radii || radii->empty()) {
        return inputText(field().nullMeaning);
    }
    const auto [low, high] = std::minmax_element(radii->begin(), radii->end());
    const auto number = [](double value) { return printedNumber(value); };
    return tr("%n values, %1…%2 %3", nullptr, static_cast<int>(radii->size()))
        .arg(number(*low), number(*high), unitText(field().unit));
}

void RadiiEditor::show(bool) {
    m_refused.clear(); // it concerned the previous project
    m_summary->setText(summary());
    m_clear->setEnabled(field().as<std::optional<std::vector<double>>>(owner()).has_value());
}

void RadiiEditor::retranslate() {
    m_summary->setText(summary());
    m_read->setText(tr("Read from CSV…"));
    m_clear->setText(tr("Clear"));
    m_read->setAccessibleName(tr("%1: read from a CSV file").arg(inputText(field().label)));
    m_clear->setAccessibleName(tr("%1: clear").arg(inputText(field().label)));
    const QString hint = tr("A number a line in µm, or the last column of a table; the number of "
                            "values becomes the number of radii per section.");
    m_read->setToolTip(QStringLiteral("<p>%1</p>").arg(hint.toHtmlEscaped()));
    m_clear->setToolTip(m_clear->accessibleName());
}

Remark RadiiEditor::remark() const {
    return m_refused.isEmpty() ? FieldEditor::remark() : Remark{Mark::error, m_refused};
}

} // namespace sparkout
