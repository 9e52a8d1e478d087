// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/page_columns.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/batch.h"
#include "core/project/given_factors.h"
#include "core/project/machine.h"
#include "core/study/batch_edits.h"
#include "core/study/operation.h"
#include "ui/form/mark.h"
#include "ui/inputs/form_metrics.h"
#include "ui/inputs/hint_strip.h"
#include "ui/kit/metrics.h"
#include "ui/session/document.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/calibration_text.h"
#include "ui/text/hint_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCheckBox>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionGroupBox>
#include <QStylePainter>
#include <QWidget>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace sparkout {

namespace {

double correlationOf(const Project& project, std::size_t i, std::size_t j) {
    const NumberRows& matrix = project.batch ? project.batch->correlation : std::nullopt;
    return matrix && i < matrix->size() && j < (*matrix)[i].size() ? (*matrix)[i][j] : 0;
}

} // namespace

CorrelationBox::CorrelationBox(std::string path, const Field& field, int depth, Document& document,
                               QWidget* parent)
    : InputBox(std::move(path), field, depth, document, parent) {
    setObjectName(QString::fromStdString(this->path()));
    rows().addWidget(&numbers());
    rows().addWidget(&reason());
    numbers().setOrder(
        [this](const PastedCells& cells, QString& fault) { return orderOf(cells, fault); });
}

void CorrelationBox::showProject(bool replaced) {
    std::vector<NumberLines::Line> lines;
    const std::vector<GivenFactor> given = givenFactors(document().project());
    for (std::size_t i = 0; i < given.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (given[i].isLaw() || given[j].isLaw()) {
                continue;
            }
            NumberLines::Line line;
            line.path = path() + "/" + std::to_string(i) + "/" + std::to_string(j);
            line.spec.hard = field().hard;
            line.get = [i, j](const Project& project) {
                return std::optional(correlationOf(project, i, j));
            };
            line.set = [i, j](Project& project, std::optional<double> value) {
                if (value) {
                    project = withCorrelation(std::move(project), j, i, *value);
                }
            };
            line.label = [a = given[j].kind, b = given[i].kind] {
                return tr("%1 – %2", "two factors")
                    .arg(inputText(factorLabel(a)), inputText(factorLabel(b)));
            };
            line.hint = [] {
                return tr("Between −1 and 1; 0: independent. Of normal factors Pearson's "
                          "coefficient, of others nearly Spearman's.");
            };
            lines.push_back(std::move(line));
        }
    }
    setVisible(!lines.empty());
    numbers().setLines(std::move(lines));
    numbers().showProject(replaced);
}

/// The cells of a whole matrix below its diagonal, in the order of the lines; of any other block
/// all cells.
std::vector<QString> CorrelationBox::orderOf(const PastedCells& cells, QString& fault) const {
    const std::vector<GivenFactor> given = givenFactors(document().project());
    const auto size = static_cast<qsizetype>(given.size());
    const bool square = size > 1 && cells.rows.size() == given.size()
                        && std::ranges::all_of(cells.rows, [size](const QStringList& row) {
                               return row.size() == size;
                           });
    if (!square) {
        return cells.inOrder();
    }
    std::vector<QString> ordered;
    for (qsizetype i = 0; i < size; ++i) {
        const auto row = static_cast<std::size_t>(i);
        if (pastedNumber(cells.rows[row][i]).value_or(1) != 1) {
            fault = tr("row %1, column %1: “%2” is not 1").arg(i + 1).arg(cells.rows[row][i]);
            return {};
        }
        for (qsizetype j = 0; j < i; ++j) {
            const QString below = cells.rows[row][j];
            const QString above = cells.rows[static_cast<std::size_t>(j)][i];
            if (!above.trimmed().isEmpty() && pastedNumber(above) != pastedNumber(below)) {
                fault = tr("row %1, column %2: “%3” differs from “%4” across the diagonal")
                            .arg(QString::number(j + 1), QString::number(i + 1), above, below);
                return {};
            }
            if (!given[row].isLaw() && !given[static_cast<std::size_t>(j)].isLaw()) {
                ordered.push_back(below);
            }
        }
    }
    return ordered;
}

void CorrelationBox::setOutcome(const OutcomePtr& outcome) {
    reason().showRemark(remarkAt(outcome->issues, path()));
    numbers().setIssues(outcome->issues);
}

void CorrelationBox::retranslate() {
    setTitle(inputText(field().label));
    setAccessibleName(title());
    setToolTip(hintMarkup(field()));
    numbers().retranslate();
}

