#include "figures/sweep/ranks.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#ifdef ROTOR_MPI
#include <mpi.h>
#endif

namespace rotor {

#ifdef ROTOR_MPI

namespace {

/// What other ranks send: the two numbers of a block and its rows, or why they cannot continue. A
/// block without points only asks for more.
enum Tag : int { rows_of_block = 1, failure = 2, dealt_block = 3 };

/// The number of blocks sent to a rank in advance, so that it never waits for an answer.
constexpr int ahead = 4;

bool is_launched() {
  constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"};
  return std::any_of(variables.begin(), variables.end(),
                     [](const char* variable) { return std::getenv(variable) != nullptr; });
}

void pause() { std::this_thread::sleep_for(std::chrono::microseconds(100)); }

/// A message that has arrived, if any. Polls, because MPI keeps a core busy while it waits.
std::optional<MPI_Status> next_message() {
  int is_there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  return is_there ? std::optional(status) : std::nullopt;
}

std::string receive(const MPI_Status& from) {
  int size = 0;
  MPI_Get_count(&from, MPI_CHAR, &size);
  std::string message(static_cast<std::size_t>(size), '\0');
  MPI_Recv(message.data(), size, MPI_CHAR, from.MPI_SOURCE, from.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

void send(const std::string& message, int to, Tag tag) {
  MPI_Send(message.data(), static_cast<int>(message.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

std::string packed(const Block& block, const std::string& rows = "") {
  const std::array<long, 2> numbers = {block.from, block.until};
  return std::string(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers)) + rows;
}

Block block_in(const std::string& message) {
  std::array<long, 2> numbers{};
  std::memcpy(numbers.data(), message.data(), sizeof(numbers));
  return {numbers[0], numbers[1]};
}

}  // namespace

Ranks::Ranks() {
  if (!is_launched()) return;
  int threads = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &threads);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  shutdowns_ = ahead * (count_ - 1);
}

Ranks::~Ranks() {
  if (is_launched()) MPI_Finalize();
}

bool Ranks::broadcast(bool word) const {
  int number = word;
  if (count_ > 1) MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return number != 0;
}

void Ranks::answer(BlockScheduler& scheduler, int rank) {
  const auto block = scheduler.next_if_due();
  if (!block && !scheduler.is_dealt_out()) return waiting_.push_back(rank);
  if (!block) --shutdowns_;
  send(packed(block.value_or(Block{0, 0})), rank, dealt_block);
}

void Ranks::serve(BlockScheduler& scheduler) {
  if (count_ == 1) return;
  for (const int rank : std::exchange(waiting_, {})) answer(scheduler, rank);
  while (const auto message = next_message()) {
    const std::string content = receive(*message);
    if (message->MPI_TAG == failure) {
      scheduler.stop(std::make_exception_ptr(std::runtime_error(content)));
      continue;
    }
    const Block block = block_in(content);
    if (block.from < block.until) scheduler.take(block, content.substr(sizeof(long) * 2));
    answer(scheduler, message->MPI_SOURCE);
  }
}

void Ranks::shut_down_workers(BlockScheduler& scheduler) {
  for (; shutdowns_ > 0; pause()) serve(scheduler);
}

void work_for_first(const Work& work) {
  std::exception_ptr reason;
  for (int n = 0; n < ahead; ++n) send(packed({0, 0}), 0, rows_of_block);
  for (int shut_down = 0; shut_down < ahead;) {
    const auto message = next_message();
    if (!message) {
      pause();
      continue;
    }
    const Block block = block_in(receive(*message));
    if (block.from == block.until) {
      ++shut_down;
      continue;
    }
    std::string rows;
    try {
      if (!reason) rows = rows_of(block, work);
    } catch (const std::exception& error) {
      reason = std::current_exception();
      send(error.what(), 0, failure);
    }
    send(packed(reason ? Block{0, 0} : block, rows), 0, rows_of_block);
  }
  if (reason) std::rethrow_exception(reason);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
bool Ranks::broadcast(bool word) const { return is_first() && word; }
void Ranks::serve(BlockScheduler& /*scheduler*/) {}
void Ranks::shut_down_workers(BlockScheduler& /*scheduler*/) {}
void work_for_first(const Work& /*work*/) {}

#endif

}  // namespace rotor
