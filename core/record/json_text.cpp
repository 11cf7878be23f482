#include "record/json_text.h"

#include <nlohmann/json.hpp>

#include "base/text.h"

namespace lsos {

namespace {

// Accepts values nested no deeper than this; builds nothing.
class NestingCounter : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  bool enter() { return ++depth_ <= depth_max; }
  bool leave() { return depth_-- > 0; }

  static constexpr int depth_max = 64;
  int depth_ = 0;
};

}  // namespace

bool is_json_object(std::string_view text) {
  NestingCounter counter;
  return trimmed(text).starts_with('{') && nlohmann::json::sax_parse(text, &counter);
}

}  // namespace lsos