namespace {

constexpr std::size_t mostListed = 6; ///< sections whose computed γ is listed

std::vector<std::string> keysOf(const GivenCompliance& given) {
    if (std::holds_alternative<ZoneCompliance>(given)) {
        return {"rz1", "nz", "rz2"};
    }
    std::vector<std::string> keys;
    if (const auto* sections = std::get_if<std::vector<double>>(&given)) {
        for (std::size_t i = 0; i < sections->size(); ++i) {
            keys.push_back(std::to_string(i));
        }
    }
    return keys;
}

double& valueAt(GivenCompliance& given, std::size_t index) {
    if (auto* zones = std::get_if<ZoneCompliance>(&given)) {
        return index == 0 ? zones->rz1 : index == 1 ? zones->nz : zones->rz2;
    }
    return std::get<std::vector<double>>(given)[index];
}

} // namespace

ComplianceBox::ComplianceBox(std::string path, const Field& field, Document& document,
                             QWidget* parent)
    : InputBox(std::move(path), field, 1, document, parent)
    , m_computed(new QCheckBox(this))
    , m_gammas(new QLabel(this))
    , m_calibration(new QLabel(this)) {
    numbers().setNames([](const QString& label) { return tr("Compliance of %1").arg(label); });
    rows().setContentsMargins(inset(1), metrics::row, inset(1), metrics::tight);
    for (QWidget* part : std::initializer_list<QWidget*>{m_computed, &numbers(), m_gammas,
                                                         m_calibration, &reason()}) {
        rows().addWidget(part);
    }
    m_calibration->setObjectName(QStringLiteral("complianceCalibration"));
    m_calibration->setTextFormat(Qt::PlainText);
    m_calibration->setWordWrap(true);
    m_calibration->setForegroundRole(QPalette::PlaceholderText);
    m_calibration->setVisible(false);
    m_gammas->setObjectName(QStringLiteral("computedCompliance"));
    m_gammas->setTextFormat(Qt::PlainText);
    m_gammas->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_gammas->setWordWrap(true);
    m_gammas->setForegroundRole(QPalette::PlaceholderText);
    connect(m_computed, &QCheckBox::clicked, this, [this](bool computed) {
        this->document().edit(withGivenCompliance(this->document().project(), !computed),
                              {"Input", this->field().label});
    });
}

NumberLines::Line ComplianceBox::lineOf(const std::string& key, std::size_t index) const {
    NumberLines::Line line;
    line.path = path() + "/" + key;
    line.spec = NumberSpec::of(field());
    line.spec.optional = false;
    line.get = [index](const Project& project) -> std::optional<double> {
        GivenCompliance given = project.machine->compliance_mm_per_n;
        return index < keysOf(given).size() ? std::optional(valueAt(given, index)) : std::nullopt;
    };
    line.set = [index](Project& project, std::optional<double> value) {
        GivenCompliance& given = project.machine->compliance_mm_per_n;
        if (value && index < keysOf(given).size()) {
            valueAt(given, index) = *value;
        }
    };
    line.label = [key] {
        const bool section = key.front() >= '0' && key.front() <= '9';
        return section ? tr("Section %1").arg(std::stoi(key) + 1) : zoneText(key.c_str());
    };
    line.hint = [&of = field()] { return hintPlain(of); };
    line.tip = [&of = field()] { return hintMarkup(of); };
    if (field().slider) {
        line.slider = [path = line.path, &of = field()](const Project& project) {
            return sliderSpec(project, path, of);
        };
    }
    return line;
}

void ComplianceBox::showProject(bool replaced) {
    const Project& project = document().project();
    const GivenCompliance& given = project.machine->compliance_mm_per_n;
    std::vector<NumberLines::Line> lines;
    for (const std::string& key : keysOf(given)) {
        lines.push_back(lineOf(key, lines.size()));
    }
    numbers().setLines(std::move(lines));
    numbers().showProject(replaced);
    const bool computed = std::holds_alternative<std::monostate>(given);
    m_computed->setChecked(computed);
    numbers().setVisible(!computed);
    showComputed();
    showCalibration(project);
}

/// One line for all inputs that were found from the same data; values changed since come first.
void ComplianceBox::showCalibration(const Project& project) {
    const Calibration *first = nullptr, *changed = nullptr;
    for (const std::string& key : keysOf(project.machine->compliance_mm_per_n)) {
        const Calibration* const record = calibrationOf(project, path() + "/" + key);
        const bool holds = record && hasCalibratedValue(project, *record);
        first = first ? first : record;
        changed = changed || holds ? changed : record;
    }
    const Calibration* const named = changed ? changed : first;
    m_calibration->setText(named ? CalibrationText::state(project, *named) : QString());
    m_calibration->setVisible(named && !m_computed->isChecked());
}

