// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/waves_dialog.h"

#include "core/project/machine.h"
#include "ui/dialogs/copy_table.h"
#include "ui/form/number_field.h"
#include "ui/form/pasted_numbers.h"
#include "ui/kit/font_size.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/metrics.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/wave_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <string_view>

namespace sparkout {

namespace {

/// The first output, the source, as a text, the others but its number as they are.
ValueTable causesTable(const std::vector<WaveCause>& causes) {
    ValueTable table{.isList = true};
    const auto isShown = [](const Output<WaveCause>& row) {
        const std::string_view key = row.key;
        return key != "source" && key != "frequency_hz" && key != "lobes";
    };
    const std::span<const Output<WaveCause>> outputs = waveCauseOutputs();
    table.columns.push_back(
        {.text = outputLabel(outputs.front()), .key = outputs.front().key, .isText = true});
    for (const Output<WaveCause>& row : outputs) {
        if (isShown(row)) {
            table.columns.push_back(
                {.text = outputLabel(row), .tip = outputHint(row), .key = row.key});
        }
    }
    for (const WaveCause& cause : causes) {
        std::vector<ValueCell> cells{{.text = WaveText::cause(cause)}};
        for (const Output<WaveCause>& row : outputs) {
            if (isShown(row)) {
                const OutputValue value = row.of(cause);
                cells.push_back(ValueCell::of(outputNumber(row, value),
                                              [&](double) { return outputText(row, value); }));
            }
        }
        table.addRow({.text = WaveText::cause(cause)}, std::move(cells));
    }
    return table;
}

} // namespace

WavesDialog::WavesDialog(const Project& project, Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_project(project)
    , m_count(new NumberField({.hard = {fewestWaves, mostWaves}, .integer = true}, this))
    , m_frequencies(new QLineEdit(this))
    , m_model(new ValueModel(this))
    , m_table(new CopyTable(*m_model, this))
    , m_test(new QLabel(this)) {
    setWindowTitle(tr("Waves on a part"));
    setHelpTopic(*this, QStringLiteral("waves#causes"));
    m_count->setObjectName(QStringLiteral("wavesCounted"));
    m_count->setValue(std::max(orderOfWaves(project), fewestWaves));
    m_frequencies->setObjectName(QStringLiteral("wavesFrequencies"));
    m_frequencies->setPlaceholderText(tr("none"));
    m_frequencies->setToolTip(
        tr("Motors, belts, pumps, the floor: numbers separated by semicolons"));
    m_table->setObjectName(QStringLiteral("waveCauses"));
    m_table->setAccessibleName(windowTitle());
    m_table->setArrangeable(&settings);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setMinimumSectionSize(atFontSize(70));
    m_table->setWordWrap(false);
    m_test->setObjectName(QStringLiteral("waveTest"));
    m_test->setTextFormat(Qt::PlainText);
    m_test->setWordWrap(true);
    m_test->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* form = new QFormLayout;
    form->addRow(tr("&Waves counted around the part:"), m_count);
    form->addRow(tr("Known &frequencies, Hz:"), m_frequencies);
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_count, &NumberField::valueEdited, this, &WavesDialog::find);
    connect(m_frequencies, &QLineEdit::textChanged, this, &WavesDialog::find);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::wide);
    layout->addLayout(form);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_test);
    layout->addWidget(buttons);
    resize(atFontSize(980), atFontSize(380));
    find();
}

void WavesDialog::find() {
    const PastedNumbers frequencies(PastedCells::of(m_frequencies->text()),
                                    {lowestFrequency_hz, highestFrequency_hz}, "Hz");
    if (!frequencies.fault().isEmpty()) {
        m_test->setText(frequencies.fault());
        return;
    }
    const WaveInquiry asked{static_cast<int>(m_count->value().value_or(fewestWaves)),
                            frequencies.inOrder()};
    m_causes = waveCauses(m_project, asked);
    m_model->setTable(causesTable(m_causes));
    const WaveTest test = waveTest(m_project, asked.counted);
    m_test->setText(tr("The part turns with %1 rev/min, the wheel with %2. Other work speed: %3 "
                       "rev/min; other wheel speed: %4 rev/min.")
                        .arg(Names::significant(m_project.machine->work_speed_rpm),
                             Names::fixed(wheelSpeed_rpm(m_project), 0),
                             Names::fixed(test.workSpeed_rpm, 1),
                             Names::fixed(test.wheelSpeed_rpm, 0))
                    + u' ' + WaveText::howToTell());
}

} // namespace sparkout
