// Purpose: collects the messages of the validation layers. The messenger is created as an object of its own.
// A messenger that is only in the pNext chain of VkInstanceCreateInfo gets no messages about frames, because
// Vulkan uses it only while the instance is created or destroyed. With such a messenger, a run without
// messages would prove nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace weft::vk {

enum class MessageSeverity : uint8_t { info, warning, error };

struct Message {
    MessageSeverity severity = MessageSeverity::error;
    std::string id;  // Identifier of the message, such as "SYNC-HAZARD-WRITE_AFTER_WRITE" or "VUID-…".
    // The innermost debug label in the message, which is usually the name of a pass. Without a label: the
    // current pass of the thread; see set_current_pass().
    std::string pass;
    std::string text;
};

// Thread-safe, because drivers may report messages from any thread.
class MessageCollector {
 public:
    void add(Message message);
    // Sends all later messages to `log` instead of storing them. Call this before the first message.
    void send_to(std::function<void(const Message&)> log) { log_ = std::move(log); }
    // Sets the current pass of the calling thread: later messages without a label belong to it; empty: none.
    // Each thread has its own pass, because one thread may render frames while another creates pipelines.
    void set_current_pass(std::string pass);
    [[nodiscard]] std::string current_pass() const;
    [[nodiscard]] std::vector<Message> messages() const;  // Returns all warnings and errors so far.
    [[nodiscard]] size_t count() const;

 private:
    std::function<void(const Message&)> log_;
    mutable std::mutex mutex_;
    std::map<std::thread::id, std::string> current_pass_;
    std::vector<Message> messages_;
};

}  // namespace weft::vk
