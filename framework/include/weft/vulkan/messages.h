// Purpose: collects what the validation layers say. The messenger is created explicitly: one that is only
// chained to instance creation sees nothing afterwards, and "0 messages" would prove nothing.
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
    std::string pass;  // the pass being recorded or submitted, or the label the message names
    std::string text;
};

// Thread-safe: drivers may call back from any thread.
class MessageCollector {
 public:
    void add(Message message);
    // The pass that messages on the calling thread are blamed on from now on; empty for none. One thread may
    // draw frames while another makes pipelines.
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
