// Purpose: collects messages of the validation layers. The messenger must be created explicitly: one that is
// only chained to instance creation receives no later messages, and "0 messages" would prove nothing.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace weft::vk {

enum class MessageSeverity : uint8_t { info, warning, error };

struct Message {
    MessageSeverity severity = MessageSeverity::error;
    std::string id;    // "SYNC-HAZARD-WRITE_AFTER_WRITE", "VUID-…"
    std::string pass;  // the pass being recorded or submitted, or the label in the message
    std::string text;
};

// Thread-safe: drivers may call back from any thread.
class MessageCollector {
 public:
    void add(Message message);
    // Sets the pass for later messages on the calling thread; empty for none. Per thread, because one thread
    // may render frames while another creates pipelines.
    void set_current_pass(std::string pass);
    [[nodiscard]] std::string current_pass() const;
    [[nodiscard]] std::vector<Message> messages() const;  // warnings and errors
    [[nodiscard]] size_t count() const;

 private:
    mutable std::mutex mutex_;
    std::map<std::thread::id, std::string> current_pass_;
    std::vector<Message> messages_;
};

}  // namespace weft::vk
