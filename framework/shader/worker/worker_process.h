// Purpose: the compiler worker, seen from its caller: a process that is started without a shell, with only
// its socket as descriptor and an empty environment. It is killed when it exceeds its time or memory or sends
// invalid messages. The worker limits its own address space; sanitizer builds cannot, so this class also
// watches its resident memory. Time is the worker's processor time, or the time it sleeps while an answer is
// due; waiting for a processor on a busy machine does not count. Errors: X570 the worker cannot be started,
// or has another version.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "shader/worker/protocol.h"
#include "weft/limits.h"
#include "weft/result.h"

namespace weft::shader {

enum class WorkerEnd : uint8_t { running, out_of_memory, out_of_time, crashed, protocol_error };

class WorkerProcess {
 public:
    // `version`: the compiler_version() that the worker must report.
    [[nodiscard]] static Result<std::unique_ptr<WorkerProcess>> start(const std::filesystem::path& program,
                                                                      const ShaderLimits& limits,
                                                                      const std::string& version);
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    // Sets the time limit, counted from now.
    void allow(std::chrono::milliseconds time);
    // Processor time since the worker's start.
    [[nodiscard]] std::chrono::milliseconds used();

    // After a failure of either function the process has ended, and end() has the reason.
    [[nodiscard]] bool send(const Message& message);
    [[nodiscard]] std::optional<Message> receive();
    [[nodiscard]] WorkerEnd end() const { return end_; }
    [[nodiscard]] int signal() const { return signal_; }  // signal of a crash; 0: the worker exited normally

    // Kills the worker after it sent an invalid message.
    void kill();

 private:
    WorkerProcess(pid_t pid, int socket, const ShaderLimits& limits)
        : pid_(pid), socket_(socket), limits_(limits) {}

    [[nodiscard]] bool ready(short events);
    [[nodiscard]] bool read_exactly(char* to, size_t bytes);
    // Updates used_ from the system. Returns true if the process sleeps.
    bool observe();
    [[nodiscard]] uint64_t resident_bytes() const;
    void wait_for_end();
    void kill_for(WorkerEnd reason);

    pid_t pid_ = -1;
    int socket_ = -1;
    ShaderLimits limits_;
    WorkerEnd end_ = WorkerEnd::running;
    int signal_ = 0;
    std::chrono::milliseconds used_{0}, most_used_{0};
    std::chrono::milliseconds asleep_{0}, most_asleep_{0};
};

}  // namespace weft::shader
