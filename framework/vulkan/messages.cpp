#include "vulkan/messages.h"

#include <utility>

namespace weft::vk {

void MessageCollector::add(Message message) {
    const std::lock_guard lock(mutex_);
    if (message.pass.empty()) message.pass = current_pass_;
    messages_.push_back(std::move(message));
}

void MessageCollector::set_current_pass(std::string pass) {
    const std::lock_guard lock(mutex_);
    current_pass_ = std::move(pass);
}

std::string MessageCollector::current_pass() const {
    const std::lock_guard lock(mutex_);
    return current_pass_;
}

std::vector<Message> MessageCollector::messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

size_t MessageCollector::count() const {
    const std::lock_guard lock(mutex_);
    return messages_.size();
}

}  // namespace weft::vk
