#include "mission/port/script_host.h"

namespace lsos {

namespace {

// Serialises a FieldValue: the index of its alternative, then the value.
struct ArchivedValue {
  FieldValue value;

  void archive(Archive& a) {
    std::uint8_t kind = static_cast<std::uint8_t>(value.index());
    LSOS_ARCHIVE(a, kind);
    switch (kind) {
      case 0:
        through<bool>(a);
        break;
      case 1:
        through<std::int64_t>(a);
        break;
      case 2:
        through<double>(a);
        break;
      case 3:
        through<std::string>(a);
        break;
      case 4: {
        Instant instant = a.is_reading() ? Instant{} : std::get<Instant>(value);
        LSOS_ARCHIVE(a, instant.tai_us);
        value = instant;
        break;
      }
      default:
        throw Archive::Mismatch("saved state holds a value of an unknown kind");
    }
  }

  template <class T>
  void through(Archive& a) {
    T alternative = a.is_reading() ? T{} : std::get<T>(value);
    LSOS_ARCHIVE(a, alternative);
    value = alternative;
  }
};

}  // namespace

void EventArguments::archive(Archive& a) {
  std::map<std::string, ArchivedValue> values;
  for (const auto& [key, value] : params) values[key] = {value};
  LSOS_ARCHIVE(a, values, geometry_S_m, holes_S_m);
  params.clear();
  for (const auto& [key, value] : values) params[key] = value.value;
}

}  // namespace lsos
