// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/measured_section.h"

#include "core/files/safe_file.h"
#include "core/measured/closed_profile.h"
#include "core/measured/measured_table.h"
#include "ui/measured/measured_text.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/texts.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QStringList>

#include <string>
#include <utility>
#include <variant>

namespace sparkout {

std::optional<MeasuredSection> MeasuredSection::read(const QString& path, double nominalRadius_mm,
                                                     QString& reason) {
    auto bytes = readFile(systemPath(path), limits::measuredBytes);
    if (const auto* fault = std::get_if<FileError>(&bytes)) {
        reason = readErrorText(*fault);
        return std::nullopt;
    }
    ClosedProfile profile = readClosedProfile(std::get<std::string>(bytes), nominalRadius_mm);
    constexpr std::size_t mostFaults = 5;
    QStringList faults;
    for (std::size_t i = 0; i < profile.faults.size() && i < mostFaults; ++i) {
        faults << MeasuredText::fault(profile.faults[i]);
    }
    if (!faults.isEmpty()) {
        reason = tr("A table of two columns is needed: the angle in °, and the radius in mm or the "
                    "deviation from it in µm.")
                 + u'\n' + faults.join(u'\n');
        return std::nullopt;
    }
    MeasuredSection section;
    section.name = printableText(QFileInfo(path).fileName());
    section.radii_mm = std::move(profile.radii_mm);
    return section;
}

std::optional<MeasuredSection> MeasuredSection::ask(QWidget* window, double nominalRadius_mm) {
    const QString path =
        QFileDialog::getOpenFileName(window, tr("Read a measured profile"), {},
                                     tr("Tables (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (path.isEmpty()) {
        return std::nullopt;
    }
    QString reason;
    auto section = read(path, nominalRadius_mm, reason);
    if (!section) {
        QMessageBox box(QMessageBox::Information, tr("The profile was not read"), reason,
                        QMessageBox::Ok, window);
        box.setTextFormat(Qt::PlainText);
        box.exec();
    }
    return section;
}

} // namespace sparkout
