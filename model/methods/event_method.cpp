#include "model/methods/event_method.hpp"

namespace rotor {
template class SynchronousMotion<double>;
template class FlightChart<double>;
template class EventMethod<double>;
}  // namespace rotor
