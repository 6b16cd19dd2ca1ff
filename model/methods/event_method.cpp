#include "model/methods/event_method.hpp"

namespace rotor {
template class EventMethod<double>;
}  // namespace rotor