void ComplianceBox::setOutcome(const OutcomePtr& outcome) {
    if (outcome->ran()) {
        m_good = outcome;
    }
    setIssues(outcome->issues);
    showComputed();
}

void ComplianceBox::forgetResults() {
    m_good.reset();
    showComputed();
}

/// Shows γ zone by zone, or the least and the largest of many sections.
void ComplianceBox::showComputed() {
    QStringList values;
    if (m_computed->isChecked() && m_good
        && std::holds_alternative<std::monostate>(
            m_good->result.project.machine->compliance_mm_per_n)) {
        const std::vector<SectionResult>& sections = m_good->result.sections;
        const auto value = [&](std::size_t i) {
            return tr("%1: %2", "zone: compliance")
                .arg(Names::zone(sections[i].zone, static_cast<int>(i)),
                     Names::significant(sections[i].compliance_mm_per_n));
        };
        if (sections.size() <= mostListed) {
            for (std::size_t i = 0; i < sections.size(); ++i) {
                values << value(i);
            }
        } else {
            const auto [low, high] =
                std::ranges::minmax_element(sections, {}, &SectionResult::compliance_mm_per_n);
            values << value(static_cast<std::size_t>(low - sections.begin()))
                   << value(static_cast<std::size_t>(high - sections.begin()));
        }
    }
    m_gammas->setText(values.isEmpty()
                          ? QString()
                          : values.join(QStringLiteral("; ")) + u' ' + unitText(field().unit));
    m_gammas->setVisible(!values.isEmpty());
}

void ComplianceBox::setIssues(const Issues& issues) {
    m_issues = issues;
    reason().showRemark(remarkAt(m_issues, path()));
    numbers().setIssues(m_issues);
}

void ComplianceBox::retranslate() {
    setTitle(tr("%1 %2").arg(inputText(field().label), QString::fromUtf8(field().symbol)));
    setToolTip(hintMarkup(field()));
    setAccessibleName(inputText(field().label));
    m_computed->setText(inputText(field().nullMeaning));
    m_computed->setAccessibleName(m_computed->text());
    numbers().retranslate();
    m_gammas->setAccessibleName(tr("Computed compliance"));
    showComputed();
    showCalibration(document().project());
    setIssues(Issues(m_issues));
}

void ComplianceBox::focusPath(const std::string& path) {
    if (!numbers().focusPath(path) && !numbers().focusPath(this->path())) {
        m_computed->setFocus(Qt::OtherFocusReason);
    }
}

InputBox::InputBox(std::string path, const Field& field, int depth, Document& document,
                   QWidget* parent)
    : SectionBox(depth, parent)
    , m_path(std::move(path))
    , m_field(field)
    , m_document(document)
    , m_numbers(new NumberLines(document, field.label, this))
    , m_reason(new ReasonLabel(this)) {
    setHintField(*this, field);
    m_numbers->setNames([&field](const QString& label) {
        return tr("%1: %2", "input: number").arg(inputText(field.label), label);
    });
    connect(m_numbers, &NumberLines::refusalsChanged, this, &InputBox::refusalsChanged);
}

bool InputBox::holds(const std::string& path) const {
    return path == m_path || path.starts_with(m_path + "/");
}

namespace {

constexpr int deepest = 2;

/// The margin that the style leaves beside the contents of a box.
int styleInset() {
    static const int inset = [] {
        QGroupBox box;
        box.ensurePolished();
        return box.contentsMargins().left();
    }();
    return inset;
}

} // namespace

int SectionBox::inset(int depth) {
    return (deepest - depth) * styleInset();
}

SectionBox::SectionBox(int depth, QWidget* parent)
    : QGroupBox(parent), m_depth(depth), m_rows(new PageColumns(this)) {
    m_rows->setContentsMargins(0, metrics::row, 0, metrics::tight);
    m_rows->setSpacing(metrics::gap);
}

void SectionBox::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionGroupBox option;
    initStyleOption(&option);
    option.subControls &= ~QStyle::SC_GroupBoxFrame;
    painter.translate(inset(m_depth - 1), 0);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    option.fontMetrics = QFontMetrics(bold);
    painter.drawComplexControl(QStyle::CC_GroupBox, option);
}

namespace {

constexpr int between = metrics::wide; ///< the columns

int heightAt(const QLayoutItem& item, int width) {
    const int height =
        item.hasHeightForWidth() ? item.heightForWidth(width) : item.sizeHint().height();
    return std::max(height, item.minimumSize().height());
}

} // namespace

