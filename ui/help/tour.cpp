// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/tour.h"

#include "ui/kit/metrics.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

constexpr int tipSize = 14; ///< length and half width of the pointer to the widget
constexpr int balloonWidth = 300;
constexpr double balloonCorner = 6;

/// The place of a balloon beside a target: right, left, below or above it, or in its middle if it
/// fits nowhere else.
QRect placeBeside(const QRect& target, const QSize& size, const QRect& room) {
    const QPoint middle = target.center();
    const std::array<QPoint, 4> corners{
        QPoint(target.right() + tipSize, middle.y() - size.height() / 2),
        QPoint(target.left() - tipSize - size.width(), middle.y() - size.height() / 2),
        QPoint(middle.x() - size.width() / 2, target.bottom() + tipSize),
        QPoint(middle.x() - size.width() / 2, target.top() - tipSize - size.height())};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        QRect place(corners[i], size);
        if (i < 2) { // along its side it may be moved
            place.moveTop(std::clamp(place.top(), room.top(),
                                     std::max(room.top(), room.bottom() - size.height())));
        } else {
            place.moveLeft(std::clamp(place.left(), room.left(),
                                      std::max(room.left(), room.right() - size.width())));
        }
        if (room.contains(place)) {
            return place;
        }
    }
    QRect inside(QPoint(), size);
    inside.moveCenter(middle);
    return inside;
}

} // namespace

TourBalloon::TourBalloon(QWidget& window)
    : QWidget(&window)
    , m_title(new QLabel(this))
    , m_text(new QLabel(this))
    , m_place(new QLabel(this))
    , m_skip(new QPushButton(this))
    , m_back(new QPushButton(this))
    , m_next(new QPushButton(this)) {
    setObjectName(QStringLiteral("tourBalloon"));
    setFocusPolicy(Qt::NoFocus);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (QLabel* label : {m_title, m_text, m_place}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(label != m_place);
        label->setForegroundRole(QPalette::ToolTipText);
    }
    m_skip->setObjectName(QStringLiteral("tourSkip"));
    m_back->setObjectName(QStringLiteral("tourBack"));
    m_next->setObjectName(QStringLiteral("tourNext"));
    for (QPushButton* button : {m_skip, m_back, m_next}) {
        button->setAutoDefault(true); // Enter presses the one in focus
    }
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(metrics::tight);
    buttons->addWidget(m_place, 1);
    buttons->addWidget(m_skip);
    buttons->addWidget(m_back);
    buttons->addWidget(m_next);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(tipSize + metrics::margin, tipSize + metrics::margin,
                               tipSize + metrics::margin, tipSize + metrics::margin);
    layout->setSpacing(metrics::gap);
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addLayout(buttons);
    connect(m_next, &QPushButton::clicked, this, &TourBalloon::next);
    connect(m_back, &QPushButton::clicked, this, &TourBalloon::back);
    connect(m_skip, &QPushButton::clicked, this, &TourBalloon::ended);
    hide();
}

void TourBalloon::show(const Text& text, const QRect& target) {
    m_title->setText(text.title);
    m_text->setText(text.body);
    m_place->setText(text.place);
    m_skip->setText(tr("Skip"));
    m_skip->setVisible(!text.last);
    m_back->setText(tr("Back"));
    m_back->setVisible(!text.first);
    m_next->setText(text.last ? tr("Done") : tr("Next"));
    setAccessibleName(text.title);
    setAccessibleDescription(text.body);
    place(target);
    QWidget::show();
    raise();
    m_next->setFocus(Qt::OtherFocusReason);
}

QRect TourBalloon::body() const {
    return rect().adjusted(tipSize, tipSize, -tipSize, -tipSize);
}

QPoint TourBalloon::tip() const {
    return mapToParent(m_tip);
}

QString TourBalloon::title() const {
    return m_title->text();
}

