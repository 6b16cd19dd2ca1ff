/// The engine's interface to the page's script. Everything is passed as JSON text, except for the
/// motion, which is an array of numbers, row after row.
#include <emscripten/bind.h>

#include "verification/report/engine/explorer.hpp"

namespace rotor {
namespace {

using emscripten::val;

class Engine {
 public:
  /// A refusal is returned as a result, too.
  val run(const std::string& options) {
    val result = val::object();
    try {
      const Picture picture = explorer_.run(Json::parse(options).get<Options>());
      const Table& motion = picture.motion;
      const auto numbers =
          emscripten::typed_memory_view(motion.rows() * motion.columns(), motion.row(0).data());
      result.set("metadata", picture.metadata.dump());
      result.set("motion", val(numbers).call<val>("slice"));
    } catch (const std::exception& error) {
      result.set("refusal", std::string(error.what()));
    }
    return result;
  }

 private:
  Explorer explorer_;
};

}  // namespace
}  // namespace rotor

EMSCRIPTEN_BINDINGS(explore) {
  emscripten::class_<rotor::Engine>("Engine").constructor<>().function("run", &rotor::Engine::run);
}
