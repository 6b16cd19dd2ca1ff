/// The engine's interface to the page's script. Everything is passed as JSON text, except for the
/// tables, which are arrays of numbers, row after row.
#include <emscripten/bind.h>
#include <emscripten/emscripten.h>

#include "verification/report/engine/explorer.hpp"

namespace rotor {
namespace {

using emscripten::val;

/// Reports progress to the page. A busy engine cannot receive messages: to end a run, the page ends
/// its worker.
class PageMonitor : public Observer {
 public:
  explicit PageMonitor(val on_progress) : on_progress_(std::move(on_progress)) {}

  bool should_continue(const Progress& now) override {
    constexpr long seldom = 256;  // reading a clock is not free
    if (++steps_ % seldom == 0 && emscripten_get_now() >= next_ms_) {
      next_ms_ = emscripten_get_now() + every_ms;
      on_progress_(now.time_s);
    }
    return true;
  }

 private:
  static constexpr double every_ms = 250;

  val on_progress_;
  long steps_ = 0;
  double next_ms_ = emscripten_get_now() + every_ms;
};

val array(const Table& table) {
  const std::size_t size = table.rows() * table.columns();
  if (size == 0) return val::global("Float64Array").new_(0);
  return val(emscripten::typed_memory_view(size, table.row(0).data())).call<val>("slice");
}

class Engine {
 public:
  val run(const std::string& options, val on_progress) {
    return answer(on_progress, [&](Observer& monitor) {
      return to_page(explorer_.run(read(options), monitor));
    });
  }

  std::string describe_numbers() const { return Explorer::describe_numbers().dump(); }

 private:
  static Options read(const std::string& options) { return Json::parse(options).get<Options>(); }
  static val to_page(const Picture& picture) {
    val result = val::object();
    result.set("metadata", picture.metadata.dump());
    result.set("motion", array(picture.motion));
    result.set("works", array(picture.works));
    return result;
  }
  /// A refusal is returned as a result, too.
  template <class Action>
  static val answer(const val& on_progress, const Action& action) {
    PageMonitor monitor(on_progress);
    try {
      return action(monitor);
    } catch (const std::exception& error) {
      val refused = val::object();
      refused.set("refusal", std::string(error.what()));
      return refused;
    }
  }

  Explorer explorer_;
};

}  // namespace
}  // namespace rotor

EMSCRIPTEN_BINDINGS(explore) {
  emscripten::class_<rotor::Engine>("Engine")
      .constructor<>()
      .function("run", &rotor::Engine::run)
      .function("describeNumbers", &rotor::Engine::describe_numbers);
}
