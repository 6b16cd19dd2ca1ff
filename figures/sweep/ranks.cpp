#include "figures/sweep/ranks.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#ifdef ROTOR_MPI
#include <mpi.h>
#endif

namespace rotor {

#ifdef ROTOR_MPI

namespace {

/// The first rank sends points, the others send their rows after them, or why they cannot continue;
/// `end` says that nothing is left.
enum Tag : int { point_and_row = 1, failure = 2, end = 3 };

struct Message {
  int from, tag;
  std::string content;
};

/// The number of points sent to a rank in advance, so that it never waits for an answer.
constexpr int ahead = 16;

bool is_launched() {
  constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"};
  return std::any_of(variables.begin(), variables.end(),
                     [](const char* variable) { return std::getenv(variable) != nullptr; });
}

/// A message that has arrived, if any. Polls, because MPI keeps a core busy while it waits.
std::optional<Message> next_message() {
  int is_there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (!is_there) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  Message message{status.MPI_SOURCE, status.MPI_TAG,
                  std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.content.data(), size, MPI_CHAR, message.from, message.tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

Message wait_for_message() {
  for (;; std::this_thread::sleep_for(std::chrono::microseconds(100)))
    if (auto message = next_message()) return *message;
}

void send(const std::string& message, int to, Tag tag) {
  MPI_Send(message.data(), static_cast<int>(message.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

std::string packed(long point, const std::string& row = "") {
  return std::string(reinterpret_cast<const char*>(&point), sizeof(point)) + row;
}

long point_in(const std::string& message) {
  long point = 0;
  std::memcpy(&point, message.data(), sizeof(point));
  return point;
}

}  // namespace

Ranks::Ranks() {
  if (!is_launched()) return;
  int threads = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &threads);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  out_.resize(static_cast<std::size_t>(count_));
}

Ranks::~Ranks() {
  if (is_launched()) MPI_Finalize();
}

bool Ranks::broadcast(bool word) const {
  int number = word;
  if (count_ > 1) MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return number != 0;
}

void Ranks::serve(PointScheduler& scheduler) {
  if (count_ == 1) return;
  while (const auto message = next_message()) {
    --out_[static_cast<std::size_t>(message->from)];
    if (message->tag == failure)
      scheduler.stop(std::make_exception_ptr(std::runtime_error(message->content)));
    else
      scheduler.take(point_in(message->content), message->content.substr(sizeof(long)));
  }
  for (int rank = 1; rank < count_; ++rank)
    for (int& out = out_[static_cast<std::size_t>(rank)]; out < ahead; ++out) {
      const auto point = scheduler.next_if_due();
      if (!point) return;
      send(packed(*point), rank, point_and_row);
    }
}

void Ranks::shut_down_workers() const {
  for (int rank = 1; rank < count_; ++rank) send("", rank, end);
  for (int working = count_ - 1; working > 0;)
    if (wait_for_message().tag == end) --working;
}

void work_for_first(const Work& work) {
  std::exception_ptr reason;
  for (Message message = wait_for_message(); message.tag != end; message = wait_for_message()) {
    if (reason) continue;
    const long point = point_in(message.content);
    try {
      send(packed(point, work(point)), 0, point_and_row);
    } catch (const std::exception& error) {
      reason = std::current_exception();
      send(error.what(), 0, failure);
    }
  }
  send("", 0, end);
  if (reason) std::rethrow_exception(reason);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
bool Ranks::broadcast(bool word) const { return is_first() && word; }
void Ranks::serve(PointScheduler& /*scheduler*/) {}
void Ranks::shut_down_workers() const {}
void work_for_first(const Work& /*work*/) {}

#endif

}  // namespace rotor