void PageColumns::addWide(QWidget* part) {
    addWidget(part);
    m_wide.push_back(part);
}

/// A column is at least as wide as a page of one column with a scroll bar.
bool PageColumns::hasTwo(int width) const {
    const int bar = parentWidget()->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    return (width - between) / 2 >= panelWidth() - bar - 2 * metrics::margin;
}

bool PageColumns::isWide(const QLayoutItem& item) const {
    const QWidget* widget = const_cast<QLayoutItem&>(item).widget();
    return std::ranges::find(m_wide, widget) != m_wide.end();
}

/// Rows of fields are layouts, with a smaller gap than parts with a frame or a title.
int PageColumns::gap(const QLayoutItem& above, const QLayoutItem& below) const {
    const auto isRow = [](const QLayoutItem& item) {
        return const_cast<QLayoutItem&>(item).layout() != nullptr;
    };
    return isRow(above) && isRow(below) ? metrics::row : spacing();
}

int PageColumns::heightOf(std::span<const Part> parts) const {
    int height = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        height += parts[i].height + (i > 0 ? gap(*parts[i - 1].item, *parts[i].item) : 0);
    }
    return height;
}

/// The number of parts on the left: the first of the splits whose higher column is lowest.
std::size_t PageColumns::split(std::span<const Part> parts) const {
    std::size_t best = parts.size();
    int least = heightOf(parts);
    for (std::size_t left = 1; left < parts.size(); ++left) {
        const int height = std::max(heightOf(parts.first(left)), heightOf(parts.subspan(left)));
        if (height < least) {
            least = height;
            best = left;
        }
    }
    return best;
}

int PageColumns::placeColumn(std::span<const Part> parts, QRect room, const Put& put) const {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int y = room.top() + heightOf(parts.first(i + 1)) - parts[i].height;
        put(*parts[i].item, {room.left(), y, room.width(), parts[i].height});
    }
    return heightOf(parts);
}

/// Places parts in two columns; a single box spans both.
int PageColumns::placeColumns(const Items& items, const QRect& room, const Put& put) const {
    const bool isAlone = items.size() == 1 && qobject_cast<SectionBox*>(items.front()->widget());
    const int width = isAlone ? room.width() : (room.width() - between) / 2;
    std::vector<Part> parts;
    for (QLayoutItem* item : items) {
        parts.push_back({item, heightAt(*item, width)});
    }
    const std::span<const Part> all(parts);
    const std::size_t left = split(all);
    const QRect first(room.left(), room.top(), width, room.height());
    const QRect second = first.translated(room.width() - width, 0);
    return std::max(placeColumn(all.first(left), first, put),
                    placeColumn(all.subspan(left), second, put));
}

int PageColumns::place(const QRect& room, const Put& put) const {
    Items shown;
    for (int i = 0; i < count(); ++i) {
        if (!itemAt(i)->isEmpty()) {
            shown.push_back(itemAt(i));
        }
    }
    if (!hasTwo(room.width())) {
        std::vector<Part> parts;
        for (QLayoutItem* item : shown) {
            parts.push_back({item, heightAt(*item, room.width())});
        }
        return placeColumn(parts, room, put);
    }
    int y = room.top();
    QLayoutItem* above = nullptr;
    for (auto item = shown.begin(); item != shown.end();) {
        const auto end = isWide(**item)
                             ? item + 1
                             : std::find_if(item, shown.end(), [this](const QLayoutItem* next) {
                                   return isWide(*next);
                               });
        y += above ? gap(*above, **item) : 0;
        const QRect rest(room.left(), y, room.width(), room.bottom() + 1 - y);
        if (isWide(**item)) {
            const Part part{*item, heightAt(**item, room.width())};
            y += placeColumn({&part, 1}, rest, put);
        } else {
            y += placeColumns({item, end}, rest, put);
        }
        above = *(end - 1);
        item = end;
    }
    return y - room.top();
}

int PageColumns::heightForWidth(int width) const {
    const QMargins margins = contentsMargins();
    const QRect room(0, 0, width - margins.left() - margins.right(), 0);
    return margins.top() + place(room, [](QLayoutItem&, const QRect&) {}) + margins.bottom();
}

int PageColumns::minimumHeightForWidth(int width) const {
    return heightForWidth(width);
}

/// The height follows from the width.
QSize PageColumns::minimumSize() const {
    return {QVBoxLayout::minimumSize().width(), 0};
}

void PageColumns::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    place(rect.marginsRemoved(contentsMargins()),
          [](QLayoutItem& item, const QRect& at) { item.setGeometry(at); });
}

} // namespace sparkout
