#include "weft/vulkan/messages.h"

#include <utility>

namespace weft::vk {

void MessageCollector::add(Message message) {
    if (message.pass.empty()) message.pass = current_pass();
    if (log_) return log_(message);
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

void MessageCollector::set_current_pass(std::string pass) {
    const std::lock_guard lock(mutex_);
    if (pass.empty())
        current_pass_.erase(std::this_thread::get_id());
    else
        current_pass_[std::this_thread::get_id()] = std::move(pass);
}

std::string MessageCollector::current_pass() const {
    const std::lock_guard lock(mutex_);
    const auto found = current_pass_.find(std::this_thread::get_id());
    return found == current_pass_.end() ? std::string() : found->second;
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
