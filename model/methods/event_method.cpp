#include "model/methods/event_method.ipp"

namespace rotor {
template class EventMethod<double>;
}  // namespace rotor