void TourBalloon::place(const QRect& target) {
    const int width = std::max(balloonWidth, minimumSizeHint().width() - 2 * tipSize);
    const int height = layout()->heightForWidth(width + 2 * tipSize) - 2 * tipSize;
    const QRect body = placeBeside(target, {width, height}, parentWidget()->rect());
    setGeometry(body.adjusted(-tipSize, -tipSize, tipSize, tipSize));
    // The tip is the point of the target nearest to the balloon.
    const QPoint near(std::clamp(body.center().x(), target.left(), target.right()),
                      std::clamp(body.center().y(), target.top(), target.bottom()));
    m_tip = mapFromParent(near);
    update();
}

void TourBalloon::paintEvent(QPaintEvent*) {
    QPainterPath shape;
    shape.addRoundedRect(QRectF(body()), balloonCorner, balloonCorner);
    const QRect inner = body().adjusted(tipSize, tipSize, -tipSize, -tipSize);
    if (!body().contains(m_tip)) {
        const QPointF root(std::clamp(m_tip.x(), inner.left(), inner.right()),
                           std::clamp(m_tip.y(), inner.top(), inner.bottom()));
        const bool sideways = m_tip.x() < body().left() || m_tip.x() > body().right();
        const QPointF half = sideways ? QPointF(0, tipSize) : QPointF(tipSize, 0);
        QPainterPath arrow(root - half);
        arrow.lineTo(
            QPointF(std::clamp(m_tip.x(), 0, width() - 1), std::clamp(m_tip.y(), 0, height() - 1)));
        arrow.lineTo(root + half);
        arrow.closeSubpath();
        shape = shape.united(arrow);
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.setBrush(palette().brush(QPalette::ToolTipBase));
    painter.drawPath(shape);
}

Tour::Tour(QWidget& window, std::vector<TourStep> steps)
    : QObject(&window), m_window(window), m_steps(std::move(steps)) {}

Tour::~Tour() = default;

void Tour::start() {
    end();
    m_balloon = std::make_unique<TourBalloon>(m_window);
    connect(m_balloon.get(), &TourBalloon::next, this, [this] { go(1); });
    connect(m_balloon.get(), &TourBalloon::back, this, [this] { go(-1); });
    connect(m_balloon.get(), &TourBalloon::ended, this, &Tour::end);
    m_step = -1;
    qApp->installEventFilter(this);
    go(1);
}

void Tour::end() {
    if (!m_balloon) {
        return;
    }
    qApp->removeEventFilter(this);
    m_balloon->disconnect(this); // a key press on its way to it has no effect
    m_balloon->hide();
    m_balloon.release()->deleteLater(); // one of its buttons may be the caller
    emit finished();
}

bool Tour::running() const {
    return m_balloon != nullptr;
}

void Tour::go(int by) {
    for (m_step += by; m_step < int(m_steps.size()); m_step += by) {
        if (m_step < 0) { // there is nothing before the first shown step
            m_step = 0;
            by = 1;
        }
        if (showStep()) {
            return;
        }
    }
    end();
}

bool Tour::showStep() {
    const TourStep& step = m_steps[std::size_t(m_step)];
    step.target(); // visible, and laid out:
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    const QRect target = step.target() & m_window.rect();
    if (target.isEmpty()) {
        return false;
    }
    m_balloon->show({step.title(), step.text(), tr("%1 of %2").arg(m_step + 1).arg(m_steps.size()),
                     m_step == 0, m_step + 1 == int(m_steps.size())},
                    target);
    return true;
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    const bool escape = event->type() == QEvent::KeyPress
                        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape
                        && QApplication::activeWindow() == &m_window && watched->isWidgetType()
                        && !QApplication::activePopupWidget();
    if (escape) {
        end();
        return true;
    }
    if (watched == &m_window && running()
        && (event->type() == QEvent::Resize || event->type() == QEvent::LanguageChange)) {
        QTimer::singleShot(0, this, [this] { // after the layout of its parts
            if (running()) {
                showStep();
            }
        });
    }
    return false;
}

} // namespace sparkout
