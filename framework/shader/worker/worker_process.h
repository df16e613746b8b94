// Purpose: starts and watches the shader worker process. The worker is started without a shell, with an empty
// environment, and with its socket as the only open file descriptor besides /dev/null. It is killed if it
// exceeds its time or memory, or sends invalid messages. The worker limits its own address space. Builds with
// sanitizers cannot do this, so this class also watches the resident memory. The same time limit
// applies separately to the worker's processor time and to the time that the worker sleeps while the caller
// waits for it. The time that the worker waits for a processor on a busy machine does not count. Error X570:
// the worker cannot be started, or has another version.
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
    // Starts the worker program. The worker must report `version` as its compiler_version().
    [[nodiscard]] static Result<std::unique_ptr<WorkerProcess>> start(const std::filesystem::path& program,
                                                                      const ShaderLimits& limits,
                                                                      const std::string& version);
    ~WorkerProcess();
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    // Sets the processor time that the worker may use from now on. The same limit applies separately to the
    // time that the worker sleeps.
    void allow(std::chrono::milliseconds time);
    // Returns the processor time that the worker has used since its start.
    [[nodiscard]] std::chrono::milliseconds used();

    // If send() or receive() fails, the process has ended, and end() returns the reason.
    [[nodiscard]] bool send(const Message& message);
    [[nodiscard]] std::optional<Message> receive();
    [[nodiscard]] WorkerEnd end() const { return end_; }
    // Returns the signal that ended the worker; 0 if the worker exited normally.
    [[nodiscard]] int signal() const { return signal_; }

    // Kills the worker because it sent an invalid message.
    void kill();

 private:
    WorkerProcess(pid_t pid, int socket, const ShaderLimits& limits)
        : pid_(pid), socket_(socket), limits_(limits) {}

    [[nodiscard]] bool ready(short events);
    [[nodiscard]] bool read_exactly(char* to, size_t bytes);
    // Updates used_ from /proc. Returns true if the process sleeps.
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
