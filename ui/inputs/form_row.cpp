// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/form_row.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/member.h"
#include "ui/form/input_marks.h"
#include "ui/form/number_field.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/hint_strip.h"
#include "ui/inputs/page_columns.h"
#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/text/calibration_text.h"
#include "ui/text/field_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QVariant>

#include <algorithm>

namespace sparkout {

namespace {

constexpr const char* lockedProperty = "lockedByLesson";
constexpr const char* hiddenProperty = "hiddenByLesson";

/// The ticks of boxes disable their contents.
bool isInUntickedBox(const QWidget& widget) {
    for (const QWidget* up = widget.parentWidget(); up; up = up->parentWidget()) {
        const auto* box = qobject_cast<const QGroupBox*>(up);
        if (box && box->isCheckable() && !box->isChecked()) {
            return true;
        }
    }
    return false;
}

bool isBelowPath(std::string_view path, std::string_view above) {
    return path.starts_with(above) && path.size() > above.size() && path[above.size()] == '/';
}

} // namespace

FormAccess::FormAccess(const LessonStep& step, bool isAwaited)
    : m_step(LessonStep{}), m_isAwaited(isAwaited) {
    m_step->others = step.others;
    m_step->inputs = step.inputs;
}

Access FormAccess::given(std::string_view path) const {
    return m_step ? accessTo(*m_step, path) : Access::free;
}

Access FormAccess::at(std::string_view path) const {
    const Access access = given(path);
    return m_isAwaited && access == Access::free ? Access::locked : access;
}

bool FormAccess::hasFree(std::string_view path) const {
    return at(path) == Access::free
           || (!m_isAwaited && m_step
               && std::any_of(
                   m_step->inputs.begin(), m_step->inputs.end(), [path](const InputAccess& each) {
                       return each.access == Access::free && isBelowPath(each.path, path);
                   }));
}

bool FormAccess::hasShown(std::string_view path) const {
    return given(path) != Access::hidden
           || (m_step
               && std::any_of(
                   m_step->inputs.begin(), m_step->inputs.end(), [path](const InputAccess& each) {
                       return each.access != Access::hidden && isBelowPath(each.path, path);
                   }));
}

void FormAccess::lock(QWidget& widget, bool locked) {
    if (locked) {
        widget.setEnabled(false);
    } else if (widget.property(lockedProperty).toBool()) {
        widget.setEnabled(!isInUntickedBox(widget));
    }
    widget.setProperty(lockedProperty, locked);
}

bool FormAccess::hide(QWidget& widget, bool hidden) {
    const bool wasHidden = widget.property(hiddenProperty).toBool();
    widget.setProperty(hiddenProperty, hidden);
    if (hidden || wasHidden) {
        widget.setVisible(!hidden);
    }
    return wasHidden && !hidden;
}

QString FormAccess::lockText() const {
    return m_isAwaited ? tr("Locked until the prediction is given.")
                       : tr("Locked in this step of the laboratory work.");
}

namespace {

bool isAsIn(const Project& other, const Field& field, const void* owner, const std::string& path) {
    const ConstMember there = findMember(other, path);
    if (!there) {
        return false;
    }
    switch (field.kind) {
    case Kind::optionalObject:
        if (!field.objectIn(owner) || !field.objectIn(there.owner)) {
            return !field.objectIn(owner) && !field.objectIn(there.owner);
        }
        [[fallthrough]];
    case Kind::object:
        return std::ranges::all_of(field.nested->fields, [&](const Field& member) {
            return isAsIn(other, member, field.objectIn(owner), path + '/' + member.key);
        });
    case Kind::objectList: return field.size(owner) == field.size(there.owner);
    default: return field.same(owner, there.owner);
    }
}

} // namespace

bool InputRank::isNews(const Project& project, const std::string& path) const {
    const bool isWanted = std::ranges::any_of(wanted, [&path](const std::string& one) {
        return one == path || one.starts_with(path + '/') || path.starts_with(one + '/');
    });
    if (isWanted || calibrationOf(project, path)) {
        return true;
    }
    const ConstMember member = findMember(project, path);
    return member && !isAsNew(*member.field, member.owner)
           && !(asCatalogue && isAsIn(*asCatalogue, *member.field, member.owner, path));
}

namespace {

constexpr int widestField = 216;

} // namespace

FormRow::FormRow(std::unique_ptr<FieldEditor> editor, QGridLayout& grid, QWidget* parent)
    : m_editor(std::move(editor))
    , m_head(new QWidget(parent))
    , m_label(new QLabel(m_head))
    , m_unit(new QLabel(parent))
    , m_reason(new QLabel(parent))
    , m_shared(new SharedMark(m_head))
    , m_calibrated(new CalibratedMark(m_head)) {
    m_label->setTextFormat(Qt::RichText);
    m_label->setWordWrap(true);
    m_label->setBuddy(m_editor->widget());
    m_unit->setTextFormat(Qt::PlainText);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setWordWrap(true);
    m_reason->setVisible(false);
    connect(m_editor.get(), &FieldEditor::remarkChanged, this, &FormRow::showRemark);
    for (QWidget* widget : {m_editor->widget(), m_head, m_editor->slider()}) {
        if (widget) {
            widget->installEventFilter(this);
        }
    }
    if (hasDefault(m_editor->field())) {
        m_mark = new ResetMark(m_head);
        connect(m_mark, &ResetMark::clicked, m_editor.get(), &FieldEditor::resetToDefault);
    }
    addTo(grid);
}

void FormRow::addTo(QGridLayout& grid) {
    auto* head = new QHBoxLayout(m_head);
    head->setContentsMargins(0, 0, 0, 0);
    head->setSpacing(metrics::hair);
    head->addWidget(m_label, 1);
    head->addWidget(m_shared);
    head->addWidget(m_calibrated);
    if (m_mark) {
        head->addWidget(m_mark);
    }
    const int row = grid.rowCount();
    QWidget* const field = m_editor->widget();
    if (m_editor->tall()) {
        auto* line = new QHBoxLayout;
        line->setSpacing(metrics::gap);
        line->addWidget(field, 1);
        if (!m_editor->wide()) {
            line->addWidget(m_unit);
        }
        grid.addWidget(m_head, row, 0, 1, 3);
        grid.addLayout(line, row + 1, 0, 1, 3);
    } else if (m_editor->wide()) {
        head->setSpacing(metrics::gap);
        head->addWidget(field);
        grid.addWidget(m_head, row, 0, 1, 3);
    } else {
        if (auto* number = qobject_cast<NumberField*>(field)) {
            number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        setTextWidth(*field, metrics::field);
        setTextWidth(*m_unit, unitColumn);
        grid.addWidget(field, row, 1);
        grid.addWidget(m_unit, row, 2);
        if (QWidget* slider = m_editor->slider()) { // a label of two lines is beside both
            m_label->setMinimumHeight(field->sizeHint().height());
            grid.addWidget(m_head, row, 0, 2, 1, Qt::AlignTop);
            grid.addWidget(slider, row + 1, 1, 1, 2);
        } else {
            grid.addWidget(m_head, row, 0);
        }
    }
    grid.addWidget(m_reason, row + 2, 0, 1, 3);
    m_unit->setVisible(!m_editor->wide());
}

void FormRow::show(const Project& project, bool replaced, const InputRank& rank) {
    const ConstMember member = findMember(project, m_editor->path());
    m_isRelevant = member && member.relevant(project) && m_access != Access::hidden;
    m_editor->show(replaced);
    if (auto* box = qobject_cast<QComboBox*>(m_editor->widget())) {
        box->setToolTip(box->currentText());
    }
    m_label->setText(labelMarkup(m_editor->field(), project)); // a bore has another symbol
    m_isShown = m_isRelevant
                && (rank.shows(project, m_editor->field(), m_editor->path())
                    || m_editor->remark().mark != Mark::none || m_editor->widget()->hasFocus());
    for (QWidget* widget : {m_head, m_editor->widget(), m_editor->slider()}) {
        if (widget) {
            widget->setVisible(m_isShown);
        }
    }
    m_unit->setVisible(m_isShown && !m_editor->wide());
    for (QWidget* widget :
         {m_editor->widget(), m_editor->slider(), static_cast<QWidget*>(m_mark)}) {
        if (widget) {
            FormAccess::lock(*widget, m_access != Access::free);
        }
    }
    if (m_mark) {
        m_mark->showChanged(m_editor->changedFromDefault());
    }
    showCalibration(project);
    showRemark();
}

void FormRow::showCalibration(const Project& project) {
    const Calibration* const record = calibrationOf(project, m_editor->path());
    m_calibration = record ? CalibrationText::state(project, *record) : QString();
    m_calibrated->showCalibration(record && hasCalibratedValue(project, *record),
                                  record ? CalibrationText::details(project, *record) : QString());
}

void FormRow::setShared(bool shared) {
    if (m_isShared != shared) {
        m_isShared = shared;
        m_shared->setVisible(shared);
        showHint();
    }
}

void FormRow::setAccess(const FormAccess& access) {
    m_access = access.at(m_editor->path());
    m_lock = m_access == Access::free ? QString() : access.lockText();
    showHint();
}

void FormRow::setIssues(const Issues& issues) {
    m_editor->setIssue(remarkFor(issues, m_editor->path()));
}

bool FormRow::meaningIsLong() const {
    const QString meaning = inputText(m_editor->field().nullMeaning);
    return m_editor->widget()->fontMetrics().horizontalAdvance(meaning)
           > atFontSize(metrics::field) - 12;
}

QString FormRow::caption() const {
    const auto* line = qobject_cast<QLineEdit*>(m_editor->widget());
    return line && m_editor->empty() && meaningIsLong()
               ? tr("empty: %1").arg(inputText(m_editor->field().nullMeaning))
               : m_calibration;
}

void FormRow::showRemark() {
    const Remark remark = m_editor->remark();
    const QString text = remark.mark == Mark::none ? caption() : remark.reason;
    QPalette colors = m_label->palette();
    colors.setColor(QPalette::WindowText, remark.mark == Mark::none
                                              ? colors.color(QPalette::PlaceholderText)
                                              : markColor(remark.mark, colors));
    const bool shown = m_isShown && !text.isEmpty();
    // A message that disappears while typing leaves its space until the field is left.
    QSizePolicy policy = m_reason->sizePolicy();
    policy.setRetainSizeWhenHidden(m_isShown && !shown && m_editor->widget()->hasFocus()
                                   && (m_reason->isVisible() || policy.retainSizeWhenHidden()));
    m_reason->setSizePolicy(policy);
    m_reason->setPalette(colors);
    if (!policy.retainSizeWhenHidden()) {
        m_reason->setText(text);
    }
    m_reason->setVisible(shown);
}

/// Makes the field as wide as its texts if the other fields are narrower.
void FormRow::fitWide() {
    if (!m_editor->wide() || m_editor->tall()) {
        return;
    }
    int width = atFontSize(wideField);
    if (auto* box = qobject_cast<QComboBox*>(m_editor->widget())) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        width = std::clamp(box->sizeHint().width(), atFontSize(wideField), atFontSize(widestField));
    }
    m_editor->widget()->setFixedWidth(width);
}

void FormRow::retranslate(const Project& project) {
    const Field& field = m_editor->field();
    m_editor->retranslate();
    fitWide();
    m_label->setText(labelMarkup(field, project));
    m_unit->setText(unitText(field.unit));
    m_shared->retranslate();
    showCalibration(project);
    showHint();
    if (m_mark) {
        m_mark->showDefault(inputText(field.label), defaultText(field));
    }
    showRemark();
}

void FormRow::showHint() {
    const Field& field = m_editor->field();
    const QString shared = SharedMark::text();
    QString hint = m_isShared ? QStringLiteral("%1<p><b>%2</b></p>").arg(hintMarkup(field), shared)
                              : hintMarkup(field);
    QString plain =
        m_isShared ? QStringLiteral("%1 (%2)").arg(hintPlain(field), shared) : hintPlain(field);
    if (!m_lock.isEmpty()) {
        hint += QStringLiteral("<p><b>%1</b></p>").arg(m_lock);
        plain += u' ' + m_lock;
    }
    QWidget* const widget = m_editor->widget();
    m_editor->describe(*field.unit
                           ? tr("%1, %2").arg(StockReading::label(field), unitText(field.unit))
                           : StockReading::label(field),
                       hint, plain);
    for (QWidget* one : {static_cast<QWidget*>(m_label), widget, m_editor->slider()}) {
        if (one) {
            one->setToolTip(hint);
            setHintField(*one, field);
        }
    }
    if (auto* line = qobject_cast<NumberField*>(widget); line && meaningIsLong()) {
        line->setPlaceholderText(QStringLiteral("—")); // its meaning stands below
    }
}

void FormRow::fillMenu(QMenu& menu) {
    if (StockReading::isStock(m_editor->field())) {
        menu.addSeparator();
        QAction* diameter = menu.addAction(tr("Stock on diameter"));
        diameter->setObjectName(QStringLiteral("stockOnDiameter"));
        diameter->setCheckable(true);
        diameter->setChecked(StockReading::instance().onDiameter());
        connect(diameter, &QAction::toggled, &StockReading::instance(),
                &StockReading::setOnDiameter);
    }
    if (!m_mark) {
        return;
    }
    menu.addSeparator();
    QAction* reset = menu.addAction(m_mark->menuText());
    reset->setEnabled(m_editor->changedFromDefault() && m_editor->widget()->isEnabled());
    connect(reset, &QAction::triggered, m_editor.get(), &FieldEditor::resetToDefault);
}

bool FormRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) {
        showRemark();
    }
    if (event->type() != QEvent::ContextMenu) {
        return QObject::eventFilter(watched, event);
    }
    auto* line = qobject_cast<QLineEdit*>(watched);
    const auto* asked = static_cast<QContextMenuEvent*>(event);
    auto* menu = line ? line->createStandardContextMenu() : new QMenu(m_editor->widget());
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillMenu(*menu);
    if (menu->isEmpty()) {
        delete menu;
        return QObject::eventFilter(watched, event);
    }
    menu->popup(asked->globalPos());
    return true;
}

} // namespace sparkout
