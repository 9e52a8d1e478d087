// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/help_topic.h"

#include <QVariant>
#include <QWidget>

namespace sparkout {

namespace {
constexpr const char* topicProperty = "sparkoutHelpTopic";
}

void setHelpTopic(QWidget& widget, const QString& topic) {
    widget.setProperty(topicProperty, topic);
}

QString helpTopicOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
        if (const QString topic = widget->property(topicProperty).toString(); !topic.isEmpty()) {
            return topic;
        }
    }
    return {};
}

} // namespace sparkout
