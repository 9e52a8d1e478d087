// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_topic.h"

#include "ui/help/help_fields.h"
#include "ui/inputs/hint_strip.h"
#include "ui/views/view.h"

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
    if (const Field* field = hintField(widget)) {
        return fieldTopic(*field);
    }
    for (; widget; widget = widget->parentWidget()) {
        if (const QString topic = widget->property(topicProperty).toString(); !topic.isEmpty()) {
            return topic;
        }
        if (qobject_cast<const View*>(widget)) {
            return widget->objectName();
        }
    }
    return {};
}

} // namespace sparkout
